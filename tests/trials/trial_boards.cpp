// SPDX-License-Identifier: Apache-2.0
// Sessions whose targets name their own points, and poses in place of images: is TCP->Body unbiased, do its sigmas
// hold, and is what was hidden named? trial_boards fit COUNT [FIRST_SEED] | trial_boards diagnose COUNT [FIRST_SEED];
// [--markdown]
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "fixtures/targets.h"
#include "session/pose_points.h"
#include "simulation/random.h"
#include "trials/table.h"

namespace handsight {
namespace {

constexpr double normal_95 = 1.959963985;

struct Kind {
  std::string name;
  Session like;
  bool mount_is_known = true, noise_is_given = false;
};

Session with_print(Session s, std::optional<double> sigma) {
  s.target->sigma = sigma;
  set_target(s, Target(*s.target));
  return s;
}

Session pose_session() {
  Session s = fixture::tracker_session(3);
  s.pose_sensor = PoseSensor{5e-4, 1e-3};
  show_poses(s, pose_lever(*s.pose_sensor));
  return s;
}

std::vector<Kind> kinds() {
  const Session board = fixture::target_session();
  return {{"ChArUco, one camera on a stand", board},
          {"ChArUco, one camera on a stand, mount unknown", board, false},
          {"ChArUco, two cameras, mount unknown", fixture::target_session(fixture::charuco(), 2), false},
          {"ChArUco on the table, camera on the hand, mount unknown", fixture::eye_in_hand_session(), false},
          {"ChArUco printed to 0.2 mm, one camera", with_print(board, 2e-4)},
          {"ChArUco of free points, one camera", with_print(board, std::nullopt)},
          {"AprilGrid, one camera, mount unknown", fixture::target_session(fixture::aprilgrid()), false},
          {"three tags, one camera, mount unknown", fixture::target_session(fixture::tags()), false},
          {"poses, sigmas given, mount unknown", pose_session(), false, true},
          {"poses, sigmas not given, mount unknown", pose_session(), false, false}};
}

struct Sums {
  int count = 0, repeatability = 0, not_converged = 0, failed = 0;
  Vector6 z = Vector6::Zero(), z2 = Vector6::Zero(), covered = Vector6::Zero(), squares = Vector6::Zero();
};

Rigid load_truth(const SimulatedSession& s, const Fit& f) {
  if (!s.session.pose_sensor) return fixture::true_target_body(s, f.sides);
  // The points of poses stand for the target's frame, whatever their lever.
  const std::vector<Vector3> shape = pose_shape(pose_lever(pose_session().pose_sensor.value()));
  return align_points(Eigen::Map<const Eigen::Matrix3Xd>(s.markers_in_tcp[0].data(), 3, pose_markers),
                      Eigen::Map<const Eigen::Matrix3Xd>(shape[0].data(), 3, pose_markers),
                      Eigen::VectorXd::Ones(pose_markers)) *
         body_frame(f.sides, shape).tcp_from_body;
}

void add(const Kind& kind, std::uint64_t seed, Sums& sums) {
  SimulationOptions o;
  o.observations = 40;
  o.seed = seed;
  o.declare_noise = kind.noise_is_given;
  SimulatedSession s = simulate_session(kind.like, o);
  if (!kind.mount_is_known) s.session = fixture::with_unknown_mount(s.session);
  try {
    const Fit f = fit(s.session);
    const Vector6 xi = small_motion_between(load_truth(s, f), f.tcp_from_body);
    const Vector6 z = xi.cwiseQuotient(f.covariance.diagonal().cwiseSqrt());
    ++sums.count;
    sums.repeatability += f.covariance_kind == CovarianceKind::repeatability;
    sums.not_converged += !f.converged();
    sums.z += z;
    sums.z2 += z.cwiseAbs2();
    sums.squares += xi.cwiseAbs2();
    sums.covered.array() += (z.array().abs() <= normal_95).cast<double>();
  } catch (const InputError& error) {
    ++sums.failed;
    fmt::print("seed {}: {}\n", seed, error.what());
  }
}

/// From the least of the six parameters to the most.
std::string from_to(const Eigen::Ref<const Eigen::VectorXd>& values, int digits) {
  return fmt::format("{:.{}f} to {:.{}f}", values.minCoeff(), digits, values.maxCoeff(), digits);
}

void print(trials::Table& table, const std::string& name, const Sums& s) {
  const Vector6 rms = (s.squares / s.count).cwiseSqrt();
  table.print(
      {name, fmt::format("{} um, {} mrad", from_to(1e6 * rms.head<3>(), 0), from_to(1e3 * rms.tail<3>(), 2)),
       (s.z / s.count).cwiseAbs().maxCoeff(), from_to((s.z2 / s.count).cwiseSqrt(), 2),
       fmt::format("{}, all {:.1f}", from_to(100 * s.covered / s.count, 1), 100 * s.covered.sum() / (6 * s.count))});
}

void fits(int count, std::uint64_t first, const trials::TableOutput& output) {
  trials::Table table({{.heading = "target", .width = 56},
                       {.heading = "rms error of TCP->Body", .width = 36},
                       {fmt::format("largest mean / sigma (+- {:.3f})", 1 / std::sqrt(static_cast<double>(count))), 2},
                       {.heading = "rms / sigma", .width = 12},
                       {.heading = "within 95 %", .width = 24}},
                      output);
  for (const Kind& kind : kinds()) {
    Sums s;
    for (int i = 0; i < count; ++i) add(kind, first + static_cast<std::uint64_t>(i), s);
    fmt::print("{}: {} fits, {} by scatter, {} not converged, {} refused\n", kind.name, s.count, s.repeatability,
               s.not_converged, s.failed);
    const char* names[] = {"x", "y", "z", "rx", "ry", "rz"};
    for (int i = 0; i < 6; ++i)
      fmt::print("  {:<3} rms {:9.2f} {:<4}  mean/sigma {:6.3f} +- {:.3f}  rms/sigma {:6.3f}  within 95 %: {:5.1f} %\n",
                 names[i], 1e6 * std::sqrt(s.squares[i] / s.count), i < 3 ? "um" : "urad", s.z[i] / s.count,
                 1 / std::sqrt(static_cast<double>(s.count)), std::sqrt(s.z2[i] / s.count),
                 100 * s.covered[i] / s.count);
    print(table, kind.name, s);
    std::fflush(stdout);
  }
}

/// Noncentrality: squares in units of the noise that the effect leaves in a model without it, fitted as a diagnosis
/// fits (see trials::noncentrality_of).
double noncentrality(const Session& like, SimulationOptions o, double noise) {
  o.noise = 1e-6 * noise;
  o.declare_noise = false;
  return fit(simulate_session(like, o).session, {.smallest_step = 1e-9}).solution.normal.data_cost() / (noise * noise);
}

void diagnose_kind(const std::string& name, const Session& like, double noise, int count, std::uint64_t first,
                   trials::Table& table) {
  const Chain chain = make_chain(like);
  const OwnEffects own = list_own_effects(like, chain);
  int trials = 0, named_first = 0, named = 0, place = 0;
  for (const char* id : {"joint_elasticity", "encoder_eccentricity", "link_geometry", "joint_offset", "backlash"}) {
    const Effect& effect = *find_effect(id, own);
    const std::vector<int> places = effect_places(effect, chain);
    for (int i = 0; i < count && !places.empty(); ++i) {
      Random random(first + static_cast<std::uint64_t>(7919 * i));
      SimulationOptions o;
      o.seed = first + static_cast<std::uint64_t>(i);
      o.observations = 80;
      o.noise = noise;
      EffectTerm term = effect_terms(id, chain, own).front();
      term.place = places[static_cast<std::size_t>(random.uniform(0, static_cast<double>(places.size()) - 1e-9))];
      for (std::size_t p = 0; p < term.values.size(); ++p)
        term.values[p] = prior_sigma(effect.parameters[p], chain) * random.gaussian();
      o.effects = {term};
      if (noncentrality(like, o, noise) < 50) continue;
      DiagnosisOptions quick;
      quick.with_held_out = false;
      const Diagnosis d = diagnose(simulate_session(like, o).session, quick);
      if (d.candidates.empty()) continue;
      const DiagnosisCandidate& best = d.candidates.front();
      const bool is_first = best.id == id;
      ++trials;
      named_first += is_first;
      named += is_first || std::count(best.indistinguishable_from.begin(), best.indistinguishable_from.end(), id) > 0;
      const std::string where = place_name(effect, term.place, like.robot);
      place += is_first && std::count(best.where.begin(), best.where.end(), where) > 0;
      if (!is_first) fmt::print("  seed {} {} at {}: {} first\n", o.seed, id, where, best.id);
    }
  }
  table.print({name, trials, named_first, place, named});
}

void diagnose_all(int count, std::uint64_t first, const trials::TableOutput& output) {
  trials::Table table({{.heading = "target", .width = 40},
                       {"trials"},
                       {"first"},
                       {"at the right place"},
                       {"first, or reported as not distinguishable from it"}},
                      output);
  diagnose_kind("ChArUco, one camera on a stand", fixture::target_session(), 0.2, count, first, table);
  diagnose_kind("ChArUco on the table, camera on the hand", fixture::eye_in_hand_session(), 0.2, count, first, table);
  diagnose_kind("three tags, one camera", fixture::target_session(fixture::tags()), 0.2, count, first, table);
  diagnose_kind("poses", pose_session(), 5e-4, count, first, table);
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  const handsight::trials::TableOutput output = handsight::trials::take_table_output(argc, argv);
  const std::string what = argc > 1 ? argv[1] : "fit";
  const int count = argc > 2 ? std::atoi(argv[2]) : 20;
  const auto first = static_cast<std::uint64_t>(argc > 3 ? std::atoll(argv[3]) : 1);
  if (what == "diagnose")
    handsight::diagnose_all(count, first, output);
  else
    handsight::fits(count, first, output);
}
