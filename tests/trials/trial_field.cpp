// SPDX-License-Identifier: Apache-2.0
// What laboratories bring: causes far larger than usual, mistakes, robots that scatter, poses that come region by
// region. trial_field [COUNT] [FIRST_SEED] [KIND] [judge]; kinds: zero, zeros, link, slip, scatter, regions, target,
// mount, sense. At the end: how often the names that were reported with some probability are there. With `judge`, for
// worlds with a background: the hand of one who is told the large cause and that each of four small effects is there at
// every joint in half of the worlds, and chooses among the sixteen by their evidence.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>

#include "blunders/find_blunders.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/verdict/diagnosis.h"
#include "estimation/report/fit_report.h"
#include "fixtures/targets.h"
#include "fixtures/trial_sessions.h"

namespace handsight::trials {
namespace {

constexpr double degree = M_PI / 180;
constexpr int fresh = 100;
constexpr double tracker_sigma = 1e-4;  // m

/// What is true and hidden.
struct World {
  Session session;  // as measured: the nominal robot
  std::vector<EffectTerm> effects;
  std::vector<EffectTerm> large;   // of these, without what is small
  std::set<std::string> right;     // names that are true
  std::set<std::string> unasked;   // neither right nor wrong: another name does the very same
  std::set<std::string> dominant;  // those that come first
  std::string blunder;             // ID:WHERE of a mistake
  double target_scale = 0;         // by which the target is larger than described
  double repeatability = 0;        // of each joint from pose to pose, rad
  bool has_remainder = false;      // something is left that nothing in the catalogue says
  std::vector<Vector3> markers_in_tcp;
  Rigid mount_from_sensor;
  std::vector<Eigen::VectorXd> fresh_poses;  // over the whole joint range
};

/// Everything about a world is drawn from this.
struct Draw {
  std::mt19937_64 random;
  std::uniform_real_distribution<double> uniform{0, 1};
  std::normal_distribution<double> normal;

