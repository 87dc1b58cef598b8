// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/curves/place_formulas.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "diagnosis/curves/formula_numbers.h"
#include "effects/formula.h"

namespace handsight {
namespace {

constexpr std::array names{"tcp_x", "tcp_y", "tcp_z"};

/// "(tcp_x - 0.9986*tcp_z + 0.412)" of constant + factors . tcp; four digits, which the formula is then exact with.
std::string sum_text(double constant, const Vector3& factors) {
  std::string text;
  const auto add = [&](double amount, const std::string& term) {
    text += text.empty() ? (amount < 0 ? "-" : "") : (amount < 0 ? " - " : " + ");
    text += term;
  };
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (std::abs(factors[i]) < 5e-5 * factors.norm()) continue;
    const std::string size = short_number(std::abs(factors[i])), name = names[static_cast<std::size_t>(i)];
    add(factors[i], size == "1" ? name : fmt::format("{}*{}", size, name));
  }
  if (const std::string size = short_number(std::abs(constant)); size != "0") add(constant, size);
  return "(" + text + ")";
}

/// One coordinate of the TCP in the sensor's frame.
std::string coordinate_text(const Rigid& sensor_from_mount, int axis, double factor = 1) {
  return sum_text(factor * sensor_from_mount.translation[axis],
                  factor * Vector3(sensor_from_mount.rotation.row(axis).transpose()));
}

PlaceFormula evaluated(std::string text, const Eigen::Matrix3Xd& at) {
  const Formula formula(text, {names.begin(), names.end()}, "a curve of the place");
  PlaceFormula place{std::move(text), Eigen::VectorXd(at.cols())};
  for (Eigen::Index i = 0; i < at.cols(); ++i) place.values[i] = formula.value({at.col(i).data(), 3});
  return place;
}

}  // namespace

Eigen::Matrix3Xd tcp_places(const Problem& problem) {
  const ProblemSource& source = *problem.source;
  Eigen::Matrix3Xd all(3, static_cast<Eigen::Index>(problem.observations.size()));
  for (Eigen::Index i = 0; i < all.cols(); ++i) {
    const auto index = static_cast<std::size_t>(problem.observations[static_cast<std::size_t>(i)].index);
    const ObservationState& c = source.states[index];
    all.col(i) = c.tcp ? *c.tcp : nominal_tcp(source.chain, c.sensor);
  }
  return all;
}

PlaceFormula distance_formula(const Problem& problem, const Eigen::Matrix3Xd& places, const Rigid& mount_from_sensor) {
  if (problem.rig) return evaluated(coordinate_text(inverse(mount_from_sensor), 2), places);
  std::string text;
  for (Eigen::Index i = 0; i < 3; ++i)
    text += fmt::format("{}{}^2", i ? " + " : "sqrt(", sum_text(-mount_from_sensor.translation[i], Vector3::Unit(i)));
  return evaluated(text + ")", places);
}

PlaceFormula image_formula(const Problem& problem, const Eigen::Matrix3Xd& places, const Rigid& mount_from_sensor,
                           int axis) {
  const Rigid sensor_from_mount = inverse(mount_from_sensor);
  const Camera& camera = problem.rig->at(0).camera;
  double nearest = 1e300;
  for (Eigen::Index i = 0; i < places.cols(); ++i)
    nearest = std::min(nearest, (sensor_from_mount * Vector3(places.col(i))).z());
  const double focal = axis == 0 ? camera.fx : camera.fy, centre = axis == 0 ? camera.cx : camera.cy;
  const std::string seen = coordinate_text(sensor_from_mount, axis, focal),
                    depth = coordinate_text(sensor_from_mount, 2);
  return evaluated(fmt::format("({}/max({}, {}) + {})", seen, short_number(std::max(nearest / 2, 1e-3)), depth,
                               short_number(centre)),
                   places);
}

std::string centred_text(const std::string& place, double middle, double reach) {
  return fmt::format("(({} {} {})/{})", place, middle < 0 ? '+' : '-', short_number(std::abs(middle)),
                     short_number(reach));
}

std::string centred_part(const std::string& formula) {
  for (std::size_t begin = formula.find("(("); begin != std::string::npos; begin = formula.find("((", begin + 1)) {
    int open = 0;
    std::size_t end = begin;
    do {
      open += formula[end] == '(' ? 1 : formula[end] == ')' ? -1 : 0;
    } while (++end < formula.size() && open > 0);
    std::string part = formula.substr(begin, end - begin);
    if (open == 0 && part.find("tcp_") != std::string::npos) return part;
  }
  return "";
}

std::optional<PlaceFormula> followed_place(const Problem& problem, const EffectDefinition& curve) {
  const std::string part = curve.moves.empty() ? "" : centred_part(curve.moves.front().formula);
  if (part.empty()) return std::nullopt;
  const std::size_t reach = part.rfind(")/");
  const std::size_t plus = part.rfind(" + ", reach), minus = part.rfind(" - ", reach);
  const std::size_t end = plus == std::string::npos ? minus : minus == std::string::npos ? plus : std::max(plus, minus);
  if (end == std::string::npos || end < 3) return std::nullopt;
  return evaluated(part.substr(2, end - 2), tcp_places(problem));
}

}  // namespace handsight
