// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/unit_switch.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QToolButton>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

QString about(SizeUnit unit) {
  switch (unit) {
    case SizeUnit::pixel:
      return QObject::tr("Sizes in px, of one image coordinate (U)");
    case SizeUnit::millimetre:
      return QObject::tr("Sizes in mm at the hand: the markers' distances in space (U)");
    case SizeUnit::sigma:
      return QObject::tr("Sizes in σ, the noise of one coordinate: what the colours mean (U)");
  }
  return {};
}

}  // namespace

UnitSwitch::UnitSwitch(QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* group = new QButtonGroup(this);
  constexpr std::array<const char*, 3> names = {"unit_px", "unit_mm", "unit_sigma"};
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const auto unit = static_cast<SizeUnit>(i);
    auto* b = new QToolButton(this);
    b->setObjectName(names[i]);
    b->setText(unit_name(unit));
    b->setFont(text_font(TextRole::small));
    b->setCheckable(true);
    b->setAutoRaise(true);
    b->setFixedHeight(row_height_px);
    b->setMinimumWidth(32);
    b->setAccessibleName(about(unit));
    group->addButton(b, static_cast<int>(i));
    layout->addWidget(b);
    buttons_[i] = b;
    set_why_not(unit, {});
  }
  connect(group, &QButtonGroup::idClicked, this, [this](int id) { emit chosen(static_cast<SizeUnit>(id)); });
  set_unit(SizeUnit::pixel);
}

void UnitSwitch::set_unit(SizeUnit unit) { buttons_[static_cast<std::size_t>(unit)]->setChecked(true); }

void UnitSwitch::set_why_not(SizeUnit unit, const QString& sentence) {
  QToolButton* b = buttons_[static_cast<std::size_t>(unit)];
  b->setEnabled(sentence.isEmpty());
  b->setToolTip(sentence.isEmpty() ? about(unit) : sentence);
}

}  // namespace handsight::widgets
