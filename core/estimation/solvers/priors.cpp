// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/priors.h"

#include <algorithm>
#include <cmath>

#include "chain/sighting.h"
#include "estimation/problem/robot_scale.h"
#include "estimation/solvers/part_prior.h"
#include "geometry/orthonormal_columns.h"

namespace handsight {

Prior camera_prior(const Problem& problem) {
  Prior prior;
  if (!learns_from_camera_images(problem)) return prior;
  const CameraKnowledge& known = *problem.camera_images;
  const Eigen::MatrixXd& by_effect = problem.cameras_by_effect;
  const Eigen::VectorXd change = change_of_rig(known.rig, *problem.rig);
  prior.information = by_effect.transpose() * known.information * by_effect;
  prior.gradient = -by_effect.transpose() * (known.information * change + known.pull);
  prior.cost = disagreement(known, *problem.rig);
  return prior;
}

namespace {

/// One piece's part of the prior; its markers have the numbers `first` to `first + count - 1`.
void add_piece(const KnownShape& shape, double weight, const std::vector<Vector3>& markers, Eigen::Index first,
               Eigen::Index count, Prior& prior) {
  if (count == 1) return;  // a single point has no shape
  Eigen::Matrix3Xd here(3, count), known(3, count);
  Eigen::MatrixXd motions(3 * count, 6);
  for (Eigen::Index m = 0; m < count; ++m) {
    const auto i = static_cast<std::size_t>(first + m);
    here.col(m) = markers[i];
    known.col(m) = shape.markers[i];
    motions.block<3, 3>(3 * m, 0) = Matrix3::Identity();
    motions.block<3, 3>(3 * m, 3) = -cross_matrix(markers[i]);
  }
  const Rigid laid = align_points(here, known, Eigen::VectorXd::Ones(count));
  Eigen::VectorXd off(3 * count);
  for (Eigen::Index m = 0; m < count; ++m) off.segment<3>(3 * m) = here.col(m) - laid * Vector3(known.col(m));
  // A body of three markers and more has six motions that no shape knows of.
  const Eigen::MatrixXd q = orthonormal_columns(motions);
  auto information = prior.information.block(3 * first, 3 * first, 3 * count, 3 * count);
  information.noalias() -= weight * q * q.transpose();
  information.diagonal().array() += weight;
  prior.gradient.segment(3 * first, 3 * count) = -weight * off;
  prior.cost += weight * off.squaredNorm();
}

/// m, of one coordinate of a piece; what is known exactly is taken as known to 1 um.
double print_sigma(const Problem& problem, int piece = 0) {
  constexpr double exactly = 1e-6;
  return std::max(problem.shape->piece_sigma(piece), exactly);
}

/// (noise / sigma)^2 of a piece of a known shape.
double shape_prior_weight(const Problem& problem, int piece) {
  return std::pow(problem.noise / print_sigma(problem, piece), 2);
}

PriorRows rows_of_parts(const Problem& problem, const std::vector<Vector3>& markers) {
  PartRows rows = part_rows(*problem.shape, markers, print_sigma(problem));
  return {problem.noise * rows.by_markers, problem.noise * rows.off};
}

Prior prior_of(const PriorRows& rows) {
  Prior prior;
  prior.information.noalias() = rows.by_markers.transpose() * rows.by_markers;
  prior.gradient.noalias() = -rows.by_markers.transpose() * rows.off;
  prior.cost = rows.off.squaredNorm();
  return prior;
}

}  // namespace

Prior shape_prior(const Problem& problem, const std::vector<Vector3>& markers) {
  Prior prior;
  if (!problem.has_shape_prior()) return prior;
  const KnownShape& shape = *problem.shape;
  if (!shape.parts.empty()) return prior_of(rows_of_parts(problem, markers));
  const auto count = static_cast<Eigen::Index>(markers.size());
  prior.information = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  prior.gradient = Eigen::VectorXd::Zero(3 * count);
  for (Eigen::Index first = 0, next = 0; first < count; first = next) {
    while (next < count && shape.piece(static_cast<std::size_t>(next)) == shape.piece(static_cast<std::size_t>(first)))
      ++next;
    const int piece = shape.piece(static_cast<std::size_t>(first));
    add_piece(shape, shape_prior_weight(problem, piece), markers, first, next - first, prior);
  }
  return prior;
}

PriorRows shape_prior_rows(const Problem& problem, const std::vector<Vector3>& markers) {
  if (problem.has_shape_prior() && !problem.shape->parts.empty()) return rows_of_parts(problem, markers);
  // The information is the weight times a projection, which is its own root.
  const Prior prior = shape_prior(problem, markers);
  Eigen::VectorXd roots(prior.gradient.size());
  for (std::size_t m = 0; m < markers.size(); ++m)
    roots.segment<3>(3 * static_cast<Eigen::Index>(m))
        .setConstant(1 / std::sqrt(shape_prior_weight(problem, problem.shape->piece(m))));
  return {roots.asDiagonal() * prior.information, -roots.cwiseProduct(prior.gradient)};
}

namespace {

void add(const Prior& prior, double weight, Eigen::Index at, NormalEquations& normal) {
  const Eigen::Index count = prior.gradient.size();
  normal.information.block(at, at, count, count) += weight * prior.information;
  normal.gradient.segment(at, count) += weight * prior.gradient;
  normal.prior_cost += weight * prior.cost;
}

}  // namespace

Prior robot_scale_prior(const Problem& problem) {
  Prior prior;
  if (!holds_robot_scale(problem)) return prior;
  const Eigen::VectorXd by_effect = problem.robot_scale->by_effect / robot_scale_sigma;
  const double off = problem.robot_scale->change / robot_scale_sigma;
  prior.information = by_effect * by_effect.transpose();
  prior.gradient = -off * by_effect;
  prior.cost = off * off;
  return prior;
}

DistanceRow distance_row(const MountDistance& d, const Vector3& of, const Vector3& from) {
  const Vector3 between = of - from;
  const double length = between.norm();
  const Vector3 along = length > 0 ? Vector3(between / length) : Vector3(Vector3::UnitX());
  return {(d.by - length) / d.sigma, -along / d.sigma, along / d.sigma};
}

namespace {

/// The known distances of mounts, by the mounts' columns.
void add_distances(const Problem& problem, const Unknowns& unknowns, NormalEquations& normal) {
  for (const MountDistance& d : problem.mount_distances) {
    const Rigid &of = unknowns.mount(d.of), &from = unknowns.mount(d.from);
    const DistanceRow row = distance_row(d, of.translation, from.translation);
    // M exp(v): the origin moves by the mount's rotation times v's translation.
    Eigen::VectorXd by = Eigen::VectorXd::Zero(problem.columns());
    if (const Eigen::Index c = problem.column_of_mount(d.of); c >= 0)
      by.segment<3>(c) += of.rotation.transpose() * row.by_of;
    if (const Eigen::Index c = problem.column_of_mount(d.from); c >= 0)
      by.segment<3>(c) += from.rotation.transpose() * row.by_from;
    const double weight = problem.noise * problem.noise;
    normal.information += weight * by * by.transpose();
    normal.gradient -= weight * row.off * by;
    normal.prior_cost += weight * row.off * row.off;
  }
}

/// What is known of where mounts are, by their columns.
void add_places(const Problem& problem, const Unknowns& unknowns, NormalEquations& normal) {
  const double weight = problem.noise * problem.noise;
  for (const MountPlace& place : problem.mount_places) {
    const PlaceRow row = place_row(place, unknowns.mount(place.mount));
    normal.prior_cost += weight * row.off * row.off;
    const Eigen::Index c = problem.column_of_mount(place.mount);
    if (c < 0) continue;
    normal.information.block<6, 6>(c, c) += weight * row.by_motion * row.by_motion.transpose();
    normal.gradient.segment<6>(c) -= weight * row.off * row.by_motion;
  }
}

}  // namespace

PlaceRow place_row(const MountPlace& place, const Rigid& mount) {
  const Vector3 here = inverse(mount) * place.point;
  PlaceRow row;
  row.off = -place.along.dot(here) / place.sigma;
  row.by_motion << place.along, here.cross(place.along);
  row.by_motion /= place.sigma;
  return row;
}

bool has_fixtures(const Problem& problem) {
  return problem.source && std::any_of(problem.source->chain.parts.begin(), problem.source->chain.parts.end(),
                                       [](const Chain& part) { return part.is_fixture; });
}

void add_priors(const Problem& problem, const Unknowns& unknowns, NormalEquations& normal) {
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i) {
    const double weight = problem.noise / problem.columns_of_effects[static_cast<std::size_t>(i)].prior_sigma();
    const Eigen::Index column = problem.effect_column() + i;
    normal.information(column, column) += weight * weight;
    normal.gradient[column] -= weight * weight * unknowns.effects[i];
    normal.prior_cost += std::pow(weight * unknowns.effects[i], 2);
  }
  add(camera_prior(problem), problem.noise * problem.noise, problem.effect_column(), normal);
  add(robot_scale_prior(problem), problem.noise * problem.noise, problem.effect_column(), normal);
  add(shape_prior(problem, unknowns.markers_in_tcp), 1, 0, normal);
  add_distances(problem, unknowns, normal);
  add_places(problem, unknowns, normal);
  normal.cost += normal.prior_cost;
}

}  // namespace handsight
