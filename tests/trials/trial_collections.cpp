// SPDX-License-Identifier: Apache-2.0
// Several sessions of one robot together against the best of them alone: are effects named that no single session
// shows, is nothing named that is not there, and how far is the hand from where it is predicted in poses that were not
// measured?
//   trial_collections [COUNT [SEED [WORLD]]]; worlds: two_hands, places, days, null
// With "time" for a world: how much time of a processor 2000 observations in five sessions take.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <random>

#include "diagnosis/selection/improvement.h"
#include "estimation/fit/fit_parts.h"
#include "estimation/fit/part_fit.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/part_report.h"
#include "estimation/report/prediction.h"
#include "fixtures/trial_sessions.h"
#include "fixtures/two_arms.h"
#include "trials/table.h"

namespace handsight {
namespace {

constexpr double noise_m = 2e-4;
constexpr double shown_together = 60, least_hidden = 20;  // noncentrality of what is hidden: of all, of one alone

/// One world: its sessions, what is hidden in the robot, and where.
struct World {
  std::vector<JoinedMember> members;
  std::vector<EffectTerm> hidden;
  std::string id, place;  // of what is hidden; empty: nothing
};

SimulationOptions simulation(std::uint64_t seed) {
  SimulationOptions o;
  o.seed = seed;
  o.observations = 30;
  o.noise = noise_m;
  o.nearest = 0.2;
  o.farthest = 4;
  o.most_turned = 1.5;
  return o;
}

Session placed(Session s, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double x = uniform(random), y = uniform(random), z = uniform(random), turn = uniform(random);
  s.mount.mount_from_sensor = {rotation_from_rpy({0.1 + 0.1 * z, -0.2 + 0.1 * x, 2.5 + 0.8 * turn}),
                               {2.4 + 0.3 * x, 0.4 + y, 1.1 + 0.3 * z}};
  return s;
}

/// Sessions of a kind of world, with these effects of the robot in all of them; `noise` of one coordinate, m.
std::vector<JoinedMember> list_members(const std::string& kind, const std::vector<EffectTerm>& effects,
                                       std::uint64_t seed, double noise) {
  std::mt19937_64 random(seed);
  std::vector<JoinedMember> members;
  const auto add = [&](const Session& like, const std::string& title, const std::string& rig) {
    SimulationOptions o = simulation(random());
    o.effects = effects;
    o.noise = noise;
    members.push_back(fixture::simulated_member(like, o, title));
    members.back().rig = rig;
  };
  if (kind == "places") {  // one hand before a tracker in four places
    for (const char* place : {"here", "there", "elsewhere", "far"})
      add(placed(fixture::hand_session('l'), random), place, "");
  } else if (kind == "days") {  // one hand, one place, four days; each day the markers are glued anew
    const Session like = placed(fixture::hand_session('l'), random);
    for (const char* day : {"june", "july", "august", "september"}) add(like, day, "tracker");
  } else {  // both hands before one tracker, twice
    const Session left = placed(fixture::hand_session('l'), random);
    Session right = fixture::hand_session('r');
    right.mount = left.mount;
    for (const char* day : {"june", "august"}) {
      add(left, std::string("left ") + day, "tracker");
      add(right, std::string("right ") + day, "tracker");
    }
  }
  return members;
}

/// What the measurements without noise miss without the effect, in squares of the noise.
double noncentrality(const Session& without_noise) {
  const Fit plain = fit(without_noise);
  return plain.solution.normal.data_cost() / (noise_m * noise_m);
}

/// An effect that all sessions together show with `shown_together`, no single one with more than `least_hidden`.
World world_of(const std::string& kind, std::uint64_t seed) {
  World w;
  if (kind == "null") {
    w.members = list_members("two_hands", {}, seed, noise_m);
    return w;
  }
  std::mt19937_64 random(seed);
  const Session like = fixture::hand_session('l');
  const std::vector<std::string> ids{"joint_offset", "joint_elasticity", "joint_scale", "encoder_eccentricity"};
  const std::vector<std::string> places{"torso_2", "torso_1", "l2", "l3", "l4"};
  for (int attempt = 0; attempt < 100; ++attempt) {
    w.id = ids[random() % ids.size()];
    w.place = places[random() % (kind == "two_hands" ? 2 : places.size())];
    EffectTerm term = term_of(*find_effect(w.id), find_joint(like.robot, w.place));
    std::normal_distribution<double> normal;
    for (std::size_t p = 0; p < term.values.size(); ++p)
      term.values[p] = normal(random) * term_effect(term).parameters[p].sigma;
    constexpr double silent = 1e-9;
    std::vector<JoinedMember> quiet = list_members(kind, {term}, seed, silent);
    const double of_all = noncentrality(joined(quiet, "quiet"));
    if (!(of_all > 1)) continue;  // what turns with the mounts
    double of_one = 0;
    for (const JoinedMember& m : quiet) of_one = std::max(of_one, noncentrality(m.session));
    if (of_one / of_all > least_hidden / shown_together) continue;
    const double times = std::sqrt(shown_together / of_all);
    if (times > 5) continue;  // larger than robots are built
    for (double& v : term.values) v *= times;
    w.hidden = {term};
    w.members = list_members(kind, w.hidden, seed, noise_m);
    return w;
  }
  throw std::runtime_error("no such world");
}

/// Median distance of the predicted from the true hand, over poses drawn from the whole of the joints' ranges; the
/// prediction is of where the TCP is, its place on the hand as commanded.
double hand_error(const Fit& fit, const Session& session, const std::vector<EffectTerm>& hidden, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const Chain chain = make_chain(session);
  const PredictionModel model = prediction_model(fit);
  std::vector<double> errors;
  for (int i = 0; i < 200; ++i) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(chain.joints.size()));
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
      q[j] = std::uniform_real_distribution<double>(0.8 * joint.lower, 0.8 * joint.upper)(random);
    }
    const ObservationState c = states_at(chain, q);
    const Rigid truly = observed_ends(c, moved_sites(c, hidden)).ends.root_from_tcp;
    errors.push_back((predict_tcp(c, model).root_from_tcp_est.translation - truly.translation).norm());
  }
  std::nth_element(errors.begin(), errors.begin() + 100, errors.end());
  return errors[100];
}

