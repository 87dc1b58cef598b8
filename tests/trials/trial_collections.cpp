// SPDX-License-Identifier: Apache-2.0
// Several sessions of one robot together against the best of them alone: are effects named that no single session
// shows, is nothing named that is not there, and how far is the hand from where it is predicted in poses that were not
// measured?
//   trial_collections [COUNT [SEED [WORLD]]]; worlds: those of fixtures/collection_worlds.h
// With "time" for a world: how much time of a processor 2000 observations in five sessions take. With "worlds" and a
// world: what can be hidden in it, and how much of it a session alone shows. With "judge" and a world: how many a judge
// names who knows how the worlds are made.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <random>

#include "base/freed_memory.h"
#include "diagnosis/selection/improvement.h"
#include "estimation/fit/fit_parts.h"
#include "estimation/fit/part_fit.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/part_report.h"
#include "fixtures/collection_worlds.h"
#include "trials/collection_judge.h"
#include "trials/table.h"

namespace handsight {
namespace {

using namespace fixture;

/// Median distance of the predicted from the true hand, as the sensor's link sees it, over poses drawn from the whole
/// of the joints' ranges; the prediction is of where the TCP is, its place on the hand as commanded.
double hand_error(const Fit& fit, const Session& session, const std::vector<EffectTerm>& hidden, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const Chain chain = make_chain(session);
  const std::vector<EffectTerm> found = list_terms(fit);
  std::vector<double> errors;
  for (int i = 0; i < 200; ++i) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(chain.joints.size()));
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
      q[j] = std::uniform_real_distribution<double>(0.8 * joint.lower, 0.8 * joint.upper)(random);
    }
    const ObservationState c = states_at(chain, q);
    const auto seen = [&](const std::vector<EffectTerm>& effects) {
      const ChainEnds ends = observed_ends(c, moved_sites(c, effects)).ends;
      return inverse(ends.root_from_mount) * ends.root_from_tcp;
    };
    errors.push_back((seen(found).translation - seen(hidden).translation).norm());
  }
  std::nth_element(errors.begin(), errors.begin() + 100, errors.end());
  return errors[100];
}

struct Tally {
  int worlds = 0, not_there = 0, named = 0, named_alone = 0, named_by_best = 0, wrong = 0;
  int reported_as_open = 0, sure_and_wrong = 0, likelier_truth = 0;  // of those that were not named
  int sure = 0, sure_of_wrong = 0;                                   // names told above 95 %
  int inside = 0, told = 0;  // numbers of each TCP->Body in their 95 % intervals
  std::vector<double> ratio, seconds;
};

/// How many numbers of a part's TCP->Body are inside their 95 % intervals: six, or three where its rotation is unseen.
void count_inside(const PartFit& part, const WorldMember& member, Tally& t) {
  constexpr double normal_95 = 1.959964;
  const Rigid truth = body_frame(part.fit.sides, member.markers_in_tcp).tcp_from_body;
  const Rigid off = truth * inverse(part.fit.tcp_from_body);  // exp(xi)
  const Vector6 sigma = origin_sigma(part.fit.tcp_from_body, part.fit.covariance);
  const Vector3 place = truth.translation - part.fit.tcp_from_body.translation;
  const Vector3 turn = vector_from_rotation(off.rotation);
  for (int i = 0; i < (part.fit.rotation_is_observed ? 6 : 3); ++i) {
    t.inside += std::abs(i < 3 ? place[i] : turn[i - 3]) <= normal_95 * sigma[i];
    ++t.told;
  }
}

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
    numbers += trials::count_numbers(e.term);
  }
  const int of_truth = trials::count_numbers(w.hidden.front());
  const double left_truth = trials::left_with(s, w.hidden), left_named = trials::left_with(s, named);
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
  for (const RefusedStep& r : m.refused)
    fmt::print("    not taken: {} {}: {}\n", r.id, fmt::join(r.where, " "), r.reason.english());
}

