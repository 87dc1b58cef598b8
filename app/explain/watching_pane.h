// SPDX-License-Identifier: GPL-3.0-or-later
// The lower row: the staircase, the versions or the running fit; the residual cloud before and after; the robot as the
// model bends it.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "document/stairs_memory.h"
#include "explain/adding.h"
#include "explain/expecting.h"
#include "widgets/explain/staircase.h"

class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QStackedWidget;

namespace handsight::widgets {
class BillList;
class CostCurve;
class RobotView;
class VersionList;
}  // namespace handsight::widgets

namespace handsight::app {

class WatchingPane : public QWidget {
  Q_OBJECT

 public:
  WatchingPane(Workbench& workbench, Adding& adding, QWidget* parent = nullptr);

  /// The versions, the cloud and the robot of the model that is shown.
  void refresh();
  /// Adding has come to its end: the versions with the bill of what is in the model, and what to expect of it.
  void show_bill();
  /// The same where something has been found out of it.
  void refresh_bill();
  /// Writes down the errors of the versions, for the next start and for versions that the document forgets.
  void remember();
  /// A candidate on trial: its residuals, its bending, the step that it would be. Null: nothing.
  void set_prediction(const ModelResiduals* residuals, const CandidateView* view, const Eigen::VectorXd& numbers,
                      const std::vector<EffectTerm>& terms, const QString& name);
  /// The robot in a posture that was not taken.
  void show_posture(const Eigen::VectorXd& position);
  void show_robot();

  /// The versions that are compared; null: none are marked.
  ModelVersionPointer compared_a() const { return version_at(a_); }
  ModelVersionPointer compared_b() const { return version_at(b_); }
  void set_blinking(bool blinking);

 signals:
  void version_chosen(const ModelVersionPointer& version);

 private:
  struct Row {
    ModelVersionPointer version;  // null: refused
    const Refusal* refusal = nullptr;
    int index = 0;                            // of the undo stack
    const RememberedStair* memory = nullptr;  // of a start before: its error alone is known
  };
  enum Tab { tab_stairs, tab_versions, tab_fit };
  void make_layout();
  void connect_all();
  void refresh_rows();
  void refresh_cloud();
  void choose_tab(int tab);
  std::vector<widgets::CloudPoint> in_unit(std::vector<widgets::CloudPoint> points) const;
  void compare(int a, int b);
  void take_back(int row);
  void began(const QString& what);
  void ended(AdditionEnd end);
  void picture(const FitPicture& picture);
  void bend(double share);  // of the way from one picture of a fit to the next
  void set_ghost(const std::vector<Rigid>& bent);
  ModelVersionPointer version_at(int row) const;
  const RememberedStair* find_memory(int index) const;
  int selected_index() const;  // the selected observation, into Session::observations

  Workbench& workbench_;
  Adding& adding_;
  Expecting expecting_;
  std::vector<RememberedStair> memory_;  // of this session's versions, from before it was opened and since
  std::vector<Row> rows_;
  int a_ = -1, b_ = -1;
  bool robot_is_set_ = false;
  std::vector<Rigid> straight_;  // links without the model's effects
  double magnification_ = 1;
  double cloud_scale_ = 1;  // from px (mm) to the cloud's unit
  std::vector<Rigid> bent_from_, bent_to_, bent_now_;
  QVariantAnimation bending_;
  QElapsedTimer since_robot_;
  QButtonGroup* tabs_;
  QStackedWidget* left_;
  widgets::Staircase* stairs_;
  widgets::VersionList* versions_;
  widgets::BillList* bill_;
  widgets::CostCurve* cost_;
  widgets::ResidualCloud* cloud_;
  widgets::RobotView* robot_;
  QLabel* robot_title_;
  QHBoxLayout* columns_;
};

}  // namespace handsight::app
