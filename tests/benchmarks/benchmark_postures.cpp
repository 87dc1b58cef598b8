// SPDX-License-Identifier: Apache-2.0
// What every fit with effects is made of: where effects put an observation's chain, with derivatives and without, and
// sums over rows, beside Eigen's. benchmark_postures [SESSION...] [--markdown]
#include <benchmark/benchmark.h>

#include <random>

#include "benchmarks/measured_runs.h"
#include "estimation/problem/column_products.h"
#include "estimation/problem/problem.h"
#include "fixtures/arms.h"
#include "robot/posture_memory.h"
#include "session/session_xml.h"
#include "simulation/random.h"
#include "simulation/simulated_session.h"
#include "trials/table.h"

namespace handsight {
namespace {

/// Geometry, springs of joints and links and play at every joint, at about their prior sigmas.
struct Posed {
  Session session;
  Problem problem;
  Eigen::VectorXd values;

  explicit Posed(Session like) : session(std::move(like)) {
    std::vector<EffectTerm> terms;
    const Chain chain = make_chain(session);
    for (const char* id : {"link_geometry", "joint_elasticity", "link_elasticity", "backlash"})
      for (EffectTerm& term : effect_terms(id, chain)) terms.push_back(std::move(term));
    problem = make_problem(session, chain, {}, terms);
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    values = Eigen::VectorXd::NullaryExpr(problem.effect_count(), [&](Eigen::Index i) {
      return 0.5 * std::abs(normal(random)) * problem.columns_of_effects[static_cast<std::size_t>(i)].sigma;
    });
  }
};

/// Time an observation, of steps of a thousandth of the effects' sizes.
void place(benchmark::State& state, const Session& like, bool derives) {
  Posed posed(like);
  double sign = 1;
  for (auto _ : state) {
    posed.values *= 1 + 1e-3 * (sign = -sign);
    derives ? set_effects(posed.problem, posed.values) : follow_effects(posed.problem, posed.values);
  }
  const auto observations = static_cast<double>(posed.problem.observations.size());
  state.counters["columns"] = static_cast<double>(posed.problem.effect_count());
  state.counters["an_observation"] =
      benchmark::Counter(observations, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void squares(benchmark::State& state, bool ours) {
  const Eigen::MatrixXd rows = Eigen::MatrixXd::Random(state.range(0), state.range(1));
  Eigen::MatrixXd sum(rows.cols(), rows.cols());
  for (auto _ : state) {
    sum.setZero();
    if (ours)
      add_column_products(rows, sum);
    else
      sum.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    benchmark::DoNotOptimize(sum.data());
  }
}

void products(benchmark::State& state, bool ours) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(state.range(0), state.range(1));
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(state.range(0), state.range(2));
  Eigen::MatrixXd sum;
  for (auto _ : state) {
    if (ours)
      sum = column_products(a, b);
    else
      sum.noalias() = a.transpose() * b;
    benchmark::DoNotOptimize(sum.data());
  }
}

Session of_hundred_poses(const Session& like) {
  SimulationOptions options;
  options.observations = 100;
  return simulate_session(like, options).session;
}

/// Names of benchmarks, without what follows a "/".
constexpr const char* simulated[] = {"six_axes", "seven_axes", "torso"};

void add_benchmarks(const std::vector<std::string>& sessions) {
  for (const bool derives : {true, false}) {
    const auto add = [&](std::string name, const Session& like) {
      name += derives ? "/with_derivatives" : "/without";
      benchmark::RegisterBenchmark(name.c_str(), place, like, derives)->Unit(benchmark::kMillisecond);
    };
    add("six_axes", of_hundred_poses(fixture::stand_session()));
    add("seven_axes", of_hundred_poses(fixture::seven_axis_session()));
    add("torso", of_hundred_poses(fixture::torso_session()));
    for (const std::string& session : sessions) add(session, read_session(session));
  }
  for (const bool ours : {true, false}) {
    const std::string by = ours ? "ours" : "eigen";
    benchmark::RegisterBenchmark(("squares/" + by).c_str(), squares, ours)
        ->Args({192, 20})
        ->Args({192, 80})
        ->Args({1500, 90})
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("products/" + by).c_str(), products, ours)
        ->Args({750, 30, 100})
        ->Args({1500, 90, 300})
        ->Unit(benchmark::kMicrosecond);
  }
}

constexpr double us = 1e6;

void print_postures(const MeasuredRuns& runs, const std::vector<std::string>& sessions,
                    const trials::TableOutput& output) {
  trials::Table table({{.heading = "robot", .width = 32}, {"with all derivatives", 1}, {"without", 1}}, output);
  const auto print = [&](const std::string& title, const std::string& name) {
    const std::string with = name + "/with_derivatives";
    table.print({fmt::format("{}, {:.0f} columns", title, runs.counter(with, "columns")),
                 us * runs.counter(with, "an_observation"), us * runs.counter(name + "/without", "an_observation")});
  };
  for (const std::string& session : sessions) print(session, session);
  for (const char* name : simulated) print(fmt::format("simulated, {}", name), name);
}

void print_products(const MeasuredRuns& runs, const trials::TableOutput& output) {
  trials::Table table({{.heading = "product", .width = 28}, {"ours", 1}, {"Eigen", 1}}, output);
  const auto print = [&](const char* title, const std::string& kind, const std::string& size) {
    table.print({title, us * runs.seconds(kind + "/ours" + size), us * runs.seconds(kind + "/eigen" + size)});
  };
  print("A^T A, 192 x 20", "squares", "/192/20");
  print("A^T A, 192 x 80", "squares", "/192/80");
  print("A^T A, 1500 x 90", "squares", "/1500/90");
  print("A^T B, 750 x 30 and 100", "products", "/750/30/100");
  print("A^T B, 1500 x 90 and 300", "products", "/1500/90/300");
}

/// Passes to the equilibrium of random postures of a six-axis arm with springs and play at every joint.
void print_passes(const trials::TableOutput& output) {
  constexpr int postures = 400;
  const Robot robot = fixture::six_axis_arm();
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> angle(-2.5, 2.5);
  trials::Table table({{.heading = "springs of rad/(N m), play of rad", .width = 34},
                       {"ours", 1},
                       {"plain", 1},
                       {"without an end, ours", 0},
                       {"plain", 0}},
                      output);
  for (const double softness : {3e-5, 3e-4, 1e-3, 4e-3})
    for (const double gap : {1e-3, 1e-2}) {
      PostureMemory memory;
      double ours = 0, plain = 0, never = 0, plain_never = 0;
      for (int i = 0; i < postures; ++i) {
        RobotChange change;
        change.joints.resize(robot.joints.size());
        for (JointChange& c : change.joints) {
          c.compliance = softness * std::abs(normal(random));
          c.lateral_compliance = 0.3 * softness * std::abs(normal(random));
          c.gap = gap * normal(random);
        }
        const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(6, [&] { return angle(random); });
        const Vector3 down(0, 0, -9.81);
        const Posture& p = memory.solve(robot, q, change, down);
        const Posture beside = solve_posture<double>(robot, q, change, down);
        ours += p.iterations, plain += beside.iterations;
        never += p.converged ? 0 : 1, plain_never += beside.converged ? 0 : 1;
      }
      table.print(
          {fmt::format("{:.0e}, {:.0e}", softness, gap), ours / postures, plain / postures, never, plain_never});
    }
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  using namespace handsight;
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  benchmark::Initialize(&argc, argv);
  const std::vector<std::string> sessions(argv + 1, argv + argc);
  add_benchmarks(sessions);
  MeasuredRuns runs;
  benchmark::RunSpecifiedBenchmarks(&runs);
  print_postures(runs, sessions, output);
  print_products(runs, output);
  print_passes(output);
}
