// SPDX-License-Identifier: Apache-2.0
// A robot that moves while the window watches: images and angles arrive in the session's folder.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QToolButton>
#include <fstream>

#include "app/arriving_session.h"
#include "app/window/pages.h"
#include "cli/cli_runner.h"

namespace handsight::test {
namespace {

namespace fs = std::filesystem;

class LiveWindow : public testing::Test, protected ArrivingSession {
 protected:
  LiveWindow() : ArrivingSession(first_count) { table(header("number")); }
  void measure(std::int64_t id) { std::ofstream(home / "joints.csv", std::ios::app) << line(id, std::to_string(id)); }
  void arrive(std::int64_t id) {
    bring(id);
    measure(id);
  }
  /// Labelled, and playing what is there.
  void begin_to_watch() {
    ASSERT_TRUE(desk.window.open(QString::fromStdString(home.string())));
    ASSERT_TRUE(label.corners_are_found());
    for (const Vector2& px : {Vector2(421, 338), Vector2(408, 411), Vector2(473, 378)}) label.click_left(px);
    label.use();
    calibrate.set_fastest();
    desk.press_button("watch");
    ASSERT_TRUE(desk.wait([this] { return calibrate.decisions() == first_count; }));
  }
  std::size_t count() { return desk.document().session().observations.size(); }
  QString said() { return desk.find<QLabel>("live_text")->text(); }
  bool is_decided(std::int64_t id) {
    const Observation* o = desk.document().find(id);
    return o && o->decision != Decision::none;
  }

