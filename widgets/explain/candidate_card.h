// SPDX-License-Identifier: GPL-3.0-or-later
// A card of what may be missing in the model, or an honest one that says why there is nothing to add.
#pragma once

#include <QFrame>
#include <optional>
#include <string>
#include <vector>

#include "widgets/lists/model_panel.h"

class QLineEdit;
class QPushButton;

namespace handsight::widgets {

enum class CardKind { candidate, adequate, unexplained, ambiguous, too_few, scatter, noise_unknown };

/// Error left beside today's and the noise, in `unit`.
struct ErrorLeft {
  std::optional<double> now, left, noise;
  bool is_predicted = false;  // not fitted in full: the bar is dashed
  QString unit = "px";
};

/// A check with the real robot as numbers: predicted, measured, and what that says.
struct CardCheck {
  QString prediction;  // "In the pose of observation 37 1 kg makes the hand drop by 1.40 ± 0.20 mm more than ..."
  QString unit;        // of what is typed
  QString measured;    // "1.30 ± 0.05"; empty: nothing yet
  QString answer;      // "Inside: 0.5 sigma from the prediction. That speaks for this cause."
  bool is_inside = false;
};

struct CardState {
  QString id;  // what signals say; unique in the list
  CardKind kind = CardKind::candidate;
  std::string effect;  // of the catalogue, for the drawing; empty: the unnamed curve
  QString title;       // "Joint elasticity"
  QString where;       // "arm_2, arm_4"
  QString words;       // what it is; of an honest card its sentence
  ErrorLeft error;
  QString evidence;                   // "Follows the gravity torque of arm_2; chance would show this once in 10,000."
  std::vector<ModelParameter> sizes;  // value with sigma against what is plausible
  QString cannot_be_told_from;        // "payload, base tilt"; empty: nothing
  QString check;                      // a cheap check with the robot
  std::optional<CardCheck> check_number;
  QString caution;  // "The fit wants 4 kg; 1 kg is plausible."
  bool can_add = true;
  QString why_not;  // where it cannot be added: the button's tool tip, and shown
  bool can_what_if = true, can_show_poses = false;
  QString action, action_id;  // an honest card's button: text and what the signal says; empty: none
};

/// At least 168 px high. Hover or focus inside asks for a preview; Enter on the card, or its button, adds.
class CandidateCard : public QFrame {
  Q_OBJECT
 public:
  explicit CandidateCard(QWidget* parent = nullptr);
  void set_state(CardState state);
  void set_main(bool is_main);  // the one main action of the list
  void set_previewed(bool previewed);
  const CardState& state() const { return state_; }
  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QPushButton* add_button() const { return add_; }
  QPushButton* poses_button() const { return poses_; }
  QPushButton* what_if_button() const { return what_if_; }
  QPushButton* action_button() const { return action_; }
  QLineEdit* measured_field() const { return measured_; }
  /// Why what was typed was not taken; until it is typed again.
  void set_measured_note(const QString& sentence);

 signals:
  void preview(const QString& id);
  void preview_ended(const QString& id);
  void add(const QString& id);
  void show_poses(const QString& id);
  void what_if(const QString& id);
  void action(const QString& action_id);
  void measured(const QString& id, const QString& text);  // typed; empty: it is to be forgotten

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place_buttons();
  void show_check(const std::optional<CardCheck>& before);
  void take_measured();
  void look_at_attention();  // hover or focus came or went

  CardState state_;
  bool is_main_ = false, is_previewed_ = false, is_hovered_ = false, is_attended_ = false;
  QPushButton *add_ = nullptr, *what_if_ = nullptr, *poses_ = nullptr, *action_ = nullptr;
  QLineEdit* measured_ = nullptr;
};

}  // namespace handsight::widgets
