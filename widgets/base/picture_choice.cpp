// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/picture_choice.h"

#include <QAbstractButton>
#include <QGridLayout>
#include <QPainter>
#include <algorithm>

#include "widgets/base/icons.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr int tile_width = 112, tile_height = 92, drawing_side = 44;

class PictureTile : public QAbstractButton {
 public:
  PictureTile(const PictureOption& option, QWidget* parent) : QAbstractButton(parent), icon_(option.icon) {
    setText(option.words);
    setToolTip(option.hint);
    setAccessibleName(option.words);
    setAccessibleDescription(option.hint);
    setCheckable(true);
    setAutoExclusive(true);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  QSize sizeHint() const override { return {tile_width, tile_height}; }
  QSize minimumSizeHint() const override { return {tile_width - 12, tile_height}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const Colors& c = colors();
    const bool is_on = isChecked();
    p.setPen(QPen(is_on || hasFocus() ? c.accent : underMouse() ? c.control_edge : c.hairline, is_on ? 2 : 1));
    p.setBrush(is_on ? c.selected_row : c.panel);
    p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 5, 5);
    if (hasFocus() && is_on) {
      p.setPen(QPen(c.accent, 1, Qt::DotLine));
      p.setBrush(Qt::NoBrush);
      p.drawRoundedRect(QRectF(rect()).adjusted(4, 4, -4, -4), 3, 3);
    }
    draw_icon(p, QRectF((width() - drawing_side) / 2.0, 8, drawing_side, drawing_side), icon_,
              !isEnabled() ? c.hairline
              : is_on      ? c.ink1
                           : c.ink2);
    p.setPen(isEnabled() ? c.ink1 : c.ink3);
    p.setFont(text_font(TextRole::small));
    p.drawText(QRectF(4, 10 + drawing_side, width() - 8, tile_height - drawing_side - 12),
               Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextWordWrap, text());
  }

 private:
  QString icon_;
};

}  // namespace

PictureChoice::PictureChoice(const QString& name, const std::vector<PictureOption>& options, int columns,
                             QWidget* parent)
    : QWidget(parent) {
  setObjectName(name);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(layout_gap);
  for (int i = 0; i < columns; ++i) grid->setColumnStretch(i, 1);
  for (int i = 0; i < static_cast<int>(options.size()); ++i) {
    auto* tile = new PictureTile(options[static_cast<std::size_t>(i)], this);
    tile->setObjectName(QString("%1_%2").arg(name).arg(i));
    grid->addWidget(tile, i / columns, i % columns);
    connect(tile, &QAbstractButton::toggled, this, [this, i](bool on) {
      if (on) emit chosen(i);
    });
    buttons_.push_back(tile);
  }
  // A row that is not full: its tiles are as wide as those of the others.
  for (int i = static_cast<int>(options.size()); i < columns; ++i)
    grid->addItem(new QSpacerItem(tile_width, 0, QSizePolicy::Expanding), 0, i);
  if (!buttons_.empty()) buttons_.front()->setChecked(true);
}

int PictureChoice::current() const {
  const auto found =
      std::find_if(buttons_.begin(), buttons_.end(), [](const QAbstractButton* b) { return b->isChecked(); });
  return found == buttons_.end() ? -1 : static_cast<int>(found - buttons_.begin());
}

void PictureChoice::choose(int option) { buttons_.at(static_cast<std::size_t>(option))->setChecked(true); }

void PictureChoice::set_possible(int option, bool possible) {
  buttons_.at(static_cast<std::size_t>(option))->setEnabled(possible);
}

}  // namespace handsight::widgets
