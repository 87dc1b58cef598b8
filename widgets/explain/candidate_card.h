// SPDX-License-Identifier: GPL-3.0-or-later
// A card of what may be missing in the model, or an honest one that says why there is nothing to add.
#pragma once

#include <QFrame>
#include <QPoint>
#include <optional>

#include "widgets/explain/card_state.h"

class QLineEdit;
class QPushButton;

namespace handsight::widgets {

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
  void leaveEvent(QEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void moveEvent(QMoveEvent* event) override;
  void showEvent(QShowEvent* event) override;
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
  void pointed_at(const QMouseEvent& move);

  CardState state_;
  /// Where the pointer lay while the card came to lie below it: until it moves, nobody points at the card.
  std::optional<QPoint> resting_pointer_;
  bool is_main_ = false, is_previewed_ = false, is_hovered_ = false, is_attended_ = false;
  QPushButton *add_ = nullptr, *what_if_ = nullptr, *poses_ = nullptr, *action_ = nullptr;
  QLineEdit* measured_ = nullptr;
};

}  // namespace handsight::widgets
