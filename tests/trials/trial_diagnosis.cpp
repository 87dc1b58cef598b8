// SPDX-License-Identifier: Apache-2.0
// Blind trials of the diagnosis: robots, cameras, markers and sizes at random; is what was hidden named, and is nothing
// named where nothing is hidden? trial_diagnosis null|effects|outside|several COUNT [FIRST_SEED] [ROBOT] [KIND]
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

#include "diagnosis/improvement.h"
#include "fixtures/arms.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

constexpr double sigma = 0.2;  // px
constexpr int observations = 80;

/// Justin's right hand with head cameras, a six-axis arm with springs and a seven-axis arm watched from a stand.
Session robot_session(int robot) {
  if (robot == 0) {
    Session s = read_session(std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/rigs/justin_head");
    s.sigma_pixel.reset();
    return s;
  }
  if (robot == 1) {
    Session s = fixture::stand_session(3);
    for (const std::size_t j : {1, 2}) s.robot.joints[j].stiffness = 12000;
    return s;
  }
  return fixture::seven_axis_session(4);
}

struct Trial {
  SimulatedSession simulated;
  double noncentrality = 0;
};

/// chi-squared of what the model without the effects leaves of the same session without noise.
double noncentrality_of(const Session& like, SimulationOptions options) {
  if (options.effects.empty()) return 0;
  options.noise = 1e-7;
  const Fit f = fit(simulate_session(like, options).session, {});
  return f.solution.normal.data_cost() / (sigma * sigma);
}

SimulationOptions simulation(std::uint64_t seed) {
  SimulationOptions o;
  o.observations = observations;
  o.seed = seed;
  o.noise = sigma;
  o.declare_noise = false;
  return o;
}

double student_3(std::mt19937_64& random) {
  std::student_t_distribution<double> t(3);
  return t(random) / std::sqrt(3.0);
}

/// What may be wrong with a session that misses nothing.
void disturb(Session& session, const std::string& kind, std::uint64_t seed) {
  std::mt19937_64 random(seed * 7919 + 17);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  for (Observation& o : session.observations) {
    for (Sighting& s : o.sightings)
      for (auto* point : {&s.left, &s.right}) {
        if (!*point) continue;
        if (kind == "student") **point += sigma * Vector2(student_3(random), student_3(random));
        if (kind == "wrong" && uniform(random) < 0.05) **point += 8 * Vector2(normal(random), normal(random));
      }
    if (kind == "unseen") std::erase_if(o.sightings, [&](const Sighting&) { return uniform(random) < 0.2; });
    if (kind == "repeatability")  // the arm stood elsewhere than its sensors say
      for (Eigen::Index j = 0; j < o.position.size(); ++j) o.position[j] += 1e-4 * normal(random);
  }
}

std::string top(const Diagnosis& d) {
  if (d.candidates.empty()) return "-";
  const DiagnosisCandidate& c = d.candidates.front();
  return c.unnamed ? "unnamed " + c.unnamed->localiser.variable->name : c.id;
}

DiagnosisOptions quick() {
  DiagnosisOptions o;
  o.with_held_out = false;
  return o;
}

int null_trials(int count, std::uint64_t first, int only_robot, const std::string& kind) {
  for (int robot = 0; robot < 3; ++robot) {
    if (only_robot >= 0 && robot != only_robot) continue;
    const Session like = robot_session(robot);
    int adequate = 0;
    double largest = 0, milliseconds = 0;
    std::vector<double> best;
    for (int i = 0; i < count; ++i) {
      SimulationOptions o = simulation(first + static_cast<std::uint64_t>(i));
      if (kind == "student") o.noise = 1e-7;
      Session session = simulate_session(like, o).session;
      disturb(session, kind, o.seed);
      const auto start = std::chrono::steady_clock::now();
      const Diagnosis d = diagnose(session, quick());
      milliseconds += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      adequate += d.verdict == Verdict::adequate ? 1 : 0;
      best.push_back(d.candidates.empty() ? 0 : d.candidates.front().ln_bayes_factor);
      largest = std::max(largest, best.back());
      if (d.verdict != Verdict::adequate)
        fmt::print("  robot {} seed {}: {} {} lnBF {:.1f} scatter {:.0e} wrong {} p {:.1g}\n", robot, o.seed,
                   verdict_text(d.verdict), top(d), best.back(), d.scatter, d.model.wrong.size(),
                   d.lack_of_fit_p.value_or(-1));
      std::fflush(stdout);
    }
    std::sort(best.begin(), best.end());
    fmt::print(
        "null {} robot {}: adequate {} of {} ({:.2f} %), lnBF 95 % {:.2f} 99 % {:.2f} largest {:.2f}, {:.0f} ms each\n",
        kind, robot, adequate, count, 100.0 * adequate / count, best[best.size() * 95 / 100],
        best[best.size() * 99 / 100], largest, milliseconds / count);
  }
  return 0;
}

/// An effect of random size (0.3 to 3 plausible, log-uniform) at one joint, two, or all.
std::vector<EffectTerm> random_terms(const Effect& e, const Chain& chain, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  std::vector<int> places = effect_places(e, chain);
  if (places.empty()) return {};
  std::shuffle(places.begin(), places.end(), random);
  if (e.scope == EffectScope::marker) {
    places.resize(1);
  } else if (e.scope == EffectScope::joint) {
    const double draw = uniform(random);
    if (draw < 0.75) places.resize(std::min<std::size_t>(places.size(), draw < 0.5 ? 1 : 2));
  }
  const double size = 0.3 * std::pow(10.0, uniform(random));
  std::vector<EffectTerm> terms;
  for (const int place : places) {
    EffectTerm t{e.id, place, {}};
    for (const EffectParameter& p : e.parameters) {
      if (!p.is_choice) {
        t.values.push_back(size * p.sigma * normal(random));
      } else if (p.choices.empty()) {
        t.values.push_back(std::floor(10 + uniform(random) * (observations - 20)));
      } else {
        t.values.push_back(
            p.choices[static_cast<std::size_t>(uniform(random) * static_cast<double>(p.choices.size()))]);
      }
    }
    if (e.id == "joint_elasticity" || e.id == "link_elasticity") t.values[0] = std::abs(t.values[0]);
    terms.push_back(t);
  }
  return terms;
}

struct Tally {
  int trials = 0, first = 0, named = 0, joint_trials = 0, joint = 0, detected = 0;
};

void print(const std::string& name, const Tally& t) {
  fmt::print("{:<28} {:>6} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f}\n", name, t.trials,
             100.0 * t.first / std::max(1, t.trials), 100.0 * t.named / std::max(1, t.trials),
             100.0 * t.joint / std::max(1, t.joint_trials), 100.0 * t.detected / std::max(1, t.trials));
}

int effect_trials(int count, std::uint64_t first, int only_robot, const std::string& only) {
  std::map<std::string, Tally> by_effect, by_noncentrality;
  const double edges[] = {0, 10, 30, 50, 100, 1000, 1e300};
  const char* names[] = {"a 0-10", "b 10-30", "c 30-50", "d 50-100", "e 100-1000", "f over 1000"};
  for (int robot = 0; robot < 3; ++robot) {
    if (only_robot >= 0 && robot != only_robot) continue;
    const Session like = robot_session(robot);
    const Chain chain = chain_of(like);
    for (const Effect& e : catalogue()) {
      if (only != "all" && e.id != only) continue;
      for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
        std::mt19937_64 random(seed * 104729 + std::hash<std::string>{}(e.id) % 100000 + static_cast<unsigned>(robot));
        SimulationOptions o = simulation(seed + 5000 * static_cast<std::uint64_t>(robot));
        o.effects = random_terms(e, chain, random);
        if (o.effects.empty()) break;
        SimulatedSession s;
        double lambda = 0;
        try {
          lambda = noncentrality_of(like, o);
          s = simulate_session(like, o);
        } catch (const InputError&) {
          continue;
        }
        const Diagnosis d = diagnose(s.session, quick());
        if (d.candidates.empty()) continue;
        const DiagnosisCandidate& best = d.candidates.front();
        const bool is_first = best.id == e.id;
        const bool is_named =
            is_first || std::count(best.cannot_be_told_from.begin(), best.cannot_be_told_from.end(), e.id) > 0;
        const bool detected = d.verdict != Verdict::adequate;
        const bool at_joint = e.scope == EffectScope::joint && o.effects.size() == 1;
        const bool joint =
            is_first && std::count(best.where.begin(), best.where.end(),
                                   at_joint ? like.robot.joints[static_cast<std::size_t>(o.effects[0].joint)].name
                                            : std::string()) > 0;
        std::size_t bin = 0;
        while (lambda >= edges[bin + 1]) ++bin;
        for (Tally* t : {lambda >= 50 ? &by_effect[e.id] : nullptr, &by_noncentrality[names[bin]]}) {
          if (!t) continue;
          ++t->trials;
          t->first += is_first;
          t->named += is_named;
          t->detected += detected;
          t->joint_trials += at_joint && is_first;
          t->joint += joint;
        }
        if (lambda >= 50 && !is_first) {
          const auto truth =
              std::find_if(d.candidates.begin(), d.candidates.end(), [&](const auto& c) { return c.id == e.id; });
          fmt::print("  robot {} seed {} {} x{} lambda {:.0f}: {} ({}) {:.1f}, truth {:.1f}{}\n", robot, seed, e.id,
                     o.effects.size(), lambda, top(d), verdict_text(d.verdict), best.ln_bayes_factor,
                     truth == d.candidates.end() ? 0.0 : truth->ln_bayes_factor, is_named ? " (named)" : "");
          std::fflush(stdout);
        }
      }
    }
  }
  fmt::print("{:<28} {:>6} {:>8} {:>8} {:>8} {:>8}\n", "at noncentrality >= 50", "trials", "first %", "named %",
             "joint %", "found %");
  Tally all;
  for (const auto& [name, t] : by_effect) {
    print(name, t);
    all.trials += t.trials, all.first += t.first, all.named += t.named, all.joint += t.joint;
    all.joint_trials += t.joint_trials, all.detected += t.detected;
  }
  print("all", all);
  for (const auto& [name, t] : by_noncentrality) print("noncentrality " + name, t);
  return 0;
}

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
      const StereoRig& rig = *s.true_rig;
      if (g.left) *g.left += project(rig.left, after * x) - project(rig.left, before * x);
      if (g.right)
        *g.right += project(rig.right, rig.right_from_left * (after * x)) -
                    project(rig.right, rig.right_from_left * (before * x));
    }
  }
}

