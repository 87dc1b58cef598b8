// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/model_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/lists/parameter_row.h"

namespace handsight::widgets {
namespace {

/// A long title must not widen the panel: the numbers below it would end beyond its edge.
QString in_lines(const QString& title, const QFontMetrics& metrics) {
  constexpr int room = 210;  // px
  QStringList lines{QString()};
  for (const QString& word : title.split(' ')) {
    const QString longer = lines.back().isEmpty() ? word : lines.back() + ' ' + word;
    if (lines.back().isEmpty() || metrics.horizontalAdvance(longer) <= room)
      lines.back() = longer;
    else
      lines << word;
  }
  return lines.join('\n');
}

}  // namespace

ModelPanel::ModelPanel(QWidget* parent) : QFrame(parent), empty_text_(tr("No model yet.")) {
  setFrameShape(QFrame::NoFrame);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(layout_gap, 6, 0, 0);
  layout->setSpacing(4);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(0, 0, 4, 0);
  title_ = new QLabel(tr("Model"), this);
  title_->setFont(text_font(TextRole::title));
  headline_ = new QLabel(this);
  headline_->setFont(number_font(TextRole::body));
  fold_ = new QToolButton(this);
  fold_->setAutoRaise(true);
  fold_->setFixedSize(28, 28);
  fold_->setAccessibleName(tr("Fold the model panel"));
  head->addWidget(title_);
  head->addStretch(1);
  head->addWidget(headline_);
  head->addWidget(fold_);
  layout->addLayout(head);
  scroll_ = new QScrollArea(this);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  content_ = new QWidget(scroll_);
  content_->setBackgroundRole(QPalette::Base);
  content_->setAutoFillBackground(true);
  list_ = new QVBoxLayout(content_);
  list_->setContentsMargins(0, 0, layout_gap, layout_gap);
  list_->setSpacing(layout_gap);
  scroll_->setWidget(content_);
  layout->addWidget(scroll_, 1);
  layout->addStretch(0);
  connect(fold_, &QToolButton::clicked, this, [this] {
    set_folded(!is_folded_);
    emit folded_changed(is_folded_);
  });
  is_folded_ = true;
  set_folded(false);
  rebuild();
}

void ModelPanel::set_effects(std::vector<ModelEffect> effects) {
  effects_ = std::move(effects);
  rebuild();
}

void ModelPanel::set_headline(const QString& text) {
  headline_text_ = text;
  refresh_texts();
}

void ModelPanel::set_empty_text(const QString& text) {
  empty_text_ = text;
  if (effects_.empty()) rebuild();
}

void ModelPanel::set_busy(bool busy) {
  is_busy_ = busy;
  refresh_texts();
}

void ModelPanel::set_folded(bool folded) {
  if (folded == is_folded_) return;
  is_folded_ = folded;
  setFixedWidth(folded ? 36 : 288);
  layout()->setContentsMargins(folded ? 4 : layout_gap, 6, 0, 0);
  title_->setVisible(!folded);
  headline_->setVisible(!folded);
  scroll_->setVisible(!folded);
  static_cast<QVBoxLayout*>(layout())->setStretch(2, folded ? 1 : 0);
  fold_->setArrowType(folded ? Qt::LeftArrow : Qt::RightArrow);
  fold_->setToolTip(folded ? tr("Show the model (M)") : tr("Fold the model away (M)"));
}

/// Folded it says what it is, along its edge.
void ModelPanel::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  if (!is_folded_) return;
  constexpr int below_fold = 44, room = 200;
  QPainter painter(this);
  painter.setFont(text_font(TextRole::title));
  painter.setPen(colors().ink2);
  painter.translate(width(), below_fold);
  painter.rotate(90);
  painter.drawText(QRect(0, 0, room, width()), Qt::AlignLeft | Qt::AlignVCenter, tr("Model"));
}

void ModelPanel::set_selected_joint(const QString& joint) {
  if (joint == selected_joint_) return;
  selected_joint_ = joint;
  rebuild();
}

