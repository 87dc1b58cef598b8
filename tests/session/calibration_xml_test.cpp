// SPDX-License-Identifier: Apache-2.0
#include "session/calibration_xml.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "base/files.h"
#include "session_texts.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

EstimatedMotion some_motion(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::normal_distribution<double> normal;
  Vector6 small;
  Matrix6 square_root;
  for (double& number : small) number = normal(random);
  for (double& number : square_root.reshaped()) number = 1e-4 * normal(random);
  return {small_motion<double>(small), square_root * square_root.transpose()};
}

Calibration some_calibration() {
  Calibration calibration;
  calibration.session = "Right hand, \"12 March\" & <more>";
  calibration.created = "2026-11-21T10:00:00Z";
  calibration.software = "handsight 0.1.0";
  calibration.tcp_from_body = some_motion(1);
  calibration.fit = {80, 78, 2, 0.21, 0.2300000000000001, {}, {}, {}, {}, 1.0 / 3};
  calibration.markers = {{0.1, 0.2, 0.3}, {1.0 / 3, -1e-17, 0}, {0, 0, 5e-324}};
  calibration.effects = {
      {"joint_elasticity",
       {{"arm_2", "compliance", 1e-4 / 3, 1e-6 / 7, "rad/(N m)"}, {"arm_3", "compliance", -1e-5, {}, "rad/(N m)"}}},
      {"base_tilt", {{"", "tilt_x", 0.001, 0, "rad"}}}};
  calibration.tcp = "arm_l7";
  calibration.mount = "head_b";
  calibration.joints = {"torso_1", "arm_\xC3\xBC"};
  calibration.gravity = Vector3(0.1, 0, -9.81);
  calibration.positions = {Eigen::Vector2d(0.1, -1.0 / 3), Eigen::Vector2d(2, 5e-324)};
  calibration.mount_from_sensor = some_motion(2);
  calibration.tcp_repeatability = some_motion(3).covariance;
  Eigen::MatrixXd root = Eigen::MatrixXd::Identity(9, 9);  // xi, two compliances, a tilt that was held
  root.topLeftCorner<6, 6>() = some_motion(4).covariance;
  root.row(8).setZero();
  root(6, 0) = 1e-3;
  calibration.model_covariance = root * root.transpose();
  return calibration;
}

void expect_same(const EstimatedMotion& a, const EstimatedMotion& b) {
  EXPECT_EQ(a.motion.rotation, b.motion.rotation);
  EXPECT_EQ(a.motion.translation, b.motion.translation);
  EXPECT_EQ(a.covariance, b.covariance);
}

void expect_same(const CalibrationFit& a, const CalibrationFit& b) {
  EXPECT_EQ(a.observations, b.observations);
  EXPECT_EQ(a.used, b.used);
  EXPECT_EQ(a.rejected, b.rejected);
  for (const auto number : {&CalibrationFit::rms_pixel, &CalibrationFit::held_out_rms_pixel,
                            &CalibrationFit::noise_pixel, &CalibrationFit::rms_m, &CalibrationFit::held_out_rms_m,
                            &CalibrationFit::noise_m, &CalibrationFit::chi2_per_dof})
    EXPECT_EQ(a.*number, b.*number);
}

void expect_same(const CalibrationEffect& a, const CalibrationEffect& b) {
  EXPECT_EQ(a.id, b.id);
  ASSERT_EQ(a.parameters.size(), b.parameters.size());
  for (std::size_t i = 0; i < a.parameters.size(); ++i) {
    EXPECT_EQ(a.parameters[i].of, b.parameters[i].of);
    EXPECT_EQ(a.parameters[i].name, b.parameters[i].name);
    EXPECT_EQ(a.parameters[i].value, b.parameters[i].value);
    EXPECT_EQ(a.parameters[i].sigma, b.parameters[i].sigma);
    EXPECT_EQ(a.parameters[i].unit, b.parameters[i].unit);
  }
}

