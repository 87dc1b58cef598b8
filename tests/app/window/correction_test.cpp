// SPDX-License-Identifier: Apache-2.0
// Taking the correction to the robot: beside a pose of one's own, and what it buys, in Export.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QRegularExpression>
#include <QTabWidget>
#include <numeric>

#include "app/window/explain_fixture.h"
#include "calibrate/own_pose_page.h"
#include "export/correction_box.h"

namespace handsight::test {
namespace {

class Correcting : public Explain {
 protected:
  app::OwnPosePage* own_pose() {
    desk.window.show_workspace(app::Place::calibrate);
    auto* page = desk.window.findChild<app::OwnPosePage*>();
    for (auto* tabs : desk.window.findChildren<QTabWidget*>())
      if (tabs->indexOf(page) >= 0) tabs->setCurrentWidget(page);
    QTest::qWait(20);
    return page;
  }
  /// The angles that were asked for, rad.
  Eigen::VectorXd asked() {
    const auto count = static_cast<Eigen::Index>(desk.document().session().joints.size());
    Eigen::VectorXd q(count);
    for (Eigen::Index i = 0; i < count; ++i)
      q[i] = desk.find<QDoubleSpinBox>(("own_pose_joint_" + std::to_string(i)).c_str())->value() / 57.29577951308232;
    return q;
  }
  /// The angles that the page says are to be commanded, rad.
  Eigen::VectorXd commands() {
    const auto count = static_cast<Eigen::Index>(desk.document().session().joints.size());
    Eigen::VectorXd q(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const QString text = desk.find<QLabel>(("own_pose_command_" + std::to_string(i)).c_str())->text();
      q[i] = text.section(' ', 1, 1).replace(QChar(0x2212), '-').toDouble() / 57.29577951308232;
    }
    return q;
  }
};

TEST_F(Correcting, OwnPoseSaysWhatToCommandSoThatTheHandArrives) {
  open("hidden_3");
  own_pose();
  EXPECT_FALSE(desk.find<QLabel>("own_pose_correction")->isVisible()) << "a model without effects corrects nothing";
  desk.window.show_workspace(app::Place::explain);
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  ASSERT_TRUE(own_pose()->isVisible());
  auto* sentence = desk.find<QLabel>("own_pose_correction");
  ASSERT_TRUE(sentence->isVisible());
  const Session& s = desk.document().session();
  const Chain chain = make_chain(s);
  const PredictionModel& model = desk.document().model()->prediction;
  const TcpPrediction as_commanded = predict_tcp(chain, asked(), model);
  const TcpPrediction corrected = predict_tcp(chain, commands(), model);
  const double before = (as_commanded.root_from_tcp_est.translation - as_commanded.root_from_tcp.translation).norm();
  const double after = (corrected.root_from_tcp_est.translation - as_commanded.root_from_tcp.translation).norm();
  EXPECT_GT(before, 1e-3);
  EXPECT_LT(after, 1e-4) << "the command is told to 0.001 degrees";
  EXPECT_TRUE(sentence->text().contains(QRegularExpression("misses its place by \\d")))
      << sentence->text().toStdString();
}

TEST_F(Correcting, ExportSaysWhatItBuys) {
  open("hidden_3");
  desk.window.show_workspace(app::Place::write_out);
  EXPECT_FALSE(desk.find<QWidget>("correction")->isVisible());
  desk.window.show_workspace(app::Place::explain);
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  desk.window.show_workspace(app::Place::write_out);
  auto* box = desk.window.findChild<app::CorrectionBox*>();
  ASSERT_TRUE(box->isVisible());
  ASSERT_TRUE(desk.wait([&] { return box->gain() != nullptr; }, 30000));
  EXPECT_EQ(box->gain()->before.size(), 500u);
  EXPECT_LT(box->gain()->median_after, 0.1 * box->gain()->median_before);
  const app::GainBins bins = app::gain_bins(*box->gain());
  EXPECT_NEAR(std::accumulate(bins.before.begin(), bins.before.end(), 0.0), 1, 1e-9);
  EXPECT_NEAR(std::accumulate(bins.after.begin(), bins.after.end(), 0.0), 1, 1e-9);
  EXPECT_TRUE(desk.find<QLabel>("correction_sentence")->text().contains("500 poses"));
  EXPECT_TRUE(desk.find<QWidget>("correction_bars")->isVisible());
}

}  // namespace
}  // namespace handsight::test