Outside outside_session(const Session& like, const SimulatedSession& s, const std::string& kind, std::uint64_t seed) {
  std::mt19937_64 random(seed * 31 + 7);
  std::normal_distribution<double> normal;
  const Chain chain = chain_of(like);
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

int outside_trials(int count, std::uint64_t first, int only_robot, const std::string& only) {
  for (const std::string kind : {"sine3", "tool", "coupling", "drift", "cubic"}) {
    if (only != "all" && only != kind) continue;
    int trials = 0, unexplained = 0, family = 0, right = 0, adequate = 0;
    for (int robot = 0; robot < 3; ++robot) {
      if (only_robot >= 0 && robot != only_robot) continue;
      const Session like = robot_session(robot);
      for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
        const SimulatedSession s = simulate_session(like, simulation(seed));
        const Outside out = outside_session(like, s, kind, seed);
        const Improvement m = improve(out.session);
        const Diagnosis& d = m.last;
        std::string added;
        for (const ImprovementStep& step : m.steps) added += step.added + " ";
        if (d.verdict == Verdict::adequate && m.steps.size() == 1) {  // too small to be seen
          ++adequate;
          continue;
        }
        ++trials;
        const bool is_unexplained = d.verdict == Verdict::unexplained;
        const bool is_family = kind == "cubic" && m.steps.size() == 2 && m.steps[1].added == "joint_elasticity";
        const bool is_right = d.reason.find(out.variable) != std::string::npos;
        unexplained += is_unexplained && m.steps.size() == 1;
        family += is_unexplained && is_family;
        right += is_unexplained && is_right;
        if (!is_unexplained || !is_right || (m.steps.size() > 1 && !is_family))
          fmt::print("  {} robot {} seed {}: {} after {}; truth {}; {}\n", kind, robot, seed, verdict_text(d.verdict),
                     m.steps.size() > 1 ? added : "nothing", out.variable, d.reason.substr(0, 150));
        std::fflush(stdout);
      }
    }
    fmt::print(
        "outside {:<9}: {} seen ({} too small): unexplained at once {}, right family first {}, right variable {}\n",
        kind, trials, adequate, unexplained, family, right);
  }
  return 0;
}