void ModelPanel::refresh_texts() { headline_->setText(is_busy_ ? tr("fitting ...") : headline_text_); }

QWidget* ModelPanel::make_effect(const ModelEffect& effect) {
  const Colors& c = colors();
  auto* box = new QWidget(content_);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  QPalette tinted = palette();
  if (effect.is_candidate) {
    tinted.setColor(QPalette::WindowText, c.candidate);
    tinted.setColor(QPalette::ButtonText, c.candidate);
  }
  if (effect.is_permanent) {
    auto* title = new QLabel(effect.title, box);
    QFont font = text_font(TextRole::body);
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    title->setPalette(tinted);
    title->setForegroundRole(QPalette::WindowText);
    title->setWordWrap(true);
    title->setToolTip(effect.help);
    layout->addWidget(title);
  } else {
    auto* check = new QCheckBox(box);
    check->setText(in_lines(effect.title, check->fontMetrics()));
    check->setObjectName(QStringLiteral("effect_") + effect.id);
    check->setChecked(effect.is_in_model);
    check->setEnabled(effect.can_change);
    check->setToolTip(effect.help);
    check->setMinimumHeight(row_height_px);
    QPalette boxed = tinted;
    boxed.setColor(QPalette::Window, c.control_edge.lighter(140));  // the style draws the box darker than this
    check->setPalette(boxed);
    connect(check, &QCheckBox::clicked, this, [this, id = effect.id](bool on) { emit effect_toggled(id, on); });
    layout->addWidget(check);
  }
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) add_parameter(effect, static_cast<int>(i), box);
  if (effect.can_hold) {
    auto* hold = new QPushButton(effect.is_held ? tr("Estimate it again") : tr("Hold these numbers"), box);
    hold->setObjectName(QStringLiteral("hold_") + effect.id);
    hold->setMinimumHeight(row_height_px);
    hold->setToolTip(effect.is_held ? tr("The fit may move the numbers again, from where they are")
                                    : tr("The fit leaves the numbers where they are; then they can be typed"));
    connect(hold, &QPushButton::clicked, this,
            [this, id = effect.id, held = effect.is_held] { emit effect_held(id, !held); });
    layout->addWidget(hold, 0, Qt::AlignLeft);
  }
  if (!effect.note.isEmpty()) {
    auto* note = new QLabel(effect.note, box);
    note->setWordWrap(true);
    note->setFont(text_font(TextRole::small));
    QPalette inks = palette();
    inks.setColor(QPalette::WindowText, effect.note_is_warning ? c.care : c.ink2);
    note->setPalette(inks);
    note->setForegroundRole(QPalette::WindowText);
    layout->addWidget(note);
  }
  return box;
}

void ModelPanel::add_parameter(const ModelEffect& effect, int index, QWidget* box) {
  const ModelParameter& parameter = effect.parameters[static_cast<std::size_t>(index)];
  const bool is_selected = !parameter.of.isEmpty() && parameter.of == selected_joint_;
  auto* row = new ParameterRow(parameter, effect.is_candidate, is_selected, box);
  row->setProperty("joint", parameter.of);
  row->installEventFilter(this);
  if (!parameter.of.isEmpty()) row->setCursor(Qt::PointingHandCursor);
  box->layout()->addWidget(row);
  const QString whose = (parameter.of + ' ' + parameter.name).trimmed();
  if (QToolButton* hold = row->hold()) {
    hold->setObjectName(QStringLiteral("hold_%1_%2").arg(effect.id).arg(index));
    hold->setAccessibleName(tr("Hold %1").arg(whose));
    connect(hold, &QToolButton::clicked, this,
            [this, id = effect.id, index](bool held) { emit number_held(id, index, held); });
  }
  QLineEdit* field = row->field();
  if (!field) return;
  field->setObjectName(QStringLiteral("value_%1_%2").arg(effect.id).arg(index));
  field->setAccessibleName(whose);
  connect(field, &QLineEdit::editingFinished, this, [this, field, id = effect.id, index, before = field->text()] {
    bool is_number = false;
    const double value = with_decimal_point(field->text()).toDouble(&is_number);
    if (!is_number) return field->setText(before);
    if (field->text() != before) emit value_typed(id, index, value);
  });
}

