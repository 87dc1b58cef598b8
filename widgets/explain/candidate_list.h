// SPDX-License-Identifier: GPL-3.0-or-later
// The cards of what may be missing, best first, in a scroll area.
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/explain/candidate_card.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace handsight::widgets {

/// fresh: of a new version of the model, in the order given. kept: news of the same version: cards that are there stay
/// in their places, new ones come below, and a chip offers to sort again.
enum class CardOrder { fresh, kept };

enum class FootPlace { before_why_not, after_why_not };

class CandidateList : public QWidget {
  Q_OBJECT
 public:
  explicit CandidateList(QWidget* parent = nullptr);
  void set_cards(std::vector<CardState> cards, CardOrder order);
  void set_previewed(const QString& id);  // the card that is shown as tried; empty: none
  void set_empty_text(const QString& sentence);
  void set_can_add(bool can_add);                                      // false while a fit runs
  void set_measured_note(const QString& id, const QString& sentence);  // why what was typed was not taken
  CandidateCard* card(int index) const;
  int count() const { return static_cast<int>(cards_.size()); }
  std::vector<QString> shown() const;  // ids in the order shown
  QPushButton* resort_chip() const { return resort_; }
  QPushButton* why_not_button() const { return why_not_; }
  /// Adds the first card that can be added, and names it. Always there, below the cards, in the same place.
  QPushButton* add_button() const { return add_; }
  /// A button in the row below the cards: Add | ... | Why not ...? | ...
  void add_at_foot(QWidget* widget, FootPlace place);
  QSize sizeHint() const override;

 signals:
  void preview(const QString& id);
  void preview_ended(const QString& id);
  void add(const QString& id);
  void show_poses(const QString& id);
  void what_if(const QString& id);
  void action(const QString& action_id);
  void measured(const QString& id, const QString& text);
  void why_not_requested();  // the table of all effects

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_cards(const std::vector<CardState>& in_order);
  CandidateCard* make_card();
  void mark_main();
  void resort();
  void let_go(const QString& id);

  std::vector<CandidateCard*> cards_;
  std::vector<CardState> wanted_;
  std::vector<QString> attended_;  // hovered or focused, the latest last: a card may have both, or two have one each
  bool can_add_ = true;
  QLabel *title_, *empty_;
  void show_add();
  void lay_out_foot();
  const CandidateCard* first_to_add() const;

  QPushButton *resort_, *why_not_, *add_;
  QHBoxLayout *foot_, *second_foot_;
  std::vector<QWidget*> at_foot_;
  bool has_second_foot_ = false;
  int longest_add_ = 0;  // px, of the main button
  QScrollArea* scroll_;
  QWidget* content_;
  QVBoxLayout* list_;
};

}  // namespace handsight::widgets
