// SPDX-License-Identifier: GPL-3.0-or-later
// "What is missing": the cards; behind them the table of all effects, poses that would tell, and the truth.
#pragma once

#include <QWidget>

#include "explain/adding.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace handsight::widgets {
class CandidateList;
class EffectTable;
class TruthPanel;
}  // namespace handsight::widgets

namespace handsight::app {

class AddingOn;
class PosesPane;

class MissingPane : public QWidget {
  Q_OBJECT

 public:
  MissingPane(Workbench& workbench, Adding& adding, QWidget* parent = nullptr);

  /// The cards of the present diagnosis, or what is waited for.
  void refresh();
  void show_cards();
  void show_poses(const std::string& id);
  void show_why_not();
  /// What was hidden in a session that knows it, beside what was found.
  void reveal();
  bool can_reveal() const;
  /// As the button of that name; nothing where there is nothing to add.
  void add_until_it_stops();
  /// Does adding rest, so that what was added last can be looked at?
  bool is_paused() const;
  widgets::CandidateList* cards() const { return cards_; }
  PosesPane* poses() const { return poses_; }

 signals:
  void tried(const QString& id);  // empty: no longer
  void what_if(const QString& id);
  void curve_wanted();
  void export_wanted();
  void look_wanted();
  void added_until_it_stopped();

 private:
  void make_layout();
  void make_until_it_stops();
  /// What the button does, and whether there is something to do.
  void show_until_it_stops();
  void refresh_cards();
  void connect_all();
  void refresh_truth();
  void explain_row(const QString& id);
  QWidget* page_with_way_back(QWidget* content, const QString& title, const char* name);

  Workbench& workbench_;
  Adding& adding_;
  AddingOn* adding_on_;
  QPushButton *until_it_stops_, *pause_;
  ModelVersionPointer shown_for_;  // the version that the cards are of
  QStackedWidget* pages_;
  widgets::CandidateList* cards_;
  widgets::EffectTable* table_;
  widgets::TruthPanel* truth_;
  PosesPane* poses_;
  QLabel* row_reason_;
  std::vector<widgets::EffectRow> rows_;
  QWidget *table_page_, *truth_page_;
};

}  // namespace handsight::app