  static constexpr int first_count = 6;
  Desk desk;
  LabelPage label{desk};
  CalibratePage calibrate{desk};
};

TEST_F(LiveWindow, WhatArrivesIsTakenTrackedAndFitted) {
  begin_to_watch();
  EXPECT_TRUE(said().contains("Waiting for the next image pair in images")) << said().toStdString();
  EXPECT_TRUE(said().contains("0 arrived"));
  for (std::int64_t id = first_count; id < 9; ++id) {
    arrive(id);
    ASSERT_TRUE(desk.wait([&] { return is_decided(id); })) << id << ": " << said().toStdString();
  }
  EXPECT_TRUE(said().contains("3 arrived")) << said().toStdString();
  EXPECT_TRUE(desk.wait([this] { return calibrate.decisions() == 9; })) << calibrate.decisions();
  EXPECT_EQ(desk.find<QAbstractButton>("play")->text(), "Pause") << "it goes on waiting";
  ASSERT_TRUE(desk.settle());
  ASSERT_NE(desk.document().model(), nullptr) << "the fit follows, without waiting for the play to end";
  EXPECT_EQ(desk.document().model()->report->observations, 9);
  // The command line, with all nine from the beginning, takes and finds the same.
  desk.key(Qt::Key_S, Qt::ControlModifier);
  const Session live = read_session(home);
  ASSERT_EQ(live.observations.size(), 9U);
  const auto other = folder.path / "other";
  fs::copy(home, other, fs::copy_options::recursive);
  Session whole = all;
  whole.file = other / "session.xml";
  whole.observations.resize(9);
  save_session(whole);
  const std::vector<std::string> clicks = {"421,338", "408,411", "473,378"};
  ASSERT_EQ(
      run_cli(folder.path, {"label", other.string(), "--observation", "0", "--left", clicks[0], clicks[1], clicks[2]})
          .exit_code,
      0);
  ASSERT_EQ(run_cli(folder.path, {"online", other.string(), "--save"}).exit_code, 0);
  const Session by_cli = read_session(other);
  for (std::size_t i = 0; i < 9; ++i) {
    const Observation &a = live.observations[i], &b = by_cli.observations[i];
    EXPECT_EQ(a.decision, b.decision) << i;
    EXPECT_EQ(a.reason, b.reason) << i;
    ASSERT_EQ(a.sightings.size(), b.sightings.size()) << i;
    for (std::size_t k = 0; k < a.sightings.size(); ++k)
      EXPECT_EQ(seen_by(a.sightings[k], 0)->pixel, seen_by(b.sightings[k], 0)->pixel) << i;
  }
}

TEST_F(LiveWindow, AMeasuredTimeThatRunsBackIsSaidAndNotReplaced) {
  table(header("number,time"));
  begin_to_watch();
  const double last = desk.document().session().observations.back().time;
  const auto measure_at = [&](std::int64_t id, double time) {
    bring(id);
    std::ofstream(home / "joints.csv", std::ios::app) << line(id, fmt::format("{},{}", id, time));
  };
  measure_at(6, last - 5);
  ASSERT_TRUE(desk.wait([&] { return said().contains("was left out: its time"); })) << said().toStdString();
  EXPECT_EQ(count(), static_cast<std::size_t>(first_count));
  measure_at(7, last + 2.5);
  ASSERT_TRUE(desk.wait([&] { return count() == first_count + 1; })) << said().toStdString();
  EXPECT_EQ(desk.document().session().observations.back().time, last + 2.5) << "as it was measured";
}

TEST_F(LiveWindow, WhatIsNotWholeIsNamedAndTakenWhenItIs) {
  begin_to_watch();
  const std::int64_t id = first_count;
  measure(id);
  const std::string left = read_file(sample / one(id).images[0]);
  std::ofstream(home / one(id).images[0], std::ios::binary) << left.substr(0, left.size() / 3);
  const QString name = QString::fromStdString(fs::path(one(id).images[0]).filename().string());
  ASSERT_TRUE(desk.wait([&] { return said().contains(name); })) << said().toStdString();
  EXPECT_TRUE(said().contains("waits for its right image")) << said().toStdString();
  fs::copy_file(sample / one(id).images[1], home / one(id).images[1]);
  ASSERT_TRUE(desk.wait([&] { return said().contains("is cut off after"); })) << said().toStdString();
  EXPECT_EQ(count(), static_cast<std::size_t>(first_count));
  std::ofstream(home / one(id).images[0], std::ios::binary) << left;
  ASSERT_TRUE(desk.wait([&] { return is_decided(id); })) << said().toStdString();
  EXPECT_FALSE(said().contains(name)) << said().toStdString();
  EXPECT_TRUE(
      desk.window.workbench().images.image(desk.document().session(), *desk.document().find(id), 0).refusal.isEmpty());
}

TEST_F(LiveWindow, UndoTakesTheLastArrivalBackAndItStaysAway) {
  begin_to_watch();
  arrive(first_count);
  ASSERT_TRUE(desk.wait([&] { return is_decided(first_count); }));
  arrive(first_count + 1);
  ASSERT_TRUE(desk.wait([&] { return is_decided(first_count + 1); }));
  const int actions = desk.document().undo_stack().index();
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(desk.document().undo_stack().index(), actions - 1);
  EXPECT_EQ(desk.document().find(first_count + 1), nullptr) << "arrival and decision are one action";
  EXPECT_TRUE(is_decided(first_count)) << "and each arrival its own";
  QTest::qWait(1200);
  EXPECT_EQ(desk.document().find(first_count + 1), nullptr) << "what was undone is not taken again";
  EXPECT_NE(desk.window.workbench().selection.current().observation, first_count + 1);
  desk.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(is_decided(first_count + 1));
  // Every page can show what has come and gone.
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  for (int page = 0; page < 5; ++page) {
    desk.key(Qt::Key_1 + page, Qt::ControlModifier);
    EXPECT_TRUE(desk.settle());
  }
}

TEST_F(LiveWindow, BeforeTheFirstLabelArrivalsWaitToBePlayed) {
  ASSERT_TRUE(desk.window.open(QString::fromStdString(home.string())));
  desk.key(Qt::Key_2, Qt::ControlModifier);
  desk.press_button("watch");
  arrive(first_count);
  ASSERT_TRUE(desk.wait([&] { return count() == first_count + 1; })) << said().toStdString();
  EXPECT_FALSE(is_decided(first_count));
  EXPECT_EQ(desk.find<QLabel>("play_progress")->text().left(9), "Waits for");
  desk.press_button("watch");
  EXPECT_FALSE(desk.find<QLabel>("live_text")->isVisible());
  arrive(first_count + 1);
  QTest::qWait(1200);
  EXPECT_EQ(count(), static_cast<std::size_t>(first_count + 1)) << "nobody watches";
}

TEST_F(LiveWindow, APipeInPlaceOfATableDoesNotHoldUpTheWindow) {
  begin_to_watch();
  // A pipe that nobody writes to: who opens it waits for ever. It is refused unopened.
  const fs::path table = home / "joints.csv";
  std::string text = read_file(table), line = std::to_string(first_count);
  for (const double q : one(first_count).position) line += "," + format_number(q);
  text += line + "\n";
  fs::remove(table);
  ASSERT_EQ(::mkfifo(table.c_str(), 0600), 0);
  bring(first_count);
  QTest::qWait(1500);
  desk.key(Qt::Key_3, Qt::ControlModifier);
  desk.key(Qt::Key_2, Qt::ControlModifier);
  EXPECT_EQ(count(), static_cast<std::size_t>(first_count));
  // A table after all.
  fs::remove(table);
  replace_file(table, text);
  EXPECT_TRUE(desk.wait([&] { return is_decided(first_count); }, 60000));
}

/// One camera and a board: nothing is labelled, what arrives is found and fitted.
TEST(LiveBoard, IsWatchedWithOneCamera) {
  const TemporaryFolder folder;
  const std::string like = HANDSIGHT_SOURCE_DIR "/sample_sessions/rigs/one_camera_board", live = folder.path / "live";
  const CliResult played = run_cli(folder.path, {"simulate", "--like", like, "--live", live, "--rate", "1000",
                                                 "--observations", "12", "--seed", "4"});
  ASSERT_EQ(played.exit_code, 0) << played.errors;
  Desk desk;
  CalibratePage calibrate{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString(live)));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_2, Qt::ControlModifier);
  calibrate.set_fastest();
  ASSERT_TRUE(desk.find<QAbstractButton>("watch")->isEnabled());
  desk.press_button("watch");
  ASSERT_TRUE(desk.wait([&] { return desk.document().session().observations.size() == 12; }))
      << desk.find<QLabel>("live_text")->text().toStdString();
  EXPECT_TRUE(desk.wait([&] { return calibrate.decisions() == 12; })) << calibrate.decisions();
  const auto& all = desk.document().session().observations;
  EXPECT_GE(
      std::count_if(all.begin(), all.end(), [](const Observation& o) { return o.decision == Decision::accepted; }), 9);
  const QString said = desk.find<QLabel>("live_text")->text();
  EXPECT_TRUE(said.contains("Waiting for the next images in images")) << said.toStdString();
  EXPECT_TRUE(said.contains("11 arrived")) << said.toStdString();
}

}  // namespace
}  // namespace handsight::test
