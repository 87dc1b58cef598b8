// SPDX-License-Identifier: Apache-2.0
// Robots as they are: several effects at once, masses a little wrong, joints that do not repeat, and a shift of the
// hand that no catalogue has. trial_messy COUNT [FIRST_SEED] [ROBOT] [SHIFT_MM; all for 0, 0.2 and 0.6] [--markdown]
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <set>
#include <string>

#include "estimation/report/prediction.h"
#include "trials/messy_comparisons.h"
#include "trials/table.h"

namespace handsight::trials {
namespace {

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
