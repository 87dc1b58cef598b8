// SPDX-License-Identifier: Apache-2.0
// Is nothing named where nothing is hidden? trial_null COUNT [FIRST_SEED] [ROBOT]
// [gaussian|student|repeatability|wrong|unseen]
#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "fixtures/trial_sessions.h"

namespace handsight::trials {
namespace {

int null_trials(const Arguments& a) {
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
  }
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  return null_trials(arguments(argc, argv, "gaussian"));
}
