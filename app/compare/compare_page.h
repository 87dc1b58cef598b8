// SPDX-License-Identifier: GPL-3.0-or-later
// A second session, or a calibration, beside the one that is open: what has changed, and the same plots for both. It
// takes the place of a workspace; the open session stays as it is.
#pragma once

#include <array>

#include "compare/comparing.h"
#include "workbench/workspace.h"

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
  void compare_with(const std::filesystem::path& other);
  /// Asks for the other one.
  void choose();
  /// Has anything been chosen for the session that is open?
  bool has_other() const { return !other_.empty(); }
  /// What is shown; null: nothing yet.
  const ComparedPair* shown() const { return pair_.get(); }

 signals:
  void close_requested();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_layout();
  QWidget* make_head();
  QWidget* make_lists();
  QWidget* make_clouds();
  QWidget* make_convergence();
  QWidget* make_patterns();
  void start();
  void swap();
  void clear();
  void show_pair(std::shared_ptr<const ComparedPair> pair);
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

  std::filesystem::path other_;
  bool other_is_later_ = false;
  std::shared_ptr<const ComparedPair> pair_;
  std::int64_t revision_ = 0;  // of the document when it was compared
  bool is_running_ = false, is_stopped_ = false;
  Verdict verdict_ = Verdict::none;
  QLabel *names_, *said_, *more_, *empty_;
  QPushButton *choose_, *swap_, *again_, *close_, *choose_first_;
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
