// SPDX-License-Identifier: Apache-2.0
// Robots as they are: several effects at once, masses a little wrong, joints that do not repeat, and a shift of the
// hand that no catalogue has. trial_messy COUNT [FIRST_SEED] [ROBOT] [SHIFT_MM; all for 0, 0.2 and 0.6] [--markdown]
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "diagnosis/ranking/curves.h"
#include "effects/own_effect.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/prediction.h"
#include "fixtures/gaussian_process.h"
#include "fixtures/trial_sessions.h"
#include "trials/table.h"

namespace handsight::trials {
namespace {

constexpr int measured = 100, fresh = 200;
constexpr double mass_error = 0.12, repeatability = 1e-4;  // relative; rad

/// What is true and hidden.
struct Messy {
  Session session;  // as measured: the nominal robot
  Robot true_robot;
  std::vector<EffectTerm> effects;
  std::optional<EffectTerm> shift;
  Rigid tcp_from_body;
  std::vector<Eigen::VectorXd> fresh_poses;
};

/// Three to five effects, 0.15 to 1 of the usual size.
std::vector<EffectTerm> hidden_effects(const Session& like, std::mt19937_64& random) {
  static const std::set<std::string> left_out{"body_slip", "marker_slip", "mount_slip"};
  const Chain chain = make_chain(like);
  const std::size_t count = 3 + random() % 3;
  std::vector<EffectTerm> all;
  std::set<std::string> ids;
  std::uniform_real_distribution<double> uniform(0, 1);
  while (ids.size() < count) {
    const Effect& e = catalogue()[random() % catalogue().size()];
    if (left_out.count(e.id) || ids.count(e.id)) continue;
    std::vector<EffectTerm> terms = random_terms(e, chain, random);
    if (terms.empty()) continue;
    // random_terms draws 0.3 to 3 of the usual size; here 0.15 to 1.
    const double size = 0.15 * std::pow(1 / 0.15, uniform(random)) / (0.3 * std::pow(10.0, 0.5));
    for (EffectTerm& t : terms)
      for (std::size_t p = 0; p < t.values.size(); ++p)
        if (!e.parameters[p].is_choice) t.values[p] *= size;
    SimulationOptions alone = simulation(1);
    alone.observations = measured;
    alone.effects = terms;
    if (like.robot.name == "random_robot") alone.farthest = 3;
    if (noncentrality_of(like, alone) < 50) continue;  // what these poses do not show is nobody's to find
    ids.insert(e.id);
    all.insert(all.end(), terms.begin(), terms.end());
  }
  return all;
}

Messy messy_session(int robot, std::uint64_t seed, double size_mm) {
  std::mt19937_64 random(seed * 9176 + 31 * static_cast<unsigned>(robot) + static_cast<unsigned>(1000 * size_mm));
  std::normal_distribution<double> normal;
  const Session like = robot_session(robot, seed);
  Messy m;
  Session real = like;
  for (Link& link : real.robot.links) link.mass *= std::max(0.3, 1 + mass_error * normal(random));
  m.true_robot = real.robot;
  m.effects = hidden_effects(like, random);
  m.shift = hidden_shift(like, size_mm, random);
  SimulationOptions o = simulation(seed + 40000, robot);
  o.observations = measured;
  o.effects = m.effects;
  if (m.shift) o.effects.push_back(*m.shift);
  SimulatedSession s = simulate_session(real, o);
  m.session = s.session;
  m.session.robot = like.robot;
  for (Observation& observation : m.session.observations)
    for (Eigen::Index j = 0; j < observation.position.size(); ++j)
      observation.position[j] += repeatability * normal(random);
  const std::vector<std::optional<Vector3>> known(s.markers_in_tcp.begin(), s.markers_in_tcp.end());
  m.tcp_from_body = body_frame(choose_sides(known), s.markers_in_tcp).tcp_from_body;
  SimulationOptions later = o;
  later.seed = seed + 70000;
  later.observations = fresh;
  for (const Observation& observation : simulate_session(real, later).session.observations)
    m.fresh_poses.push_back(observation.position);
  return m;
}

Rigid hand_at(const Chain& chain, const Eigen::VectorXd& pose, const std::vector<EffectTerm>& terms) {
  const ObservationState c = states_at(chain, pose);
  return observed_ends(c, moved_sites(c, terms)).ends.root_from_tcp;
}

/// Where a fit puts the body's origin in the TCP frame at a pose, beside what its terms move.
using PointOfHand = std::function<Vector3(const Eigen::VectorXd& pose)>;

/// Mean distance (mm) of the body's true origin in fresh poses from where the fit puts it.
double error_on_fresh(const Messy& m, const Fit& f, const PointOfHand& point) {
  Session real = m.session;
  real.robot = m.true_robot;
  const Chain truth = make_chain(real), model = make_chain(m.session);
  std::vector<EffectTerm> terms = m.effects;
  if (m.shift) terms.push_back(*m.shift);
  double sum = 0;
  for (const Eigen::VectorXd& pose : m.fresh_poses)
    sum +=
        (hand_at(truth, pose, terms) * m.tcp_from_body.translation - hand_at(model, pose, list_terms(f)) * point(pose))
            .norm();
  return 1e3 * sum / static_cast<double>(m.fresh_poses.size());
}

double error_on_fresh(const Messy& m, const Fit& f) {
  return error_on_fresh(m, f, [&](const Eigen::VectorXd&) { return f.tcp_from_body.translation; });
}

/// TCP->Body alone, and a Gaussian process over the joint angles on where the observations saw the body instead, along
/// the axes of the robot's root.
double error_of_learning(const Messy& m, const Fit& alone) {
  const FitReport r = report(m.session, alone);
  const Chain model = make_chain(m.session);
  const Vector3 body = alone.tcp_from_body.translation;
  std::vector<std::pair<Eigen::VectorXd, Vector3>> seen;
  for (const ObservationReport& o : r.per_observation) {
    if (!o.deviation) continue;
    const Eigen::VectorXd& pose = m.session.observations[static_cast<std::size_t>(o.index)].position;
    const Vector3 off = o.deviation->tcp_from_tcp_est * body - body;
    seen.emplace_back(pose, hand_at(model, pose, {}).rotation * off);
  }
  Eigen::MatrixXd angles(seen.size(), seen.front().first.size()), off(seen.size(), 3);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    angles.row(static_cast<Eigen::Index>(i)) = seen[i].first;
    off.row(static_cast<Eigen::Index>(i)) = 1e3 * seen[i].second;
  }
  const GaussianProcess process(angles, off);
  return error_on_fresh(m, alone, [&](const Eigen::VectorXd& pose) {
    return Vector3(body + 1e-3 * hand_at(model, pose, {}).rotation.transpose() * process.at(pose).transpose());
  });
}

/// The terms of an effect at every place of the chain; none where it has no place there.
std::vector<EffectTerm> everywhere(const Effect& e, const Chain& chain) {
  try {
    return effect_terms(e.id, chain);
  } catch (const InputError&) {
    return {};
  }
}

/// Everything of the catalogue at every place in one fit, held by its prior sigmas alone; but what begins at some
/// observation.
Fit all_at_once(const Messy& m) {
  FitOptions o;
  const Chain chain = make_chain(m.session);
  for (const Effect& e : catalogue()) {
    if (std::any_of(e.parameters.begin(), e.parameters.end(), [](const auto& p) { return p.is_choice; })) continue;
    for (EffectTerm& t : everywhere(e, chain)) o.estimated.push_back(std::move(t));
  }
  return fit(m.session, o);
}

/// The effects that are there but `without`, to be estimated.
FitOptions told_effects(const Messy& m, const std::string& without) {
  FitOptions o;
  for (EffectTerm t : m.effects) {
    if (t.id == without) continue;
    const Effect& e = term_effect(t);
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!e.parameters[p].is_choice) t.values[p] = 0;
    o.estimated.push_back(t);
  }
  return o;
}

