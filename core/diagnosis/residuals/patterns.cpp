// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/residuals/patterns.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace handsight {
namespace {

constexpr int most_neighbours = 12;

void add_axes(const Message& frame, const std::vector<Matrix6>& frame_from_sensor, const LinearModel& model,
              std::vector<ResidualAxis>& list) {
  const char* axes[] = {"x", "y", "z"};
  const std::size_t first = list.size();
  for (int k = 0; k < 6; ++k)
    list.push_back({k < 3 ? message("shift along {} of the {}", axes[k], frame)
                          : message("turn about {} of the {}", axes[k - 3], frame),
                    k < 3 ? "m" : "rad",
                    -1,
                    {}});
  for (std::size_t i = 0; i < model.observations.size(); ++i) {
    // The shortest motion that explains the external residual; with six rows the only one.
    const Eigen::MatrixXd inverse = model.observations[i].by_body.completeOrthogonalDecomposition().pseudoInverse();
    const Eigen::MatrixXd in_frame = frame_from_sensor[i] * inverse;
    for (int k = 0; k < 6; ++k) list[first + static_cast<std::size_t>(k)].weights.push_back(in_frame.row(k));
  }
}

/// Turns a motion about the sensor's origin into one about the TCP's, in axes turned by `rotation`.
Matrix6 about_tcp(const LinearObservation& o, const Matrix3& axes_from_sensor) {
  return adjoint(Rigid{axes_from_sensor, -(axes_from_sensor * o.sensor_from_tcp.translation)});
}

void add_joints(const Problem& problem, const LinearModel& model, std::vector<ResidualAxis>& list) {
  constexpr double least_information = 1e-6;
  const Chain& chain = problem.source->chain;
  for (std::size_t j = 0; j < chain.joints.size(); ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[j])];
    ResidualAxis axis{
        message("error of {}", joint.name), joint.kind == JointKind::prismatic ? "m" : "rad", chain.joints[j], {}};
    bool moves = false;
    for (const LinearObservation& o : model.observations) {
      const Eigen::VectorXd column = o.by_joints.col(static_cast<Eigen::Index>(j));
      const double information = column.squaredNorm();
      moves = moves || information > least_information;
      axis.weights.push_back(information > least_information
                                 ? Eigen::RowVectorXd(column.transpose() / information)
                                 : Eigen::RowVectorXd(Eigen::RowVectorXd::Zero(column.size())));
    }
    if (moves) list.push_back(std::move(axis));
  }
}

struct Structure {
  double strength = 0;
  double p = 1;
};

/// Neighbours along the variable should be alike if it matters. S = sum of w y_i y_j over neighbours; flipping the sign
/// of whole observations leaves its mean 0 and its variance sum w^2 y_i^2 y_j^2.
Structure structure(const Eigen::VectorXd& y, const std::vector<Eigen::Index>& order) {
  const auto n = static_cast<int>(order.size());
  const int reach = std::clamp(n / 12, 1, most_neighbours);
  double sum = 0, variance = 0, squares = 0, left = 0;
  for (int i = 0; i < n; ++i) {
    const double here = y[order[static_cast<std::size_t>(i)]];
    double mean = 0, weight = 0;
    for (int d = -reach; d <= reach; ++d) {
      if (d == 0 || i + d < 0 || i + d >= n) continue;
      const double there = y[order[static_cast<std::size_t>(i + d)]];
      mean += there;
      weight += 1;
      if (d < 0) continue;
      sum += here * there;
      variance += here * here * there * there;
    }
    mean /= std::max(weight, 1.0);
    squares += here * here;
    left += (here - mean) * (here - mean) * weight / (weight + 1);  // a mean of `weight` others has noise of its own
  }
  if (!(variance > 0)) return {};
  const double z = sum / std::sqrt(variance);
  return {std::clamp(1 - left / squares, 0.0, 1.0), 0.5 * std::erfc(z / std::sqrt(2.0))};
}