void expect_same(const Calibration& a, const Calibration& b) {
  EXPECT_EQ(a.session, b.session);
  EXPECT_EQ(a.created, b.created);
  EXPECT_EQ(a.software, b.software);
  expect_same(a.tcp_from_body, b.tcp_from_body);
  expect_same(a.fit, b.fit);
  EXPECT_EQ(a.markers, b.markers);
  EXPECT_EQ(a.unseen_markers, b.unseen_markers);
  ASSERT_EQ(a.effects.size(), b.effects.size());
  for (std::size_t i = 0; i < a.effects.size(); ++i) expect_same(a.effects[i], b.effects[i]);
  EXPECT_EQ(a.tcp, b.tcp);
  EXPECT_EQ(a.mount, b.mount);
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.gravity, b.gravity);
  ASSERT_EQ(a.mount_from_sensor.has_value(), b.mount_from_sensor.has_value());
  EXPECT_EQ(a.tcp_repeatability, b.tcp_repeatability);
  EXPECT_EQ(a.model_covariance, b.model_covariance);
  if (a.mount_from_sensor) expect_same(*a.mount_from_sensor, *b.mount_from_sensor);
}

/// The contract's own example, with numbers.
const std::string small_calibration =
    R"(<handsight_calibration version="1" session="s" created="2026-11-21T10:00:00Z" software="other 1">
  <tcp_from_body xyz="0.1 0.2 0.3" rpy="0 0 0"><matrix>1 0 0 0.1  0 1 0 0.2  0 0 1 0.3  0 0 0 1</matrix>
    <covariance order="x y z rx ry rz">1 0 0 0 0 0  0 1 0 0 0 0  0 0 1 0 0 0  0 0 0 4 2 0  0 0 0 2 4 0  0 0 0 0 0 0</covariance></tcp_from_body>
  <fit observations="80" used="78" rejected="2" rms_pixel="0.5"/>
  <markers><marker index="1" xyz="1 0 0"/><marker index="0" xyz="0 0 0"/></markers>
  <effects><effect id="joint_offset"><parameter of="j1" name="offset" value="0.01" sigma="0.001" unit="rad"/></effect></effects>
</handsight_calibration>
)";

std::string refusal(const std::string& piece, const std::string& by) {
  return find_refusal([&] { parse_calibration(changed(small_calibration, piece, by), "calibration.xml"); });
}

TEST(Calibration, ReadsBackBitForBit) {
  expect_same(some_calibration(), parse_calibration(calibration_text(some_calibration()), "calibration.xml"));
  Calibration bare;
  bare.markers = {Vector3::Zero()};
  expect_same(bare, parse_calibration(calibration_text(bare), "calibration.xml"));
  for (int seed = 0; seed < 200; ++seed) {
    bare.tcp_from_body = some_motion(seed);
    expect_same(bare, parse_calibration(calibration_text(bare), "calibration.xml"));
  }
}

TEST(Calibration, UnknownNumbersAreLeftOut) {
  const std::string text = calibration_text(some_calibration());
  EXPECT_THAT(text, HasSubstr("rms_pixel=\"0.21\""));
  EXPECT_THAT(text, Not(HasSubstr("noise_pixel")));
  EXPECT_THAT(text, Not(HasSubstr("rms_m=")));
  EXPECT_THAT(text, HasSubstr("value=\"-1e-05\" unit"));
}

TEST(Calibration, MarkersThatWereNeverSeenHaveNoPosition) {
  Calibration calibration = some_calibration();
  calibration.markers[1].setZero();
  calibration.unseen_markers = {1};
  EXPECT_THAT(calibration_text(calibration), Not(HasSubstr("index=\"1\"")));
  expect_same(calibration, parse_calibration(calibration_text(calibration), "calibration.xml"));
}

