// SPDX-License-Identifier: Apache-2.0
// Does the online estimate approach its final value as its covariance says? And what does it do where the
// robot has a hidden error, of which the noise knows nothing?
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cstdlib>

#include "estimation/online/online.h"
#include "session/session_xml.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

constexpr int observations = 100;
constexpr int first_tested = 10, last_tested = 90;
constexpr double least_share = 0.93, most_share = 0.97;

/// The estimate after each observation, index n - 1.
struct OnlineCurve {
  std::vector<OnlineStep> steps;
  std::vector<Matrix6> by_noise;  // the covariance that the noise alone gives
  int rejected = 0;
};

/// Justin's right hand as in sample_sessions/hundred_poses, without its bad poses.
OnlineCurve calibrate(const Session& like, std::uint64_t seed, double sag) {
  SimulationOptions options;
  options.follow = true;
  options.seed = seed;
  options.observations = observations;
  for (const char* joint : {"right_arm_1", "right_arm_2", "right_arm_3", "right_arm_4"})
    if (sag > 0) options.effects.push_back({"joint_elasticity", find_joint(like.robot, joint), {sag}});
  const SimulatedSession s = simulate_session(like, options);
  OnlineCalibration online(s.session);
  OnlineCurve curve;
  for (const Observation& o : s.session.observations) {
    OnlineStep step = online.add(o, nullptr);
    if (!step.accepted) {
      ++curve.rejected;
      continue;
    }
    const Eigen::Index markers = 3 * s.session.marker_count;
    const BodyFrame frame = body_frame(*online.sides(), online.estimate()->unknowns().markers_in_tcp);
    curve.by_noise.push_back(
        s.noise * s.noise *
        body_covariance(frame, online.estimate()->unit_covariance().topLeftCorner(markers, markers)));
    curve.steps.push_back(std::move(step));
  }
  return curve;
}

/// xi from the final estimate to the one after n observations.
Vector6 from_final(const OnlineCurve& curve, int n) {
  return small_motion_between(curve.steps.back().tcp_from_body,
                              curve.steps[static_cast<std::size_t>(n - 1)].tcp_from_body);
}

