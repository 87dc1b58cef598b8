// SPDX-License-Identifier: Apache-2.0
// Robots with joints that err from pose to pose: TCP->Body (of a camera on the hand: its mount) by the fit, by one that
// takes every pixel alike, and by one that was given all sizes; and how many of the six numbers lie inside 95 %.
// trial_erring_robot [COUNT] [FIRST_SEED]
// [--markdown]
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "estimation/body_error.h"
#include "estimation/fit/fit.h"
#include "fixtures/erring_robot.h"
#include "trials/table.h"

namespace {
using namespace handsight;
using fixture::ErringRig;

struct Errors {
  double squares = 0;
  int inside = 0, numbers = 0, fits = 0;

  double rms_mm() const { return 1e3 * std::sqrt(squares / fits); }
};

void add(const SimulatedSession& s, const Fit& f, bool of_mount, Errors& errors) {
  if (!f.converged()) return;
  const Vector6 off = of_mount
                          ? small_motion_between(inverse(estimate(f).mount_from_sensor), inverse(s.mount_from_sensor))
                          : body_error(s, f);
  const Eigen::Index mount = f.problem.mount_column();
  const Matrix6 covariance = of_mount ? Matrix6(f.parameter_covariance.block<6, 6>(mount, mount)) : f.covariance;
  errors.squares += off.head<3>().squaredNorm();
  ++errors.fits;
  for (int i = 0; i < 6; ++i) errors.inside += std::abs(off[i]) < 1.96 * std::sqrt(covariance(i, i));
  errors.numbers += 6;
}

/// The answer of a robot whose sizes are known.
Fit reported(const Fit& f, const fixture::ErringRobotOptions& o) {
  Fit best = f;
  best.problem = with_motions(best.problem);
  best.problem.flange_error = {o.place, o.joints};
  best.problem.noise = o.noise;
  best.solution = solve(best.problem, estimate(f), {.fixed_body = f.fixed_markers});
  const BodyFrame frame = body_frame(best.sides, estimate(best).markers_in_tcp);
  best.tcp_from_body = frame.tcp_from_body;
  return best;
}

void trial(const char* name, ErringRig rig, int count, std::uint64_t first, fixture::ErringRobotOptions o,
           trials::Table& table) {
  Errors ours, plain, bound;
  const bool of_mount = rig == ErringRig::camera_on_hand;
  int seen = 0;
  for (int i = 0; i < count; ++i) {
    o.seed = first + static_cast<std::uint64_t>(i);
    const SimulatedSession s = fixture::erring_robot(rig, o);
    const Fit f = fit(s.session), alike = fit(s.session, {.smallest_step = 1e-11});
    seen += f.problem.flange_error.is_any();
    add(s, f, of_mount, ours);
    add(s, alike, of_mount, plain);
    add(s, reported(alike, o), of_mount, bound);
  }
  table.print({name, o.poses, 1e3 * o.joints, 1e3 * o.place, ours.rms_mm(), plain.rms_mm(), bound.rms_mm(),
               100.0 * ours.inside / ours.numbers, 100.0 * plain.inside / plain.numbers, seen});
  if (ours.fits < count) fmt::print("  converged {} of {}\n", ours.fits, count);
}

}  // namespace

int main(int argc, char** argv) {
  const trials::TableOutput output = trials::take_table_output(argc, argv);
  const int count = argc > 1 ? std::atoi(argv[1]) : 40;
  const auto first = static_cast<std::uint64_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  trials::Table table({{.heading = "rig", .width = 14},
                       {"poses"},
                       {"joints, mrad", 2},
                       {"flange, mm", 2},
                       {"ours", 3},
                       {"all pixels alike", 3},
                       {"given all sizes", 3},
                       {"inside", 1, "%"},
                       {"inside, all pixels alike", 1, "%"},
                       {"seen"}},
                      output);
  for (const auto& [name, rig] : {std::pair{"markers", ErringRig::markers},
                                  {"board", ErringRig::board},
                                  {"camera on hand", ErringRig::camera_on_hand}})
    for (const double mm : {0.0, 0.1, 0.3, 1.0, 3.0})
      for (const int poses : {6, 8, 15, 40})
        for (const bool of_joints : {true, false}) {
          if (mm == 0 && !of_joints) continue;
          // A joint acts over half a metre, about.
          trial(name, rig, count, first,
                {.poses = poses, .joints = of_joints ? 2e-3 * mm : 0, .place = of_joints ? 0 : 1e-3 * mm, .turn = 0},
                table);
        }
}