TEST(Calibration, CovariancesOfWhatIsNotObservableAreRead) {
  Calibration calibration = some_calibration();
  Matrix6& covariance = calibration.tcp_from_body.covariance;
  covariance.setZero();  // one marker: only the position is seen; rounding is all that stands for the rotation
  covariance.topLeftCorner<3, 3>().diagonal().setConstant(1e-8);
  covariance(4, 4) = -1e-25;
  covariance(3, 5) = covariance(5, 3) = 3e-25;
  covariance(0, 4) = covariance(4, 0) = 1e-24;
  expect_same(calibration, parse_calibration(calibration_text(calibration), "calibration.xml"));
}

TEST(Calibration, NumbersThatAreNotFiniteAreNotWritten) {
  Calibration calibration = some_calibration();
  calibration.effects[0].parameters[0].value = NAN;
  EXPECT_THROW(calibration_text(calibration), BrokenPromise);
  EXPECT_EQ(find_refusal([&] { require_finite(calibration); }),
            "The calibration cannot be written: compliance of joint_elasticity is not finite; the observations do not "
            "determine it. Look at the session with check and diagnose.");
  calibration = some_calibration();
  EXPECT_EQ(find_refusal([&] { require_finite(calibration); }), "nothing was refused");
  calibration.tcp_from_body.covariance(2, 2) = INFINITY;
  const TemporaryFolder temporary;
  EXPECT_THAT(find_refusal([&] { write_calibration(temporary.path / "c.xml", calibration); }),
              HasSubstr("TCP->Body or its covariance is not finite"));
  EXPECT_FALSE(std::filesystem::exists(temporary.path / "c.xml"));
}

TEST(Calibration, AnEffectMayStandTwiceWithNumbers) {
  Calibration calibration = some_calibration();
  calibration.effects.push_back(calibration.effects[0]);
  calibration.effects.push_back({"joint_elasticity", {{"arm_2", "compliance", 1, {}, "rad/(N m)"}}});
  calibration.model_covariance.reset();
  const std::string text = calibration_text(calibration);
  EXPECT_THAT(text, HasSubstr("<effect id=\"joint_elasticity\" number=\"2\">"));
  EXPECT_THAT(text, HasSubstr("<effect id=\"joint_elasticity\" number=\"3\">"));
  EXPECT_THAT(text, HasSubstr("<effect id=\"base_tilt\">"));
  const Calibration read = parse_calibration(text, "c.xml");
  ASSERT_EQ(read.effects.size(), 4u);
  EXPECT_EQ(read.effects[3].parameters[0].value, 1);
  EXPECT_EQ(calibration_text(read), text);
}

TEST(Calibration, FilesAreReplacedAndRead) {
  const TemporaryFolder temporary;
  write_calibration(temporary.path / "calibration.xml", some_calibration());
  expect_same(some_calibration(), read_calibration(temporary.path / "calibration.xml"));
  EXPECT_THAT(find_refusal([&] { write_calibration(temporary.path / "no" / "c.xml", some_calibration()); }),
              HasSubstr("cannot be written"));
}

/// What parse_calibration would refuse is never written: the file that is there stays.
TEST(Calibration, WhatCouldNotBeReadAgainIsNotWritten) {
  const TemporaryFolder temporary;
  const auto file = temporary.path / "calibration.xml";
  write_calibration(file, some_calibration());
  const std::string before = read_file(file);
  EXPECT_EQ(before, readable_text(some_calibration()));
  Calibration broken = some_calibration();
  broken.created = "later";
  const double sigma_x = std::sqrt(broken.tcp_from_body.covariance(0, 0));
  const double sigma_y = std::sqrt(broken.tcp_from_body.covariance(1, 1));
  broken.tcp_from_body.covariance(0, 1) = broken.tcp_from_body.covariance(1, 0) = 1.01 * sigma_x * sigma_y;
  Calibration negative = some_calibration();
  (*negative.model_covariance)(7, 7) *= -1;
  for (const Calibration& one : {broken, negative}) {
    try {
      write_calibration(file, one);
      FAIL() << "a calibration that cannot be read was written";
    } catch (const BrokenPromise& promise) {
      EXPECT_THAT(promise.what(), HasSubstr("could not be read again"));
      EXPECT_THAT(promise.what(), HasSubstr("expected a covariance"));
    }
    EXPECT_EQ(read_file(file), before);
  }
}

