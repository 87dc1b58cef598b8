// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/goals_form.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "base/numbers.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"

namespace handsight::app {
namespace {

QDoubleSpinBox* number_field(const char* name, double value, double least, double most, int decimals,
                             const QString& unit, QWidget* parent) {
  auto* field = new QDoubleSpinBox(parent);
  field->setObjectName(name);
  field->setDecimals(decimals);
  field->setRange(least, most);
  field->setValue(value);
  field->setSuffix(unit);
  field->setMinimumHeight(widgets::control_height);
  field->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the page
  return field;
}

QCheckBox* box_of(const char* name, const QString& text, bool is_on, QWidget* field, QWidget* parent) {
  auto* box = new QCheckBox(text, parent);
  box->setObjectName(name);
  box->setChecked(is_on);
  field->setEnabled(is_on);
  QObject::connect(box, &QCheckBox::toggled, field, &QWidget::setEnabled);
  return box;
}

}  // namespace

GoalsForm::GoalsForm(QWidget* parent) : QWidget(parent) {
  hand_mm_ = number_field("goal_hand_mm", 0.5, 0.01, 100, 2, tr(" mm"), this);
  odds_value_ = number_field("goal_odds_value", 20, 2, 1e6, 0, tr(" to one"), this);
  minutes_ = number_field("goal_minutes", 30, 0.1, 1e4, 1, tr(" min"), this);
  speed_ = number_field("experiment_speed", 0.2, 0.001, 10, 3, tr(" rad/s"), this);
  speed_->setToolTip(tr("Of the fastest joint (m/s where it slides); the first move takes a tenth of it"));
  poses_ = new QSpinBox(this);
  poses_->setObjectName("goal_poses");
  poses_->setRange(1, 10000);
  poses_->setValue(60);
  poses_->setMinimumHeight(widgets::control_height);
  poses_->setFocusPolicy(Qt::StrongFocus);
  hand_ = box_of("goal_hand", tr("the hand is known within"), false, hand_mm_, this);
  hand_->setToolTip(tr("In 95 of 100 cases, in 95 of 100 poses over what can be reached and seen"));
  odds_ = box_of("goal_odds", tr("one cause, or none, by odds of"), true, odds_value_, this);
  count_ = box_of("goal_count", tr("poses, at most"), true, poses_, this);
  time_ = box_of("goal_time", tr("time, at most"), false, minutes_, this);
  box_ = new QLineEdit(this);
  box_->setObjectName("experiment_box");
  box_->setPlaceholderText(tr("everywhere"));
  box_->setToolTip(tr("Two corners of a box in the root's frame, x y z x y z in m: where the hand is to be known"));
  cell_ = new QLineEdit(this);
  cell_->setObjectName("experiment_cell");
  cell_->setPlaceholderText(tr("the floor alone"));
  cell_->setToolTip(tr("A file cell.xml with what stands about the robot: boxes and planes (docs/experiment.md)"));
  choose_ = new QPushButton(QStringLiteral("…"), this);  // the room is the file's
  choose_->setObjectName("experiment_choose_cell");
  choose_->setAccessibleName(tr("Choose…"));
  choose_->setFixedWidth(36);
  connect(choose_, &QPushButton::clicked, this, &GoalsForm::choose_cell);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  int row = 0;
  for (const auto& [check, field] : std::initializer_list<std::pair<QWidget*, QWidget*>>{
           {hand_, hand_mm_}, {odds_, odds_value_}, {count_, poses_}, {time_, minutes_}}) {
    grid->addWidget(check, row, 0);
    grid->addWidget(field, row++, 1, 1, 2);
  }
  const auto named = [&](const QString& text, QWidget* field, int columns) {
    auto* label = new QLabel(text, this);
    label->setBuddy(field);
    grid->addWidget(label, row, 0);
    grid->addWidget(field, row++, 1, 1, columns);
  };
  named(tr("speed"), speed_, 2);
  named(tr("where the hand works"), box_, 2);
  named(tr("what stands about"), cell_, 1);
  grid->addWidget(choose_, row - 1, 2);
  grid->setColumnStretch(1, 1);
}

Goals GoalsForm::until() const {
  Goals goals;
  if (hand_->isChecked()) goals.hand = 1e-3 * hand_mm_->value();
  if (odds_->isChecked()) goals.odds = odds_value_->value();
  if (count_->isChecked()) goals.count = poses_->value();
  if (time_->isChecked()) goals.seconds = 60 * minutes_->value();
  if (!goals.wants_something() && !goals.seconds) goals.count = poses_->value();  // nothing goes on for ever
  return goals;
}

bool GoalsForm::has_box() const { return !box_->text().trimmed().isEmpty(); }

double GoalsForm::speed() const { return speed_->value(); }

std::optional<WorkBox> GoalsForm::box() const {
  const std::string text = widgets::with_decimal_point(box_->text().trimmed()).toStdString();
  if (text.empty()) return std::nullopt;
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != 6)
    throw InputError("Where the hand works: expected six numbers, x y z x y z of two corners of a box in m.");
  const Vector3 a((*numbers)[0], (*numbers)[1], (*numbers)[2]), b((*numbers)[3], (*numbers)[4], (*numbers)[5]);
  return WorkBox{a.cwiseMin(b), a.cwiseMax(b)};
}

ExperimentOptions GoalsForm::options() const {
  ExperimentOptions options;
  options.until = until();
  options.speed = speed();
  options.box = box();
  if (const QString cell = cell_->text().trimmed(); !cell.isEmpty()) options.cell = read_cell(cell.toStdString());
  return options;
}

void GoalsForm::set_places_enabled(bool enabled) {
  for (QWidget* w : std::initializer_list<QWidget*>{box_, cell_, choose_}) w->setEnabled(enabled);
}

void GoalsForm::choose_cell() {
  auto* dialog = new QFileDialog(this, tr("What stands about the robot"), {}, tr("Cells (*.xml)"));
  dialog->setObjectName("cell_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, cell_, &QLineEdit::setText);
  dialog->open();
}

}  // namespace handsight::app
