// SPDX-License-Identifier: Apache-2.0
// Pictures of an experiment from the first page to its end, and of rechecks.
#include <gtest/gtest.h>

#include "app/programs/pictures/photographer.h"
#include "app/window/measure_page.h"
#include "experiment/paths/collision_world.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

TEST(Pictures, OfAnExperiment) {
  if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
  QCursor::setPos(1, 1);
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  MeasurePage page{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "hidden_2").string())));
  ASSERT_TRUE(desk.settle());
  page.open();
  photo.take("experiment_empty");
  const QByteArray path = qgetenv("PATH");
  qputenv("PATH", QByteArray(HANDSIGHT_BINARY_DIR "/app/cli:") + path);
  desk.press_button("experiment_try");
  ASSERT_TRUE(desk.wait([&] { return page.state() == app::RunState::asking; }, 60000)) << page.said().toStdString();
  ASSERT_TRUE(desk.settle());
  photo.take("experiment_plan");
  page.set_count(15);
  page.set_speed(2);
  desk.press_button("experiment_begin");
  photo.take_now("experiment_question");
  desk.press_button("experiment_yes");
  ASSERT_TRUE(desk.wait([&] { return desk.document().session().observations.size() > 10; }, 180000));
  ASSERT_TRUE(page.moves());
  // Without the folders of whoever takes the picture.
  desk.find<QComboBox>("experiment_driver")->setEditText("handsight-driver-simulated robot --in-real-time");
  photo.take_now("experiment");
  ASSERT_TRUE(page.ends(400000)) << page.said().toStdString();
  ASSERT_TRUE(desk.settle());
  photo.take("experiment_end");
  qputenv("PATH", path);
}

TEST(Pictures, OfAnExperimentOfTouches) {
  if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
  QCursor::setPos(1, 1);
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  MeasurePage page{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "probe_and_plate").string())));
  ASSERT_TRUE(desk.settle());
  page.open();
  desk.find<QCheckBox>("goal_odds")->setChecked(false);  // the sample's touches tell the cause already
  page.type_simulated();
  ASSERT_TRUE(page.connect()) << page.said().toStdString();
  photo.take_now("experiment_touch_plan");
  page.set_count(8);
  page.set_speed(5);
  page.start();
  ASSERT_TRUE(page.ends(400000)) << page.said().toStdString();
  ASSERT_TRUE(desk.settle());
  photo.take("experiment_touch_end");
}

TEST(Pictures, OfRechecks) {
  if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
  QCursor::setPos(1, 1);
  const TemporaryFolder folder;
  const auto session = copy_of_sample(folder.path, "hidden_2");
  const auto calibration = folder.path / "calibration.xml";
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  MeasurePage page{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  page.open();
  page.show_tab(1);
  photo.take("recheck_empty");
  ASSERT_EQ(run_cli(folder.path, {"fit", session.string(), "--export", calibration.string()}).exit_code, 0);
  desk.find<QLineEdit>("recheck_calibration")->setText(QString::fromStdString(calibration.string()));
  const auto recheck = [&](const std::string& options) {
    page.type_simulated(options);
    ASSERT_TRUE(page.connect()) << page.said().toStdString();
    page.workspace()->run().start({}, 8);
    ASSERT_TRUE(page.ends()) << page.said().toStdString();
  };
  recheck("");
  recheck("--seed 2");
  recheck("--seed 3 --change body_slip:x=0.003");
  ASSERT_TRUE(desk.settle());
  photo.take("recheck");
}

}  // namespace
}  // namespace handsight::test