struct Tally {
  int worlds = 0, named = 0, named_alone = 0, wrong = 0;
  int reported_as_open = 0, sure_and_wrong = 0, likelier_truth = 0;  // of those that were not named
  std::vector<double> ratio, seconds;
};

bool names(const Improvement& m, const World& w, int& wrong) {
  bool right = false;
  for (const FittedEffect& e : m.last.model.fit.effects) {
    const std::string place = place_name(term_effect(e.term), e.term.place, m.last.model.session.robot);
    const bool is_it = e.term.id == w.id && place == w.place;
    right = right || is_it;
    wrong += !is_it;
  }
  return right;
}

/// chi-squared of what a fit with these effects leaves.
double left_with(const Session& s, const std::vector<EffectTerm>& terms) {
  FitOptions options;
  options.estimated = terms;
  for (EffectTerm& t : options.estimated)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!term_effect(t).parameters[p].is_choice) t.values[p] = 0;
  const Fit f = fit(s, options);
  return f.solution.normal.data_cost() / (noise_m * noise_m);
}

/// Of a world in which the hidden effect was not named: does the answer say so, and could the truth be known? Sure is
/// who claims a wrong name above 95 % and does not list the right one. `likelier_truth`: a fit with the truth's effect
/// leaves clearly less than one with what was named, number for number.
void look_at_miss(const Session& s, const World& w, const Improvement& m, Tally& t) {
  double claimed = 0, truth = 0;
  bool is_listed = false;
  for (const InclusionProbability& n : m.inclusion_probabilities.names) {
    const bool is_it = n.id == w.id;
    if (n.is_in_model && !is_it) claimed = std::max(claimed, n.probability);
    if (is_it) truth = n.probability;
    is_listed =
        is_listed || is_it || std::count(n.indistinguishable_from.begin(), n.indistinguishable_from.end(), w.id) > 0;
  }
  std::vector<EffectTerm> named;
  int numbers = 0;
  for (const FittedEffect& e : m.last.model.fit.effects) {
    named.push_back(e.term);
    for (const EffectParameter& p : term_effect(e.term).parameters) numbers += !p.is_choice;
  }
  int of_truth = 0;
  for (const EffectParameter& p : term_effect(w.hidden.front()).parameters) of_truth += !p.is_choice;
  const double left_truth = left_with(s, w.hidden), left_named = left_with(s, named);
  // ln of the odds by Schwarz's criterion, which knows nothing of prior sigmas.
  const double rows = static_cast<double>(m.last.model.fit.rows);
  const double ln_odds = 0.5 * (left_named - left_truth) - 0.5 * (of_truth - numbers) * std::log(rows);
  const bool is_sure = claimed > 0.95 && !is_listed;
  t.reported_as_open += !is_sure;
  t.sure_and_wrong += is_sure;
  t.likelier_truth += ln_odds > std::log(20.0);
  fmt::print(
      "  not named: claimed {:.3f}, truth {:.3f}{}; chi-squared {:.1f} with the truth's {} numbers, {:.1f} with "
      "the {} of what was named: ln odds of the truth {:.1f}\n",
      claimed, truth, is_listed ? " (listed)" : "", left_truth, of_truth, left_named, numbers, ln_odds);
}