void ModelPanel::rebuild() {
  QWidget* focused = content_->isAncestorOf(focusWidget()) ? focusWidget() : nullptr;
  const QString focus = focused ? focused->objectName() : QString();
  // A number that is being typed is neither taken nor lost because the rows come anew.
  auto* typing = qobject_cast<QLineEdit*>(focused);
  const QString typed = typing && typing->isModified() ? typing->text() : QString();
  const int cursor = typing ? typing->cursorPosition() : 0;
  for (QLineEdit* field : content_->findChildren<QLineEdit*>()) field->blockSignals(true);
  // Else the focus would wander from row to row as they go, and the panel would scroll after it.
  if (focused) focused->clearFocus();
  while (QLayoutItem* item = list_->takeAt(0)) {
    if (item->widget()) {
      // A check box's own click may be what led here: it must outlive its signal.
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
  for (const ModelEffect& effect : effects_)
    if (effect.is_in_model || effect.group.isEmpty()) list_->addWidget(make_effect(effect));
  add_groups();
  if (effects_.empty()) {
    auto* empty = new QLabel(empty_text_, content_);
    empty->setWordWrap(true);
    list_->addWidget(empty);
  }
  list_->addStretch(1);
  refresh_texts();
  if (focus.isEmpty()) return;
  for (int i = list_->count(); i-- > 0;)
    if (QWidget* box = list_->itemAt(i)->widget())
      if (auto* again = box->findChild<QWidget*>(focus)) {
        again->setFocus();
        auto* field = qobject_cast<QLineEdit*>(again);
        if (!field || typed.isEmpty()) return;
        field->setText(typed);
        field->setModified(true);
        field->setCursorPosition(cursor);
        return;
      }
}

bool ModelPanel::is_group_folded(const QString& group) const {
  const auto choice = group_choices_.find(group);
  if (choice != group_choices_.end()) return *choice;
  return std::all_of(effects_.begin(), effects_.end(),
                     [&](const ModelEffect& e) { return e.group != group || e.is_in_model || e.is_out_of_sight; });
}

/// Under each heading what is not in the model.
void ModelPanel::add_groups() {
  QStringList groups;
  for (const ModelEffect& e : effects_)
    if (!e.is_in_model && !e.group.isEmpty() && !groups.contains(e.group)) groups << e.group;
  for (const QString& group : groups) {
    const bool folded = is_group_folded(group);
    auto* head = new QToolButton(content_);
    head->setObjectName(QStringLiteral("group_") + group);
    head->setAutoRaise(true);
    head->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    head->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    head->setMinimumHeight(row_height_px);
    QFont font = text_font(TextRole::body);
    font.setWeight(QFont::DemiBold);
    head->setFont(font);
    const auto count = std::count_if(effects_.begin(), effects_.end(),
                                     [&](const ModelEffect& e) { return !e.is_in_model && e.group == group; });
    head->setText(folded ? tr("%1 (%2)").arg(group).arg(count) : group);
    head->setAccessibleName(folded ? tr("Show %1").arg(group) : tr("Fold %1 away").arg(group));
    connect(head, &QToolButton::clicked, this, [this, group, folded] {
      group_choices_[group] = !folded;
      rebuild();
    });
    head->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // a long name must not widen the list
    list_->addWidget(head);
    if (folded) continue;
    for (const ModelEffect& e : effects_)
      if (!e.is_in_model && e.group == group) list_->addWidget(make_effect(e));
  }
}

bool ModelPanel::eventFilter(QObject* watched, QEvent* event) {
  const QString joint = watched->property("joint").toString();
  if (event->type() == QEvent::MouseButtonRelease && !joint.isEmpty()) {
    emit joint_selected(joint);
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

void ModelPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && list_) rebuild();
  QFrame::changeEvent(event);
}

}  // namespace handsight::widgets