  double between(double low, double high) { return low + (high - low) * uniform(random); }
  double log_between(double low, double high) { return low * std::pow(high / low, uniform(random)); }
  double sign() { return random() % 2 ? 1.0 : -1.0; }
  int one_of(const std::vector<int>& places) { return places[random() % places.size()]; }
};

EffectTerm term_with(const std::string& id, int place, std::vector<double> values) {
  EffectTerm term = term_of(*find_effect(id), place);
  term.values = std::move(values);
  return term;
}

/// Chi-squared that a term does to noise-free measurements: what does not show is nobody's to find.
bool shows(const Session& like, const SimulationOptions& o, const EffectTerm& term) {
  SimulationOptions alone = o;
  alone.effects = {term};
  const double in_noise = like.is_tracker() ? std::pow(sigma / tracker_sigma, 2) : 1;
  return in_noise * noncentrality_of(like, alone) > 100;
}

std::vector<EffectTerm> hidden(const std::string& kind, const Session& like, const SimulationOptions& o, Draw& draw) {
  const Chain chain = make_chain(like);
  const std::vector<int> joints = effect_places(*find_effect("joint_offset"), chain);
  std::vector<EffectTerm> terms;
  if (kind == "zeros")
    for (const int j : joints)
      terms.push_back(term_with("joint_offset", j, {draw.sign() * draw.log_between(1, 6) * degree}));
  while (kind == "zero" && (terms.empty() || !shows(like, o, terms.front())))
    terms = {term_with("joint_offset", draw.one_of(joints), {draw.sign() * draw.log_between(1, 6) * degree})};
  while (kind == "link" && (terms.empty() || !shows(like, o, terms.front()))) {
    const double size = draw.log_between(3e-3, 10e-3), turn = draw.between(-M_PI, M_PI);
    terms = {term_with("link_geometry", draw.one_of(joints), {size * std::cos(turn), size * std::sin(turn), 0, 0})};
  }
  if (kind == "slip") {
    const double size = draw.log_between(5e-3, 20e-3), turn = draw.between(-M_PI, M_PI);
    const double from = std::floor(o.observations * draw.between(0.25, 0.75));
    terms = {term_with("body_slip", -1,
                       {size * std::cos(turn), size * std::sin(turn), 0, 0.02 * draw.normal(draw.random),
                        0.02 * draw.normal(draw.random), 0, from})};
  }
  return terms;
}

/// The values are added to those of the same effect at the same place.
void add_to(std::vector<EffectTerm>& terms, const EffectTerm& more) {
  for (EffectTerm& t : terms)
    if (t.id == more.id && t.place == more.place) {
      for (std::size_t p = 0; p < t.values.size(); ++p) t.values[p] += more.values[p];
      return;
    }
  terms.push_back(more);
}

constexpr int kinds_of_rig = 8;

/// Two cameras and markers (four robots), a tracker, a board before one camera and two, a camera on the hand.
Session like_of(const std::string& kind, std::uint64_t seed) {
  const int rig = kind == "target" ? 5 + static_cast<int>(seed % 3) : static_cast<int>(seed % kinds_of_rig);
  if (rig == 4) return fixture::tracker_session();
  if (rig == 5) return fixture::target_session();
  if (rig == 6) return fixture::target_session(fixture::charuco(), 2);
  if (rig == 7) return fixture::eye_in_hand_session();
  return robot_session(rig, seed);
}

const std::array<const char*, 4> small_effects{"joint_offset", "link_geometry", "joint_elasticity",
                                               "encoder_eccentricity"};

/// Small deviations: a tenth of what is usual, at every joint; each of four effects is there in half of the worlds.
std::vector<EffectTerm> background(const Session& like, Draw& draw) {
  const Chain chain = make_chain(like);
  std::vector<EffectTerm> terms;
  for (const char* id : small_effects) {
    if (draw.sign() < 0) continue;
    const Effect& e = *find_effect(id);
    for (const int place : effect_places(e, chain)) {
      EffectTerm t = term_of(e, place);
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!e.parameters[p].is_choice)
          t.values[p] = 0.1 * prior_sigma(e.parameters[p], chain) * draw.normal(draw.random);
      if (e.id == "joint_elasticity") t.values[0] = std::abs(t.values[0]);
      terms.push_back(t);
    }
  }
  return terms;
}

/// What is described wrongly: the target's size, the mount, a joint's sense.
void misdescribe(const std::string& kind, const Session& like, Draw& draw, World& w) {
  if (kind == "target") {
    w.target_scale = draw.sign() * draw.log_between(5e-3, 0.1);
    for (Vector3& x : w.session.shape->markers) x /= 1 + w.target_scale;
    w.session.target->square /= 1 + w.target_scale;
    w.session.target->tag /= 1 + w.target_scale;
    w.right.insert("target_scale");
    w.dominant = {"target_scale"};
  }
  if (kind == "mount") {
    Vector3 off, turn;
    for (int i = 0; i < 3; ++i) off[i] = draw.normal(draw.random);
    for (int i = 0; i < 3; ++i) turn[i] = draw.normal(draw.random);
    off *= draw.between(0.02, 0.06) / off.norm();
    turn *= draw.between(2, 6) * degree / turn.norm();
    Rigid& mount = w.session.mount.mount_from_sensor;
    mount = Rigid{mount.rotation * rotation_from_rpy(turn), mount.translation + off};
    w.session.mount.estimate = false;
    w.right.insert("camera_mount");
    w.unasked = {"joint_offset", "link_geometry"};
    w.dominant = {"camera_mount"};
  }
  if (kind == "sense") {
    // Of a joint below sensor and hand the sense does not show.
    std::size_t joint = 0;
    Session turned;
    do {
      joint = static_cast<std::size_t>(draw.random() % like.joints.size());
      turned = w.session;
      for (Observation& o : turned.observations) o.position[static_cast<Eigen::Index>(joint)] *= -1;
    } while (!may_be_a_blunder(turned, fit(turned, {})));
    w.session = turned;
    w.blunder = "joint_sense:" + like.joints[joint];
  }
}

World world(const std::string& kind, int observations, std::uint64_t seed) {
  Draw draw{std::mt19937_64(seed * 7919 + 13)};
  const Session like = like_of(kind, seed);
  const int robot = like.rig && like.rig->count() == 2 && !like.target ? static_cast<int>(seed % kinds_of_rig) : 1;
  SimulationOptions o = simulation(seed + 90000, robot);
  o.observations = observations;
  if (like.is_tracker()) o.noise = tracker_sigma;
  World w;
  w.effects = w.large = hidden(kind, like, o, draw);
  for (const EffectTerm& t : w.effects) w.dominant.insert(t.id);
  // Where the first joint sits and where a mount is that is held are one and the same.
  const bool is_first = !w.effects.empty() && w.effects.front().place ==
                                                  effect_places(*find_effect("joint_offset"), make_chain(like)).front();
  if (!like.mount.estimate && is_first) w.dominant.insert("camera_mount");
  if (kind != "scatter" && kind != "regions")
    for (EffectTerm& t : background(like, draw)) add_to(w.effects, t);
  for (const EffectTerm& t : w.effects) w.right.insert(t.id);
  // What the first joint's zero and place do, a mount that is held does too.
  if (!like.mount.estimate) {
    w.right.insert("camera_mount");
    w.unasked = {"camera_mount", "joint_offset", "link_geometry"};
    if (!w.dominant.empty() && !is_first) w.unasked.erase(*w.dominant.begin());
  }
  o.effects = w.effects;
  if (kind == "regions") {
    o.follow = true;
    if (const auto shift = hidden_shift(like, 0.6, draw.random)) w.effects.push_back(*shift);
    o.effects = w.effects;
    w.has_remainder = true;
  }
  SimulatedSession s = simulate_session(like, o);
  w.session = s.session;
  misdescribe(kind, like, draw, w);
  const double repeatability = w.repeatability = kind == "scatter" ? draw.log_between(1e-4, 3e-3) : 5e-5;
  for (Observation& observation : w.session.observations)
    for (double& q : observation.position) q += repeatability * draw.normal(draw.random);
  w.has_remainder = w.has_remainder || repeatability > 8e-4;
  w.markers_in_tcp = s.markers_in_tcp;
  w.mount_from_sensor = like.mount.mount_from_sensor;
  SimulationOptions later = o;
  later.seed = seed + 170000;
  later.observations = fresh;
  later.joint_range = 1;
  later.follow = false;
  for (const Observation& observation : simulate_session(like, later).session.observations)
    w.fresh_poses.push_back(observation.position);
  return w;
}

/// The body's origin as the sensor sees it.
Vector3 seen_at(const Chain& chain, const Eigen::VectorXd& pose, const std::vector<EffectTerm>& terms,
                const Rigid& mount_from_sensor, const Vector3& body) {
  const Sites sites = moved_sites(states_at(chain, pose), terms);
  const auto ends = observed_ends(states_at(chain, pose), sites).ends;
  return inverse(ends.root_from_mount * mount_from_sensor * small_motion<double>(sites.mount)) * ends.root_from_tcp *
         body;
}

/// Mean distance (mm) of the body's true origin in fresh poses from where the fit puts it.
double error_on_fresh(const World& w, const Fit& f) {
  const Chain chain = make_chain(w.session);
  const Vector3 body = body_frame(f.sides, w.markers_in_tcp).tcp_from_body.translation;
  double sum = 0;
  for (const Eigen::VectorXd& pose : w.fresh_poses)
    sum += (seen_at(chain, pose, w.effects, w.mount_from_sensor, body) -
            seen_at(chain, pose, list_terms(f), estimate(f).mount_from_sensor, f.tcp_from_body.translation))
               .norm();
  return 1e3 * sum / static_cast<double>(w.fresh_poses.size());
}

/// The same at 0, and what is described wrongly beside them.
std::vector<EffectTerm> to_estimate(const World& w, const std::vector<EffectTerm>& effects) {
  std::vector<EffectTerm> terms;
  for (EffectTerm t : effects) {
    const Effect& e = term_effect(t);
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!e.parameters[p].is_choice) t.values[p] = 0;
    terms.push_back(t);
  }
  for (const char* id : {"target_scale", "camera_mount"})
    if (w.dominant.contains(id)) {
      const Chain chain = make_chain(w.session);
      for (EffectTerm& t : effect_terms(id, chain, list_own_effects(w.session, chain))) terms.push_back(t);
    }
  return terms;
}

