// SPDX-License-Identifier: Apache-2.0
// Touches: are the robot's numbers that they can tell unbiased, do the 95 % intervals hold, and is one hidden cause
// named first?
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <random>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/finding.h"
#include "effects/own_effect.h"
#include "fixtures/touch_session.h"
#include "session/fixtures/list.h"
#include "trials/table.h"
#include "trials/touch_judge.h"

namespace handsight {
namespace {

using namespace trials;

constexpr double normal_95 = 1.959964;  // two-sided
bool with_candidates = false;           // --candidates
bool with_nearest = false;              // --nearest

/// What stands about the robot.
Session setting(const std::string& kind) {
  Session s = fixture::probe_session();
  for (const std::size_t j : {1, 2}) s.robot.joints[j].stiffness = 12000;
  const bool all = kind == "all";
  if (kind == "plane") fixture::add_fixture(s, &fixtures::plane, "plate", {0.45, 0, 0.25});
  if (kind == "planes" || all) fixture::add_plates(s);
  if (kind == "sockets" || all) {  // 50 mm apart, known to 0.01 mm
    const int first = static_cast<int>(s.fixtures.size());
    fixture::add_fixture(s, &fixtures::point, "socket_1", {0.48, 0.025, 0.3});
    fixture::add_fixture(s, &fixtures::point, "socket_2", {0.48, -0.025, 0.3});
    s.distances.push_back({first, first + 1, 0.05, 1e-5});
  }
  if (kind == "gauges" || all) {  // on three sides
    fixture::add_fixture(s, &fixtures::gauge, "dial_front", {0.55, 0, 0.4}, {0, 1.5707963, 0});
    fixture::add_fixture(s, &fixtures::gauge, "dial_side", {0.4, 0.3, 0.4}, {-1.5707963, 0, 0});
    fixture::add_fixture(s, &fixtures::gauge, "dial_below", {0.45, 0, 0.25});
  }
  if (kind == "bar" || all) fixture::add_fixture(s, &fixtures::length, "bar", {0.25, 0.1, 0.1});
  return s;
}

/// What the user says of where things stand: nothing of planes and points, of the others within millimetres.
void blur_places(Session& s, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (std::size_t f = 0; f < s.fixtures.size(); ++f) {
    Mount& mount = f == 0 ? s.mount : s.other_mounts[f - 1];
    Vector6 off;
    for (double& o : off) o = 3e-3 * normal(random);
    mount.mount_from_sensor = mount.mount_from_sensor * small_motion<double>(off);
  }
  fixture::forget_places(s);
}

EffectTerm at_joint(const Session& s, const char* id, const std::string& joint) {
  return term_of(*find_effect(id), find_joint(s.robot, joint));
}

struct Fixtures {
  const char* kind;
  const char* title;  // as tables name it
};
constexpr Fixtures all_fixtures[] = {{"plane", "one plate"},
                                     {"planes", "a plate in three places"},
                                     {"sockets", "two sockets, 50 mm apart to 0.01 mm"},
                                     {"gauges", "dial gauges on three sides"},
                                     {"bar", "ball bar of three lengths"},
                                     {"all", "all together"}};

struct Sums {
  double z = 0, squares = 0;
  int count = 0, covered = 0, untold = 0;
  void add(double error, double sigma) {
    const double off = error / sigma;
    z += off;
    squares += off * off;
    ++count;
    covered += std::abs(off) <= normal_95;
  }
};

/// All joints' zeros at once, drawn within 2 mrad; those whose sigma is above half of the prior's cannot be determined.
void coverage(const Fixtures& fixtures, int seeds, int touches, std::uint64_t first_seed, trials::Table& table) {
  const std::string kind = fixtures.kind;
  std::map<std::string, Sums> sums;
  int not_converged = 0, repeatability = 0, failed = 0;
  for (int i = 0; i < seeds; ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const Session like = setting(kind);
    std::vector<EffectTerm> truth;
    for (const std::string& joint : like.joints) {
      truth.push_back(at_joint(like, "joint_offset", joint));
      truth.back().values[0] = 2e-3 * normal(random);
    }
    const SimulatedSession made = fixture::simulated_touches(like, touches, seed, truth);
    Session s = made.session;
    blur_places(s, random);
    FitOptions o;
    for (const EffectTerm& t : truth) o.estimated.push_back(term_of(term_effect(t), t.place));
    try {
      const Fit f = fit(s, o);
      not_converged += !f.converged();
      repeatability += f.covariance_kind == CovarianceKind::repeatability;
      for (std::size_t j = 0; j < truth.size(); ++j) {
        Sums& of = sums[like.joints[j]];
        const double sigma = f.effects[j].sigmas[0];
        if (sigma > 2.5e-3)
          ++of.untold;
        else
          of.add(f.effects[j].term.values[0] - truth[j].values[0], sigma);
      }
    } catch (const InputError& e) {
      ++failed;
      fmt::print("  seed {}: {}\n", seed, e.what());
    }
  }
  fmt::print("{} ({} touches, {} seeds): not converged {}, scatter {}, refused {}\n", kind, touches, seeds,
             not_converged, repeatability, failed);
  double least_mean = 1e9, most_mean = -1e9, least_within = 100, most_within = -1;
  for (const auto& [joint, of] : sums) {
    if (of.count == 0) {
      fmt::print("  {}: cannot be told ({} of {})\n", joint, of.untold, of.untold);
      continue;
    }
    fmt::print("  {}: told {}, mean {:+.3f} sigma (+- {:.3f}), rms {:.3f}, within 95 % {:.1f} %\n", joint, of.count,
               of.z / of.count, 1 / std::sqrt(of.count), std::sqrt(of.squares / of.count),
               100.0 * of.covered / of.count);
    const double mean = of.z / of.count, within = 100.0 * of.covered / of.count;
    least_mean = std::min(least_mean, mean), most_mean = std::max(most_mean, mean);
    least_within = std::min(least_within, within), most_within = std::max(most_within, within);
  }
  if (most_within < 0) return;  // no joint can be reported
  table.print({fixtures.title, seeds - failed, fmt::format("{:.3f} to {:.3f}", least_mean, most_mean),
               fmt::format("{:.1f} to {:.1f} %", least_within, most_within)});
}

/// Within three of its prior sigmas each: what the diagnosis calls plausible.
bool is_plausible(const EffectTerm& term) {
  const Effect& effect = term_effect(term);
  for (std::size_t p = 0; p < term.values.size(); ++p)
    if (!effect.parameters[p].is_choice && std::abs(term.values[p]) > 3 * effect.parameters[p].sigma) return false;
  return true;
}

/// A cause of that kind at a random joint, as large as makes its noncentrality 50 to 100; nothing where it would have
/// to be larger than is plausible.
std::optional<EffectTerm> hidden(const Session& like, const char* id, int touches, std::uint64_t seed) {
  std::mt19937_64 random(seed * 31 + 7);
  std::normal_distribution<double> normal;
  const std::vector<int> places = effect_places(*find_effect(id), make_chain(like));
  if (places.empty()) return std::nullopt;
  EffectTerm term = term_of(*find_effect(id), places[random() % places.size()]);
  const Effect& effect = term_effect(term);
  const bool is_positive = std::string(id) == "joint_elasticity" || std::string(id) == "backlash";
  for (std::size_t p = 0; p < term.values.size(); ++p)
    if (!effect.parameters[p].is_choice)
      term.values[p] = effect.parameters[p].sigma * (is_positive ? 0.5 + std::abs(normal(random)) : normal(random));
  double shown = noncentrality(exact_touches(like, touches, seed, term));
  for (int round = 0; round < 3 && !(shown > 50 && shown < 100); ++round) {
    const double times = std::sqrt(70 / std::max(shown, 1e-9));
    for (double& v : term.values) v *= times;
    shown = noncentrality(exact_touches(like, touches, seed, term));
  }
  return shown > 50 && is_plausible(term) ? std::optional(term) : std::nullopt;
}

/// Of the sessions with one cause: in how many it is named, and in how many it could be.
struct Score {
  int shown = 0, unseen = 0;
  int first = 0, tied = 0;       // named first; another is, and said to be the same here
  int judged = 0;                // the judge has it first
  int sure = 0, first_sure = 0;  // the judge has it first by odds of 20; of these, named first or tied