/// An efficient estimate of part of the data differs from that of all by the difference of the covariances.
bool passes(const OnlineCurve& curve, int n) {
  static const double limit = boost::math::quantile(boost::math::chi_squared(6), 0.95);
  const Matrix6 covariance = curve.steps[static_cast<std::size_t>(n - 1)].covariance - curve.steps.back().covariance;
  const Vector6 xi = from_final(curve, n);
  const double distance = xi.dot(covariance.ldlt().solve(xi));
  return distance >= 0 && distance <= limit;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void count_rejected_and_scatter(const std::vector<OnlineCurve>& curves) {
  int rejected = 0, repeatability = 0, steps = 0;
  for (const OnlineCurve& c : curves) {
    rejected += c.rejected;
    for (std::size_t k = first_tested - 1; k < c.steps.size(); ++k) {
      ++steps;
      repeatability += c.steps[k].covariance_is_scatter ? 1 : 0;
    }
  }
  fmt::print("observations rejected: {}; covariance by scatter in {} of {} steps from n = {} on\n", rejected,
             repeatability, steps, first_tested);
}

/// Steps whose covariance, or whose final one, is by scatter are shares of another statistic: counted, not
/// tested.
bool print_shares(const std::vector<OnlineCurve>& curves) {
  long tested = 0, passed = 0, left_out = 0;
  const Session like = read_session(HANDSIGHT_SOURCE_DIR "/sample_sessions/rigs/justin_head");
  bool met = true;
  std::string per_n;
  for (int n = first_tested; n <= last_tested; ++n) {
    int tested_n = 0, passed_n = 0;
    for (const OnlineCurve& c : curves) {
      if (static_cast<int>(c.steps.size()) <= n) continue;
      if (c.steps[static_cast<std::size_t>(n - 1)].covariance_is_scatter || c.steps.back().covariance_is_scatter) {
        ++left_out;
        continue;
      }
      ++tested_n;
      passed_n += passes(c, n) ? 1 : 0;
    }
    tested += tested_n;
    passed += passed_n;
    if (n == 10 || n == 20 || n == 45 || n == 80)
      per_n += fmt::format("  n = {}: {:.1f} %", n, tested_n ? 100.0 * passed_n / tested_n : 0.0);
  }
  const double share = tested ? static_cast<double>(passed) / static_cast<double>(tested) : 0.0;
  met = share >= least_share && share <= most_share;
  fmt::print(
      "within the 95 % ellipsoid of cov_n - cov_100: {:.2f} % of {} (n = {} to {}; {} by scatter left out) "
      "{}\n{}\n",
      100 * share, tested, first_tested, last_tested, left_out, met ? "ok" : "NOT MET", per_n);
  return met;
}

/// The first n from which the parameter stays within twice `sigma` of its final value.
int settled(const OnlineCurve& curve, int parameter, double sigma) {
  int n = static_cast<int>(curve.steps.size());
  while (n > 1 && std::abs(from_final(curve, n - 1)[parameter]) <= 2 * sigma) --n;
  return n;
}

/// Medians over the seeds, parameter by parameter.
void print_behaviour(const std::vector<OnlineCurve>& curves) {
  fmt::print("medians over the seeds; wander: the largest distance from the final value after n = 45\n");
  fmt::print(
      "        noise sigma at 100   reported/noise sigma   wander/noise sigma   wander/reported sigma   "
      "settled within 2 noise sigma   2 reported sigma\n");
  const char* names[] = {"x", "y", "z", "rx", "ry", "rz"};
  for (int i = 0; i < 6; ++i) {
    std::vector<double> noise_sigma, ratio, by_noise, by_reported, settled_noise, settled_reported;
    for (const OnlineCurve& c : curves) {
      const double noise = std::sqrt(c.by_noise.back()(i, i));
      const double reported = std::sqrt(c.steps.back().covariance(i, i));
      double wander = 0;
      for (int n = 45; n < static_cast<int>(c.steps.size()); ++n)
        wander = std::max(wander, std::abs(from_final(c, n)[i]));
      noise_sigma.push_back(1e6 * noise);
      ratio.push_back(reported / noise);
      by_noise.push_back(wander / noise);
      by_reported.push_back(wander / reported);
      settled_noise.push_back(settled(c, i, noise));
      settled_reported.push_back(settled(c, i, reported));
    }
    fmt::print("{:>4}  {:10.1f} {:<4}  {:19.1f}  {:21.1f}  {:20.2f}  {:26.0f}  {:19.0f}\n", names[i],
               median(noise_sigma), i < 3 ? "um" : "urad", median(ratio), median(by_noise), median(by_reported),
               median(settled_noise), median(settled_reported));
  }
}

}  // namespace
}  // namespace handsight

/// trial_convergence [seeds] [sag in rad/(N m)]
int main(int argc, char** argv) {
  using namespace handsight;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 200;
  const double hidden = argc > 2 ? std::atof(argv[2]) : 2e-4;
  const Session like = read_session(HANDSIGHT_SOURCE_DIR "/sample_sessions/rigs/justin_head");
  bool met = true;
  for (const double sag : {0.0, hidden}) {
    std::vector<OnlineCurve> curves;
    for (int seed = 1; seed <= seeds; ++seed) curves.push_back(calibrate(like, static_cast<std::uint64_t>(seed), sag));
    fmt::print("\n{} seeds, {} observations each, {}\n", seeds, observations,
               sag > 0 ? fmt::format("hidden sag of {:.0e} rad/(N m) at the arm's first four joints", sag)
                       : "no hidden effect");
    count_rejected_and_scatter(curves);
    if (sag == 0) met = print_shares(curves);
    print_behaviour(curves);
  }
  return met ? 0 : 1;
}
