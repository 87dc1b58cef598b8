// SPDX-License-Identifier: Apache-2.0
// Fits from wrong starts: is the same minimum reached as from the truth? trial_wrong_starts [COUNT] [FIRST_SEED] [RIG]
// [--markdown]
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "fixtures/wrong_starts.h"
#include "trials/table.h"

int main(int argc, char** argv) {
  using namespace handsight;
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  const int count = argc > 1 ? std::atoi(argv[1]) : 200;
  const int first = argc > 2 ? std::atoi(argv[2]) : 1;
  const int only = argc > 3 ? std::atoi(argv[3]) : -1;
  trials::Table table(
      {{.heading = "rig", .width = 64}, {"reached"}, {"reported not converged"}, {"wrong without a warning"}}, output);
  const auto rigs = fixture::wrong_start_rigs();
  for (int r = 0; r < static_cast<int>(rigs.size()); ++r) {
    if (only >= 0 && r != only) continue;
    int reached = 0, said_no = 0, lost = 0;
    double seconds = 0;
    for (int i = 0; i < count; ++i) {
      const auto w = fixture::wrong_start(rigs[static_cast<std::size_t>(r)], static_cast<std::uint64_t>(first + i));
      Fit found, reported;
      const auto began = std::chrono::steady_clock::now();
      const fixture::Outcome outcome = fixture::make_outcome(w, &found, &reported);
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      reached += outcome == fixture::Outcome::reached;
      said_no += outcome == fixture::Outcome::said_no;
      lost += outcome == fixture::Outcome::lost_silently;
      if (outcome != fixture::Outcome::reached)
        fmt::print("  rig {} seed {}: {}, {:.4g} px, {:.6g} against {:.6g} (from the truth {})\n", r, first + i,
                   outcome == fixture::Outcome::said_no ? "said no" : "LOST", found.residual_rms,
                   found.solution.normal.cost, reported.solution.normal.cost,
                   reported.converged() ? "converged" : "NOT CONVERGED");
      std::fflush(stdout);
    }
    table.print({rigs[static_cast<std::size_t>(r)].name, trials::share_text(reached, count), said_no, lost});
    fmt::print("  {:.0f} ms for both fits\n", 1e3 * seconds / count);
    std::fflush(stdout);
  }
}
