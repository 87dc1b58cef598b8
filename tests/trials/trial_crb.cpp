// SPDX-License-Identifier: Apache-2.0
// Is the fit efficient, and are its covariances true? Many fits of one geometry with fresh noise: errors
// against the Cramer-Rao bound, and how often the 95 % intervals hold the truth.
// trial_crb [FITS] [OBSERVATIONS] [--markdown]
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "estimation/fit/fit.h"
#include "fixtures/arms.h"
#include "simulation/random.h"
#include "trials/table.h"

namespace handsight {
namespace {

constexpr double noise = 0.2;           // px
constexpr double normal_95 = 1.959964;  // two-sided
constexpr double most_excess = 0.03;    // of the rms over the bound
constexpr double least_coverage = 0.94, most_coverage = 0.96;
constexpr std::uint64_t noise_seed = 20240501;
constexpr const char* names[] = {"x", "y", "z", "rx", "ry", "rz"};

struct Geometry {
  Session exact;  // every measurement without noise
  Problem problem;
  Unknowns truth;
  BodySides sides;
  Rigid tcp_from_body;
};

Geometry make_geometry(int observations) {
  SimulationOptions options;
  options.observations = observations;
  options.noise = 0;
  const SimulatedSession s = simulate_session(fixture::stand_session(), options);
  Geometry g{
      s.session, make_problem(s.session, make_chain(s.session)), {s.markers_in_tcp, s.mount_from_sensor}, {}, {}};
  g.sides = choose_sides({s.markers_in_tcp.begin(), s.markers_in_tcp.end()});
  g.tcp_from_body = body_frame(g.sides, s.markers_in_tcp).tcp_from_body;
  return g;
}

Eigen::VectorXd predicted_pixels(const Geometry& g, const std::vector<Vector3>& markers) {
  std::vector<double> pixels;
  for (const ProblemObservation& o : g.problem.observations) {
    const Rigid sensor_from_tcp = inverse(o.root_from_mount * g.truth.mount_from_sensor) * o.root_from_tcp;
    for (const Sighting& s : o.sightings) {
      const Vector3 x = sensor_from_tcp * markers[static_cast<std::size_t>(s.marker)];
      for (const RigCamera& c : g.problem.rig->cameras) {
        const Vector2 pixel = project(c.camera, c.camera_from_first * x);
        pixels.insert(pixels.end(), {pixel.x(), pixel.y()});
      }
    }
  }
  return Eigen::Map<Eigen::VectorXd>(pixels.data(), static_cast<Eigen::Index>(pixels.size()));
}

/// The bound on the covariance of xi at the truth. By central differences of the measurements and of the body
/// frame: no derivative of the program's own, and nothing of its normal equations, is trusted here.
Matrix6 cramer_rao_bound(const Geometry& g) {
  const auto columns = static_cast<Eigen::Index>(3 * g.truth.markers_in_tcp.size());
  const double h = 1e-5;  // m
  Eigen::MatrixXd pixels(predicted_pixels(g, g.truth.markers_in_tcp).size(), columns);
  Eigen::MatrixXd motion(6, columns);
  for (Eigen::Index c = 0; c < columns; ++c) {
    std::vector<Vector3> up = g.truth.markers_in_tcp, down = up;
    up[static_cast<std::size_t>(c / 3)][c % 3] += h;
    down[static_cast<std::size_t>(c / 3)][c % 3] -= h;
    pixels.col(c) = (predicted_pixels(g, up) - predicted_pixels(g, down)) / (2 * h);
    motion.col(c) = (small_motion_between(g.tcp_from_body, body_frame(g.sides, up).tcp_from_body) -
                     small_motion_between(g.tcp_from_body, body_frame(g.sides, down).tcp_from_body)) /
                    (2 * h);
  }
  const Eigen::MatrixXd information = pixels.transpose() * pixels / (noise * noise);
  return motion * information.inverse() * motion.transpose();
}

Session with_noise(const Session& exact, Random& random) {
  Session session = exact;
  for (Observation& o : session.observations)
    for (Sighting& s : o.sightings)
      for (CameraPoint& seen : s.in_cameras)
        for (double& coordinate : seen.pixel) coordinate += noise * random.gaussian();
  return session;
}

struct Sums {
  Vector6 error = Vector6::Zero(), squares = Vector6::Zero(), covered = Vector6::Zero();
  int repeatability = 0, not_converged = 0;
};

struct Outcome {
  bool met = true;
  Vector6 ratio = Vector6::Zero(), within = Vector6::Zero();  // rms over the bound; share inside 95 %
};

Outcome run(const Geometry& g, int count, bool declared) {
  const auto began = std::chrono::steady_clock::now();
  Sums sums;
  Random random(noise_seed);
  FitOptions options;
  options.sides = g.sides;
  for (int i = 0; i < count; ++i) {
    Session session = with_noise(g.exact, random);
    session.sigma_pixel = declared ? std::optional(noise) : std::nullopt;
    const Fit f = fit(session, options);
    const Vector6 xi = small_motion_between(g.tcp_from_body, f.tcp_from_body);
    sums.error += xi;
    sums.squares += xi.cwiseAbs2();
    sums.covered.array() += (xi.array().abs() <= normal_95 * f.covariance.diagonal().array().sqrt()).cast<double>();
    sums.repeatability += f.covariance_kind == CovarianceKind::repeatability ? 1 : 0;
    sums.not_converged += f.converged() ? 0 : 1;
  }
  const Vector6 bound = cramer_rao_bound(g).diagonal().cwiseSqrt();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  fmt::print("\n{} fits of {} observations, free markers, noise {:.1f} px {} ({:.1f} s)\n", count,
             g.exact.observations.size(), noise, declared ? "declared" : "not declared (estimated)", seconds);
  fmt::print("covariance by scatter in {} fits, not converged {}\n", sums.repeatability, sums.not_converged);
  Outcome outcome{sums.not_converged == 0, (sums.squares / count).cwiseSqrt().cwiseQuotient(bound),
                  sums.covered / count};
  for (int i = 0; i < 6; ++i) {
    const bool met = std::abs(outcome.ratio[i] - 1) <= most_excess && outcome.within[i] >= least_coverage &&
                     outcome.within[i] <= most_coverage;
    outcome.met = outcome.met && met;
    fmt::print("{:>4}  bound {:9.3f} {:<4}  mean/bound {:10.4f}   {}\n", names[i], 1e6 * bound[i],
               i < 3 ? "um" : "urad", sums.error[i] / count / bound[i], met ? "ok" : "NOT MET");
  }
  return outcome;
}

void print(trials::Table& table, const std::string& what, const Vector6& values, double factor, int digits) {
  std::vector<trials::TableCell> row{what};
  for (const double value : values) row.emplace_back(fmt::format("{:.{}f}", factor * value, digits));
  table.print(row);
}

void print_outcomes(const Outcome& declared, const Outcome& estimated, const trials::TableOutput& output) {
  std::vector<trials::TableColumn> columns{{.heading = "TCP->Body", .width = 64}};
  for (const char* name : names) columns.push_back({name});
  trials::Table table(columns, output);
  print(table, "rms error / Cramer-Rao bound (aim: within 3 %)", declared.ratio, 1, 3);
  print(table, "95 % intervals that hold the truth, noise declared (94 to 96 %)", declared.within, 100, 1);
  print(table, "the same, noise estimated", estimated.within, 100, 1);
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  const handsight::trials::TableOutput output = handsight::trials::take_table_output(argc, argv);
  const int count = argc > 1 ? std::atoi(argv[1]) : 10000;
  const handsight::Geometry g = handsight::make_geometry(argc > 2 ? std::atoi(argv[2]) : 20);
  const handsight::Outcome declared = handsight::run(g, count, true), estimated = handsight::run(g, count, false);
  handsight::print_outcomes(declared, estimated, output);
  const bool met = declared.met && estimated.met;
  fmt::print("\nrms within 3 % of the bound, 94 to 96 % in the intervals: {}\n", met ? "ok" : "NOT MET");
  return met ? 0 : 1;
}
