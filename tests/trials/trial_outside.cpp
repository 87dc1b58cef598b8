// SPDX-License-Identifier: Apache-2.0
// What does it say of deviations that the catalogue does not have? trial_outside COUNT [FIRST_SEED] [ROBOT]
// [sine3|tool|coupling|drift|cubic]
#include <fmt/format.h>

#include <cstdio>

#include "fixtures/trial_sessions.h"

namespace handsight::trials {
namespace {

/// Deviations that the catalogue does not have. Returns the variable that they follow ("" where the joint's own angle).
struct Outside {
  Session session;
  std::string variable;
};

Rigid small(const Vector6& v, double factor) { return small_motion<double>(Vector6(factor * v)); }

/// Moves the images by what a motion of the tool or of the sensor in each observation would change.
template <class Motion>
void move_images(const SimulatedSession& s, Session& session, Motion&& motion) {
  for (std::size_t i = 0; i < session.observations.size(); ++i) {
    const auto [tool, sensor] = motion(i);
    const Rigid before = inverse(s.root_from_sensor[i]) * s.root_from_tcp[i];
    const Rigid after = inverse(s.root_from_sensor[i] * sensor) * s.root_from_tcp[i] * tool;
    for (Sighting& g : session.observations[i].sightings) {
      const Vector3 x = s.markers[i][static_cast<std::size_t>(g.marker)];
      for (CameraPoint& seen : g.in_cameras) {
        const RigCamera& c = s.true_rig->at(seen.camera);
        seen.pixel += project(c.camera, c.camera_from_first * (after * x)) -
                      project(c.camera, c.camera_from_first * (before * x));
      }
    }
  }
}

Outside outside_session(const Session& like, const SimulatedSession& s, const std::string& kind, std::uint64_t seed) {
  std::mt19937_64 random(seed * 31 + 7);
  std::normal_distribution<double> normal;
  const Chain chain = make_chain(like);
  const auto joints = static_cast<int>(chain.joints.size());
  Outside out{s.session, ""};
  // Joints between sensor and hand that matter: the middle of the arm.
  const int first = joints >= 10 ? 3 : 0;
  const int j = first + static_cast<int>(random() % 4),
            other = first + static_cast<int>((random() % 3 + 1 + static_cast<unsigned>(j - first)) % 4);
  const auto name = [&](int k) {
    return like.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(k)])].name;
  };
  Vector6 v;
  for (int k = 0; k < 6; ++k) v[k] = normal(random) * (k < 3 ? 1e-3 : 2e-3);
  const double size = 1e-3 * (1 + std::abs(normal(random)));
  if (kind == "sine3" || kind == "coupling" || kind == "cubic") {
    const auto torque_at = [&](const Observation& o) {
      const Posture p = solve_posture(chain.robot, joint_values(chain.robot, chain.joints, o.position), chain.gravity);
      return p.torque[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
    };
    double squares = 0;
    for (const Observation& o : out.session.observations) squares += std::pow(torque_at(o), 2);
    const double usual = std::sqrt(squares / static_cast<double>(out.session.observations.size()));
    for (Observation& o : out.session.observations) {
      const double q = o.position[j];
      if (kind == "sine3") o.position[j] -= size * std::sin(3 * q + 0.7);
      if (kind == "coupling") o.position[j] -= 2 * size * o.position[other];
      if (kind == "cubic" && usual > 0.5) o.position[j] -= size * std::pow(torque_at(o) / usual, 3);
    }
    out.variable =
        kind == "cubic" ? "gravity torque at " + name(j) : "angle of " + name(kind == "coupling" ? other : j);
  } else if (kind == "tool") {
    move_images(s, out.session, [&](std::size_t i) {
      return std::pair(small(v, std::sin(3.3 * out.session.observations[i].position[j])), Rigid{});
    });
    out.variable = "angle of " + name(j);
  } else {
    const double whole = out.session.observations.back().time;
    move_images(s, out.session, [&](std::size_t i) {
      return std::pair(Rigid{}, small(v, std::sin(2 * 3.14159265 * 2.3 * out.session.observations[i].time / whole)));
    });
    out.variable = "time";
  }
  return out;
}

int outside_trials(const Arguments& a) {
  for (const std::string kind : {"sine3", "tool", "coupling", "drift", "cubic"}) {
    if (a.kind != "all" && a.kind != kind) continue;
    int trials = 0, unexplained = 0, family = 0, right = 0, adequate = 0;
    for (int robot = 0; robot < 4; ++robot) {
      if (a.skips(robot)) continue;
      for (int i = 0; i < a.count; ++i) {
        const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
        const Session like = robot_session(robot, seed);
        const SimulatedSession s = simulate_session(like, simulation(seed, robot));
        const Outside out = outside_session(like, s, kind, seed);
        const Improvement m = improve(out.session);
        const Diagnosis& d = m.last;
        std::string added;
        std::size_t names = 0;
        for (const ImprovementStep& step : m.steps) {
          added += step.added + " ";
          names += !step.added.empty() && step.formula.empty();
        }
        if (d.verdict == Verdict::adequate && m.steps.size() == 1) {  // too small to be seen
          ++adequate;
          continue;
        }
        ++trials;
        const bool is_unexplained = d.verdict == Verdict::unexplained;
        const bool is_family = kind == "cubic" && names == 1 && m.steps[1].added == "joint_elasticity";
        const bool is_right = d.reason.find(out.variable) != std::string::npos;
        unexplained += is_unexplained && names == 0;
        family += is_unexplained && is_family;
        right += is_unexplained && is_right;
        if (!is_unexplained || !is_right || (names > 0 && !is_family))
          fmt::print("  {} robot {} seed {}: {} after {}; truth {}; {}\n", kind, robot, seed, verdict_text(d.verdict),
                     m.steps.size() > 1 ? added : "nothing", out.variable, d.reason.english().substr(0, 150));
        std::fflush(stdout);
      }
    }
    fmt::print(
        "outside {:<9}: {} seen ({} too small): unexplained without a name {}, right family first {}, right variable "
        "{}\n",
        kind, trials, adequate, unexplained, family, right);
  }
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  return outside_trials(arguments(argc, argv, "all"));
}