/// Told which effects there are, but `without`; `everything`: the shift's form too.
Fit reported(const Messy& m, bool everything, const std::string& without = {}) {
  FitOptions o = told_effects(m, without);
  if (everything && m.shift) {
    o.estimated.push_back(*m.shift);
    std::fill(o.estimated.back().values.begin(), o.estimated.back().values.end(), 0.0);
  }
  return fit(m.session, o);
}

/// A wave of the hand along each axis with the variable that a term follows, of a frequency and any phase.
EffectTerm wave_of(const EffectTerm& shift, double frequency, const Robot& robot) {
  const std::string& formula = shift.own->definition->moves.front().formula;
  const std::size_t begin = formula.find("q_");
  const std::string variable = formula.substr(begin, formula.find('+', begin) - begin);
  EffectDefinition d;
  d.id = "wave";
  d.scope = "session";
  for (const std::string axis : {"x", "y", "z"}) {
    d.parameters.push_back({axis + "_sine", "m", 1e-3});
    d.parameters.push_back({axis + "_cosine", "m", 1e-3});
    d.moves.push_back(
        {"hand_" + axis, fmt::format("{0}_sine*sin({1}*{2}) + {0}_cosine*cos({1}*{2})", axis, frequency, variable), 0});
  }
  const auto effect = own_effect(d, robot);
  return term_of(*effect, -1, effect);
}

