// SPDX-License-Identifier: GPL-3.0-or-later
// Another session, several, or a calibration beside the one that is open, or the sessions of a collection beside each
// other: what has changed, and the same plots for two of them. It takes the place of a workspace; what is open stays as
// it is.
#pragma once

#include <array>

#include "compare/comparing.h"
#include "compare/comparing_several.h"
#include "workbench/workspace.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSplitter;
class QTableWidget;
class QTabWidget;

namespace handsight::widgets {
class ConvergencePlot;
class PatternPage;
class ResidualCloud;
}  // namespace handsight::widgets

namespace handsight::app {

class ComparePage : public Workspace {
  Q_OBJECT

 public:
  ComparePage(Workbench& workbench, QWidget* parent);

  WorkStatus status() const override { return {}; }
  Panel panel() const override { return Panel::folded; }
  void activate() override;

  /// Compares the open session with this one (a session's folder or file, or a calibration), as they stand now.
  void compare_with(const std::filesystem::path& other) { compare_with(std::vector{other}); }
  /// The same with several, the earliest first. None: the sessions of the collection that is open.
  void compare_with(std::vector<std::filesystem::path> others);
  /// Asks for the others; the sessions of a collection are compared with each other.
  void choose();
  /// Has anything been chosen for the session that is open?
  bool has_other() const { return is_chosen_; }
  /// What is shown; null: nothing yet.
  const ComparedPair* shown() const { return pair_.get(); }
  /// All of three and more, of which `shown` are two; null: there are two alone.
  const ComparedSeveral* all_shown() const { return several_.get(); }

 signals:
  void close_requested();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_layout();
  QWidget* make_head();
  QWidget* make_lists();
  QWidget* make_which();
  QWidget* make_clouds();
  QWidget* make_convergence();
  QWidget* make_patterns();
  void start();
  void start_pair();
  void start_several();
  void failed(const QString& sentence);
  QString others_text() const;
  void swap();
  void clear();
  void show_pair(std::shared_ptr<const ComparedPair> pair);
  void show_several(std::shared_ptr<const ComparedSeveral> several);
  void show_sides(int before, int after);
  void refresh_several_lists();
  void show_sentence(const QString& sentence, bool is_refusal);
  void refresh();
  void refresh_names();
  void refresh_lists();
  void refresh_clouds();
  void refresh_convergence();
  void refresh_patterns();
  void fit_to_height();
  void tint();

  enum class Verdict { none, same, changed, refused };

  std::vector<std::filesystem::path> others_;
  bool is_chosen_ = false, other_is_later_ = false;
  std::shared_ptr<const ComparedPair> pair_;
  std::shared_ptr<const ComparedSeveral> several_;
  std::vector<std::array<int, 2>> sides_of_rows_;  // of changes_: the sessions that it lies between; -1: none
  std::int64_t revision_ = 0;                      // of the document when it was compared
  bool is_running_ = false, is_stopped_ = false;
  Verdict verdict_ = Verdict::none;
  QLabel *names_, *said_, *more_, *empty_;
  QPushButton *choose_, *swap_, *again_, *close_, *choose_first_;
  QWidget* which_;  // of several: the two whose plots are shown
  std::array<QComboBox*, 2> shown_sides_{};
  QWidget* verdict_box_;
  QSplitter* body_;
  QTableWidget *changes_, *numbers_;
  QLabel *changes_title_, *numbers_title_;
  QTabWidget* tabs_;
  widgets::ResidualCloud* cloud_;
  std::array<widgets::ConvergencePlot*, 4> plots_{};  // position before, after; rotation before, after
  std::array<QLabel*, 2> sides_{};                    // above the patterns of each
  std::array<widgets::PatternPage*, 2> patterns_{};
};

}  // namespace handsight::app