  void add(const Score& o) {
    shown += o.shown, unseen += o.unseen, first += o.first, tied += o.tied;
    judged += o.judged, sure += o.sure, first_sure += o.first_sure;
  }
  void print(trials::Table& table, const char* title) const {
    table.print({title, shown, first, first + tied, judged, fmt::format("{} of {}", first_sure, sure)});
    if (unseen > 0) fmt::print("  {} cannot show\n", unseen);
  }
};

/// The first candidates of a diagnosis, for whoever wants to know why another is named.
void print_candidates(const Diagnosis& d) {
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(most, d.candidates.size()); ++i) {
    const DiagnosisCandidate& c = d.candidates[i];
    fmt::print("    {:<22} {:<10} ln BF {:7.2f} of {:.2f}, explains {:.3f}{}{}{}\n", c.unnamed ? "a curve" : c.id,
               fmt::join(c.where, "+"), c.ln_bayes_factor, d.threshold, c.explained.value_or(0),
               is_believable(c) ? "" : ", not believable", c.too_large ? ", too large" : "",
               c.refitted ? "" : ", not refitted");
  }
}

void score_session(const std::string& kind, const char* id, int touches, std::uint64_t seed, Score& score) {
  const Session like = setting(kind);
  const auto term = hidden(like, id, touches, seed);
  score.unseen += !term;
  if (!term) return;
  Session s = fixture::simulated_touches(like, touches, seed, {*term}).session;
  std::mt19937_64 random(seed);
  blur_places(s, random);
  const Diagnosis d = diagnose(s);
  const Judgement judgement = judge(s);
  const auto rival = find_rival(judgement, id);
  const double margin = evidence_of(judgement, id) - rival.second;
  const DiagnosisCandidate* const leading = finding_of(d);  // what every sentence names first
  const std::string named = !leading ? "nothing" : leading->unnamed ? "a curve" : leading->id;
  const bool is_it = named == id;
  const bool is_twin = leading && !is_it &&
                       std::find(leading->indistinguishable_from.begin(), leading->indistinguishable_from.end(), id) !=
                           leading->indistinguishable_from.end();
  const bool is_sure = margin > std::log(20);
  const Session exact = exact_touches(like, touches, seed, *term);
  if (with_nearest) {
    const auto near = nearest_to(exact, id);
    fmt::print("  {} seed {}: of its {:.1f} {} leaves {:.1f}, {} {:.1f}, {} {:.1f}\n", id, seed, noncentrality(exact),
               near[0].second, near[0].first, near[1].second, near[1].first, near[2].second, near[2].first);
  }
  ++score.shown;
  score.first += is_it;
  score.tied += is_twin;
  score.judged += margin > 0;
  score.sure += is_sure;
  score.first_sure += is_sure && (is_it || is_twin);
  if (!is_it)
    fmt::print("  {}: {} at {} seed {}: {} is first{}; judge: {:.1f} for it against {:.1f} for {}, {:.1f} for {}\n",
               kind, id, like.robot.joints[static_cast<std::size_t>(term->place)].name, seed, named,
               is_twin ? ", said to be the same here" : "", evidence_of(judgement, id), rival.second, rival.first,
               evidence_of(judgement, named), named);
  if (!is_it && leading && !leading->unnamed)
    fmt::print("    fitted in its place, {} leaves {:.1f} of {:.1f}\n", named, left_by(exact, leading->terms),
               noncentrality(exact));
  if (!is_it && with_candidates) print_candidates(d);
  std::fflush(stdout);
}

trials::Table scores_table(const trials::TableOutput& output) {
  return trials::Table({{.heading = "hidden", .width = 16},
                        {"sessions in which it shows"},
                        {"first"},
                        {"first or tied"},
                        {"judge"},
                        {.heading = "of those the judge is sure of", .width = 12}},
                       output);
}

constexpr std::pair<const char*, const char*> all_causes[] = {
    {"joint_offset", "joint zero"},     {"joint_scale", "joint scale"},           {"link_geometry", "geometry"},
    {"joint_elasticity", "elasticity"}, {"encoder_eccentricity", "eccentricity"}, {"backlash", "backlash"}};
using Scores = std::array<Score, std::size(all_causes)>;

void causes(const std::string& kind, int seeds, int touches, std::uint64_t first_seed,
            const trials::TableOutput& output, Scores& sums, const std::string& cause) {
  fmt::print("{}\n", kind);
  trials::Table table = scores_table(output);
  for (std::size_t c = 0; c < std::size(all_causes); ++c) {
    if (!cause.empty() && cause != all_causes[c].first) continue;
    Score score;
    for (int i = 0; i < seeds; ++i)
      score_session(kind, all_causes[c].first, touches, first_seed + static_cast<std::uint64_t>(i), score);
    score.print(table, all_causes[c].second);
    std::fflush(stdout);
    sums[c].add(score);
  }
}

}  // namespace
}  // namespace handsight

