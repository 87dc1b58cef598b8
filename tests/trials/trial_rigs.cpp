// SPDX-License-Identifier: Apache-2.0
// One camera, two, three, five: is TCP->Body unbiased, and do its sigmas hold? And is what was hidden named?
// trial_rigs fit COUNT [FIRST_SEED] | trial_rigs diagnose COUNT [FIRST_SEED]; [--markdown]
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "chain/body_frame.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "fixtures/rigs.h"
#include "simulation/random.h"
#include "trials/table.h"

namespace handsight {
namespace {

constexpr double normal_95 = 1.959963985;
constexpr double noise = 0.2;  // px

struct Kind {
  int cameras;
  bool mount_is_known, shape_is_known;
  std::string name() const {
    return fmt::format("{}, mount {}{}", cameras, mount_is_known ? "known" : "estimated",
                       shape_is_known ? ", shape known" : "");
  }
};

struct Sums {
  int count = 0, repeatability = 0, not_converged = 0, failed = 0;
  Vector6 z = Vector6::Zero(), z2 = Vector6::Zero(), covered = Vector6::Zero(), squares = Vector6::Zero();
};

void add(const Kind& kind, std::uint64_t seed, Sums& sums) {
  SimulationOptions o;
  o.observations = 40;
  o.seed = seed;
  o.noise = noise;
  o.declare_noise = false;
  SimulatedSession s = simulate_session(fixture::rig_session(kind.cameras), o);
  s.session.mount.estimate = !kind.mount_is_known;
  FitOptions options;
  if (kind.shape_is_known) s.session.shape = KnownShape{s.markers_in_tcp, 1e-6};  // m: as good as held
  if (!kind.mount_is_known) {
    Random random(seed * 31 + 5);
    Vector6 off;
    for (double& x : off) x = 0.03 * random.gaussian();
    s.session.mount.mount_from_sensor = s.session.mount.mount_from_sensor * small_motion<double>(off);
  }
  try {
    const Fit f = fit(s.session, options);
    const Rigid truth = body_frame(f.sides, s.markers_in_tcp).tcp_from_body;
    const Vector6 xi = small_motion_between(truth, f.tcp_from_body);
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

void tell(const Kind& kind, const Sums& s, trials::Table& table) {
  fmt::print("{}: {} fits, {} by scatter, {} not converged, {} refused\n", kind.name(), s.count, s.repeatability,
             s.not_converged, s.failed);
  const char* names[] = {"x", "y", "z", "rx", "ry", "rz"};
  for (int i = 0; i < 6; ++i)
    fmt::print("  {:<3} rms {:9.2f} {:<4}  mean/sigma {:6.3f} +- {:.3f}  rms/sigma {:6.3f}  within 95 %: {:5.1f} %\n",
               names[i], 1e6 * std::sqrt(s.squares[i] / s.count), i < 3 ? "um" : "urad", s.z[i] / s.count,
               1 / std::sqrt(static_cast<double>(s.count)), std::sqrt(s.z2[i] / s.count), 100 * s.covered[i] / s.count);
  const Vector6 rms = (s.squares / s.count).cwiseSqrt();
  table.print({kind.name(),
               fmt::format("{} um, {} mrad", from_to(1e6 * rms.head<3>(), 0), from_to(1e3 * rms.tail<3>(), 1)),
               (s.z / s.count).cwiseAbs().maxCoeff(), from_to((s.z2 / s.count).cwiseSqrt(), 2),
               from_to(100 * s.covered / s.count, 1), fmt::format("{} / {}", s.repeatability, s.not_converged)});
}

void fits(int count, std::uint64_t first, const trials::TableOutput& output) {
  trials::Table table({{.heading = "cameras", .width = 32},
                       {.heading = "rms error of TCP->Body", .width = 36},
                       {fmt::format("largest mean / sigma (+- {:.3f})", 1 / std::sqrt(static_cast<double>(count))), 2},
                       {.heading = "rms / sigma", .width = 12},
                       {.heading = "within 95 %", .width = 12},
                       {"covariance by scatter / not converged"}},
                      output);
  for (const int cameras : {1, 2, 3, 5})
    for (const bool mount_is_known : {true, false})
      for (const bool shape_is_known : {false, true}) {
        const Kind kind{cameras, mount_is_known, shape_is_known};
        Sums sums;
        for (int i = 0; i < count; ++i) add(kind, first + static_cast<std::uint64_t>(i), sums);
        tell(kind, sums, table);
      }
}

struct Tally {
  int trials = 0, first = 0, named = 0, place = 0;
};

/// Noncentrality: squares in units of the noise that the effect leaves in a model without it.
double noncentrality(const Session& like, SimulationOptions o) {
  o.noise = 1e-7;
  const Fit f = fit(simulate_session(like, o).session, {});
  return f.solution.normal.data_cost() / (noise * noise);
}

void diagnose_all(int count, std::uint64_t first, const trials::TableOutput& output) {
  trials::Table table({{"cameras"},
                       {"trials"},
                       {.heading = "first", .width = 16},
                       {"at the right place"},
                       {"first, or reported as not distinguishable from it"}},
                      output);
  for (const int cameras : {1, 3, 5}) {
    Tally all;
    const Session like = fixture::rig_session(cameras);
    const Chain chain = make_chain(like);
    const OwnEffects own = list_own_effects(like, chain);
    for (const char* id :
         {"joint_elasticity", "encoder_eccentricity", "link_geometry", "camera_intrinsics", "lens_distortion", "rig"}) {
      const Effect& effect = *find_effect(id, own);
      const std::vector<int> places = effect_places(effect, chain);
      Tally t;
      for (int i = 0; i < count && !places.empty(); ++i) {
        Random random(first + static_cast<std::uint64_t>(7919 * i));
        SimulationOptions o;
        o.seed = first + static_cast<std::uint64_t>(i);
        o.observations = 80;
        o.noise = noise;
        o.declare_noise = false;
        EffectTerm term = effect_terms(id, chain, own).front();
        term.place = places[static_cast<std::size_t>(random.uniform(0, static_cast<double>(places.size()) - 1e-9))];
        for (std::size_t p = 0; p < term.values.size(); ++p)
          term.values[p] = prior_sigma(effect.parameters[p], chain) * random.gaussian();
        o.effects = {term};
        if (noncentrality(like, o) < 50) continue;
        DiagnosisOptions quick;
        quick.with_held_out = false;
        const Diagnosis d = diagnose(simulate_session(like, o).session, quick);
        if (d.candidates.empty()) continue;
        const DiagnosisCandidate& best = d.candidates.front();
        const bool is_first = best.id == id;
        ++t.trials;
        t.first += is_first;
        t.named +=
            is_first || std::count(best.indistinguishable_from.begin(), best.indistinguishable_from.end(), id) > 0;
        const std::string where = place_name(effect, term.place, like.robot);
        t.place += is_first && std::count(best.where.begin(), best.where.end(), where) > 0;
        if (!is_first) fmt::print("  seed {} {} at {}: {} first\n", o.seed, id, where, best.id);
      }
      if (t.trials > 0)
        fmt::print("  {} cameras {:<22} {:>4} trials, first {:>4}, named {:>4}, place {:>4}\n", cameras, id, t.trials,
                   t.first, t.named, t.place);
      std::fflush(stdout);
      all.trials += t.trials, all.first += t.first, all.named += t.named, all.place += t.place;
    }
    const double share = 100.0 * all.first / std::max(1, all.trials);
    table.print({cameras, all.trials, fmt::format("{} ({:.1f} %)", all.first, share), all.place, all.named});
  }
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
