// SPDX-License-Identifier: Apache-2.0
// The figures of the real window, driven as a user drives it: start to first picture, selecting in a large session,
// playing, and how long the window takes to answer while a fit runs. Run it under with_display.sh.
#include <gtest/gtest.h>
#include <time.h>

#include <QApplication>
#include <QTabWidget>
#include <algorithm>
#include <cstring>
#include <fstream>

#include "app/programs/window_program.h"
#include "app/window/pages.h"
#include "session/session_xml.h"
#include "simulation/simulated_session.h"
#include "temporary_folder.h"
#include "widgets/base/theme.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {
namespace {

Session rig() { return read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/rigs/justin_head"); }

std::filesystem::path make_session(const TemporaryFolder& folder, int observations,
                                   const std::vector<EffectTerm>& effects = {}) {
  SimulationOptions options;
  options.observations = observations;
  options.follow = observations > 1000;
  options.effects = effects;
  Session s = simulate_session(rig(), options).session;
  const auto at = folder.path / std::to_string(observations);
  std::filesystem::create_directories(at);
  std::filesystem::copy_file(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "resources/justin.urdf", at / "robot.urdf");
  s.file = at / "session.xml";
  s.robot_file = "robot.urdf";
  s.source.reset();
  save_session(s);
  return at;
}

/// Every view painted, nothing left to do.
void paint_everything() {
  for (int i = 0; i < 4; ++i) {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
  }
}

double seconds_of(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Of all threads of this process, s.
double processor_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

/// Of this thread alone, s.
double thread_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

void say(const char* what, double value, const char* unit, double limit) {
  std::printf("%-60s %8.1f %s (to be <= %g)\n", what, value, unit, limit);
}

TEST(Window, StartToFirstPicture) {
  const TemporaryFolder folder;
  const auto session = make_session(folder, 100);
  const double thread = thread_seconds();
  QElapsedTimer timer;
  timer.start();
  app::MainWindow window;
  window.open(QString::fromStdString(session.string()));
  window.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
  QCoreApplication::sendPostedEvents();
  say("window made, 100 observations opened and painted", static_cast<double>(timer.elapsed()), "ms", 500);
  std::printf("%-60s %8.0f ms of the window's thread\n", "", 1e3 * (thread_seconds() - thread));
  paint_everything();
  std::printf("%-60s %8lld ms, %.0f ms of the window's thread\n", "the robot too",
              static_cast<long long>(timer.elapsed()), 1e3 * (thread_seconds() - thread));
}

/// "VmRSS" or "VmHWM" of this process, MB.
long memory(const char* what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(what)) return std::atol(line.c_str() + std::strlen(what) + 1) / 1024;
  return 0;
}

/// A session of a hundred thousand that handsight-cli has made (docs/measurements.md): HANDSIGHT_LONG_SESSION=FOLDER.
TEST(Window, MemoryWithALongSession) {
  const QString session = qEnvironmentVariable("HANDSIGHT_LONG_SESSION");
  if (session.isEmpty()) GTEST_SKIP() << "HANDSIGHT_LONG_SESSION names no session";
  Desk desk;
  desk.window.resize(1440, 900);
  QElapsedTimer timer;
  double worst = 0;
  const auto until = [&](const std::function<bool()>& there) {
    while (!there() && timer.elapsed() < 300000) {
      const double before = thread_seconds();
      QCoreApplication::processEvents();
      worst = std::max(worst, 1e3 * (thread_seconds() - before));
      QThread::msleep(1);
    }
  };
  const auto tell = [&](const char* what) {
    std::printf("%-44s %6.1f s  resident %5ld MB, at most %5ld MB; longest round %4.0f ms of this thread\n", what,
                1e-3 * static_cast<double>(timer.elapsed()), memory("VmRSS"), memory("VmHWM"), worst);
    std::fflush(stdout);
    worst = 0;
  };
  timer.start();
  tell("empty window");
  desk.window.open(session);
  tell("opened");
  until([&] { return desk.document().model() != nullptr; });
  tell("first fit");
  auto& diagnosing = desk.window.workbench().diagnosing;
  until([&] { return diagnosing.diagnosis() != nullptr; });
  tell("named");
  const auto is_quiet = [&] {
    auto& workbench = desk.window.workbench();
    return !workbench.jobs.is_busy() && !workbench.background.is_busy() && !workbench.refit.is_pending();
  };
  until(is_quiet);
  tell("every card");
  for (const auto place : {app::Place::calibrate, app::Place::inspect, app::Place::explain}) {
    desk.window.show_workspace(place);
    until(is_quiet);
    paint_everything();
  }
  tell("Calibrate, Inspect, Explain shown");
  for (int i = 0; i < 6; ++i) {
    desk.window.workbench().exclude({desk.document().session().observations[static_cast<std::size_t>(i)].id}, "");
    until(is_quiet);
    tell("one excluded, fitted and diagnosed again");
  }
}

/// One key that selects the next observation, until every view that is shown is painted.
void select_forty(Desk& desk, const char* what) {
  std::vector<double> times;
  const auto chosen = [&] { return desk.window.workbench().selection.current().observation.value_or(-1); };
  const auto first = chosen();
  desk.find<QWidget>("strip")->setFocus();
  const double before = processor_seconds();
  for (int i = 0; i < 40; ++i) {
    QElapsedTimer timer;
    timer.start();
    QTest::keyClick(desk.window.windowHandle(), Qt::Key_Right);
    paint_everything();
    times.push_back(static_cast<double>(timer.nsecsElapsed()) * 1e-6);
  }
  const double processor = 1e3 * (processor_seconds() - before) / static_cast<double>(times.size());
  ASSERT_EQ(chosen(), first + 40)
      << "from " << first << ", with the focus on "
      << (QApplication::focusWidget() ? QApplication::focusWidget()->objectName() : "nothing").toStdString();
  std::sort(times.begin(), times.end());
  say((std::string("select in 10,000, ") + what).c_str(), times[37], "ms", 100);
  std::printf("%-60s %8.1f ms median, %.1f ms of processor time\n", "", times[20], processor);
}

TEST(Window, SelectingInTenThousand) {
  const TemporaryFolder folder;
  const auto session = make_session(folder, 10000);
  Desk desk;
  desk.window.open(QString::fromStdString(session.string()));
  ASSERT_TRUE(desk.wait([&] { return desk.document().model() != nullptr; }, 300000));
  desk.settle();
  desk.window.show_workspace(app::Place::calibrate);
  paint_everything();
  select_forty(desk, "Calibrate: 95th percentile");
  desk.window.show_workspace(app::Place::inspect);
  paint_everything();
  select_forty(desk, "Inspect, histogram: 95th percentile");
  desk.find<QTabWidget>("inspect_tabs")->setCurrentIndex(1);
  paint_everything();
  select_forty(desk, "Inspect, over the image: 95th percentile");
}

TEST(Window, PlaysThirtyASecond) {
  const TemporaryFolder folder;
  const auto session = make_session(folder, 300);
  Desk desk;
  desk.window.open(QString::fromStdString(session.string()));
  desk.window.show_workspace(app::Place::calibrate);
  CalibratePage calibrate{desk};
  calibrate.set_fastest();
  QElapsedTimer timer;
  timer.start();
  ASSERT_TRUE(calibrate.play_to_the_end());
  EXPECT_EQ(calibrate.decisions(), 300) << "every decision is shown";
  std::printf("%-60s %8.1f /s (to be >= 30)\n", "played without images", 300e3 / static_cast<double>(timer.elapsed()));
}

TEST(Window, AnswersWhileAFitRuns) {
  const TemporaryFolder folder;
  const auto session = make_session(folder, 10000);
  Desk desk;
  desk.window.open(QString::fromStdString(session.string()));
  desk.settle();
  desk.window.show_workspace(app::Place::write_out);
  desk.document().perform({.sentence = "held the body's shape",
                           .settings = app::SettingsEdit{desk.document().settings(), {Objective::angle_axis, true}}});
  double worst = 0;
  int rounds = 0;
  QElapsedTimer whole;
  whole.start();
  while ((desk.window.workbench().jobs.is_busy() || desk.window.workbench().refit.is_pending()) &&
         whole.elapsed() < 20000) {
    QElapsedTimer timer;
    timer.start();
    QCoreApplication::processEvents();
    worst = std::max(worst, static_cast<double>(timer.nsecsElapsed()) * 1e-6);
    ++rounds;
    QThread::msleep(1);
  }
  std::printf("(the fit took %lld ms, %d rounds of events)\n", static_cast<long long>(whole.elapsed()), rounds);
  say("longest round of events while a fit of 10,000 runs", worst, "ms", 50);
}

/// A desk with Explain on a session with springs in two joints that nobody knows of.
struct ExplainDesk {
  explicit ExplainDesk(int observations) {
    const Robot robot = rig().robot;
    const auto session = make_session(folder, observations,
                                      {{"joint_elasticity", find_joint(robot, "right_arm_2"), {1.5e-4}},
                                       {"joint_elasticity", find_joint(robot, "right_arm_4"), {1.3e-4}}});
    desk.window.resize(1440, 900);
    desk.window.open(QString::fromStdString(session.string()));
    desk.settle();
  }
  TemporaryFolder folder;
  Desk desk;
  ExplainPage explain{desk};
};

TEST(Explain, OpeningItWithAHundred) {
  ExplainDesk on(100);
  Desk& desk = on.desk;
  QElapsedTimer timer;
  timer.start();
  desk.window.show_workspace(app::Place::explain);
  auto& diagnosing = desk.window.workbench().diagnosing;
  desk.wait([&] { return diagnosing.residuals() != nullptr; });
  paint_everything();
  say("verdict and patterns of 100 visible", static_cast<double>(timer.elapsed()), "ms", 500);
  desk.wait([&] { return diagnosing.diagnosis() != nullptr && on.explain.cards()->count() > 0; });
  paint_everything();
  std::printf("%-60s %8lld ms\n", "cards of 100 visible", static_cast<long long>(timer.elapsed()));
}

/// When a widget was painted, ms from now.
class PaintCounter : public QObject {
 public:
  explicit PaintCounter(QWidget* widget) {
    timer_.start();
    widget->installEventFilter(this);
  }
  std::vector<double> times;

 private:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) times.push_back(static_cast<double>(timer_.nsecsElapsed()) * 1e-6);
    return false;
  }
  QElapsedTimer timer_;
};

