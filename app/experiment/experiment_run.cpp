// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/experiment_run.h"

#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>

#include "experiment/driver/child_driver.h"
#include "experiment/loop/driven_joints.h"
#include "experiment/watched_robot.h"
#include "session/edit.h"
#include "words/core_words.h"

namespace handsight::app {

/// The run's thread asks and waits, the window's answers.
struct ExperimentRun::Talk {
  std::atomic<bool> stop{false}, is_abandoned{false};

  /// Nothing where the run was given up while it waited.
  template <class Answer>
  std::optional<Answer> wait_for(std::optional<Answer>& answer, bool ends_at_stop) {
    std::unique_lock lock(mutex);
    const auto is_over = [&] { return is_abandoned || (ends_at_stop && stop); };
    while (!answer && !is_over()) changed.wait_for(lock, std::chrono::milliseconds(20));
    return std::exchange(answer, std::nullopt);
  }
  template <class Answer>
  void give(std::optional<Answer>& answer, const Answer& given) {
    const std::lock_guard lock(mutex);
    answer = given;
    changed.notify_all();
  }

  struct Start {
    bool is_wanted = false;
    Goals until;
    double speed = 0;
  };
  std::optional<Start> start;
  std::optional<bool> is_written;

 private:
  std::mutex mutex;
  std::condition_variable changed;
};

/// A new observation, and those before it that are decided otherwise by now.
struct ExperimentRun::Arrived {
  std::shared_ptr<const Session> session;
  Observation measured;
  std::vector<Observation> decided;  // the new one among them
};

namespace {

/// Those whose decision is another one than it was.
class Decisions {
 public:
  explicit Decisions(const Session& session) {
    for (const Observation& o : session.observations) known_[o.id] = {o.decision, o.reason};
  }
  std::vector<Observation> changed(const Session& session) {
    std::vector<Observation> all;
    for (const Observation& o : session.observations) {
      const std::pair<Decision, std::string> now{o.decision, o.reason};
      if (const auto found = known_.find(o.id); found != known_.end() && found->second == now) continue;
      known_[o.id] = now;
      all.push_back(o);
    }
    return all;
  }

 private:
  std::map<std::int64_t, std::pair<Decision, std::string>> known_;
};

}  // namespace

ExperimentRun::ExperimentRun(Workbench& workbench, QObject* parent) : QObject(parent), workbench_(workbench) {
  connect(&workbench.document, &Document::closing, this, &ExperimentRun::abandon);
}

ExperimentRun::~ExperimentRun() { abandon(); }

bool ExperimentRun::is_driving() const {
  return state_ == RunState::moving || state_ == RunState::looking || (state_ == RunState::thinking && may_move_) ||
         state_ == RunState::stopping;
}

bool ExperimentRun::is_of_touches() const {
  return workbench_.document.is_open() && workbench_.document.session().is_touch();
}

void ExperimentRun::set_state(RunState state) {
  if (state == state_) return;
  state_ = state;
  emit state_changed();
}

/// What the run's thread does. Everything is reported in the window's thread, as long as this run is the one that is
/// on.
class ExperimentRun::Work {
 public:
  Work(ExperimentRun& run, RunWish wish)
      : run_(run), talk_(run.talk_), wish_(std::move(wish)), session_(run.workbench_.document.shared_session()) {}

  std::shared_ptr<const ExperimentResult> operator()(JobControl& control) {
    ExperimentOptions options = wish_.options;
    options.save = false;  // the document's journal has it before the robot moves on
    options.is_interrupted = [talk = talk_, &control] {
      return talk->stop || talk->is_abandoned || control.is_cancelled();
    };
    listen(options);
    if (wish_.prepare) wish_.prepare(*session_, options);
    ChildDriver driver(wish_.command.toStdString(), *session_, {}, options.is_interrupted);
    WatchedRobot robot(driver, watch());
    return std::make_shared<const ExperimentResult>(run_experiment(*session_, robot, options));
  }

 private:
  template <class What>
  void tell(What what) const {
    QMetaObject::invokeMethod(
        &run_,
        [&run = run_, talk = talk_, what = std::move(what)] {
          if (talk == run.talk_) what(run);
        },
        Qt::QueuedConnection);
  }
  void show(RunState state) const {
    tell([state](ExperimentRun& run) {
      if (run.state_ != RunState::stopping) run.set_state(state);
    });
  }
  void listen(ExperimentOptions& options);
  RobotWatch watch();
  void greet(const DriverHello& hello);
  void arrive(const Session& session, const Observation& one);