void run(const std::string& kind, std::uint64_t seed, Tally& t) {
  const World w = world_of(kind, seed);
  const Session s = joined(w.members, "together");
  const auto start = std::chrono::steady_clock::now();
  const Improvement together = improve(s);
  t.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  ++t.worlds;
  const bool is_named = names(together, w, t.wrong);
  t.named += is_named;
  bool any = false;
  double ratio = 0, of_all = 0, of_one = 0;
  for (std::size_t p = 0; p < w.members.size(); ++p) {
    int ignored = 0;
    const Improvement alone = improve(w.members[p].session);
    any = any || names(alone, w, ignored);
    const PartFit part = fit_of_part(s, together.last.model.fit, static_cast<int>(p));
    of_one = hand_error(alone.last.model.fit, w.members[p].session, w.hidden, seed);
    of_all = hand_error(part.fit, part.session, w.hidden, seed);
    ratio = std::max(ratio, of_one > 0 ? of_all / of_one : 1);  // of the part that gains least
  }
  t.named_alone += any;
  t.ratio.push_back(ratio);
  std::string reported;
  for (const FittedEffect& e : together.last.model.fit.effects)
    reported += fmt::format(" {}:{}", e.term.id, place_name(term_effect(e.term), e.term.place, s.robot));
  fmt::print("{} {} {} {} named together {} ({} ) alone {} hand {:.3f} mm against {:.3f} mm\n", kind, seed, w.id,
             w.place, is_named, reported, any, 1e3 * of_all, 1e3 * of_one);
  if (!is_named && !w.hidden.empty()) look_at_miss(s, w, together, t);
  std::fflush(stdout);
}

double middle(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : v[v.size() / 2];
}

/// As the table names them.
std::string title_of(const std::string& kind) {
  if (kind == "two_hands") return "both hands before one tracker, two days";
  if (kind == "places") return "one hand, the tracker in four places";
  if (kind == "days") return "one hand, four days, markers glued anew";
  return "both hands, nothing hidden";
}

double processor_seconds(const auto& work) {
  const std::clock_t began = std::clock();
  work();
  return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
}

/// Five sessions of 400 observations of one hand, the tracker elsewhere in each; one joint's zero hidden.
void measure_time(int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<JoinedMember> members;
  for (const char* title : {"one", "two", "three", "four", "five"}) {
    const Session like = placed(fixture::hand_session('l'), random);
    SimulationOptions o = simulation(random());
    o.observations = 400;
    o.effects = {fixture::find_offset(like, "l3", 2e-3)};
    members.push_back(fixture::simulated_member(like, o, title));
  }
  const Session s = joined(members, "five");
  double of_fit = 1e9, with_held_out = 1e9;
  for (int i = 0; i < count; ++i) {
    Fit f;
    of_fit = std::min(of_fit, processor_seconds([&] { f = fit(s); }));
    with_held_out = std::min(with_held_out, processor_seconds([&] {
                               FitReport reported = report(s, f, {});
                               reported.held_out_region = held_out_by_region(s, f, {});
                               hold_out_sessions(s, f, {}, reported);
                             }));
  }
  std::string names;
  const double of_improve = processor_seconds([&] {
    const Improvement m = improve(s);
    for (const FittedEffect& e : m.last.model.fit.effects)
      names += " " + e.term.id + ":" + place_name(term_effect(e.term), e.term.place, s.robot);
  });
  fmt::print(
      "2000 observations in 5 sessions, time of a processor: fit {:.1f} ms, errors held out by folds, regions and "
      "sessions {:.1f} ms besides; improve {:.1f} s ({} )\n",
      1e3 * of_fit, 1e3 * with_held_out, of_improve, names);
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  using namespace handsight;
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  const int count = argc > 1 ? std::atoi(argv[1]) : 20;
  const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  const std::vector<std::string> all{"two_hands", "places", "days", "null"};
  if (argc > 3 && std::string(argv[3]) == "time") {
    measure_time(count, seed);
    return 0;
  }
  trials::Table table({{.heading = "worlds", .width = 44},
                       {"named together"},
                       {"by a session alone"},
                       {"wrong names"},
                       {"hand error together / alone", 2}},
                      output);
  for (const std::string& kind : argc > 3 ? std::vector<std::string>{argv[3]} : all) {
    Tally t;
    for (int i = 0; i < count; ++i) run(kind, seed + static_cast<std::uint64_t>(i), t);
    const bool is_hidden = kind != "null";
    table.print({title_of(kind), is_hidden ? trials::TableCell(t.named) : "-",
                 is_hidden ? trials::TableCell(t.named_alone) : "-", t.wrong, middle(t.ratio)});
    fmt::print(
        "  of {} worlds not named but reported as open {}, sure and wrong {}, the truth clearly likelier {}; {:.1f} s "
        "a world\n",
        t.worlds, t.reported_as_open, t.sure_and_wrong, t.likelier_truth, middle(t.seconds));
  }
}