TEST(Calibration, OtherProgramsFilesAreRead) {
  const Calibration calibration = parse_calibration(small_calibration, "calibration.xml");
  EXPECT_EQ(calibration.tcp_from_body.motion.translation, Vector3(0.1, 0.2, 0.3));
  EXPECT_EQ(calibration.tcp_from_body.covariance(3, 4), 2);
  EXPECT_EQ(calibration.fit.used, 78);
  EXPECT_FALSE(calibration.fit.noise_pixel);
  EXPECT_EQ(calibration.markers.at(1), Vector3(1, 0, 0));
  EXPECT_EQ(calibration.effects.at(0).parameters.at(0).sigma, 0.001);
  EXPECT_FALSE(calibration.gravity);
  EXPECT_THAT(calibration.notes, IsEmpty());
  EXPECT_THAT(parse_calibration(changed(small_calibration, "<fit ", "<foo/><fit "), "c").notes,
              ElementsAre(HasSubstr("<foo>")));
}

TEST(Calibration, XyzAndRpyDoWithoutAMatrix) {
  const std::string matrix = "<matrix>1 0 0 0.1  0 1 0 0.2  0 0 1 0.3  0 0 0 1</matrix>";
  const Calibration calibration =
      parse_calibration(changed(changed(small_calibration, matrix, ""), "rpy=\"0 0 0\"", "rpy=\"0 0 1\""), "c");
  EXPECT_EQ(calibration.tcp_from_body.motion.rotation, rotation_from_rpy({0, 0, 1}));
  EXPECT_THAT(refusal("rpy=\"0 0 0\"", "rpy=\"0 0 1\""), HasSubstr("another motion than its <matrix>"));
  EXPECT_EQ(refusal(" rpy=\"0 0 0\"", " rpy=\"0 0 1e-9\""), "nothing was refused");
  EXPECT_EQ(refusal("xyz=\"0.1 0.2 0.3\" rpy=\"0 0 0\"", ""), "nothing was refused");
}

