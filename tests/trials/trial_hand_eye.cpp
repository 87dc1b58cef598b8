// SPDX-License-Identifier: Apache-2.0
// Hand-eye from images of a board with a robot that errs, beside the best of OpenCV's seven ways and the bound: what a
// fit that was given both noises would reach. trial_hand_eye [COUNT] [FIRST_SEED]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "estimation/fit/fit.h"
#include "estimation/problem/problem.h"
#include "fixtures/hand_eye.h"
#include "trials/table.h"

namespace {
using namespace handsight;

cv::Mat rotation(const Rigid& r) {
  cv::Mat m(3, 3, CV_64F);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m.at<double>(i, j) = r.rotation(i, j);
  return m;
}

cv::Mat translation(const Rigid& r) {
  return (cv::Mat_<double>(3, 1) << r.translation.x(), r.translation.y(), r.translation.z());
}

/// Camera on the flange by each of OpenCV's ways, from poses of the board by solvePnP: errors of the place, m.
std::vector<double> opencv_errors(const fixture::HandEye& h) {
  std::vector<cv::Mat> r_flange, t_flange, r_base, t_base, r_board, t_board;
  const Camera& c = h.session.rig->at(0).camera;
  const cv::Mat k = (cv::Mat_<double>(3, 3) << c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1);
  const cv::Mat d = (cv::Mat_<double>(4, 1) << c.k1, c.k2, c.p1, c.p2);
  std::vector<cv::Point3d> board;
  for (const Vector3& x : h.board) board.emplace_back(x.x(), x.y(), x.z());
  for (const Observation& o : h.session.observations) {
    const Rigid flange = base_from_flange(o.position);
    r_flange.push_back(rotation(flange)), t_flange.push_back(translation(flange));
    r_base.push_back(rotation(inverse(flange))), t_base.push_back(translation(inverse(flange)));
    std::vector<cv::Point2d> seen;
    for (const Sighting& s : o.sightings) seen.emplace_back(seen_by(s, 0)->pixel.x(), seen_by(s, 0)->pixel.y());
    cv::Mat turn, t, r;
    cv::solvePnP(board, seen, k, d, turn, t);
    cv::Rodrigues(turn, r);
    r_board.push_back(r), t_board.push_back(t);
  }
  std::vector<double> errors;
  const auto take = [&](const cv::Mat& t) {
    errors.push_back(
        (Vector3(t.at<double>(0), t.at<double>(1), t.at<double>(2)) - h.flange_from_camera.translation).norm());
  };
  for (const auto way : {cv::CALIB_HAND_EYE_TSAI, cv::CALIB_HAND_EYE_PARK, cv::CALIB_HAND_EYE_HORAUD,
                         cv::CALIB_HAND_EYE_ANDREFF, cv::CALIB_HAND_EYE_DANIILIDIS}) {
    cv::Mat r, t;
    cv::calibrateHandEye(r_flange, t_flange, r_board, t_board, r, t, way);
    take(t);
  }
  for (const auto way : {cv::CALIB_ROBOT_WORLD_HAND_EYE_SHAH, cv::CALIB_ROBOT_WORLD_HAND_EYE_LI}) {
    cv::Mat r_world, t_world, r, t;
    cv::calibrateRobotWorldHandEye(r_board, t_board, r_base, t_base, r_world, t_world, r, t, way);
    const cv::Mat back = -r.t() * t;  // it gives the flange in the camera's frame
    take(back);
  }
  return errors;
}

double rms(const std::vector<double>& v) {
  double squares = 0;
  for (const double x : v) squares += x * x;
  return std::sqrt(squares / static_cast<double>(v.size()));
}

void trial(int count, std::uint64_t first, int poses, double place, double turn, trials::Table& table) {
  std::vector<double> ours, bound;
  std::vector<std::vector<double>> theirs(7);
  int inside = 0, numbers = 0, converged = 0;
  for (int i = 0; i < count; ++i) {
    const fixture::HandEye h = fixture::hand_eye(
        {.poses = poses, .place = place, .turn = turn, .seed = first + static_cast<std::uint64_t>(i)});
    const Fit f = fit(h.session);
    converged += f.converged();
    // As the covariance has it, in the camera's own frame.
    const Vector6 off = small_motion_between(inverse(estimate(f).mount_from_sensor), inverse(h.flange_from_camera));
    ours.push_back((estimate(f).mount_from_sensor.translation - h.flange_from_camera.translation).norm());
    const Eigen::Index mount = f.problem.mount_column();
    for (int n = 0; n < 6; ++n)
      inside += std::abs(off[n]) < 1.96 * std::sqrt(f.parameter_covariance(mount + n, mount + n));
    numbers += 6;
    Problem reported = f.problem;
    reported.flange_error = {place, turn};
    reported.noise = 0.15;
    const Solution best = solve(reported, estimate(f), {.fixed_body = true});
    bound.push_back((best.unknowns.mount_from_sensor.translation - h.flange_from_camera.translation).norm());
    const std::vector<double> errors = opencv_errors(h);
    for (std::size_t w = 0; w < errors.size(); ++w) theirs[w].push_back(std::isfinite(errors[w]) ? errors[w] : 1);
  }
  double best = std::numeric_limits<double>::infinity();
  for (const auto& way : theirs) best = std::min(best, rms(way));
  table.print({fmt::format("{:.1f} mm, {:.1f} mrad", 1e3 * place, 1e3 * turn), poses, 1e3 * rms(ours), 1e3 * rms(bound),
               1e3 * best, 100.0 * inside / numbers});
  if (converged < count) fmt::print("  converged {} of {}\n", converged, count);
}

}  // namespace

int main(int argc, char** argv) {
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  const auto first = static_cast<std::uint64_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  trials::Table table({{.heading = "robot", .width = 18},
                       {"poses"},
                       {"ours", 3},
                       {"given both noises", 3},
                       {"best of OpenCV's seven", 3},
                       {"inside", 1, "%"}},
                      output);
  for (const double place : {1e-4, 3e-4, 1e-3, 3e-3})
    for (const int poses : {4, 6, 8, 15, 40}) trial(count, first, poses, place, 3 * place, table);
}