void run(const WorldKind& kind, std::uint64_t seed, Tally& t) {
  const World w = world_of(kind, seed);
  const Session s = joined_world(w.members);
  const auto start = std::chrono::steady_clock::now();
  const Improvement together = improve(s);
  t.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  ++t.worlds;
  const bool is_named = names(together, w, t.wrong);
  for (const InclusionProbability& n : together.inclusion_probabilities.names) {
    if (!n.is_in_model || n.probability < 0.95) continue;
    ++t.sure;
    t.sure_of_wrong += n.id != w.id;
  }
  t.named += is_named;
  bool any = false, by_best = false;
  double ratio = 0, of_all = 0, of_one = 0;
  for (std::size_t p = 0; p < w.members.size(); ++p) {
    int ignored = 0;
    const Session& single = w.members[p].joined.session;
    const Improvement alone = improve(single);
    const bool is_named_alone = names(alone, w, ignored);
    any = any || is_named_alone;
    by_best = by_best || (is_named_alone && p == w.best);
    const PartFit part = fit_of_part(s, together.last.model.fit, static_cast<int>(p));
    count_inside(part, w.members[p], t);
    if (!w.place.empty() && std::find(single.joints.begin(), single.joints.end(), w.place) == single.joints.end())
      continue;
    of_one = hand_error(alone.last.model.fit, single, w.hidden, seed);
    of_all = hand_error(part.fit, part.session, w.hidden, seed);
    ratio = std::max(ratio, of_one > 0 ? of_all / of_one : 1);  // of the part that gains least, of those with the joint
  }
  t.named_alone += any;
  t.named_by_best += by_best;
  t.ratio.push_back(ratio);
  std::string reported;
  for (const FittedEffect& e : together.last.model.fit.effects)
    reported += fmt::format(" {}:{}", e.term.id, place_name(term_effect(e.term), e.term.place, s.robot));
  fmt::print("{} {} {} {} named together {} ({} ) alone {} hand {:.3f} mm against {:.3f} mm\n", kind.name, seed, w.id,
             w.place, is_named, reported, any, 1e3 * of_all, 1e3 * of_one);
  if (!is_named && !w.hidden.empty()) look_at_miss(s, w, together, t);
  std::fflush(stdout);
}

/// Some seeds have a world in which nothing can be hidden so: these are counted, and the next is taken.
void run_if_there_is_one(const WorldKind& kind, std::uint64_t seed, Tally& t) {
  try {
    run(kind, seed, t);
  } catch (const NoSuchWorld&) {
    ++t.not_there;
    fmt::print("{} {} nothing can be hidden so\n", kind.name, seed);
  }
}

double middle(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : v[v.size() / 2];
}

/// Which effects may be hidden in worlds of this kind, and how well the sessions hide them.
void list_what_hides(const WorldKind& kind, int count, std::uint64_t seed) {
  for (int i = 0; i < count; ++i) {
    const World w = world_of(kind, seed + static_cast<std::uint64_t>(i));
    fmt::print("{} {} {} {}", kind.name, seed + static_cast<std::uint64_t>(i), w.id, w.place);
    if (w.hidden.empty()) {
      fmt::print("nothing\n");
      continue;
    }
    const Shown of = shown(kind, w.hidden.front(), seed + static_cast<std::uint64_t>(i));
    fmt::print(": shows {:.1f} together, {:.1f} in one session at most\n", of.together, of.alone);
    std::fflush(stdout);
  }
}

/// How many of these worlds a judge names who knows that the cause is one of the catalogue's at one place, or one of
/// the four that are hidden, in one of the robot's joints.
void judge_worlds(const WorldKind& kind, int count, std::uint64_t seed, trials::Table& table) {
  int of_all = 0, of_hidden = 0;
  const std::vector<std::string>& ids = hidden_ids();
  const auto may_be_hidden = [&](const trials::JudgedCause& c) {
    return std::find(ids.begin(), ids.end(), c.id) != ids.end();
  };
  for (int i = 0; i < count; ++i) {
    const World w = world_of(kind, seed + static_cast<std::uint64_t>(i));
    const std::vector<trials::JudgedCause> causes = trials::judge(joined_world(w.members));
    const auto is_right = [&](const trials::JudgedCause& c) { return c.id == w.id && c.place == w.place; };
    const trials::JudgedCause& best = causes.front();
    const trials::JudgedCause& of_four = *std::find_if(causes.begin(), causes.end(), may_be_hidden);
    const trials::JudgedCause& truth = *std::find_if(causes.begin(), causes.end(), is_right);
    of_all += is_right(best);
    of_hidden += is_right(of_four);
    fmt::print("{} {} {} {}: judged {} {}, {:.1f} likelier (ln); of the four {} {}\n", kind.name,
               seed + static_cast<std::uint64_t>(i), w.id, w.place, best.id, best.place,
               best.ln_likelihood - truth.ln_likelihood, of_four.id, of_four.place);
    std::fflush(stdout);
  }
  table.print({kind.title, count, of_all, of_hidden});
}

