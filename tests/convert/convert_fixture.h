// SPDX-License-Identifier: Apache-2.0
// What users bring to `convert`, written from a session with known truth.
#pragma once

#include <gmock/gmock.h>

#include "convert/convert.h"
#include "estimation/fit/fit.h"
#include "fixtures/robot_texts.h"
#include "fixtures/robots_with_everything.h"
#include "session/session_xml.h"

namespace handsight {

/// A tracker session with known truth, whose parts are then written as other programs write them.
class Convert : public testing::Test {
 protected:
  Convert() {
    SimulationOptions options;
    options.observations = 40;
    options.seed = 5;
    truth = simulate_session(fixture::tracker_session(4), options);
    write("robot.urdf", fixture::urdf_text(truth.session.robot));
    options_.tcp = "hand";
    options_.mount = "stand";
    options_.out = folder.path / "made";
  }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder.path / name).parent_path());
    std::ofstream(folder.path / name) << text;
    return folder.path / name;
  }

  /// A table of joint readings; `unit` of each number.
  std::string joints_csv(double unit = 1, const std::string& header = "time,a1,a2,a3,a4,a5,a6", bool with_time = true) {
    std::string text = header.empty() ? "" : header + "\n";
    for (std::size_t i = 0; i < truth.session.observations.size(); ++i) {
      if (with_time) text += fmt::format("{},", 10.0 * static_cast<double>(i));
      const Eigen::VectorXd& q = truth.session.observations[i].position;
      for (Eigen::Index j = 0; j < 6; ++j) text += fmt::format("{}{}", j ? "," : "", q[j] * unit);
      text += "\n";
    }
    return text;
  }

  std::string points_csv(double unit = 1) {
    std::string text = "time";
    for (int m = 0; m < 4; ++m) text += fmt::format(",m{0}_x,m{0}_y,m{0}_z", m);
    for (std::size_t i = 0; i < truth.session.observations.size(); ++i) {
      text += fmt::format("\n{}", 10.0 * static_cast<double>(i));
      for (const Sighting& s : truth.session.observations[i].sightings)
        text += fmt::format(",{},{},{}", s.point->x() * unit, s.point->y() * unit, s.point->z() * unit);
    }
    return text + "\n";
  }

  Conversion converted(const std::vector<std::filesystem::path>& files) {
    std::filesystem::remove_all(options_.out);
    std::vector<std::filesystem::path> all = files;
    all.push_back(folder.path / "robot.urdf");
    return convert(all, options_);
  }

  std::string refusal(const std::vector<std::filesystem::path>& files) {
    try {
      converted(files);
    } catch (const InputError& error) {
      EXPECT_GE(std::string(error.what()).size(), 20u);
      EXPECT_LE(std::string(error.what()).size(), 600u);
      return error.what();
    }
    return "no refusal";
  }

  /// The converted session fits to the device's noise, with the same body.
  void expect_good(const Session& session) {
    ASSERT_EQ(session.observations.size(), truth.session.observations.size());
    const Fit f = fit(session);
    EXPECT_TRUE(f.converged());
    EXPECT_LT(f.residual_rms, 3e-4);  // m; 0.2 mm of noise
    EXPECT_EQ(read_session(options_.out).observations.size(), session.observations.size());
  }

  SimulatedSession truth;
  TemporaryFolder folder;
  ConvertOptions options_;
};

/// The body's pose in the tracker's frame, as mocap gives a rigid body.
inline std::vector<Rigid> target_poses(const SimulatedSession& truth, const Rigid& tcp_from_target) {
  std::vector<Rigid> poses;
  const Chain chain = make_chain(truth.session);
  for (const Observation& o : truth.session.observations)
    poses.push_back(sensor_from_tcp(chain_ends(chain, o.position), truth.mount_from_sensor) * tcp_from_target);
  return poses;
}

}  // namespace handsight
