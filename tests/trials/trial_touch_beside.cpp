// SPDX-License-Identifier: Apache-2.0
// trial_touch_beside [ROBOTS] [TOUCHES] [SEED]: one robot with all zeros off, calibrated once by a tracker and once by
// touches, of plates and of itself: how far its hand is off before a tracker that neither has seen.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "fixtures/touch_session.h"
#include "fixtures/two_arms.h"
#include "session/fixtures/list.h"

namespace handsight {
namespace {

constexpr double zeros = 2e-3;                // rad, one standard deviation
constexpr double tracker = 5e-5;              // m of a coordinate
constexpr double repeating = 3e-5;            // rad of each joint, anew in each pose
constexpr int tracked = 60, seen_anew = 100;  // poses

struct TouchedRobot {
  const char* name;
  Session touched, before_tracker;
  std::vector<std::string> joints;  // whose zeros are off
};

TouchedRobot plates() {
  TouchedRobot r{"a plate in three places", fixture::probe_session(), fixture::tracker_session(3), {}};
  r.before_tracker.mount.estimate = true;
  fixture::add_plates(r.touched);
  r.joints = r.touched.joints;
  return r;
}

/// The right hand's probe touches two balls and a plate of the left hand, and a ball at the chest.
TouchedRobot two_arms() {
  TouchedRobot r{"the other hand and the chest", fixture::hand_session('r', 1), fixture::hand_session('r'), {}};
  Session& s = r.touched;
  s.observations.clear();
  s.sigma_point = 2e-5;
  for (int i = 1; i <= 6; ++i) s.joints.push_back("l" + std::to_string(i));
  const auto add = [&](const FixtureKind* kind, const char* id, const char* link, const Vector3& place) {
    fixture::add_fixture(s, kind, id, place);
    (s.fixtures.size() == 1 ? s.mount : s.other_mounts.back()).link = link;
  };
  add(&fixtures::point, "ball", "left_hand", {0.12, 0, 0.03});
  add(&fixtures::point, "ball_2", "left_hand", {0.05, 0.06, 0.05});
  add(&fixtures::point, "socket", "chest", {0.4, -0.1, 0.2});
  for (const char side : {'r', 'l'})
    for (int i = 1; i <= 6; ++i) r.joints.push_back(side + std::to_string(i));
  return r;
}

SimulationOptions make_options(const std::vector<EffectTerm>& truth, const std::vector<std::string>& joints, int count,
                               std::uint64_t seed) {
  SimulationOptions o;
  o.observations = count;
  o.seed = seed;
  o.effects = truth;
  std::mt19937_64 random(seed + 77);
  std::normal_distribution<double> normal;
  for (std::int64_t id = 0; id < count; ++id)
    for (const std::string& joint : joints)
      o.disturbances.push_back({id, Disturbance::Kind::joint, joint, 0, repeating * normal(random)});
  return o;
}

bool is_read(const Session& s, const EffectTerm& t) {
  return std::count(s.joints.begin(), s.joints.end(), s.robot.joints[static_cast<std::size_t>(t.place)].name) > 0;
}

std::vector<EffectTerm> unknown(const std::vector<EffectTerm>& truth) {
  std::vector<EffectTerm> terms;
  for (const EffectTerm& t : truth) terms.push_back(term_of(term_effect(t), t.place));
  return terms;
}

/// m, root mean square of what the robot with these zeros leaves before a tracker; its place and the markers are free,
/// and so are the zeros of which the fit says that it does not know them.
double left_before(const Session& seen, const Fit& zeros_of) {
  FitOptions o;
  for (const FittedEffect& e : zeros_of.effects)
    if (e.sigmas[0] < 0.5 * term_effect(e.term).parameters[0].sigma)
      o.effects.push_back(e.term);
    else if (is_read(seen, e.term))
      o.estimated.push_back(term_of(term_effect(e.term), e.term.place));
  return fit(seen, o).residual_rms;
}

struct Compared {
  double by_touch = 0, by_tracker = 0, before = 0;  // m
};

Compared compare_once(const TouchedRobot& robot, int touches, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<EffectTerm> truth;
  for (const std::string& joint : robot.joints) {
    truth.push_back(term_of(*find_effect("joint_offset"), find_joint(robot.touched.robot, joint)));
    truth.back().values[0] = zeros * normal(random);
  }
  const Session touched =
      simulate_session(robot.touched, make_options(truth, robot.touched.joints, touches, seed)).session;
  SimulationOptions o = make_options(truth, robot.before_tracker.joints, tracked, seed + 1000000);
  o.noise = tracker;
  const Session calibrating = simulate_session(robot.before_tracker, o).session;
  o.observations = seen_anew;
  o.seed += 1000000;
  const Session anew = simulate_session(robot.before_tracker, o).session;
  std::vector<EffectTerm> of_hand;  // those of the joints that the tracker's session reads
  for (const EffectTerm& t : unknown(truth))
    if (is_read(anew, t)) of_hand.push_back(t);
  return {left_before(anew, fit(touched, {.estimated = unknown(truth)})),
          left_before(anew, fit(calibrating, {.estimated = of_hand})), fit(anew).residual_rms};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? NAN : values[values.size() / 2];
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  using namespace handsight;
  const int robots = argc > 1 ? std::atoi(argv[1]) : 20, touches = argc > 2 ? std::atoi(argv[2]) : 120;
  const std::uint64_t first = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  for (const TouchedRobot& robot : {plates(), two_arms()}) {
    std::vector<double> ratios, by_touch, by_tracker, before;
    for (int i = 0; i < robots; ++i) {
      const Compared c = compare_once(robot, touches, first + static_cast<std::uint64_t>(i));
      ratios.push_back(c.by_touch / c.by_tracker);
      by_touch.push_back(c.by_touch), by_tracker.push_back(c.by_tracker), before.push_back(c.before);
    }
    fmt::print(
        "{}: before a tracker that was not used, {} robots, {} touches: {:.3f} mm without zeros, {:.3f} by {} poses "
        "before a tracker, {:.3f} by touches (medians); touches by tracker {:.3f} in the median, at most {:.3f}, "
        "within 1.10 of {}\n",
        robot.name, robots, touches, 1e3 * median(before), 1e3 * median(by_tracker), tracked, 1e3 * median(by_touch),
        median(ratios), *std::max_element(ratios.begin(), ratios.end()),
        std::count_if(ratios.begin(), ratios.end(), [](double r) { return r <= 1.1; }));
    std::fflush(stdout);
  }
}