double processor_seconds(const auto& work) {
  const std::clock_t began = std::clock();
  work();
  return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
}

/// Five sessions of 400 observations of one hand, the tracker elsewhere in each; one joint's zero hidden.
void measure_time(int count, std::uint64_t seed) {
  WorldBuilder build({fixture::find_offset(fixture::hand_session('l'), "l3", 2e-3)}, seed, true);
  for (const char* title : {"one", "two", "three", "four", "five"})
    build.add(build.placed(fixture::hand_session('l')), title, "", "", 400, tracked_m);
  const Session s = joined_world(build.take());
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
  const auto begin = std::chrono::steady_clock::now();
  const double of_improve = processor_seconds([&] {
    const Improvement m = improve(s);
    for (const FittedEffect& e : m.last.model.fit.effects)
      names += " " + e.term.id + ":" + place_name(term_effect(e.term), e.term.place, s.robot);
  });
  fmt::print(
      "2000 observations in 5 sessions, time of a processor: fit {:.1f} ms, errors held out by folds, regions and "
      "sessions {:.1f} ms besides; improve {:.1f} s, {:.1f} s by the clock ({} )\n",
      1e3 * of_fit, 1e3 * with_held_out, of_improve,
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), names);
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  using namespace handsight;
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  const int count = argc > 1 ? std::atoi(argv[1]) : 20;
  const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  const std::string only = argc > 3 ? argv[3] : "";
  if (only == "time") {
    keep_freed_memory();  // as the programs do
    measure_time(count, seed);
    return 0;
  }
  const bool lists = only == "worlds", judges = only == "judge";
  const std::string name = !lists && !judges ? only : argc > 4 ? argv[4] : "";
  trials::Table table({{.heading = "worlds", .width = 58},
                       {"named together"},
                       {"by a session alone"},
                       {"wrong names"},
                       {"of those above 95 %"},
                       {"hand error together / alone", 2},
                       {"TCP->Body inside 95 %"}},
                      output);
  trials::Table judged({{.heading = "worlds", .width = 58},
                        {"judged"},
                        {"a judge names, of all effects"},
                        {"of the four that are hidden"}},
                       output);
  for (const WorldKind& kind : world_kinds()) {
    if (!name.empty() && name != kind.name) continue;
    if (judges && !kind.places.empty()) judge_worlds(kind, count, seed, judged);
    if (judges) continue;
    if (lists) {
      list_what_hides(kind, count, seed);
      continue;
    }
    Tally t;
    for (std::uint64_t of = seed; t.worlds < count && t.not_there <= count; ++of) run_if_there_is_one(kind, of, t);
    const bool is_hidden = !kind.places.empty();
    table.print({kind.title, is_hidden ? trials::TableCell(t.named) : "-",
                 is_hidden ? trials::TableCell(t.named_alone) : "-", t.wrong,
                 fmt::format("{} of {}", t.sure_of_wrong, t.sure), middle(t.ratio),
                 fmt::format("{:.1f} %", 100.0 * t.inside / t.told)});
    fmt::print(
        "  of {} worlds ({} seeds have none) named by that session alone that shows it best {}; not named but reported "
        "as open {}, sure and wrong {}, the truth clearly likelier {}; {:.1f} s a world\n",
        t.worlds, t.not_there, t.named_by_best, t.reported_as_open, t.sure_and_wrong, t.likelier_truth,
        middle(t.seconds));
  }
}
