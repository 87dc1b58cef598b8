// SPDX-License-Identifier: Apache-2.0
// What the benchmark library has measured, for tables. It prints its own lines as always.
#pragma once

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace handsight {

/// To be given to benchmark::RunSpecifiedBenchmarks. What was not run, or refused, is no number.
class MeasuredRuns : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration && !run.error_occurred) runs_.insert_or_assign(run.benchmark_name(), run);
    ConsoleReporter::ReportRuns(runs);
  }

  /// s of processor time an iteration; by the benchmark's own clock where it has one ("NAME/manual_time").
  double seconds(const std::string& name) const {
    const auto run = runs_.find(name);
    if (run == runs_.end()) return NAN;
    const bool is_manual = std::string_view(name).ends_with("/manual_time");
    return (is_manual ? run->second.GetAdjustedRealTime() : run->second.GetAdjustedCPUTime()) /
           benchmark::GetTimeUnitMultiplier(run->second.time_unit);
  }

  /// What it has counted.
  double counter(const std::string& name, const std::string& what) const {
    const auto run = runs_.find(name);
    if (run == runs_.end()) return NAN;
    const auto counted = run->second.counters.find(what);
    return counted == run->second.counters.end() ? NAN : counted->second.value;
  }

 private:
  std::map<std::string, Run> runs_;
};

}  // namespace handsight