Fit reported(const World& w) {
  FitOptions o;
  o.estimated = to_estimate(w, w.effects);
  return fit(w.session, o);
}

/// Of one who knows how worlds are made, but not what is in this one beside what is large.
Fit judged(const World& w) {
  const Chain chain = make_chain(w.session);
  FitOptions o;
  o.estimated = to_estimate(w, w.large);
  std::optional<Fit> likeliest = fit(w.session, o);
  const Eigen::Index large = likeliest->problem.effect_count();
  const NoiseModel by = noise_model(reported(w));
  double best = fit_evidence(*likeliest, large, by).ln_evidence;
  for (unsigned which = 1; which < 1U << small_effects.size(); ++which) {
    FitOptions with = o;
    for (std::size_t i = 0; i < small_effects.size(); ++i) {
      if (!(which >> i & 1U)) continue;
      const Effect& e = *find_effect(small_effects[i]);
      for (const int place : effect_places(e, chain))
        if (std::none_of(o.estimated.begin(), o.estimated.end(),
                         [&](const EffectTerm& t) { return t.id == e.id && t.place == place; }))
          with.estimated.push_back(term_of(e, place));
    }
    Fit f = fit(w.session, with);
    if (!f.converged()) continue;
    const double evidence = fit_evidence(f, large, by).ln_evidence;
    if (evidence <= best) continue;
    best = evidence;
    likeliest = std::move(f);
  }
  return std::move(*likeliest);
}