/// Told which effects there are and what the shift follows, as a wave: not its frequency, phase and sizes.
Fit told_the_variable(const Messy& m) {
  constexpr double widest = 0.5, exact = 2e-3, golden = 0.6180339887;  // of the frequency, which is 3.3
  const auto with = [&](double frequency) {
    FitOptions o = told_effects(m, {});
    o.estimated.push_back(wave_of(*m.shift, frequency, m.session.robot));
    return fit(m.session, o);
  };
  double low = 3.3 - widest, high = 3.3 + widest;
  std::optional<Fit> best;
  while (high - low > exact) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    Fit a = with(left), b = with(right);
    const bool is_left = a.solution.normal.data_cost() < b.solution.normal.data_cost();
    (is_left ? high : low) = is_left ? right : left;
    best = std::move(is_left ? a : b);
  }
  return std::move(*best);
}

std::set<std::string> list_ids(const std::vector<EffectTerm>& terms) {
  std::set<std::string> ids;
  for (const EffectTerm& t : terms)
    if (!is_curve(t)) ids.insert(t.id);
  return ids;
}

/// The hidden names that show where all else is given: without one of them a fit that knows the rest leaves 50 of
/// chi-squared more, in units of what it leaves with it. Nobody can find what does not show even then.
std::set<std::string> seen_beside_the_rest(const Messy& m, const Fit& everything) {
  const NormalEquations& with = everything.solution.normal;
  const double square = with.data_cost() / with.rows;
  std::set<std::string> seen;
  for (const std::string& id : list_ids(m.effects))
    if (reported(m, true, id).solution.normal.cost - with.cost > 50 * square) seen.insert(id);
  return seen;
}

std::string listed_ids(const std::set<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids) text += " " + id;
  return text;
}

int common(const std::set<std::string>& a, const std::set<std::string>& b) {
  return static_cast<int>(std::count_if(a.begin(), a.end(), [&](const std::string& id) { return b.count(id) > 0; }));
}

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  std::sort(v.begin(), v.end());
  return v.size() % 2 ? v[v.size() / 2] : 0.5 * (v[v.size() / 2 - 1] + v[v.size() / 2]);
}

/// The error that a model's sigma promises in the fresh poses: root mean square of the hand's body (mm).
double promised_on_fresh(const Messy& m, const PredictionModel& model) {
  const Chain chain = make_chain(m.session);
  double variance = 0;
  for (const Eigen::VectorXd& pose : m.fresh_poses) {
    const TcpPrediction p = predict_tcp(chain, pose, model);
    // Of the body's origin, which is where the hand is looked at.
    Eigen::Matrix<double, 3, 6> by_tcp;
    by_tcp << Matrix3::Identity(),
        -cross_matrix(Vector3(p.root_from_tcp_est.rotation * model.tcp_from_body.translation));
    variance += (by_tcp * p.covariance * by_tcp.transpose()).trace();
  }
  return 1e3 * std::sqrt(variance / static_cast<double>(m.fresh_poses.size()));
}

