// SPDX-License-Identifier: Apache-2.0
// How long a fit takes: ours, the same least squares by Ceres, its growth, the online step; and the peak
// memory. benchmark_fit [--markdown] [--benchmark_...]
#include <benchmark/benchmark.h>
#include <ceres/ceres.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <map>

#include "benchmarks/measured_runs.h"
#include "estimation/fit/fit.h"
#include "estimation/online/online.h"
#include "estimation/solvers/trust_region.h"
#include "estimation/start/start.h"
#include "fixtures/arms.h"
#include "trials/table.h"

namespace handsight {
namespace {

constexpr double agreement = 1e-9;  // m and rad: how near two answers to the same least squares must be

template <class T>
CameraT<T> cast_camera(const Camera& c) {
  return {c.width, c.height, T(c.fx), T(c.fy), T(c.skew), T(c.cx),
          T(c.cy), T(c.k1),  T(c.k2), T(c.p1), T(c.p2),   T(c.k3)};
}

/// Predicted - measured of one marker in both images, px.
struct SightingCost {
  const Rig& rig;
  const Sighting& sighting;
  Rigid tcp_side;    // root_from_tcp; sensor_from_tcp with a known mount
  Rigid mount_side;  // root_from_sensor at the start, from which `mount` is the small motion

  template <class T>
  bool of_point(const Vector3T<T>& x, T* residual) const {
    const Vector3T<T> in_right = cast<T>(rig.at(1).camera_from_first) * x;
    const Eigen::Matrix<T, 2, 1> left = project<T>(cast_camera<T>(rig.at(0).camera), x);
    const Eigen::Matrix<T, 2, 1> right = project<T>(cast_camera<T>(rig.at(1).camera), in_right);
    for (int i = 0; i < 2; ++i) {
      residual[i] = left[i] - sighting.in_cameras[0].pixel[i];
      residual[2 + i] = right[i] - sighting.in_cameras[1].pixel[i];
    }
    return true;
  }
  template <class T>
  bool operator()(const T* marker, T* residual) const {
    return of_point<T>(cast<T>(tcp_side) * Vector3T<T>(Eigen::Map<const Vector3T<T>>(marker)), residual);
  }
  template <class T>
  bool operator()(const T* marker, const T* mount, T* residual) const {
    const Vector3T<T> in_root = cast<T>(tcp_side) * Vector3T<T>(Eigen::Map<const Vector3T<T>>(marker));
    const Vector3T<T> in_reference = cast<T>(inverse(mount_side)) * in_root;
    const Vector6T<T> v = Eigen::Map<const Vector6T<T>>(mount);
    return of_point<T>(inverse(small_motion<T>(v)) * in_reference, residual);
  }
};

struct CeresFit {
  Unknowns unknowns;
  int iterations = 0;
  bool converged = false;
  Eigen::MatrixXd covariance;  // for noise 1; where it was asked for
};

/// The covariance of markers, then mount, by ceres::Covariance.
Eigen::MatrixXd covariance_by_ceres(ceres::Problem& squares, const std::vector<const double*>& blocks) {
  ceres::Covariance covariance({});
  if (!covariance.Compute(blocks, &squares)) return {};
  int size = 0;
  for (const double* block : blocks) size += squares.ParameterBlockSize(block);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> all(size, size);
  covariance.GetCovarianceMatrix(blocks, all.data());
  return all;
}

/// From chain ends to the answer: the problem built and solved, one thread. Sightings by both cameras only.
CeresFit fit_by_ceres(const Problem& problem, const Unknowns& start, bool with_covariance = false) {
  CeresFit result{start};
  Vector6 mount = Vector6::Zero();
  ceres::Problem squares;
  for (const ProblemObservation& o : problem.observations) {
    const Rigid mount_side = o.root_from_mount * start.mount_from_sensor;
    const Rigid sensor_from_tcp = inverse(mount_side) * o.root_from_tcp;
    for (const Sighting& s : o.sightings) {
      double* marker = result.unknowns.markers_in_tcp[static_cast<std::size_t>(s.marker)].data();
      if (problem.mount_is_estimated) {
        auto* cost = new SightingCost{*problem.rig, s, o.root_from_tcp, mount_side};
        squares.AddResidualBlock(new ceres::AutoDiffCostFunction<SightingCost, 4, 3, 6>(cost), nullptr, marker,
                                 mount.data());
      } else {
        auto* cost = new SightingCost{*problem.rig, s, sensor_from_tcp, {}};
        squares.AddResidualBlock(new ceres::AutoDiffCostFunction<SightingCost, 4, 3>(cost), nullptr, marker);
      }
    }
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;  // DENSE_QR takes 10 % longer
  options.num_threads = 1;
  options.max_num_iterations = 100;
  options.function_tolerance = options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-12;  // where our own fit stops, too
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &squares, &summary);
  result.unknowns.mount_from_sensor = start.mount_from_sensor * small_motion<double>(mount);
  result.iterations = static_cast<int>(summary.iterations.size()) - 1;
  result.converged = summary.termination_type == ceres::CONVERGENCE;
  if (!with_covariance) return result;
  std::vector<const double*> blocks;
  for (const Vector3& marker : result.unknowns.markers_in_tcp) blocks.push_back(marker.data());
  if (problem.mount_is_estimated) blocks.push_back(mount.data());
  result.covariance = covariance_by_ceres(squares, blocks);
  return result;
}

/// Simulated once a size, outside all times.
const Session& session(int observations, bool estimate_mount = false) {
  static std::map<std::pair<int, bool>, Session> sessions;
  auto [at, is_new] = sessions.try_emplace({observations, estimate_mount});
  if (is_new) {
    SimulationOptions options;
    options.observations = observations;
    at->second = simulate_session(fixture::stand_session(), options).session;
    at->second.mount.estimate = estimate_mount;
  }
  return at->second;
}

double difference(const Unknowns& a, const Unknowns& b) {
  double largest = small_motion_between(a.mount_from_sensor, b.mount_from_sensor).cwiseAbs().maxCoeff();
  for (std::size_t m = 0; m < a.markers_in_tcp.size(); ++m)
    largest = std::max(largest, (a.markers_in_tcp[m] - b.markers_in_tcp[m]).cwiseAbs().maxCoeff());
  return largest;
}

void refuse_unless_equal(benchmark::State& state, const Unknowns& ours, const Unknowns& other, bool converged) {
  const double largest = difference(ours, other);
  state.counters["difference"] = largest;
  if (!converged || !(largest <= agreement))
    state.SkipWithError(
        fmt::format("the two answers differ by {:.3g} (limit {:.0e}), converged: {}", largest, agreement, converged)
            .c_str());
}

/// The whole of `fit`, from the session in memory: chains, start, minimum, noise, covariances.
void fit_session(benchmark::State& state, bool estimate_mount) {
  const Session& s = session(static_cast<int>(state.range(0)), estimate_mount);
  int iterations = 0;
  for (auto _ : state) {
    const Fit f = fit(s);
    benchmark::DoNotOptimize(&f);
    iterations = f.solution.iterations;
    if (!f.converged()) state.SkipWithError("the fit did not converge");
  }
  state.counters["iterations"] = iterations;
}

struct Prepared {
  Problem problem;
  Unknowns start;
};

Prepared prepare(const Session& s) {
  Prepared p{make_problem(s, make_chain(s)), {}};
  p.start = *start_values(p.problem, s.mount);
  return p;
}

/// Our minimum alone, from the same chain ends and start as Ceres.
void solve_prepared(benchmark::State& state, bool estimate_mount) {
  const Prepared p = prepare(session(static_cast<int>(state.range(0)), estimate_mount));
  Solution solution;
  for (auto _ : state) benchmark::DoNotOptimize(solution = solve(p.problem, p.start));
  state.counters["iterations"] = solution.iterations;
}

/// Ceres is given the chain ends and the start, which `fit_session` works out in its time.
void ceres_prepared(benchmark::State& state, bool estimate_mount) {
  const Session& s = session(static_cast<int>(state.range(0)), estimate_mount);
  const Prepared p = prepare(s);
  CeresFit result;
  for (auto _ : state) benchmark::DoNotOptimize(result = fit_by_ceres(p.problem, p.start));
  state.counters["iterations"] = result.iterations;
  refuse_unless_equal(state, estimate(fit(s)), result.unknowns, result.converged);
}

/// Ceres with our derivatives, as full fits of effects use it; the placing of the observations is part of it.
void trust_region_prepared(benchmark::State& state, bool estimate_mount) {
  const Session& s = session(static_cast<int>(state.range(0)), estimate_mount);
  const Prepared p = prepare(s);
  Solution solution;
  for (auto _ : state) benchmark::DoNotOptimize(solution = solve_by_trust_region(p.problem, p.start));
  state.counters["iterations"] = solution.iterations;
  refuse_unless_equal(state, estimate(fit(s)), solution.unknowns, solution.converged);
}

/// A whole fit with effects, from nothing: an offset and a spring at every joint of the six-axis arm.
void fit_with_effects(benchmark::State& state, bool estimate_mount) {
  const Session& s = session(static_cast<int>(state.range(0)), estimate_mount);
  FitOptions options;
  const Chain chain = make_chain(s);
  for (const char* id : {"joint_offset", "joint_elasticity"})
    for (const EffectTerm& term : effect_terms(id, chain)) options.estimated.push_back(term);
  int iterations = 0;
  for (auto _ : state) {
    const Fit f = fit(s, options);
    benchmark::DoNotOptimize(&f);
    iterations = f.solution.iterations;
    if (!f.converged()) state.SkipWithError("the fit did not converge");
  }
  state.counters["iterations"] = iterations;
}

/// All of what `fit` does except its estimate of the noise: chain ends and start (by our own code), minimum,
/// covariance of markers and mount.
void ceres_session(benchmark::State& state, bool estimate_mount) {
  const Session& s = session(static_cast<int>(state.range(0)), estimate_mount);
  CeresFit result;
  for (auto _ : state) {
    const Prepared p = prepare(s);
    result = fit_by_ceres(p.problem, p.start, true);
    benchmark::DoNotOptimize(&result);
  }
  const Fit ours = fit(s);
  refuse_unless_equal(state, estimate(ours), result.unknowns, result.converged);
  const Eigen::MatrixXd markers = *ours.noise * *ours.noise * result.covariance.topLeftCorner(9, 9);
  const double off = (markers - ours.parameter_covariance.topLeftCorner(9, 9)).norm() / markers.norm();
  if (!(off < 1e-4)) state.SkipWithError(fmt::format("the covariances differ by {:.3g} of their size", off).c_str());
}

double seconds(const auto& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

constexpr int added = 20;  // observations timed together, so that the step's size hardly changes meanwhile

/// One IncrementalFit::add with `range` observations kept. Each turn works on a copy; the copy's first
/// addition, which grows its storage, is not timed.
void incremental_step(benchmark::State& state, bool estimate_mount) {
  const auto kept = static_cast<std::size_t>(state.range(0));
  const Prepared p = prepare(session(static_cast<int>(kept) + added, estimate_mount));
  IncrementalFit filled(p.problem, p.start);
  for (std::size_t k = 0; k + 1 < kept; ++k) filled.add(p.problem.observations[k]);
  for (auto _ : state) {
    IncrementalFit copy = filled;
    copy.add(p.problem.observations[kept - 1]);
    const double spent = seconds([&] {
      for (std::size_t k = kept; k < kept + added; ++k) copy.add(p.problem.observations[k]);
    });
    state.SetIterationTime(spent / added);
  }
}

/// One OnlineCalibration::add of a labelled observation with `range` observations kept.
void online_step(benchmark::State& state, bool estimate_mount) {
  const auto kept = static_cast<std::size_t>(state.range(0));
  const Session& s = session(static_cast<int>(kept) + added, estimate_mount);
  OnlineCalibration filled(s);
  for (std::size_t k = 0; k + 1 < kept; ++k) filled.add(s.observations[k], nullptr);
  std::size_t last = 0;
  for (auto _ : state) {
    OnlineCalibration copy = filled;
    copy.add(s.observations[kept - 1], nullptr);
    const double spent = seconds([&] {
      for (std::size_t k = kept; k < kept + added; ++k) last = copy.add(s.observations[k], nullptr).kept;
    });
    state.SetIterationTime(spent / added);
  }
  if (last != kept + added) state.SkipWithError(fmt::format("{} of {} were kept", last, kept + added).c_str());
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts kB
}

/// Before anything else has run, so that the peak is this fit's (with its session).
double print_peak_memory() {
  const double before = peak_memory_mb();
  const Session& s = session(10000);
  const double with_session = peak_memory_mb();
  const Fit f = fit(s);
  fmt::print("peak memory: {:.1f} MB after a fit of {} observations ({:.1f} MB before it, {:.1f} MB at start)\n",
             peak_memory_mb(), f.problem.observations.size(), with_session, before);
  return peak_memory_mb();
}

void add(std::string name, auto function, bool mount, const std::vector<std::int64_t>& sizes, bool is_step = false) {
  if (mount) name += "_mount_estimated";
  auto* added_one = benchmark::RegisterBenchmark(name.c_str(), function, mount);
  added_one->Unit(is_step ? benchmark::kMicrosecond : benchmark::kMillisecond);
  if (is_step) added_one->UseManualTime();
  for (const std::int64_t size : sizes) added_one->Arg(size);
}

void add_benchmarks() {
  for (const bool mount : {false, true}) {
    add("fit", fit_session, mount, {100, 1000, 10000});
    add("solve_only", solve_prepared, mount, {1000});
    add("fit_with_effects", fit_with_effects, mount, {100, 1000});
    add("ceres", ceres_prepared, mount, {1000});
    add("ceres_with_our_derivatives", trust_region_prepared, mount, {1000});
    add("ceres_session_to_covariance", ceres_session, mount, {1000});
    add("incremental_step", incremental_step, mount, {100, 1000}, true);
    add("online_step", online_step, mount, {100, 1000}, true);
  }
}

constexpr double ms = 1e3, us = 1e6;

/// "6.1 / 78 ms"; nothing where one was not measured.
std::string times_text(std::initializer_list<double> seconds, double unit) {
  std::string text;
  for (const double s : seconds) {
    if (!std::isfinite(s)) return "";
    text += fmt::format("{}{:.3g}", text.empty() ? "" : " / ", unit * s);
  }
  return text + (unit == ms ? " ms" : " us");
}

std::string figures(double value, const char* behind = "") {
  return std::isfinite(value) ? fmt::format("{:.2g}{}", value, behind) : "";
}

/// What was measured with one kind of mount.
struct MountRuns {
  const MeasuredRuns& runs;
  bool is_estimated;

  std::string name(const std::string& what, const std::string& size) const {
    return what + (is_estimated ? "_mount_estimated" : "") + size;
  }
  double seconds(const std::string& what, const std::string& size = "/1000") const {
    return runs.seconds(name(what, size));
  }
  double difference(const std::string& what) const { return runs.counter(name(what, "/1000"), "difference"); }
};

void print_table(const MeasuredRuns& runs, double peak_mb, const trials::TableOutput& output) {
  trials::Table table({{.heading = "what", .width = 80},
                       {.heading = "mount known", .width = 20},
                       {.heading = "mount estimated", .width = 20}},
                      output);
  const MountRuns known{runs, false}, estimated{runs, true};
  const auto row = [&](const char* what, auto of) { table.print({what, of(known), of(estimated)}); };
  row("`fit`, 100 observations", [](const MountRuns& m) { return times_text({m.seconds("fit", "/100")}, ms); });
  row("`fit`, 1000 (aim: <= 10 and 20 ms)", [](const MountRuns& m) { return times_text({m.seconds("fit")}, ms); });
  row("`fit`, 10,000 (aim: <= 11 times that)", [](const MountRuns& m) {
    const double seconds = m.seconds("fit", "/10000");
    const double times = seconds / m.seconds("fit");
    return times_text({seconds}, ms) + (std::isfinite(times) ? fmt::format(", {:.1f} times", times) : "");
  });
  row("the least squares alone, 1000: ours",
      [](const MountRuns& m) { return times_text({m.seconds("solve_only")}, ms); });
  row("the same by Ceres with our derivatives (`solve_by_trust_region`)",
      [](const MountRuns& m) { return times_text({m.seconds("ceres_with_our_derivatives")}, ms); });
  row("the same by Ceres, autodiff, normal Cholesky, one thread",
      [](const MountRuns& m) { return times_text({m.seconds("ceres")}, ms); });
  row("Ceres with autodiff over ours (aim: >= 3)",
      [](const MountRuns& m) { return figures(m.seconds("ceres") / m.seconds("solve_only")); });
  row("Ceres with autodiff over Ceres with our derivatives",
      [](const MountRuns& m) { return figures(m.seconds("ceres") / m.seconds("ceres_with_our_derivatives")); });
  row("largest difference of the answers (aim: <= 1e-9 m), autodiff / our derivatives", [](const MountRuns& m) {
    return figures(m.difference("ceres"), " / ") + figures(m.difference("ceres_with_our_derivatives"));
  });
  row("`fit` with an offset and a spring at every joint, by Ceres: 100 / 1000", [](const MountRuns& m) {
    return times_text({m.seconds("fit_with_effects", "/100"), m.seconds("fit_with_effects")}, ms);
  });
  row("forward kinematics, start, Ceres and its covariance",
      [](const MountRuns& m) { return times_text({m.seconds("ceres_session_to_covariance")}, ms); });
  const auto steps = [](const MountRuns& m, const char* what) {
    return times_text({m.seconds(what, "/100/manual_time"), m.seconds(what, "/1000/manual_time")}, us);
  };
  row("`IncrementalFit::add` with 100 / 1000 kept (aim: <= 1.2 times)",
      [&](const MountRuns& m) { return steps(m, "incremental_step"); });
  row("`OnlineCalibration::add`, labelled, 100 / 1000 kept",
      [&](const MountRuns& m) { return steps(m, "online_step"); });
  table.print({"peak memory after 10,000 (aim: < 300 MB)", fmt::format("{:.0f} MB", peak_mb)});
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  const handsight::trials::TableOutput output = handsight::trials::take_table_output(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  const double peak_mb = handsight::print_peak_memory();
  handsight::add_benchmarks();
  handsight::MeasuredRuns runs;
  benchmark::RunSpecifiedBenchmarks(&runs);
  handsight::print_table(runs, peak_mb, output);
}