/// Reported against true, of names of the catalogue, by probability.
struct Claims {
  static constexpr std::array<double, 14> bounds{0.05, 0.1, 0.2, 0.3,  0.4,  0.5,   0.6,
                                                 0.7,  0.8, 0.9, 0.95, 0.99, 0.999, 1.0000001};
  struct Bin {
    int count = 0, right = 0;
    double sum = 0;
  };
  std::array<Bin, bounds.size() - 1> bins;

  void add(double probability, bool is_right) {
    const auto above = std::upper_bound(bounds.begin(), bounds.end(), probability);
    if (above == bounds.begin() || above == bounds.end()) return;
    Bin& bin = bins[static_cast<std::size_t>(above - bounds.begin() - 1)];
    ++bin.count;
    bin.right += is_right;
    bin.sum += probability;
  }

  void print() const {
    for (std::size_t b = 0; b < bins.size(); ++b)
      if (bins[b].count > 0)
        fmt::print("reported {:5.1f} to {:5.1f} %, on average {:5.2f} %: there {:5.1f} % ({} of {})\n", 1e2 * bounds[b],
                   std::min(1e2, 1e2 * bounds[b + 1]), 1e2 * bins[b].sum / bins[b].count,
                   1e2 * bins[b].right / bins[b].count, bins[b].right, bins[b].count);
  }
};

struct Score {
  int worlds = 0, first = 0, disowned = 0, wrongly_adequate = 0, wrong_names = 0, names = 0, worse_than_plain = 0;
  std::vector<double> to_reported;  // error on fresh poses by that of the fit told everything
  std::vector<double> of_judge;     // the same of the judge, where that is asked for
  double seconds = 0;
};

/// A mistake is found before any effect.
void judge_blunder(const World& w, Score& score) {
  const std::vector<Blunder> found = find_blunders(w.session, fit(w.session, {}));
  const bool is_right =
      !found.empty() && display_name(found.front()) == w.blunder && found.front().together_with.empty();
  score.first += is_right;
  if (!is_right)
    fmt::print("  {}: {}\n", w.blunder, found.empty() ? "nothing found" : "found " + display_name(found.front()));
}

