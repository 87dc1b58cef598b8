// SPDX-License-Identifier: Apache-2.0
// What is told of robots without a fault that are measured with the errors of real ones: the nominal robot of a real
// session, and what its best model leaves, dealt to other poses. Every cause that is named is wrong.
// trial_real_noise DRAWS SEED SESSION...
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <random>

#include "chain/sighting.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/selection/improvement.h"
#include "session/pose_points.h"
#include "session/session_xml.h"

namespace handsight::trials {
namespace {

Improvement quiet_improvement(const Session& session) {
  ImprovementOptions o;
  o.with_choosing = false;
  return improve(session, o);
}

/// measured - predicted of a sighting, in its own unit: px of each camera, or m.
SightingColumn error_of(const Fit& fit, const ProblemObservation& o, Sighting sighting) {
  sighting.usual_sigma = 0;
  const Unknowns answer = estimate(fit);
  const Vector3 predicted = sensor_from_tcp_at(o, answer) * marker_at(o, answer, sighting.marker);
  return sighting_residual(fit.problem.rig_or_null(), sighting, predicted).error;
}

/// The sighting as it would be without `error`, and with `other`.
void exchange_error(const SightingColumn& error, const SightingColumn& other, Sighting& sighting) {
  const SightingColumn change = other - error;
  if (sighting.point) *sighting.point += change;
  Eigen::Index row = 0;
  for (CameraPoint& point : sighting.in_cameras) {
    point.pixel += change.segment<2>(row);
    row += 2;
  }
}

bool see_alike(const Sighting& a, const Sighting& b) {
  return a.marker == b.marker && a.point.has_value() == b.point.has_value() &&
         std::equal(a.in_cameras.begin(), a.in_cameras.end(), b.in_cameras.begin(), b.in_cameras.end(),
                    [](const CameraPoint& x, const CameraPoint& y) { return x.camera == y.camera; });
}

/// Where a fit predicts the target's pose in an observation.
Rigid predicted_pose(const Fit& fit, const ProblemObservation& o) {
  return sensor_from_tcp_at(o, estimate(fit)) * fit.tcp_from_body;
}

/// Poses have the errors of others in the target's axes.
void deal_poses(const Fit& nominal, const Fit& model, const Session& session, const std::vector<std::size_t>& from,
                Session& dealt) {
  const std::vector<ProblemObservation>& used = nominal.problem.observations;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const ProblemObservation& giver = model.problem.observations[from[i]];
    const Rigid& given = *session.observations[static_cast<std::size_t>(giver.index)].target_pose;
    const Rigid error = inverse(predicted_pose(model, giver)) * given;
    dealt.observations[static_cast<std::size_t>(used[i].index)].target_pose = predicted_pose(nominal, used[i]) * error;
  }
  show_poses(dealt, pose_lever(*session.pose_sensor));
}

/// What a nominal robot would have shown, with the errors that the model leaves of other poses.
Session dealt_anew(const Session& session, const Fit& nominal, const Fit& model, std::mt19937_64& random) {
  const std::vector<ProblemObservation>& used = nominal.problem.observations;
  std::vector<std::size_t> from(used.size());
  std::iota(from.begin(), from.end(), std::size_t{0});
  std::shuffle(from.begin(), from.end(), random);
  Session dealt = session;
  for (Observation& o : dealt.observations)
    if (std::none_of(used.begin(), used.end(), [&](const ProblemObservation& u) {
          return &dealt.observations[static_cast<std::size_t>(u.index)] == &o;
        }))
      o.decision = Decision::excluded;
  if (session.pose_sensor) {
    deal_poses(nominal, model, session, from, dealt);
    return dealt;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    const ProblemObservation& giver = model.problem.observations[from[i]];
    // What the giver did not see has no error to be dealt.
    std::erase_if(dealt.observations[static_cast<std::size_t>(used[i].index)].sightings, [&](Sighting& sighting) {
      const auto other = std::find_if(giver.sightings.begin(), giver.sightings.end(),
                                      [&](const Sighting& s) { return see_alike(sighting, s); });
      if (other == giver.sightings.end()) return true;
      exchange_error(error_of(nominal, used[i], sighting), error_of(model, giver, *other), sighting);
      return false;
    });
  }
  return dealt;
}

int real_noise(int draws, std::uint64_t seed, const std::vector<std::string>& folders) {
  int sessions = 0, named = 0, sure = 0, adequate = 0;
  for (const std::string& folder : folders) {
    const Session session = read_session(folder);
    const Improvement best = quiet_improvement(session);
    const CleanFit nominal{best.last.model.session, fit(best.last.model.session, {}), {}};
    std::mt19937_64 random(seed);
    for (int draw = 0; draw < draws; ++draw) {
      const Improvement m = quiet_improvement(dealt_anew(nominal.session, nominal.fit, best.last.model.fit, random));
      std::vector<std::string> names;
      double most = 0;
      for (const InclusionProbability& n : m.inclusion_probabilities.names)
        if (n.is_in_model) {
          names.push_back(fmt::format("{} {:.3f}", n.id, n.probability));
          if (!n.id.starts_with("curve_")) most = std::max(most, n.probability);
        }
      ++sessions;
      named += !names.empty();
      sure += most > 0.95;
      adequate += m.last.verdict == Verdict::adequate;
      fmt::print("{} draw {}: {} {}\n", folder, draw, verdict_text(m.last.verdict), fmt::join(names, ", "));
      std::fflush(stdout);
    }
  }
  fmt::print("{} sessions: something added in {}, a name of the catalogue above 95 % in {}, adequate {}\n", sessions,
             named, sure, adequate);
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "trial_real_noise DRAWS SEED SESSION...\n");
    return 2;
  }
  return handsight::trials::real_noise(std::atoi(argv[1]), std::strtoull(argv[2], nullptr, 10),
                                       {argv + 3, argv + argc});
}
