// SPDX-License-Identifier: Apache-2.0
// A mistake of a whole kind in the open session is reported with what is left before and after, and put right beside
// it.
#include "window/blunder_bar.h"

#include <gtest/gtest.h>

#include <map>

#include "app/window/pages.h"
#include "base/files.h"
#include "cli/cli_runner.h"
#include "fixtures/arms.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "widgets/explain/pattern_page.h"

namespace handsight::test {
namespace {

class BlunderPage : public testing::Test {
 protected:
  static Session simulated(int observations) {
    Session s = fixture::stand_session(4);
    s.mount.estimate = true;
    SimulationOptions options;
    options.observations = observations;
    return simulate_session(s, options).session;
  }
  /// The arm on the stand; of the wrong one a joint counts the other way.
  std::filesystem::path write(const std::string& name, bool is_wrong) {
    Session s = simulated(30);
    if (is_wrong)
      for (Observation& o : s.observations) o.position[2] *= -1;
    return write(name, std::move(s));
  }
  std::filesystem::path write(const std::string& name, Session s) {
    write_text(folder.path / name / "robot.urdf", fixture::urdf_text(s.robot));
    s.file = folder.path / name / "session.xml";
    save_session(s);
    return folder.path / name;
  }
  void open(const std::filesystem::path& session) {
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.wait([this] { return desk.document().model() != nullptr; }));
  }
  TemporaryFolder folder;
  Desk desk;
  app::BlunderBar* bar = desk.find<app::BlunderBar>("blunders");
};

TEST_F(BlunderPage, SaysWhatIsWrongAndWritesTheSessionPutRightBesideIt) {
  const auto session = write("wrong", true);
  const std::string untouched = read_file(session / "session.xml");
  open(session);
  ASSERT_TRUE(desk.wait([this] { return bar->isVisible(); }, 120000)) << "it is looked for by itself";
  EXPECT_TRUE(desk.find<QLabel>("blunders_text")->text().contains("Joint a3 counts the other way"))
      << desk.find<QLabel>("blunders_text")->text().toStdString();
  const QString sizes = desk.find<QLabel>("blunders_sizes")->text();
  ASSERT_EQ(bar->found().size(), 1u);
  EXPECT_GT(bar->found()[0].rms_before, 10);
  EXPECT_TRUE(sizes.contains("put right, 0.")) << sizes.toStdString();
  EXPECT_FALSE(desk.find<QPushButton>("blunders_open")->isVisible()) << "nothing is written yet";
  desk.press_button("blunders_write");
  ASSERT_TRUE(std::filesystem::exists(folder.path / "wrong_mended/session.xml"));
  EXPECT_EQ(read_file(session / "session.xml"), untouched) << "the old one stays as it is";
  EXPECT_FALSE(desk.find<QPushButton>("blunders_write")->isEnabled());
  desk.press_button("blunders_open");
  ASSERT_TRUE(desk.wait([this] { return desk.document().model() != nullptr; }));
  EXPECT_EQ(desk.document().session().file.parent_path().filename(), "wrong_mended");
  EXPECT_LT(*desk.document().model()->report->held_out.rms_pixel, 0.5);
  EXPECT_FALSE(bar->isVisible());
  EXPECT_EQ(app::mended_folder(read_session(session)).filename(), "wrong_mended_2") << "nothing is written over";
}

TEST_F(BlunderPage, AnotherOrderIsFoundAndPutRightInAllOfALongSession) {
  const Session right = simulated(130);
  Session wrong = right;
  std::map<std::string, std::size_t> as_text;
  for (std::size_t i = 0; i < right.observations.size(); ++i) as_text[std::to_string(i)] = i;
  auto next = wrong.observations.begin();
  for (const auto& [name, i] : as_text) (next++)->position = right.observations[i].position;
  open(write("mixed", wrong));
  ASSERT_TRUE(desk.wait([this] { return bar->isVisible(); }, 120000));
  EXPECT_TRUE(desk.find<QLabel>("blunders_text")->text().contains("sorted as text"))
      << desk.find<QLabel>("blunders_text")->text().toStdString();
  desk.press_button("blunders_write");
  const Session mended = read_session(folder.path / "mixed_mended");
  ASSERT_EQ(mended.observations.size(), right.observations.size());
  for (std::size_t i = 0; i < right.observations.size(); ++i)
    EXPECT_TRUE(mended.observations[i].position.isApprox(right.observations[i].position, 1e-9)) << i;
}

TEST_F(BlunderPage, TheWholeWindowSaysTheMistakeUntilItIsPutAway) {
  open(write("wrong", true));
  ExplainPage explain{desk};
  ASSERT_TRUE(desk.wait([this] { return bar->isVisible(); }, 120000));
  desk.key(Qt::Key_4, Qt::ControlModifier);
  const auto said = [&] { return explain.verdict().sentence; };
  EXPECT_EQ(explain.verdict().state, widgets::SessionState::mistake);
  EXPECT_TRUE(said().startsWith("Joint a3 counts the other way")) << said().toStdString();
  EXPECT_FALSE(said().contains("off by")) << "a figure of a wrong session tells nothing: " << said().toStdString();
  EXPECT_FALSE(explain.verdict().attribution) << "it is nobody's fault among cameras, body and robot";
  EXPECT_FALSE(desk.find<QPushButton>("add_first")->isEnabled());
  EXPECT_FALSE(desk.find<QPushButton>("until_it_stops")->isEnabled());
  EXPECT_TRUE(desk.wait([this] { return !desk.window.workbench().explaining.is_busy(); }))
      << "no causes are looked for in it";
  QTest::qWait(500);  // what shows there would come plot by plot
  for (const auto& plot : desk.find<widgets::PatternPage>("pattern_page")->plots())
    EXPECT_TRUE(plot.shows.isEmpty()) << "a cause beside the mistake: " << plot.shows.toStdString();
  desk.press_button("blunders_away");
  EXPECT_FALSE(bar->isVisible());
  EXPECT_NE(explain.verdict().state, widgets::SessionState::mistake) << "whoever knows better goes on";
  EXPECT_TRUE(said().contains("off by")) << said().toStdString();
}

TEST_F(BlunderPage, OfAGoodSessionSaysSoWhenAsked) {
  open(write("good", false));
  ASSERT_TRUE(desk.settle());
  EXPECT_FALSE(bar->isVisible());
  QString said;
  QObject::connect(&desk.document(), &app::Document::noticed, &desk.window, [&](const QString& s) { said = s; });
  desk.choose("blunders");
  ASSERT_TRUE(desk.wait([&] { return said.startsWith("No mistake"); }, 120000)) << said.toStdString();
  EXPECT_FALSE(bar->isVisible());
}

}  // namespace
}  // namespace handsight::test