/// For a sign: do the two sides differ?
Structure two_sides(const Eigen::VectorXd& y, const Eigen::VectorXd& sign) {
  const double sum = y.dot(sign), variance = y.cwiseAbs2().dot(sign.cwiseAbs2());
  if (!(variance > 0)) return {};
  const double z = std::abs(sum) / std::sqrt(variance);
  const double slope = sum / std::max(sign.squaredNorm(), 1.0);
  const double left = (y - slope * sign).squaredNorm();
  return {std::clamp(1 - left / y.squaredNorm(), 0.0, 1.0), std::erfc(z / std::sqrt(2.0))};
}

}  // namespace

std::vector<ResidualAxis> residual_axes(const Problem& problem, const LinearModel& model) {
  std::vector<ResidualAxis> list;
  std::vector<Matrix6> tcp, root, image;
  for (std::size_t i = 0; i < model.observations.size(); ++i) {
    const LinearObservation& o = model.observations[i];
    tcp.push_back(about_tcp(o, o.sensor_from_tcp.rotation.transpose()));
    root.push_back(
        about_tcp(o, problem.observations[i].root_from_tcp.rotation * o.sensor_from_tcp.rotation.transpose()));
    image.push_back(about_tcp(o, Matrix3::Identity()));
  }
  add_axes("TCP", tcp, model, list);
  add_axes("base", root, model, list);
  add_axes(problem.rig ? "camera" : "tracker", image, model, list);
  add_joints(problem, model, list);
  return list;
}

Eigen::VectorXd seen_along(const ResidualAxis& axis, const LinearModel& model, const Eigen::VectorXd& error) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(axis.weights.size()));
  for (std::size_t i = 0; i < axis.weights.size(); ++i) {
    const LinearObservation& o = model.observations[i];
    values[static_cast<Eigen::Index>(i)] = axis.weights[i].dot(error.segment(o.first, o.count));
  }
  return values;
}

std::vector<ResidualSeries> residual_series(const Problem& problem, const LinearModel& model) {
  std::vector<ResidualSeries> list;
  for (const ResidualAxis& axis : residual_axes(problem, model)) {
    ResidualSeries series{axis.name, axis.unit, axis.joint, seen_along(axis, model, model.external_error), {}};
    series.sigmas.resize(series.values.size());
    for (std::size_t i = 0; i < axis.weights.size(); ++i)
      series.sigmas[static_cast<Eigen::Index>(i)] = axis.weights[i].norm();
    list.push_back(std::move(series));
  }
  return list;
}

std::vector<Pattern> find_patterns(const std::vector<ResidualSeries>& series, const std::vector<Variable>& variables) {
  std::vector<Pattern> patterns;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    const Eigen::VectorXd& x = variables[v].values;
    std::vector<Eigen::Index> order(static_cast<std::size_t>(x.size()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return x[a] < x[b]; });
    for (std::size_t s = 0; s < series.size(); ++s) {
      // In units of the noise every observation counts alike, however far it is from the camera.
      const Eigen::VectorXd y =
          (series[s].sigmas.array() > 0).select(series[s].values.array() / series[s].sigmas.array().max(1e-300), 0.0);
      const Structure found = variables[v].kind == VariableKind::approach ? two_sides(y, x) : structure(y, order);
      patterns.push_back({s, v, found.strength, found.p});
    }
  }
  const auto looked_at = static_cast<double>(patterns.size());
  for (Pattern& p : patterns) p.p_value = std::min(1.0, p.p_value * looked_at);
  // Those that are no chance by how much they explain, the others by how likely chance is.
  constexpr double no_chance = 1e-3;
  std::stable_sort(patterns.begin(), patterns.end(), [](const Pattern& a, const Pattern& b) {
    const bool first = a.p_value < no_chance, second = b.p_value < no_chance;
    if (first != second) return first;
    return first ? a.strength > b.strength : a.p_value < b.p_value;
  });
  return patterns;
}

}  // namespace handsight