/// How often names are there that are reported to be there with some probability.
struct Reliability {
  static constexpr std::array<double, 6> from{0, 0.05, 0.2, 0.5, 0.8, 0.98};
  std::array<int, 6> reported{}, there{};
  std::array<double, 6> sum{};

  void add(double probability, bool is_there) {
    std::size_t bin = from.size() - 1;
    while (bin > 0 && probability < from[bin]) --bin;
    ++reported[bin];
    there[bin] += is_there;
    sum[bin] += probability;
  }

  void add(const Reliability& other) {
    for (std::size_t i = 0; i < from.size(); ++i)
      reported[i] += other.reported[i], there[i] += other.there[i], sum[i] += other.sum[i];
  }

  void print(const TableOutput& output) const {
    Table table({{"reported, on average"}, {.heading = "really there", .width = 16}}, output);
    for (std::size_t i = 1; i < from.size(); ++i) {
      if (reported[i] == 0) continue;
      const bool is_last = i + 1 == from.size();
      table.print({is_last ? "over 98 %" : fmt::format("{:.0f} %", 100 * sum[i] / reported[i]),
                   fmt::format("{:.{}f} % of {}", 100.0 * there[i] / reported[i], is_last ? 1 : 0, reported[i])});
    }
  }
};

double mean_square(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return sum / static_cast<double>(std::max<std::size_t>(1, v.size()));
}

struct Row {
  std::vector<double> alone, learned, at_once, improved, reported, variable, everything, over_promised,
      over_promised_without;
  Reliability names;
  int true_names = 0, found = 0, shown = 0, found_of_shown = 0, named = 0, wrong = 0, missing_at_the_end = 0,
      curve_seen = 0, trials = 0;
};

void run_trial(int robot, std::uint64_t seed, double size_mm, Row& row) {
  const Messy m = messy_session(robot, seed, size_mm);
  const Fit alone = fit(m.session);
  row.alone.push_back(error_on_fresh(m, alone));
  row.learned.push_back(error_of_learning(m, alone));
  row.at_once.push_back(error_on_fresh(m, all_at_once(m)));
  const auto start = std::chrono::steady_clock::now();
  const Improvement i = improve(m.session);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  row.improved.push_back(error_on_fresh(m, i.last.model.fit));
  const Fit& last = i.last.model.fit;
  row.over_promised.push_back(
      row.improved.back() / promised_on_fresh(m, prediction_model(last, i.inclusion_probabilities.model_uncertainty)));
  row.over_promised_without.push_back(row.improved.back() / promised_on_fresh(m, prediction_model(last)));
  row.reported.push_back(error_on_fresh(m, reported(m, false)));
  const Fit everything = reported(m, true);
  row.variable.push_back(error_on_fresh(m, m.shift ? told_the_variable(m) : everything));
  row.everything.push_back(error_on_fresh(m, everything));
  const std::set<std::string> truth = list_ids(m.effects), found = list_ids(list_terms(i.last.model.fit));
  const std::set<std::string> shown = seen_beside_the_rest(m, everything);
  const int right = common(found, truth);
  for (const InclusionProbability& n : i.inclusion_probabilities.names)
    if (find_effect(n.id)) row.names.add(n.probability, truth.contains(n.id));
  row.shown += static_cast<int>(shown.size());
  row.found_of_shown += common(found, shown);
  row.true_names += static_cast<int>(truth.size());
  row.found += right;
  row.named += static_cast<int>(found.size());
  row.wrong += static_cast<int>(found.size()) - right;
  row.missing_at_the_end += i.last.verdict == Verdict::missing_effect || i.last.verdict == Verdict::ambiguous;
  std::string curves;
  for (const EffectTerm& t : list_terms(i.last.model.fit))
    if (is_curve(t))
      curves += " [" + t.own->definition->moves.front().site + " " + t.own->definition->moves.front().formula + "]";
  row.curve_seen += !curves.empty();
  ++row.trials;
  fmt::print(
      "  robot {} seed {} shift {}: alone {:.3f} process {:.3f} at once {:.4f} improve {:.4f} told {:.4f} told "
      "the variable {:.4f} told everything {:.4f} mm, over promised {:.2f} (without doubt {:.2f}); {:.1f} s, {} "
      "steps\n    "
      "truth{}{}\n    shown beside the rest{}\n    found{}{} ({})\n",
      robot, seed, size_mm, row.alone.back(), row.learned.back(), row.at_once.back(), row.improved.back(),
      row.reported.back(), row.variable.back(), row.everything.back(), row.over_promised.back(),
      row.over_promised_without.back(), seconds, i.steps.size() - 1, listed_ids(truth),
      m.shift ? " + " + m.shift->own->definition->moves.front().formula : "", listed_ids(shown), listed_ids(found),
      curves, verdict_text(i.last.verdict));
  std::fflush(stdout);
}

