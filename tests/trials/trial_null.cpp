// SPDX-License-Identifier: Apache-2.0
// Is nothing named where nothing is hidden? trial_null COUNT [FIRST_SEED] [ROBOT]
// [gaussian|student|repeatability|wrong|unseen] [--markdown]
#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "fixtures/trial_sessions.h"
#include "trials/table.h"

namespace handsight::trials {
namespace {

/// As the table names it, and the least share that should be called adequate (%).
struct Kind {
  const char* name;
  const char* title;
  int aim;
};
constexpr Kind kinds[] = {{"gaussian", "Gaussian", 99},
                          {"student", "Student t, 3 degrees", 98},
                          {"repeatability", "joints repeat to 1e-4 rad", 98},
                          {"wrong", "5 % wrong corners, 8 px", 98},
                          {"unseen", "a fifth of the markers unseen", 98}};

void print_row(const Arguments& a, const std::vector<TableCell>& adequate, const TableOutput& output) {
  std::vector<TableColumn> columns{{.heading = "kind", .width = 64}};
  for (int robot = 0; robot < 4; ++robot)
    if (!a.skips(robot)) columns.push_back({.heading = fmt::format("robot {}", robot), .width = 12});
  columns.push_back({"aim", 0, "%"});
  const auto* const kind =
      std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return a.kind == k.name; });
  std::string command = fmt::format("trial_null {} {}", a.count, a.first);
  if (a.robot >= 0 || kind != kinds) command += fmt::format(" {}", a.robot);
  if (kind != kinds) command += " " + a.kind;
  const bool is_known = kind != std::end(kinds);
  std::vector<TableCell> row{fmt::format("{} (`{}`)", is_known ? kind->title : a.kind, command)};
  row.insert(row.end(), adequate.begin(), adequate.end());
  row.push_back(is_known ? TableCell(kind->aim) : TableCell());
  Table(columns, output).print(row);
}

int null_trials(const Arguments& a, const TableOutput& output) {
  std::vector<TableCell> row;
  for (int robot = 0; robot < 4; ++robot) {
    if (a.skips(robot)) continue;
    int adequate = 0;
    double largest = 0, milliseconds = 0;
    std::vector<double> best;
    for (int i = 0; i < a.count; ++i) {
      const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
      const Session like = robot_session(robot, seed);
      SimulationOptions o = simulation(seed, robot);
      if (a.kind == "student") o.noise = 1e-7;
      Session session = simulate_session(like, o).session;
      disturb(session, a.kind, o.seed);
      const auto start = std::chrono::steady_clock::now();
      const Diagnosis d = diagnose(session, quick());
      milliseconds += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      adequate += d.verdict == Verdict::adequate ? 1 : 0;
      best.push_back(d.candidates.empty() ? 0 : d.candidates.front().ln_bayes_factor);
      largest = std::max(largest, best.back());
      if (d.verdict != Verdict::adequate)
        fmt::print("  robot {} seed {}: {} {} lnBF {:.1f} scatter {:.0e} wrong {} p {:.1g}\n", robot, o.seed,
                   verdict_text(d.verdict), top(d), best.back(), d.repeatability.joints, d.model.wrong.size(),
                   d.lack_of_fit_p.value_or(-1));
      std::fflush(stdout);
    }
    std::sort(best.begin(), best.end());
    fmt::print(
        "null {} robot {}: adequate {} of {} ({:.2f} %), lnBF 95 % {:.2f} 99 % {:.2f} largest {:.2f}, {:.0f} ms each\n",
        a.kind, robot, adequate, a.count, 100.0 * adequate / a.count, best[best.size() * 95 / 100],
        best[best.size() * 99 / 100], largest, milliseconds / a.count);
    row.emplace_back(share_text(adequate, a.count));
  }
  print_row(a, row, output);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  const TableOutput output = take_table_output(argc, argv);
  return null_trials(arguments(argc, argv, "gaussian"), output);
}
