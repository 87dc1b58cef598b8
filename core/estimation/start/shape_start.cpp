// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/shape_start.h"

#include "estimation/problem/target_pose.h"
#include "estimation/start/start_by_points.h"
#include "estimation/start/start_markers.h"

namespace handsight {

std::vector<Vector3> few_points(const KnownShape& shape, int piece) {
  constexpr double reach = 0.1;  // m
  Vector3 middle = Vector3::Zero();
  int count = 0;
  for (std::size_t m = 0; m < shape.markers.size(); ++m)
    if (shape.piece(m) == piece) middle += shape.markers[m], ++count;
  middle /= std::max(count, 1);
  std::vector<Vector3> points{middle};
  for (int axis = 0; axis < 3; ++axis) points.push_back(middle + reach * Vector3::Unit(axis));
  return points;
}

namespace {

constexpr int few = few_of_a_piece;
constexpr double sure = 2;  // TargetPose::lead

/// The observations with the few points of every piece whose pose they show, as measured points.
Problem shown_by_few(const Problem& problem, const std::vector<std::vector<Vector3>>& points, bool only_sure) {
  Problem shown = problem;
  shown.rig.reset();
  shown.shape.reset();
  shown.marker_count = few * static_cast<int>(points.size());
  shown.marker_is_seen.assign(static_cast<std::size_t>(shown.marker_count), 0);
  hold_effects(shown);
  for (ProblemObservation& o : shown.observations) {
    const auto pieces = by_piece(*problem.shape, o.sightings);
    o.sightings.clear();
    o.weights.clear();
    o.marker_shifts.clear();
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
      const auto pose = target_pose(problem.rig_or_null(), pieces[piece], problem.shape->markers);
      if (!pose || (only_sure && pose->lead < sure)) continue;
      for (int i = 0; i < few; ++i) {
        Sighting& s = o.sightings.emplace_back();
        s.marker = few * static_cast<int>(piece) + i;
        s.point = pose->pose.sensor_from_body * points[piece][static_cast<std::size_t>(i)];
        shown.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
      }
    }
  }
  std::erase_if(shown.observations, [](const ProblemObservation& o) { return o.sightings.empty(); });
  return shown;
}

/// All markers from where the few points of their pieces have come to lie.
std::vector<Vector3> all_markers(const KnownShape& shape, const std::vector<std::vector<Vector3>>& points,
                                 const std::vector<Vector3>& few_in_tcp) {
  std::vector<Rigid> tcp_from_piece;
  for (std::size_t piece = 0; piece < points.size(); ++piece) {
    Eigen::Matrix3Xd in_tcp(3, few), in_piece(3, few);
    for (int i = 0; i < few; ++i) {
      in_tcp.col(i) = few_in_tcp[few * piece + static_cast<std::size_t>(i)];
      in_piece.col(i) = points[piece][static_cast<std::size_t>(i)];
    }
    tcp_from_piece.push_back(align_points(in_tcp, in_piece, Eigen::VectorXd::Ones(few)));
  }
  std::vector<Vector3> markers;
  for (std::size_t m = 0; m < shape.markers.size(); ++m)
    markers.push_back(tcp_from_piece[static_cast<std::size_t>(shape.piece(m))] * shape.markers[m]);
  return markers;
}

}  // namespace

std::vector<std::vector<Sighting>> by_piece(const KnownShape& shape, const std::vector<Sighting>& sightings) {
  std::vector<std::vector<Sighting>> pieces(static_cast<std::size_t>(shape.piece_count()));
  for (const Sighting& s : sightings)
    pieces[static_cast<std::size_t>(shape.piece(static_cast<std::size_t>(s.marker)))].push_back(s);
  return pieces;
}

std::optional<Unknowns> start_by_shape(const Problem& problem, const Mount& mount) {
  constexpr std::size_t enough = 5;
  if (!problem.shape || !problem.rig) return std::nullopt;
  std::vector<std::vector<Vector3>> points;
  for (int piece = 0; piece < problem.shape->piece_count(); ++piece)
    points.push_back(few_points(*problem.shape, piece));
  const Problem thin = thinned(problem, 60);
  Problem shown = shown_by_few(thin, points, true);
  if (shown.observations.size() < enough) shown = shown_by_few(thin, points, false);
  if (shown.observations.empty()) return std::nullopt;
  const auto start = start_by_points(shown, mount);
  if (!start) return std::nullopt;
  return Unknowns{all_markers(*problem.shape, points, start->markers_in_tcp), start->mount_from_sensor, {}};
}

Unknowns laid_onto(const KnownShape& shape, const Unknowns& unknowns) {
  const auto count = static_cast<Eigen::Index>(shape.markers.size());
  Eigen::Matrix3Xd here(3, count), known(3, count);
  for (Eigen::Index m = 0; m < count; ++m) {
    here.col(m) = unknowns.markers_in_tcp[static_cast<std::size_t>(m)];
    known.col(m) = shape.markers[static_cast<std::size_t>(m)];
  }
  const Rigid tcp_from_shape = align_points(here, known, Eigen::VectorXd::Ones(count));
  Unknowns laid = unknowns;
  for (Eigen::Index m = 0; m < count; ++m)
    laid.markers_in_tcp[static_cast<std::size_t>(m)] = tcp_from_shape * Vector3(known.col(m));
  return laid;
}

}  // namespace handsight