  ExperimentRun& run_;
  std::shared_ptr<Talk> talk_;
  RunWish wish_;
  std::shared_ptr<const Session> session_;
  Decisions decisions_{*session_};
  std::optional<JointOrder> order_;
  std::optional<Eigen::VectorXd> stands_at_;  // of the last move
};

void ExperimentRun::Work::greet(const DriverHello& hello) {
  order_ = joint_order(*session_, hello);
  const Eigen::VectorXd at =
      hello.position ? order_->to_session(*hello.position) : session_->observations.back().position;
  tell([at, name = QString::fromStdString(hello.name)](ExperimentRun& run) {
    run.driver_name_ = name;
    emit run.stood(at);
  });
  show(RunState::thinking);
}

RobotWatch ExperimentRun::Work::watch() {
  RobotWatch watch;
  watch.greeted = [this](const DriverHello& hello) { greet(hello); };
  watch.moving = [this](const std::vector<Eigen::VectorXd>& path, double speed) {
    std::vector<Eigen::VectorXd> own;
    for (const Eigen::VectorXd& point : path) own.push_back(order_->to_session(point));
    tell([own, speed](ExperimentRun& run) { emit run.moving(own, speed); });
    show(RunState::moving);
  };
  watch.stood = [this](const MoveAnswer& answer) {
    if (!answer.ok || answer.position.size() != static_cast<Eigen::Index>(order_->place_in_driver.size())) return;
    stands_at_ = order_->to_session(answer.position);
    tell([at = *stands_at_](ExperimentRun& run) { emit run.stood(at); });
  };
  watch.looking = [this] { show(RunState::looking); };
  watch.touching = [this](const TouchRequest& request) {
    tell([at = order_->to_session(request.position)](ExperimentRun& run) { emit run.feeling(at); });
    show(RunState::looking);
  };
  watch.went_back = [this] {
    if (stands_at_) tell([at = *stands_at_](ExperimentRun& run) { emit run.stood(at); });
  };
  watch.halted = [this] { tell([](ExperimentRun& run) { run.set_state(RunState::halted); }); };
  return watch;
}

void ExperimentRun::Work::listen(ExperimentOptions& options) {
  options.on_plan = [this](const std::vector<PlannedMove>& moves) {
    tell([moves](ExperimentRun& run) { emit run.planned(moves); });
  };
  options.confirm = [this, &options](const std::vector<PlannedMove>&) {
    show(RunState::asking);
    const std::optional<Talk::Start> start = talk_->wait_for(talk_->start, true);
    if (!start || !start->is_wanted) return false;
    options.until = start->until;
    options.speed = start->speed;
    return true;
  };
  options.on_step = [this](const ExperimentStep& step) {
    tell([step](ExperimentRun& run) { emit run.stepped(step); });
    show(RunState::thinking);
  };
  options.on_knowledge = [this](const Knowledge& known) {
    tell([shared = std::make_shared<const Knowledge>(known)](ExperimentRun& run) { emit run.learned(shared); });
  };
  options.on_note = [this](const Message& text) {
    tell([text](ExperimentRun& run) { emit run.noted(translated(text)); });
  };
  options.on_observation = [this](const Session& session, const Observation& one) { arrive(session, one); };
}

void ExperimentRun::Work::arrive(const Session& session, const Observation& one) {
  if (wish_.watch) wish_.watch(session, one);
  tell([arrived = Arrived{std::make_shared<const Session>(session), one, decisions_.changed(session)}](
           ExperimentRun& run) { run.take(arrived); });
  const std::optional<bool> is_written = talk_->wait_for(talk_->is_written, false);
  if (is_written && !*is_written) talk_->stop = true;
}

void ExperimentRun::begin(const RunWish& wish) {
  if (is_on() || !workbench_.document.is_open()) return;
  talk_ = std::make_shared<Talk>();
  may_move_ = false;
  driver_name_.clear();
  set_state(RunState::greeting);
  const auto end = [this, talk = talk_] {
    if (talk != talk_) return false;
    talk_.reset();
    set_state(RunState::resting);
    return true;
  };
  using Result = std::shared_ptr<const ExperimentResult>;
  jobs_.start<Result>(
      "experiment", tr("Experiment"),
      [work = std::make_shared<Work>(*this, wish)](JobControl& control) { return (*work)(control); },
      [this, end](const Result& result) {
        if (end()) emit ended(result);
      },
      [this, end](const QString& sentence) {
        if (end()) emit failed(sentence);
      });
}

void ExperimentRun::start(const Goals& until, double speed) {
  if (state_ != RunState::asking) return;
  may_move_ = true;
  set_state(RunState::thinking);
  talk_->give(talk_->start, Talk::Start{true, until, speed});
}

void ExperimentRun::refuse() {
  if (state_ == RunState::asking) talk_->give(talk_->start, Talk::Start{});
}

void ExperimentRun::stop() {
  if (!talk_) return;
  talk_->stop = true;
  if (state_ != RunState::halted) set_state(RunState::stopping);
}

void ExperimentRun::abandon() {
  if (!talk_) return;
  talk_->is_abandoned = true;
  talk_.reset();
  jobs_.cancel();
  set_state(RunState::resting);
}

void ExperimentRun::take(const Arrived& arrived) {
  const bool is_written = write_down(arrived);
  talk_->give(talk_->is_written, is_written);
  if (is_written) emit measured(arrived.session, arrived.measured.id);
}

/// An observation and its decision are one action to undo.
bool ExperimentRun::write_down(const Arrived& arrived) {
  Document& document = workbench_.document;
  if (document.find(arrived.measured.id)) {
    emit noted(tr("Observation %1 came from somewhere else meanwhile: the experiment stops.").arg(arrived.measured.id));
    return false;
  }
  const std::int64_t join = document.new_join();
  Observation undecided = arrived.measured;
  undecided.decision = Decision::none;
  undecided.reason = {};
  if (!document.perform(
          {.sentence = tr("measured observation %1").arg(undecided.id), .joins = join, .added = {undecided}}))
    return false;
  std::vector<std::pair<std::int64_t, EditableState>> after;
  for (const Observation& o : arrived.decided) {
    const Observation* own = document.find(o.id);
    if (own && own->decision != Decision::excluded) after.emplace_back(o.id, read_state(o));
  }
  Edit edit = document.make_edit(arrived.measured.decision == Decision::accepted
                                     ? tr("measured observation %1: taken").arg(undecided.id)
                                     : tr("measured observation %1: rejected").arg(undecided.id),
                                 after);
  edit.joins = join;
  return edit.is_empty() || document.perform(std::move(edit));
}

}  // namespace handsight::app