/// What the catalogue lacks (mm), and the aims for it: mm, found and wrong in %.
struct Aim {
  double size_mm;
  const char *lacks, *improved, *found, *wrong;
};
constexpr Aim aims[] = {
    {0, "nothing", "0.055", "90", "5"}, {0.2, "0.2 mm", "0.08", "85", "7"}, {0.6, "0.6 mm", "0.10", "80", "7"}};

std::string percent_of(int count, int all) {
  return fmt::format("{:.0f} % of {}", 100.0 * count / std::max(1, all), all);
}

void print(Table& table, const Aim& aim, const Row& row) {
  table.print(
      {aim.lacks, fmt::format("{:.2f} mm", median(row.alone)), fmt::format("{:.2f}", median(row.learned)),
       median(row.at_once), median(row.reported), fmt::format("{:.3f} ({})", median(row.improved), aim.improved),
       median(row.everything), fmt::format("{} ({})", percent_of(row.found, row.true_names), aim.found),
       percent_of(row.found_of_shown, row.shown), fmt::format("{} ({})", percent_of(row.wrong, row.named), aim.wrong)});
  fmt::print(
      "  {} robots, missing_effect at the end of {}; given the variable {:.3f} mm left; error over what sigma "
      "promises: {:.2f} in the median, its square "
      "{:.2f} on average; without model uncertainty {:.2f} and {:.2f}\n",
      row.trials, row.missing_at_the_end, median(row.variable), median(row.over_promised),
      mean_square(row.over_promised), median(row.over_promised_without), mean_square(row.over_promised_without));
}

int messy_trials(const Arguments& a, const TableOutput& output) {
  Table table({{.heading = "what the catalogue lacks"},
               {"TCP->Body alone"},
               {"process"},
               {"all at once", 3},
               {"given the effects", 3},
               {"`improve` (aim)"},
               {"oracle", 3},
               {.heading = "effects found (aim)", .width = 20},
               {.heading = "of those that show", .width = 18},
               {.heading = "wrong (aim)", .width = 18}},
              output);
  Reliability names;
  for (const Aim& aim : aims) {
    const double size_mm = aim.size_mm;
    if (a.kind != "all" && std::atof(a.kind.c_str()) != size_mm) continue;
    Row row;
    for (int i = 0; i < a.count; ++i) {
      const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
      const int robot = a.robot >= 0 ? a.robot : std::array{3, 1, 3, 2, 3, 0}[static_cast<std::size_t>(i) % 6];
      try {
        run_trial(robot, seed, size_mm, row);
      } catch (const InputError& e) {  // drawn cameras before which no pose shows the hand
        fmt::print("  robot {} seed {} left out: {}\n", robot, seed, e.what());
      }
    }
    print(table, aim, row);
    names.add(row.names);
  }
  names.print(output);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  const TableOutput output = take_table_output(argc, argv);
  return messy_trials(arguments(argc, argv, "all"), output);
}