/// trial_touch [coverage|causes|both] [seeds] [touches] [kind] [first seed] [cause] [--markdown] [--nearest]
/// [--candidates]
int main(int argc, char** argv) {
  using namespace handsight;
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  with_candidates = std::string(argv[argc - 1]) == "--candidates";
  argc -= with_candidates;
  with_nearest = std::string(argv[argc - 1]) == "--nearest";
  argc -= with_nearest;
  const std::string what = argc > 1 ? argv[1] : "both";
  const int seeds = argc > 2 ? std::atoi(argv[2]) : 500, touches = argc > 3 ? std::atoi(argv[3]) : 120;
  const std::string only = argc > 4 ? argv[4] : "";
  const std::uint64_t first = argc > 5 ? std::strtoull(argv[5], nullptr, 10) : 1;
  const std::string cause = argc > 6 ? argv[6] : "";
  trials::Table table({{.heading = "fixtures", .width = 36},
                       {"sessions"},
                       {.heading = "bias in sigmas", .width = 18},
                       {.heading = "within 95 %", .width = 16}},
                      output);
  Scores sums;
  for (const Fixtures& fixtures : all_fixtures) {
    if (!only.empty() && only != fixtures.kind) continue;
    if (what != "causes") coverage(fixtures, seeds, touches, first, table);
    if (what != "coverage") causes(fixtures.kind, seeds, touches, first, output, sums, cause);
  }
  if (what == "coverage" || !only.empty()) return 0;
  fmt::print("every kind of fixtures\n");
  trials::Table all = scores_table(output);
  for (std::size_t c = 0; c < std::size(all_causes); ++c) sums[c].print(all, all_causes[c].second);
  return 0;
}
