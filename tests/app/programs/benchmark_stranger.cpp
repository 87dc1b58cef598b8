// SPDX-License-Identifier: Apache-2.0
// How long a stranger waits for what is to be read and clicked (ux.md: 60 s), and how long *Add until it stops* takes
// on a real session, with the longest time for which the window does not answer. Run it under with_display.sh:
//   benchmark_stranger                       hidden_3, hidden_6, hidden_8 on a laptop's screen
//   HANDSIGHT_REAL_SESSION=FOLDER benchmark_stranger     and *Add until it stops* on that session
#include <time.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QThread>

#include "app/programs/window_program.h"
#include "app/window/stranger.h"
#include "temporary_folder.h"
#include "widgets/base/theme.h"
#include "widgets/scene/robot_view.h"

namespace handsight::test {
namespace {

/// Of this thread alone, s.
double thread_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Rounds of events as the program makes them, the longest of which is kept.
struct Rounds {
  double longest_ms = 0, longest_thread_ms = 0;

  bool until(const std::function<bool()>& there, double seconds) {
    QElapsedTimer timer;
    timer.start();
    while (!there()) {
      if (static_cast<double>(timer.elapsed()) > 1e3 * seconds) return false;
      QElapsedTimer round;
      round.start();
      const double thread = thread_seconds();
      QCoreApplication::processEvents();
      longest_ms = std::max(longest_ms, 1e-6 * static_cast<double>(round.nsecsElapsed()));
      longest_thread_ms = std::max(longest_thread_ms, 1e3 * (thread_seconds() - thread));
      QThread::usleep(500);
    }
    return true;
  }
};

void say(const char* what, const QElapsedTimer& since) {
  std::printf("  %-52s %6.1f s\n", what, 1e-3 * static_cast<double>(since.elapsed()));
  std::fflush(stdout);
}

TEST(Stranger, ReadsAndClicksOnALaptop) {
  for (const char* name : {"sample_hidden_3", "sample_hidden_6", "sample_hidden_8"}) {
    Desk desk;
    Stranger stranger{desk};
    stranger.sit_down();
    QElapsedTimer timer;
    timer.start();
    stranger.click_sample(name);
    std::printf("%s, %d x %d, from the click on the start page\n", name, desk.window.width(), desk.window.height());
    Rounds rounds;
    ASSERT_TRUE(rounds.until([&] { return stranger.reads_how_far_off(); }, 60));
    say("how far off", timer);
    ASSERT_TRUE(rounds.until([&] { return stranger.reads_whose_fault(); }, 60));
    say("whose fault", timer);
    ASSERT_TRUE(rounds.until([&] { return !stranger.reads_what_is_missing().isEmpty(); }, 60));
    say(("missing: " + stranger.reads_what_is_missing()).toUtf8().constData(), timer);
    ASSERT_TRUE(rounds.until([&] { return stranger.finds_the_button() != nullptr; }, 60));
    say("the button that adds it", timer);
    QTest::qWait(200);  // the hand is no faster
    desk.click(stranger.finds_the_button());
    const auto& stack = desk.document().undo_stack();
    ASSERT_TRUE(rounds.until([&] { return stack.index() > 0 && stranger.explain.is_settled(0); }, 60));
    say("added, fitted, and the next is named", timer);
    const auto& report = *desk.document().model()->report;
    std::printf("  error held out now %.3f px; longest round of events %.0f ms, %.0f ms of the thread's own\n",
                report.held_out.rms_pixel.value_or(0), rounds.longest_ms, rounds.longest_thread_ms);
  }
}

/// The error that counts, as the header tells it.
void tell_error(Desk& desk) {
  const app::ErrorAndNoise e = app::error_and_noise(*desk.document().model());
  std::printf("  error %.4g %s, noise %.4g\n", e.error.value_or(0) * (e.in_pixels ? 1 : 1e3), e.in_pixels ? "px" : "mm",
              e.noise.value_or(0) * (e.in_pixels ? 1 : 1e3));
}

TEST(AddUntilItStops, OnARealSession) {
  const QString session = qEnvironmentVariable("HANDSIGHT_REAL_SESSION");
  if (session.isEmpty()) GTEST_SKIP() << "HANDSIGHT_REAL_SESSION names no session";
  const TemporaryFolder folder;
  const auto copy = folder.path / "session";
  std::filesystem::copy(session.toStdString(), copy, std::filesystem::copy_options::recursive);
  Desk desk;
  Stranger stranger{desk};
  stranger.sit_down();
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy.string())));
  desk.window.show_workspace(app::Place::explain);
  ASSERT_TRUE(stranger.explain.is_settled());
  std::printf("Add until it stops, %s\n", session.toUtf8().constData());
  tell_error(desk);
  Rounds rounds;
  QElapsedTimer timer;
  timer.start();
  desk.press_button("until_it_stops");
  auto* button = desk.find<QAbstractButton>("until_it_stops");
  const QString running = QObject::tr("Stop");
  ASSERT_EQ(button->text(), running);
  std::size_t effects = 0;
  const auto is_done = [&] {
    const auto model = desk.document().model();
    if (model && model->fit && model->settings.estimated.size() != effects) {
      effects = model->settings.estimated.size();
      say(QString("%1 numbers' places in the model").arg(effects).toUtf8().constData(), timer);
    }
    return button->text() != running && stranger.explain.is_settled(0);
  };
  ASSERT_TRUE(rounds.until(is_done, 300));
  say("it has stopped", timer);
  tell_error(desk);
  std::printf("  longest round of events %.0f ms, %.0f ms of the thread's own\n", rounds.longest_ms,
              rounds.longest_thread_ms);
}

}  // namespace
}  // namespace handsight::test

int main(int argc, char** argv) { return handsight::test::run_window_program(argc, argv); }
