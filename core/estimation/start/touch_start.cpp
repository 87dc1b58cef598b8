// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/touch_start.h"

#include "base/error.h"
#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/least_squares.h"
#include "session/fixtures/fixture_kind.h"

namespace handsight {
namespace {

int fixture_of(const Session& session, const ProblemObservation& o) {
  return session.observations[static_cast<std::size_t>(o.index)].part;
}

Rigid mount_from_tcp(const ProblemObservation& o) { return inverse(o.root_from_mount) * o.root_from_tcp; }

/// R t + p = c of every touch of a point: 3 numbers a tip, 3 a fixture.
std::vector<Vector3> tips_by_points(const Session& session, const Problem& problem) {
  const Eigen::Index tips = 3 * problem.marker_count;
  const auto count = tips + 3 * static_cast<Eigen::Index>(session.fixtures.size());
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(count);
  for (const ProblemObservation& o : problem.observations) {
    const int f = fixture_of(session, o);
    if (!measures_place(*session.fixtures[static_cast<std::size_t>(f)].kind)) continue;
    const Rigid by = mount_from_tcp(o);
    Eigen::MatrixXd row = Eigen::MatrixXd::Zero(3, count);
    row.middleCols<3>(3 * o.sightings.front().marker) = by.rotation;
    row.middleCols<3>(tips + 3 * f) = -Matrix3::Identity();
    h += row.transpose() * row;
    g -= row.transpose() * by.translation;
  }
  const Eigen::VectorXd x = pseudo_inverse(h) * g;
  std::vector<Vector3> all;
  for (int m = 0; m < problem.marker_count; ++m) all.push_back(x.segment<3>(3 * m));
  return all;
}

Rigid found_frame(const Session& session, std::size_t fixture, const std::vector<Vector3>& places) {
  const Fixture& f = session.fixtures[fixture];
  if (places.size() < f.kind->least_tips)
    throw InputError(
        message("{}: nothing says where the fixture {} is, and {} touch{} of it do not tell; touch it "
                "more often, or say where it is about.",
                session.file.filename().string(), f.id, places.size(), places.size() == 1 ? "" : "es"));
  return f.kind->frame_through(places);
}

}  // namespace

Unknowns touch_start(const Session& session, const Problem& problem) {
  Unknowns start;
  start.markers_in_tcp = tips_by_points(session, problem);
  start.effects = effect_values(problem);
  start.other_mounts.resize(session.other_mounts.size());
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Mount& mount = f == 0 ? session.mount : session.other_mounts[f - 1];
    Rigid& frame = start.mount(static_cast<int>(f));
    frame = mount.mount_from_sensor;
    if (mount.known) continue;
    std::vector<Vector3> places;
    for (const ProblemObservation& o : problem.observations)
      if (fixture_of(session, o) == static_cast<int>(f))
        places.push_back(mount_from_tcp(o) * marker_at(o, start, o.sightings.front().marker));
    frame = found_frame(session, f, places);
  }
  return start;
}

}  // namespace handsight