TEST(Explain, PicturesASecondWhileAThousandAreFitted) {
  ExplainDesk on(1000);
  Desk& desk = on.desk;
  ExplainPage& explain = on.explain;
  ASSERT_TRUE(explain.open());
  app::Adding& adding = explain.workspace()->adding();
  PaintCounter cloud(desk.find<QWidget>("cloud"));
  QElapsedTimer timer;
  double worst = 0, worst_at = 0, worst_processor = 0, first = 0, last = 0;
  QObject::connect(&adding, &app::Adding::pictured, [&] {
    last = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    if (first == 0) first = last;
  });
  timer.start();
  explain.press_add();
  while (adding.is_running()) {
    const double processor = thread_seconds();
    QElapsedTimer round;
    round.start();
    QCoreApplication::processEvents();
    const double took = static_cast<double>(round.nsecsElapsed()) * 1e-6;
    worst_processor = std::max(worst_processor, 1e3 * (thread_seconds() - processor));
    if (took > worst) {
      worst = took;
      worst_at = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    }
    QThread::usleep(500);
  }
  const auto in_fit =
      std::count_if(cloud.times.begin(), cloud.times.end(), [&](double at) { return at >= first && at <= last + 160; });
  std::printf("(added in %lld ms; %d iterates shown, %d left out)\n", static_cast<long long>(timer.elapsed()),
              adding.pictures(), adding.skipped());
  say("longest round of events meanwhile", worst, "ms", 50);
  std::printf("%-60s %8.1f ms of processor time; it ended at %.0f ms\n", "", worst_processor, worst_at);
  std::printf("%-60s %8.1f /s (to be >= 20)\n", "the cloud of 1000 painted while they are fitted",
              1e3 * static_cast<double>(in_fit) / (last + 160 - first));
}

}  // namespace
}  // namespace handsight::test

int main(int argc, char** argv) { return handsight::test::run_window_program(argc, argv); }