TEST(CalibrationRefuses, WhatIsWrong) {
  EXPECT_THAT(refusal("version=\"1\"", "version=\"2\""),
              HasSubstr("line 1: <handsight_calibration> has version=\"2\""));
  EXPECT_THAT(find_refusal([] { parse_calibration("<handsight_session/>", "c.xml"); }),
              HasSubstr("expected <handsight_calibration>"));
  EXPECT_THAT(refusal("<matrix>1 0 0 0.1", "<matrix>2 0 0 0.1"), HasSubstr("line 2: <matrix> is no rigid motion"));
  EXPECT_THAT(refusal("<matrix>1 0 0 0.1", "<matrix>-1 0 0 0.1"), HasSubstr("no rigid motion"));
  EXPECT_THAT(refusal("0 0 0 1</matrix>", "0 0 1 1</matrix>"), HasSubstr("no rigid motion"));
  EXPECT_THAT(refusal("0 0 0 1</matrix>", "0 0 0</matrix>"), HasSubstr("has 15 numbers, expected 16, row by row"));
  EXPECT_THAT(refusal("x y z rx ry rz", "rx ry rz x y z"), HasSubstr("expected order=\"x y z rx ry rz\""));
  EXPECT_THAT(refusal("0 0 0 4 2 0", "0 0 0 4 1 0"), HasSubstr("not symmetric"));
  EXPECT_THAT(refusal("0 0 0 4 2 0  0 0 0 2 4 0", "0 0 0 4 5 0  0 0 0 5 4 0"), HasSubstr("correlations beyond 1"));
  EXPECT_THAT(refusal(">1 0 0 0 0 0", ">-1 0 0 0 0 0"), HasSubstr("negative variance"));
  EXPECT_THAT(refusal("1 0 0 0 0 0  0 1 0 0 0 0  0 0 1 0 0 0", "1 -.9 -.9 0 0 0  -.9 1 -.9 0 0 0  -.9 -.9 1 0 0 0"),
              HasSubstr("in some direction"));
  EXPECT_THAT(refusal("used=\"78\"", "used=\"-1\""), HasSubstr("used=\"-1\""));
  EXPECT_THAT(refusal("rms_pixel=\"0.5\"", "rms_pixel=\"null\""), HasSubstr("expected one finite number"));
  EXPECT_THAT(refusal("rms_pixel=\"0.5\"", "rms_pixel=\"-0.5\""), HasSubstr("expected at least 0"));
  EXPECT_THAT(refusal("index=\"1\"", "index=\"4096\""),
              HasSubstr("index=\"4096\", expected an integer from 0 to 4095"));
  EXPECT_THAT(refusal("index=\"1\"", "index=\"0\""), HasSubstr("a second time"));
  EXPECT_THAT(refusal("xyz=\"1 0 0\"", "xyz=\"1 0\""), HasSubstr("has 2 numbers in xyz"));
  EXPECT_THAT(refusal("<marker index=\"1\" xyz=\"1 0 0\"/><marker index=\"0\" xyz=\"0 0 0\"/>", ""),
              HasSubstr("holds no marker"));
  EXPECT_THAT(refusal("id=\"joint_offset\"", ""), HasSubstr("no attribute id"));
  EXPECT_THAT(refusal("value=\"0.01\"", ""), HasSubstr("no attribute value"));
  EXPECT_THAT(refusal("value=\"0.01\"", "value=\"nan\""), HasSubstr("\"nan\""));
  EXPECT_THAT(refusal("sigma=\"0.001\"", "sigma=\"-1\""), HasSubstr("expected at least 0"));
  EXPECT_THAT(refusal("<effects>", "<effects><effect id=\"joint_offset\"/>"), HasSubstr("a second time"));
  EXPECT_THAT(refusal("<parameter ", "<parameter of='j1' name='offset' value='1'/><parameter "),
              HasSubstr("is a second \"offset\" of \"j1\""));
  EXPECT_THAT(refusal("<fit ", "<joints>a a</joints><fit "), HasSubstr("a second time"));
  EXPECT_THAT(refusal("<fit ", "<model_covariance>1 0 0 1</model_covariance><fit "),
              HasSubstr("has 4 numbers, expected 49, row by row: 6 of TCP->Body and one for each parameter"));
  std::string zeros;
  for (int i = 0; i < 48; ++i) zeros += "0 ";
  EXPECT_EQ(refusal("<fit ", "<model_covariance>" + zeros + "0</model_covariance><fit "), "nothing was refused");
  EXPECT_THAT(refusal("<fit ", "<model_covariance>" + zeros + "-1</model_covariance><fit "),
              HasSubstr("negative variance"));
  EXPECT_THAT(refusal("<fit ", "<model_covariance>0 1 " + zeros.substr(4) + "0</model_covariance><fit "),
              HasSubstr("correlations beyond 1"));
}

TEST(CalibrationXml, PositionsReadBackBitForBitAndHaveANumberForEachJoint) {
  const Calibration written = some_calibration();
  std::string text = calibration_text(written);
  EXPECT_EQ(parse_calibration(text, "c.xml").positions, written.positions);
  EXPECT_THAT(parse_calibration(text, "c.xml").notes, IsEmpty());
  const std::size_t at = text.find("</positions>");
  ASSERT_NE(at, std::string::npos);
  text.insert(at, "0.5 ");
  try {
    parse_calibration(text, "c.xml");
    FAIL() << "five numbers for two joints were read";
  } catch (const InputError& refusal) {
    EXPECT_THAT(refusal.what(), HasSubstr("5 numbers"));
  }
}

}  // namespace
}  // namespace handsight