int several_trials(int count, std::uint64_t first, int only_robot, const std::string&) {
  for (const std::size_t effects : {std::size_t{2}, std::size_t{3}}) {
    int trials = 0, exact = 0, at_noise = 0;
    for (int robot = 0; robot < 3; ++robot) {
      if (only_robot >= 0 && robot != only_robot) continue;
      const Session like = robot_session(robot);
      const Chain chain = chain_of(like);
      for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
        std::mt19937_64 random(seed * 7001 + 13 * effects + static_cast<unsigned>(robot));
        SimulationOptions o = simulation(seed + 90000);
        std::vector<std::string> truth;
        while (truth.size() < effects) {
          const Effect& e = catalogue()[random() % catalogue().size()];
          if (std::count(truth.begin(), truth.end(), e.id)) continue;
          SimulationOptions alone = o;
          alone.effects = random_terms(e, chain, random);
          if (alone.effects.empty() || noncentrality_of(like, alone) < 60) continue;
          truth.push_back(e.id);
          o.effects.insert(o.effects.end(), alone.effects.begin(), alone.effects.end());
        }
        std::sort(truth.begin(), truth.end());
        const Improvement m = improve(simulate_session(like, o).session);
        std::vector<std::string> found;
        for (const FittedEffect& e : m.last.model.fit.effects) found.push_back(e.term.id);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        ++trials;
        exact += found == truth;
        at_noise += m.steps.back().held_out.rms_pixel.value_or(9) < 0.215;
        if (found != truth) {
          fmt::print("  robot {} seed {}: truth", robot, seed);
          for (const auto& t : truth) fmt::print(" {}", t);
          fmt::print("; found");
          for (const auto& t : found) fmt::print(" {}", t);
          fmt::print("; held out {:.3f} px, {}\n", m.steps.back().held_out.rms_pixel.value_or(-1),
                     verdict_text(m.last.verdict));
        }
        std::fflush(stdout);
      }
    }
    fmt::print("{} effects: exact set {} of {} ({:.1f} %), held out below 0.215 px {}\n", effects, exact, trials,
               100.0 * exact / trials, at_noise);
  }
  return 0;
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  using namespace handsight;
  const std::string mode = argc > 1 ? argv[1] : "null";
  const int count = argc > 2 ? std::atoi(argv[2]) : 20;
  const std::uint64_t first = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const int robot = argc > 4 ? std::atoi(argv[4]) : -1;
  const std::string kind = argc > 5 ? argv[5] : mode == "null" ? "gaussian" : "all";
  if (mode == "null") return null_trials(count, first, robot, kind);
  if (mode == "outside") return outside_trials(count, first, robot, kind);
  if (mode == "several") return several_trials(count, first, robot, kind);
  if (mode == "effects") return effect_trials(count, first, robot, kind);
  return 2;
}
