// SPDX-License-Identifier: Apache-2.0
// A camera on a flange before a target on the table, as pairs of poses with known truth, and what controllers write.
#pragma once

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <fstream>
#include <random>

#include "convert/convert.h"
#include "estimation/fit/fit.h"
#include "fixtures/drawn.h"
#include "temporary_folder.h"

namespace handsight {

class HandEyeTables : public testing::Test {
 protected:
  HandEyeTables() {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto drawn = [&](double size) { return Vector3(size * fixture::drawn_3([&] { return normal(random); })); };
    for (int i = 0; i < 16; ++i) {
      const Vector3 turn = drawn(0.35), place = drawn(0.12);
      flange.push_back(
          {rotation_from_rpy({3.14159 + turn.x(), turn.y(), 1.5 * turn.z()}), Vector3(0.55, 0.1, 0.5) + place});
      const Rigid seen = inverse(flange.back() * mount) * board;
      const Rigid noise{rotation_from_vector<double>(drawn(0.001)), drawn(2e-4)};
      target.push_back(noise * seen);
    }
    options.out = folder.path / "made";
  }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder.path / name).parent_path());
    std::ofstream(folder.path / name) << text;
    return folder.path / name;
  }

  Conversion converted(const std::vector<std::filesystem::path>& files) {
    std::filesystem::remove_all(options.out);
    return convert(files, options);
  }

  std::string refusal(const std::vector<std::filesystem::path>& files) {
    try {
      converted(files);
    } catch (const InputError& error) {
      EXPECT_LE(std::string(error.what()).size(), 600u);
      EXPECT_FALSE(std::filesystem::exists(options.out)) << "a half-made folder stayed";
      return error.what();
    }
    return "no refusal";
  }

  void expect_right(const Session& session, const std::string& what, std::size_t count = 16) {
    EXPECT_EQ(session.observations.size(), count) << what;
    const Rigid found = estimate(fit(session)).mount_from_sensor;
    EXPECT_LT((found.translation - mount.translation).norm(), 1e-3) << what;
    EXPECT_LT((found.rotation - mount.rotation).norm(), 5e-3) << what;
  }

  static std::string quaternions(const std::vector<Rigid>& poses) {
    std::string text = "x,y,z,qx,qy,qz,qw\n";
    for (const Rigid& p : poses) text += place(p, 1, ",") + fmt::format(",{}\n", joined(quaternion(p, false), ","));
    return text;
  }

  static std::string place(const Rigid& p, double unit, const char* between) {
    return joined({unit * p.translation.x(), unit * p.translation.y(), unit * p.translation.z()}, between);
  }
  static std::string joined(const std::vector<double>& numbers, const char* between) {
    std::string text;
    for (const double n : numbers) text += fmt::format("{}{:.9g}", text.empty() ? "" : between, n);
    return text;
  }
  static std::vector<double> quaternion(const Rigid& p, bool w_first) {
    const Eigen::Quaterniond q(p.rotation);
    if (w_first) return {q.w(), q.x(), q.y(), q.z()};
    return {q.x(), q.y(), q.z(), q.w()};
  }
  /// By Eigen: turns about these moving axes.
  static std::vector<double> euler(const Rigid& p, int a, int b, int c, double unit) {
    const Vector3 e = unit * p.rotation.eulerAngles(a, b, c);
    return {e.x(), e.y(), e.z()};
  }
  static std::vector<double> fixed_xyz(const Rigid& p, double unit) {
    const std::vector<double> e = euler(p, 2, 1, 0, unit);
    return {e[2], e[1], e[0]};
  }
  static std::vector<double> vector(const Rigid& p) {
    const Eigen::AngleAxisd a(p.rotation);
    const Vector3 v = a.angle() * a.axis();
    return {v.x(), v.y(), v.z()};
  }
  static std::vector<double> matrix(const Rigid& p, double unit = 1) {
    std::vector<double> n;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) n.push_back(p.rotation(r, c));
      n.push_back(unit * p.translation[r]);
    }
    n.insert(n.end(), {0, 0, 0, 1});
    return n;
  }

  static constexpr double degrees = 57.29577951308232;
  const Rigid mount{rotation_from_rpy({0.03, -0.05, 1.5}), {0.062, -0.034, 0.047}},
      board{rotation_from_rpy({0.02, 0.03, 0.5}), {0.55, 0.08, 0.01}};
  std::vector<Rigid> flange, target;
  TemporaryFolder folder;
  ConvertOptions options;
};

}  // namespace handsight
