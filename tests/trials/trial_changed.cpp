// SPDX-License-Identifier: Apache-2.0
// Several sessions of one robot between which one thing has changed, of the size that weeks leave, or nothing: a
// joint's zero by 1 mrad, the mount turned by 0.05 degrees, a lens refocused (its focal length by 0.3 %), the tool
// slipped by 0.3 mm. Is it told, and between which sessions? The robots are those of trial_compare: a third has effects
// that the model does not know, a third besides masses and a shift that no catalogue has.
//   trial_changed COUNT [FIRST_SEED [SESSIONS]]; with 2 SESSIONS `compare` of two is asked beside
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cstdio>
#include <map>

#include "compare/comparison.h"
#include "compare/several_comparison.h"
#include "fixtures/trial_sessions.h"
#include "trials/table.h"

namespace handsight::trials {
namespace {

constexpr const char* kinds[] = {"nothing", "joint_offset", "camera_mount", "lens", "body_slip"};
constexpr const char* model_names[] = {"right", "lacking", "outside"};

struct Days {
  std::vector<JoinedMember> members;
  std::string id, where;
  std::vector<std::string> after;  // where it is another
};

std::vector<EffectTerm> drawn_change(const std::string& kind, const Chain& chain, std::mt19937_64& random) {
  if (kind == "nothing") return {};
  const Effect& effect = *find_effect(kind == "lens" ? "camera_intrinsics" : kind);
  std::normal_distribution<double> normal;
  const std::vector<int> places = effect_places(effect, chain);
  EffectTerm term = term_of(effect, places[random() % places.size()]);
  const Vector3 along = fixture::drawn_3([&] { return normal(random); }).normalized();
  for (std::size_t p = 0; p < term.values.size(); ++p) {
    const std::string& name = effect.parameters[p].name;
    if (kind == "joint_offset") term.values[p] = random() % 2 ? 1e-3 : -1e-3;
    if (kind == "camera_mount" && p >= 3) term.values[p] = 0.05 / 57.2957795 * along[static_cast<Eigen::Index>(p - 3)];
    if (kind == "body_slip" && p < 3) term.values[p] = 3e-4 * along[static_cast<Eigen::Index>(p)];
    if (kind == "lens" && name.find('f') != std::string::npos) term.values[p] = 0.003 * chain.rig->at(0).camera.fx;
  }
  return {term};
}

Days drawn_days(std::uint64_t seed, int count, const std::string& kind, int model) {
  std::mt19937_64 random(seed * 7919 + 29);
  const Session like = robot_session(3, seed);
  const Chain chain = make_chain(like);
  SimulationOptions o = simulation(seed + 500000, 3);
  if (model > 0)
    for (const char* id : {"joint_elasticity", "encoder_eccentricity"})
      for (const EffectTerm& t : random_terms(*find_effect(id), chain, random)) o.effects.push_back(t);
  Session real = like;
  if (model == 2) {
    std::normal_distribution<double> normal;
    for (Link& link : real.robot.links) link.mass *= std::max(0.3, 1 + 0.12 * normal(random));
    o.effects.push_back(*hidden_shift(like, 0.3, random));
  }
  const std::vector<EffectTerm> change = drawn_change(kind, chain, random);
  Days days;
  days.id = kind == "nothing" ? "" : kind;
  if (!change.empty()) days.where = place_name(term_effect(change.front()), change.front().place, like.robot);
  const int first = 1 + static_cast<int>(random() % static_cast<unsigned>(count - 1));
  const bool alone = random() % 2;
  o.observations = count * observations;
  const SimulatedSession without = simulate_session(real, o);
  o.effects.insert(o.effects.end(), change.begin(), change.end());
  const SimulatedSession with = simulate_session(real, o);
  for (int k = 0; k < count; ++k) {
    const bool is_changed = !change.empty() && (alone ? k == first : k >= first);
    JoinedMember& m = days.members.emplace_back();
    m.session = is_changed ? with.session : without.session;
    m.session.robot = like.robot;
    m.title = fmt::format("day {}", k + 1);
    m.rig = m.body = "same";
    if (is_changed) days.after.push_back(m.title);
    auto& all = m.session.observations;
    all.erase(all.begin() + (k + 1) * observations, all.end());
    all.erase(all.begin(), all.begin() + k * observations);
  }
  return days;
}

struct Row {
  int worlds = 0, named = 0, alternative = 0, missed = 0, sure_and_wrong = 0, other = 0, pair_named = 0, pair_tied = 0;
  double seconds = 0;
};

bool is_truth(const ChangeCandidate& c, const Days& days) {
  return c.id == days.id && (days.id == "lens" || c.where == days.where) && c.after == days.after;
}

void count_pair(const Days& days, Row& row) {
  const Comparison c = compare(days.members[0].session, days.members[1].session);
  const std::string found = c.verdict == ComparisonVerdict::unchanged ? "" : c.changes.front().id;
  row.pair_named += found == days.id;
  row.pair_tied +=
      found != days.id && std::count(c.indistinguishable_from.begin(), c.indistinguishable_from.end(), days.id) > 0;
}

void run(std::uint64_t seed, int sessions, const std::string& kind, int model, Row& row) {
  const Days days = drawn_days(seed, sessions, kind, model);
  const auto start = std::chrono::steady_clock::now();
  const SeveralComparison c = compare(days.members);
  row.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ++row.worlds;
  bool named = days.id.empty() && c.changes.empty(), beside = false, sure = false;
  int other = 0;
  for (const ChangeBetween& b : c.changes) {
    const bool is_it = is_truth(b.reported, days);
    const bool may_be = std::any_of(b.alternatives.begin(), b.alternatives.end(),
                                    [&](const ChangeCandidate& a) { return is_truth(a, days); });
    named = named || is_it;
    beside = beside || may_be;
    other += !is_it && !may_be;
    sure = sure || (!is_it && b.reported.probability > 0.95);
  }
  row.named += named;
  row.alternative += !named && beside;
  row.missed += !days.id.empty() && c.changes.empty();
  row.sure_and_wrong += sure;
  row.other += other;
  if (sessions == 2) count_pair(days, row);
  if (named && other == 0) return;
  fmt::print("  seed {}, {} model: {} {} from {}: {} (threshold {:.1f})\n", seed, model_names[model],
             days.id.empty() ? "nothing" : days.id, days.where, fmt::join(days.after, ", "), c.sentence, c.threshold);
  for (const ChangeBetween& b : c.changes) {
    fmt::print("    {} {} {:.3f}", b.reported.id, b.reported.where, b.reported.probability);
    for (const ChangeCandidate& a : b.alternatives)
      fmt::print("; {} {} in {} {:.3f}", a.id, a.where, fmt::join(a.after, ", "), a.probability);
    fmt::print("\n");
  }
  std::fflush(stdout);
}

/// As the table names them, in the order of `kinds`.
constexpr const char* titles[] = {"nothing", "a joint's zero by 1 mrad", "the mount turned by 0.05 degrees",
                                  "a lens refocused (focal length by 0.3 %)", "the tool slipped by 0.3 mm"};

void print(Table& table, const std::string& title, const Row& r, bool is_change, int sessions) {
  table.print({title, r.worlds, r.named, is_change ? TableCell(r.missed) : TableCell("-"), r.other,
               sessions == 2 ? TableCell(r.pair_named) : TableCell()});
  fmt::print("  {} among the alternatives, {} above 95 % and wrong; compare of two: {} tied; {:.1f} s each\n",
             r.alternative, r.sure_and_wrong, r.pair_tied, r.seconds / std::max(1, r.worlds));
}

int changed_trials(const Arguments& a, int sessions, const TableOutput& output) {
  std::map<std::string, Row> rows;
  for (int i = 0; i < a.count; ++i) {
    const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
    const std::string kind = kinds[static_cast<std::size_t>(i) % std::size(kinds)];
    const int model = i / static_cast<int>(std::size(kinds)) % 3;
    try {
      run(seed, sessions, kind, model, rows[kind]);
    } catch (const InputError& error) {  // these cameras see hardly any pose
      fmt::print("  seed {} is left out: {}\n", seed, error.what());
    }
  }
  Table table({{.heading = "changed", .width = 42},
               {sessions == 2 ? "pairs" : "collections"},
               {"told, with its place"},
               {"missed"},
               {"something else told"},
               {"by `compare` of two"}},
              output);
  for (std::size_t k = 0; k < std::size(kinds); ++k)
    if (rows.contains(kinds[k])) print(table, titles[k], rows[kinds[k]], k > 0, sessions);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  const TableOutput output = take_table_output(argc, argv);
  Arguments a;
  if (argc > 1) a.count = std::atoi(argv[1]);
  if (argc > 2) a.first = static_cast<std::uint64_t>(std::atoll(argv[2]));
  return changed_trials(a, argc > 3 ? std::atoi(argv[3]) : 2, output);
}
