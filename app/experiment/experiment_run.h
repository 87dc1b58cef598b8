// SPDX-License-Identifier: GPL-3.0-or-later
// One experiment that runs beside the window: core's loop in a thread of its own, its driver, and what is shown of
// both.
#pragma once

#include <QObject>
#include <memory>

#include "experiment/loop/experiment.h"
#include "workbench/workbench.h"

namespace handsight::app {

enum class RunState {
  resting,   // no driver
  greeting,  // the driver is begun and says hello
  thinking,  // poses are chosen, what was seen is fitted and diagnosed
  asking,    // poses are chosen and nothing has moved: start() or refuse()
  moving,
  looking,
  stopping,  // it was asked to stop, and has not answered yet
  halted,    // it stands still; what was seen is summed up
};

/// What is asked of a run before it begins.
struct RunWish {
  QString command;  // of the driver
  ExperimentOptions options;
  /// In the run's thread: before the driver is begun, and after each observation that was made.
  std::function<void(const Session&, ExperimentOptions&)> prepare;
  std::function<void(const Session&, const Observation&)> watch;
};

/// Signals come in the window's thread, positions and paths in the order of the session's joints. What is measured goes
/// into the document, one action each, written to its journal before the robot moves on.
class ExperimentRun : public QObject {
  Q_OBJECT

 public:
  explicit ExperimentRun(Workbench& workbench, QObject* parent = nullptr);
  ~ExperimentRun() override;

  /// Begins the driver and asks it; of the open session. Nothing while another run is on.
  void begin(const RunWish& wish);
  /// The answer to the one question, with the goals and the speed as they are by now.
  void start(const Goals& until, double speed);
  void refuse();
  /// Stands still as soon as it can, at any time.
  void stop();
  /// The session is gone: the robot stops, and nothing of the run is reported any more.
  void abandon();

  RunState state() const { return state_; }
  bool is_on() const { return state_ != RunState::resting; }
  /// Something may be moving, or may begin to by itself.
  bool is_driving() const;
  const QString& driver_name() const { return driver_name_; }
  /// Of the open session: a look is a touch.
  bool is_of_touches() const;

 signals:
  void state_changed();
  void stood(const Eigen::VectorXd& position);
  void planned(const std::vector<handsight::PlannedMove>& moves);
  void moving(const std::vector<Eigen::VectorXd>& path, double speed);
  /// From where it stands to the fixture, in the posture that is expected there; stood() tells that it is back.
  void feeling(const Eigen::VectorXd& touching);
  void stepped(const handsight::ExperimentStep& step);
  void measured(const std::shared_ptr<const handsight::Session>& session, qint64 id);
  void learned(const std::shared_ptr<const handsight::Knowledge>& known);
  void noted(const QString& sentence);
  void ended(const std::shared_ptr<const handsight::ExperimentResult>& result);
  /// It could not begin, or the session cannot be measured so.
  void failed(const QString& sentence);

 private:
  struct Talk;  // what the two threads share
  struct Arrived;
  class Work;
  void set_state(RunState state);
  void take(const Arrived& arrived);
  bool write_down(const Arrived& arrived);

  Workbench& workbench_;
  RunState state_ = RunState::resting;
  QString driver_name_;
  std::shared_ptr<Talk> talk_;  // of the run that is on
  bool may_move_ = false;       // it was started
  Jobs jobs_;                   // after what its work reports to: it dies first
};

}  // namespace handsight::app