void judge_effects(std::uint64_t seed, const World& w, bool with_judge, Score& score, Claims& claims) {
  const Improvement m = improve(w.session, {});
  const std::string named = m.steps.size() > 1 ? m.steps[1].added : "";
  const bool is_first = w.dominant.empty() ? named.empty() || named.starts_with("curve_") : w.dominant.contains(named);
  score.first += is_first;
  int disowned = 0, wrong = 0;
  std::string wrong_names;
  for (const ImprovementStep& s : m.steps) disowned += w.dominant.contains(s.added) && !s.stands.empty();
  for (const InclusionProbability& n : m.inclusion_probabilities.names) {
    if (n.id.starts_with("curve_")) continue;
    if (!w.unasked.contains(n.id)) claims.add(n.probability, w.right.contains(n.id));
    if (n.probability < 0.95) continue;
    ++score.names;
    if (w.right.contains(n.id)) continue;
    ++wrong;
    wrong_names += fmt::format(" {} {:.4f}{}", n.id, n.probability, n.is_in_model ? "" : " (not in the model)");
  }
  score.disowned += disowned;
  score.wrong_names += wrong;
  const bool is_adequate = w.has_remainder && m.last.verdict == Verdict::adequate;
  score.wrongly_adequate += is_adequate;
  const double found = error_on_fresh(w, m.last.model.fit), best = error_on_fresh(w, reported(w)),
               plain = error_on_fresh(w, fit(w.session, {}));
  score.to_reported.push_back(found / std::max(best, 1e-3));
  if (with_judge) score.of_judge.push_back(error_on_fresh(w, judged(w)) / std::max(best, 1e-3));
  const bool is_worse = found > 1.5 * plain;
  score.worse_than_plain += is_worse;
  if (is_first && disowned + wrong == 0 && !is_adequate && !is_worse && found < 1.3 * best) return;
  fmt::print("  seed {}, scatter {:.2g} mrad, target {:.1f} %:", seed, 1e3 * w.repeatability, 1e2 * w.target_scale);
  for (const ImprovementStep& s : m.steps) fmt::print(" {}{}", s.added, s.stands.empty() ? "" : " (disowned)");
  for (const RefusedStep& r : m.refused) fmt::print(" [{}: {}]", r.id, r.reason);
  fmt::print("; {} disowned, {} wrong names{}, hand {:.2f} mm, told {:.2f}, plain {:.2f}, {}\n", disowned, wrong,
             wrong_names, found, best, plain, verdict_text(m.last.verdict));
}

void judge(std::uint64_t seed, const World& w, bool with_judge, Score& score, Claims& claims) {
  const auto began = std::chrono::steady_clock::now();
  ++score.worlds;
  if (w.blunder.empty())
    judge_effects(seed, w, with_judge, score, claims);
  else
    judge_blunder(w, score);
  score.seconds =
      std::max(score.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
}

/// "1.04 median 1.97 worst"
std::string ratios_text(std::vector<double> ratios) {
  if (ratios.empty()) return "of none";
  std::sort(ratios.begin(), ratios.end());
  return fmt::format("{:.2f} median {:.2f} worst", ratios[ratios.size() / 2], ratios.back());
}

void run(const std::string& kind, int count, std::uint64_t first_seed, bool asks_judge, Claims& claims) {
  const bool with_judge = asks_judge && kind != "scatter" && kind != "regions";  // these have no background
  for (const int observations : {8, 15, 25, 40, 80}) {                           // effects are reported from ten on
    Score s;
    for (int i = 0; i < count; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
      judge(seed, world(kind, observations, seed), with_judge, s, claims);
    }
    fmt::print(
        "{:8} {:2} poses: first right {} of {}, disowned {}, wrong names above 95 % {} of {}, adequate wrongly {}, "
        "worse than 1.5 plain {}, hand to told {}{}, {:.1f} s at most\n",
        kind, observations, s.first, s.worlds, s.disowned, s.wrong_names, s.names, s.wrongly_adequate,
        s.worse_than_plain, ratios_text(s.to_reported), with_judge ? ", a judge's " + ratios_text(s.of_judge) : "",
        s.seconds);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20;
  const auto first = static_cast<std::uint64_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  handsight::trials::Claims claims;
  for (const char* kind : {"zero", "zeros", "link", "slip", "scatter", "regions", "target", "mount", "sense"})
    if (argc <= 3 || std::string(argv[3]) == kind)
      handsight::trials::run(kind, count, first, argc > 4 && std::string(argv[4]) == "judge", claims);
  claims.print();
}
