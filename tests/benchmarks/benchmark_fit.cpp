// SPDX-License-Identifier: Apache-2.0
// How long a fit takes: ours, the same least squares by Ceres, its growth, the online step; and the peak
// memory.
#include <benchmark/benchmark.h>
#include <ceres/ceres.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <map>

#include "estimation/fit/fit.h"
#include "estimation/online/online.h"
#include "estimation/solvers/trust_region.h"
#include "estimation/start/start.h"
#include "fixtures/arms.h"

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
void print_peak_memory() {
  const double before = peak_memory_mb();
  const Session& s = session(10000);
  const double with_session = peak_memory_mb();
  const Fit f = fit(s);
  fmt::print("peak memory: {:.1f} MB after a fit of {} observations ({:.1f} MB before it, {:.1f} MB at start)\n",
             peak_memory_mb(), f.problem.observations.size(), with_session, before);
}

void add(std::string name, auto function, bool mount, const std::vector<std::int64_t>& sizes, bool is_step = false) {
  if (mount) name += "_mount_estimated";
  auto* added_one = benchmark::RegisterBenchmark(name.c_str(), function, mount);
  added_one->Unit(is_step ? benchmark::microsecond : benchmark::millisecond);
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

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  handsight::print_peak_memory();
  handsight::add_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
}
