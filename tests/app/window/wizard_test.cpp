// SPDX-License-Identifier: Apache-2.0
// A session made by the wizard from what a user has, then labelled and played like any other.
#include <gtest/gtest.h>

#include <QDialog>
#include <opencv2/core.hpp>

#include "app/window/pages.h"
#include "base/files.h"
#include "base/numbers.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

class WizardTest : public testing::Test {
 protected:
  WizardTest() {
    const std::filesystem::path sample = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/first_steps";
    like = read_session(sample);
    std::filesystem::create_directories(folder.path / "left");
    std::filesystem::create_directories(folder.path / "right");
    std::string table;
    for (const std::string& joint : like.joints) table += (table.empty() ? "" : ",") + joint;
    table += '\n';
    for (const Observation& o : like.observations) {
      std::filesystem::copy_file(sample / o.images[0], folder.path / "left" / fmt::format("img{:02}.png", o.id));
      std::filesystem::copy_file(sample / o.images[1], folder.path / "right" / fmt::format("img{:02}.png", o.id));
      std::string line;
      for (const double q : o.position) line += (line.empty() ? "" : ",") + format_number(q);
      table += line + '\n';
    }
    replace_file(folder.path / "angles.csv", table);
    std::filesystem::copy_file(sample / "justin.urdf", folder.path / "justin.urdf");
    write_calibration();
  }
  void write_calibration() {
    const auto matrix = [](const Camera& c) {
      return cv::Mat((cv::Mat_<double>(3, 3) << c.fx, c.skew, c.cx, 0, c.fy, c.cy, 0, 0, 1));
    };
    const auto distortion = [](const Camera& c) {
      return cv::Mat((cv::Mat_<double>(1, 5) << c.k1, c.k2, c.p1, c.p2, c.k3));
    };
    cv::FileStorage file((folder.path / "stereo.yml").string(), cv::FileStorage::WRITE);
    cv::Mat r(3, 3, CV_64F), t(3, 1, CV_64F);
    for (int i = 0; i < 3; ++i) {
      t.at<double>(i) = like.rig->at(1).camera_from_first.translation[i];
      for (int j = 0; j < 3; ++j) r.at<double>(i, j) = like.rig->at(1).camera_from_first.rotation(i, j);
    }
    file << "M1" << matrix(like.rig->at(0).camera) << "D1" << distortion(like.rig->at(0).camera) << "M2"
         << matrix(like.rig->at(1).camera) << "D2" << distortion(like.rig->at(1).camera) << "R" << r << "T" << t;
  }
  QString text(const char* name) { return QString::fromStdString((folder.path / name).string()); }
  TemporaryFolder folder;
  Session like;
  Desk desk;
};

TEST_F(WizardTest, MakesASessionThatCanBeLabelledAndPlayed) {
  desk.press_button("start_new");
  auto* wizard = desk.window.findChild<QDialog*>("wizard");
  ASSERT_NE(wizard, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(wizard));
  const auto fill = [&](const char* name, const QString& with) {
    auto* field = desk.find<QWidget>(name);
    desk.find<QScrollArea>("wizard_scroll")->ensureWidgetVisible(field);
    QTest::qWait(10);
    desk.type_into(field, with);
  };
  auto* make = desk.find<QAbstractButton>("wizard_make");
  EXPECT_FALSE(make->isEnabled());
  fill("wizard_left", text("left"));
  fill("wizard_right", text("right"));
  EXPECT_TRUE(desk.find<QLabel>("wizard_right_sentence")->text().startsWith("12 pairs"));
  fill("wizard_robot", text("justin.urdf"));
  fill("wizard_angles", text("nowhere.csv"));
  EXPECT_TRUE(desk.find<QLabel>("wizard_angles_sentence")->text().contains("nowhere.csv"));
  fill("wizard_angles", text("angles.csv"));
  EXPECT_TRUE(desk.find<QLabel>("wizard_angles_sentence")->text().startsWith("12 poses of 12 joints"));
  fill("wizard_calibration", text("stereo.yml"));
  for (const auto& [name, link] : {std::pair{"wizard_tcp", "right_hand"}, std::pair{"wizard_mount", "head_tcp"}}) {
    auto* box = desk.find<QComboBox>(name);
    box->setFocus();
    for (const char* c = link; *c; ++c) QTest::keyClick(wizard->windowHandle(), *c);
    EXPECT_EQ(box->currentText(), link);
    QTest::qWait(QApplication::keyboardInputInterval() + 50);
  }
  fill("wizard_title", "My own");
  fill("wizard_target", text("made"));
  ASSERT_TRUE(make->isEnabled()) << desk.find<QLabel>("wizard_refusal")->text().toStdString();
  desk.click(make);
  ASSERT_TRUE(desk.document().is_open());
  EXPECT_EQ(desk.document().session().title, "My own");
  EXPECT_EQ(desk.document().session().observations.size(), 12U);
  EXPECT_NEAR(desk.document().session().rig->at(0).camera.fx, like.rig->at(0).camera.fx, 1e-9);

  LabelPage label{desk};
  ASSERT_TRUE(label.corners_are_found());
  for (const Vector2& px : {Vector2(421, 338), Vector2(408, 411), Vector2(473, 378)}) label.click_left(px);
  label.use();
  CalibratePage calibrate{desk};
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  // Nothing is known of where the cameras sit: what several observations agree on settles it.
  const auto& observations = desk.document().session().observations;
  EXPECT_GE(std::count_if(observations.begin(), observations.end(),
                          [](const Observation& o) { return o.decision == Decision::accepted; }),
            10);
  EXPECT_EQ(calibrate.decisions(), 12) << "each is decided once, though some were looked at twice";
  ASSERT_NE(desk.document().model(), nullptr);
  EXPECT_NE(desk.document().model()->fit, nullptr) << desk.document().model()->refusal.toStdString();

  // More of the same images, put where the first ones came from, belong to the session too.
  desk.press_button("watch");
  ASSERT_TRUE(desk.find<QLabel>("live_text")->text().contains("angles.csv"))
      << desk.find<QLabel>("live_text")->text().toStdString();
  for (const char* side : {"left", "right"})
    std::filesystem::copy_file(folder.path / side / "img05.png", folder.path / side / "img12.png");
  const std::string table = read_file(folder.path / "angles.csv");
  std::string line = table.substr(0, table.rfind('\n', table.size() - 2));
  line = table.substr(line.size() + 1);
  replace_file(folder.path / "angles.csv", table + line);
  ASSERT_TRUE(desk.wait([&] { return desk.document().session().observations.size() == 13; }))
      << desk.find<QLabel>("live_text")->text().toStdString();
  EXPECT_TRUE(std::filesystem::exists(folder.path / "made" / desk.document().session().observations[12].images[0]));
}

}  // namespace
}  // namespace handsight::test
