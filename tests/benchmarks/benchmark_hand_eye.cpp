// SPDX-License-Identifier: Apache-2.0
// TCP->Body beside OpenCV's seven hand-eye solvers on the same simulated sessions: a ChArUco board before one camera
// and before two, and poses alone. benchmark_hand_eye [SEEDS] [POSES] [--markdown]. The cameras stand, the target is on
// the hand, nothing is known of the mount. The solvers get each pose of the target as the least squares of its pixels
// with the true shape, from the true pose: the best that could be handed to them; our fit gets the pixels and that
// shape. `bound`: what no unbiased program can be below (Cramer and Rao): errors drawn from the inverse of the
// measurements' information on the target's place, with the mount unknown.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <opencv2/calib3d.hpp>
#include <random>

#include "chain/body_frame.h"
#include "estimation/fit/fit.h"
#include "estimation/problem/body_pose.h"
#include "fixtures/targets.h"
#include "session/pose_points.h"
#include "trials/table.h"

namespace handsight {
namespace {

struct Case {
  std::string name;
  Session like;
};

Session pose_session() {
  Session s = fixture::tracker_session(3);
  s.pose_sensor = PoseSensor{5e-4, 1e-3};
  show_poses(s, pose_lever(*s.pose_sensor));
  return s;
}

cv::Mat make_matrix(const Matrix3& r) {
  cv::Mat m(3, 3, CV_64F);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m.at<double>(i, j) = r(i, j);
  return m;
}

cv::Mat make_vector(const Vector3& t) { return (cv::Mat_<double>(3, 1) << t.x(), t.y(), t.z()); }

Rigid make_rigid(const cv::Mat& r, const cv::Mat& t) {
  Rigid motion;
  for (int i = 0; i < 3; ++i) {
    motion.translation[i] = t.at<double>(i);
    for (int j = 0; j < 3; ++j) motion.rotation(i, j) = r.at<double>(i, j);
  }
  return motion;
}

/// root_from_tcp and sensor_from_target of every observation.
struct Poses {
  std::vector<Rigid> root_from_tcp, sensor_from_target;
};

Rigid by_solver(const Poses& p, int solver) {
  std::vector<cv::Mat> hand_r, hand_t, target_r, target_t;
  for (std::size_t i = 0; i < p.root_from_tcp.size(); ++i) {
    const Rigid hand = solver < 5 ? p.root_from_tcp[i] : inverse(p.root_from_tcp[i]);
    const Rigid target_from_sensor = inverse(p.sensor_from_target[i]);
    hand_r.push_back(make_matrix(hand.rotation));
    hand_t.push_back(make_vector(hand.translation));
    target_r.push_back(make_matrix(target_from_sensor.rotation));
    target_t.push_back(make_vector(target_from_sensor.translation));
  }
  cv::Mat r, t, other_r, other_t;
  if (solver < 5) {
    cv::calibrateHandEye(hand_r, hand_t, target_r, target_t, r, t, static_cast<cv::HandEyeCalibrationMethod>(solver));
    return make_rigid(r, t);
  }
  cv::calibrateRobotWorldHandEye(target_r, target_t, hand_r, hand_t, other_r, other_t, r, t,
                                 static_cast<cv::RobotWorldHandEyeCalibrationMethod>(solver - 5));
  return inverse(make_rigid(r, t));
}

constexpr const char* solvers[] = {
    "Tsai", "Park", "Horaud", "Andreff", "Daniilidis", "Shah (robot-world)", "Li (robot-world)"};

struct Errors {
  std::vector<double> mm, degrees;
  int failed = 0;
  double seconds = 0;
  void add(const Rigid& truth, const Rigid& found) {
    const Rigid off = inverse(truth) * found;
    if (!off.translation.allFinite() || !off.rotation.allFinite()) {
      ++failed;
      return;
    }
    mm.push_back(1e3 * off.translation.norm());
    degrees.push_back(57.29577951308232 * vector_from_rotation(off.rotation).norm());
  }
};

/// Errors of this covariance.
void draw(const Fit& f, std::uint64_t seed, Errors& bound) {
  constexpr int draws = 50;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const Matrix6 root = f.covariance.llt().matrixL();
  for (int i = 0; i < draws; ++i) {
    Vector6 v;
    for (double& x : v) x = normal(random);
    bound.add(f.tcp_from_body, small_motion<double>(Vector6(root * v)) * f.tcp_from_body);
  }
}

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

void tell(const std::string& name, const Errors& e) {
  fmt::print("  {:<12} {:>10.4f} {:>10.4f} mm   {:>10.5f} {:>10.5f} deg   {:>8.3f} ms{}\n", name, median(e.mm),
             e.mm.empty() ? 0.0 : *std::max_element(e.mm.begin(), e.mm.end()), median(e.degrees),
             e.degrees.empty() ? 0.0 : *std::max_element(e.degrees.begin(), e.degrees.end()),
             1e3 * e.seconds / std::max<std::size_t>(1, e.mm.size()),
             e.failed > 0 ? fmt::format("   {} failed", e.failed) : std::string());
}

template <class Work>
void timed(Errors& e, const Work& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  e.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Of one case.
struct AllErrors {
  std::map<int, Errors> theirs;
  Errors ours, bound;
};

AllErrors run(const Case& c, int seeds, int observations) {
  AllErrors all;
  auto& [theirs, ours, bound] = all;
  for (int seed = 1; seed <= seeds; ++seed) {
    SimulationOptions o;
    o.seed = static_cast<std::uint64_t>(seed);
    o.observations = observations;
    SimulatedSession s = simulate_session(c.like, o);
    const std::vector<Vector3>& lie = s.session.shape->markers;
    const BodySides sides = choose_sides({lie.begin(), lie.end()});
    const Rigid truth = body_frame(sides, s.markers_in_tcp).tcp_from_body;
    std::vector<Vector3> in_body;
    for (const Vector3& x : s.markers_in_tcp) in_body.push_back(inverse(truth) * x);
    Poses poses;
    for (std::size_t k = 0; k < s.session.observations.size(); ++k) {
      const Rigid true_pose = inverse(s.root_from_sensor[k]) * s.root_from_tcp[k] * truth;
      std::optional<Rigid> pose = s.session.observations[k].target_pose;
      if (!pose)
        if (const auto found = estimate_body_pose(s.session.rig ? &*s.session.rig : nullptr,
                                                  s.session.observations[k].sightings, in_body, true_pose))
          pose = found->sensor_from_body;
      if (!pose) continue;
      poses.root_from_tcp.push_back(s.root_from_tcp[k]);
      poses.sensor_from_target.push_back(*pose);
    }
    for (int solver = 0; solver < 7; ++solver) {
      Rigid found;
      timed(theirs[solver], [&] { found = by_solver(poses, solver); });
      theirs[solver].add(truth, found);
    }
    s.session.mount.estimate = true;
    s.session.mount.known = false;
    s.session.mount.mount_from_sensor = Rigid{};
    Fit fitted;
    timed(ours, [&] {
      FitOptions options;
      options.sides = sides;
      fitted = fit(s.session, options);
    });
    ours.add(truth, fitted.tcp_from_body);
    if (fitted.covariance_kind == CovarianceKind::noise) draw(fitted, o.seed, bound);
  }
  fmt::print("{}, {} sessions of {} poses: median and worst error of place and turn, time\n", c.name, seeds,
             observations);
  for (int solver = 0; solver < 7; ++solver) tell(solvers[solver], theirs[solver]);
  tell("Handsight", ours);
  tell("bound", bound);
  std::fflush(stdout);
  return all;
}

std::string median_and_worst(const std::vector<double>& v, const char* unit) {
  return v.empty() ? "" : fmt::format("{:.3g} / {:.3g} {}", median(v), *std::max_element(v.begin(), v.end()), unit);
}

/// A row: what `of` picks in each case.
template <class Of>
void print(trials::Table& table, const std::string& name, const std::vector<AllErrors>& cases, const Of& of) {
  std::vector<trials::TableCell> row{name};
  for (const AllErrors& all : cases) {
    row.emplace_back(median_and_worst(of(all).mm, "mm"));
    row.emplace_back(median_and_worst(of(all).degrees, "deg"));
  }
  table.print(row);
}

/// The medians of what `of` picks over the best median of the solvers.
template <class Of>
void print_over_best(trials::Table& table, const std::string& name, const std::vector<AllErrors>& cases, const Of& of) {
  std::vector<trials::TableCell> row{name};
  for (const AllErrors& all : cases)
    for (const auto numbers : {&Errors::mm, &Errors::degrees}) {
      double best = 1e300;
      for (const auto& [solver, e] : all.theirs) best = std::min(best, median(e.*numbers));
      row.emplace_back(median(of(all).*numbers) / best);
    }
  table.print(row);
}

void print_all(const std::vector<AllErrors>& cases, const trials::TableOutput& output) {
  std::vector<trials::TableColumn> columns{{.heading = "median / worst", .width = 26}};
  for (const char* name : {"one camera", "two cameras", "poses alone"})
    for (const char* what : {"place", "turn"})
      columns.push_back({.heading = fmt::format("{}: {}", name, what), .digits = 3, .width = 20});
  trials::Table table(columns, output);
  const auto ours = [](const AllErrors& all) -> const Errors& { return all.ours; };
  const auto bound = [](const AllErrors& all) -> const Errors& { return all.bound; };
  for (int solver = 0; solver < 7; ++solver)
    print(table, solvers[solver], cases, [&](const AllErrors& all) -> const Errors& { return all.theirs.at(solver); });
  print(table, "Handsight", cases, ours);
  print_over_best(table, "over the best of them", cases, ours);
  print(table, "bound", cases, bound);
  print_over_best(table, "bound over the best of them", cases, bound);
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  using namespace handsight;
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 200, poses = argc > 2 ? std::atoi(argv[2]) : 20;
  print_all({run({"One camera, a ChArUco board", fixture::target_session(fixture::charuco(), 1)}, seeds, poses),
             run({"Two cameras, a ChArUco board", fixture::target_session(fixture::charuco(), 2)}, seeds, poses),
             run({"Poses alone", pose_session()}, seeds, poses)},
            output);
}
