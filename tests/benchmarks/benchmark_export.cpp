// SPDX-License-Identifier: Apache-2.0
// How long an exported C++ file takes for a hand pose: written, compiled by c++ -O2 and run.
// benchmark_export [--markdown]
#include <benchmark/benchmark.h>

#include "benchmarks/measured_runs.h"
#include "export/exported.h"
#include "fixtures/robots_with_everything.h"
#include "fixtures/trial_sessions.h"
#include "trials/table.h"

namespace handsight {
namespace {

/// Microseconds a pose, by the program itself.
double microseconds(int robot, bool with_effects) {
  std::mt19937_64 random(5);
  const Session session = trials::robot_session(robot);
  const CalibratedRobot calibrated = fixture::robot_with(
      session, with_effects ? fixture::everything_wrong(make_chain(session), random) : std::vector<EffectTerm>{},
      random);
  const TemporaryFolder folder;
  std::ofstream(folder.path / "hand.cpp") << exported_file(calibrated, "cpp").text;
  std::ofstream(folder.path / "main.cpp") << R"cpp(
#include <chrono>
#include <cstdio>
#include "hand.cpp"
    int main() {
      using namespace handsight_hand;
      double q[joint_count], sum = 0;
      Motion hand;
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < 20000; ++i) {
        for (int j = 0; j < joint_count; ++j) q[j] = 0.4 + 0.5 * std::sin(0.1 * i + j);
        hand_pose(q, hand);
        sum += hand.shift[0];
      }
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      std::printf("%.6f %.3f\n", 1e6 * seconds / 20000, sum);
    }
  )cpp";
  const std::string said = fixture::compiled(folder.path / "main.cpp", folder.path / "main", "");
  if (!said.empty()) return -1;
  const auto answer = fixture::answers(folder.path, "'" + (folder.path / "main").string() + "'", {});
  return answer.empty() ? -1 : answer[0].numbers[0];
}

void exported_pose(benchmark::State& state) {
  for (auto _ : state) {
    const double us = microseconds(static_cast<int>(state.range(0)), state.range(1) != 0);
    state.SetIterationTime(1e-6 * us);
  }
}
/// Robot (0 Justin, 1 six axes, 2 seven), and whether every effect of the catalogue is in the model.
BENCHMARK(exported_pose)
    ->ArgsProduct({{0, 1, 2}, {0, 1}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(3);

/// us a pose, with every effect; the load of the machine (processes that run or wait) as it was at the start.
void print_table(const MeasuredRuns& runs, double load, const trials::TableOutput& output) {
  const auto us = [&](int robot) {
    return 1e6 * runs.seconds(fmt::format("exported_pose/{}/1/iterations:3/manual_time", robot));
  };
  trials::Table table({{"load of the machine", 1}, {"Justin", 1}, {"six axes", 1}, {"seven axes", 1}}, output);
  table.print({load, us(0), us(1), us(2)});
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  const handsight::trials::TableOutput output = handsight::trials::take_table_output(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  double load = NAN;
  getloadavg(&load, 1);
  handsight::MeasuredRuns runs;
  benchmark::RunSpecifiedBenchmarks(&runs);
  handsight::print_table(runs, load, output);
}
