// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <set>
#include <unordered_set>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "robot/xml_rigid.h"
#include "session/calibration_xml.h"

namespace handsight {

namespace {

constexpr double agreement = 1e-6;  // what numbers that people shorten still agree to, m and rad

template <int rows, int columns>
Eigen::Matrix<double, rows, columns> read_matrix(const XmlNode& node) {
  const std::vector<double> numbers = inner_numbers(node, rows * columns, "row by row");
  return Eigen::Matrix<double, rows, columns, Eigen::RowMajor>(numbers.data());
}

Rigid read_rigid_matrix(const XmlNode& node) {
  const Matrix4 matrix = read_matrix<4, 4>(node);
  const Matrix3 rotation = matrix.topLeftCorner<3, 3>();
  const bool is_bounded = rotation.cwiseAbs().maxCoeff() < 2;  // products of larger ones might have no double
  if (!is_bounded || !(rotation * rotation.transpose()).isIdentity(agreement) || rotation.determinant() < 0 ||
      matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    refuse(node, "is no rigid motion, expected a rotation, a translation and the last row 0 0 0 1.");
  return {rotation, matrix.topRightCorner<3, 1>()};
}

/// Refuses what cannot be a covariance. Looked at as correlations, so that neither metres and radians nor huge and tiny
/// numbers matter: `least_variances` are what counts as rounding of directions that a session does not show.
void check_covariance(const XmlNode& node, const Eigen::MatrixXd& covariance, const Eigen::VectorXd& least_variances) {
  const Eigen::VectorXd inverse_sigma = covariance.diagonal().cwiseMax(least_variances).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd correlation = inverse_sigma.asDiagonal() * covariance * inverse_sigma.asDiagonal();
  if (correlation.diagonal().minCoeff() < -agreement)
    refuse(node, "has a negative variance on its diagonal, expected a covariance.");
  const bool is_bounded = correlation.cwiseAbs().maxCoeff() < 1 + agreement;
  if (!is_bounded || (correlation - correlation.transpose()).cwiseAbs().maxCoeff() > agreement)
    refuse(node, "is not symmetric or has correlations beyond 1, expected a covariance.");
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(correlation, Eigen::EigenvaluesOnly);
  if (eigen.eigenvalues().minCoeff() < -agreement)
    refuse(node, "has a negative variance in some direction, expected a covariance.");
}

double negligible_variance(const Eigen::VectorXd& variances) {
  return std::max(1e-9 * variances.cwiseAbs().maxCoeff(), 1e-300);
}

void check_order(const XmlNode& node, const char* expected) {
  const std::string order = find_text(node, "order").value_or(expected);
  if (split_words(order) != split_words(expected))
    refuse(node, message("has order={}, expected order=\"{}\".", in_quotes(order), expected));
}

Matrix6 read_covariance(const XmlNode& node) {
  check_order(node, "x y z rx ry rz");
  Matrix6 covariance = read_matrix<6, 6>(node);
  check_covariance(node, covariance, Vector6::Constant(negligible_variance(covariance.diagonal())));
  return covariance;
}

std::size_t number_count(const std::vector<CalibrationEffect>& effects) {
  std::size_t numbers = 0;
  for (const CalibrationEffect& e : effects) numbers += e.parameters.size();
  return numbers;
}

/// Effects have units of their own: a number's least variance is its own.
Eigen::MatrixXd read_model_covariance(const XmlNode& node, const char* order, std::size_t effect_numbers,
                                      const char* row_by_row) {
  check_order(node, order);
  const std::size_t size = 6 + effect_numbers;
  const std::vector<double> numbers = inner_numbers(node, size * size, row_by_row);
  const auto rows = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd covariance = Eigen::Map<const Eigen::MatrixXd>(numbers.data(), rows, rows).transpose();
  Eigen::VectorXd least = Eigen::VectorXd::Constant(rows, 1e-300);
  least.head<6>().setConstant(negligible_variance(covariance.diagonal().head<6>()));
  check_covariance(node, covariance, least);
  return covariance;
}

EstimatedMotion read_motion(const XmlNode& node, Ignored& ignored) {
  note_unknown(ignored, node, {"xyz", "rpy"}, {"matrix", "covariance"});
  const bool has_angles = node.element->Attribute("xyz") || node.element->Attribute("rpy");
  const auto matrix = find_child(node, "matrix");
  if (!matrix && !has_angles) refuse(node, "has neither <matrix> nor xyz and rpy, expected one of them.");
  EstimatedMotion estimated;
  estimated.motion = read_rigid(node, bounds::any);
  if (matrix) {
    note_unknown(ignored, *matrix, {}, {}, true);
    const Rigid exact = read_rigid_matrix(*matrix);
    const bool agree = (exact.rotation - estimated.motion.rotation).cwiseAbs().maxCoeff() < agreement &&
                       (exact.translation - estimated.motion.translation).cwiseAbs().maxCoeff() < agreement;
    if (has_angles && !agree)
      refuse(node, "has an xyz and rpy that are another motion than its <matrix>, expected them to agree to 1e-6.");
    estimated.motion = exact;
  }
  const XmlNode covariance = required_child(node, "covariance");
  note_unknown(ignored, covariance, {"order"}, {}, true);
  estimated.covariance = read_covariance(covariance);
  return estimated;
}

std::optional<double> find_unsigned(const XmlNode& node, const char* attribute) {
  const std::optional<double> number = find_number(node, attribute);
  if (number && *number < 0) refuse(node, message("has {}=\"{}\", expected at least 0.", verbatim(attribute), *number));
  return number;
}

CalibrationFit read_fit(const XmlNode& node, Ignored& ignored) {
  note_unknown(ignored, node,
               {"observations", "used", "rejected", "rms_pixel", "held_out_rms_pixel", "noise_pixel", "rms_m",
                "held_out_rms_m", "noise_m", "chi2_per_dof"},
               {});
  const auto count = [&](const char* attribute) {
    return static_cast<int>(find_integer(node, attribute, 0, INT32_MAX).value_or(0));
  };
  return {count("observations"),
          count("used"),
          count("rejected"),
          find_unsigned(node, "rms_pixel"),
          find_unsigned(node, "held_out_rms_pixel"),
          find_unsigned(node, "noise_pixel"),
          find_unsigned(node, "rms_m"),
          find_unsigned(node, "held_out_rms_m"),
          find_unsigned(node, "noise_m"),
          find_unsigned(node, "chi2_per_dof")};
}

void read_markers(const XmlNode& parent, Calibration& calibration, Ignored& ignored) {
  note_unknown(ignored, parent, {}, {"marker"});
  constexpr std::size_t most = 4096;  // points of a board
  std::vector<std::optional<Vector3>> found(most);
  std::size_t count = 0;
  for (const XmlNode& node : children(parent, "marker")) {
    note_unknown(ignored, node, {"index", "xyz"}, {});
    const auto index = static_cast<std::size_t>(required_integer(node, "index", 0, most - 1));
    if (found[index]) refuse(node, message("has index=\"{}\" a second time, expected each marker once.", index));
    found[index] = Vector3(required_numbers(node, "xyz", 3).data());
    count = std::max(count, index + 1);
  }
  if (count == 0) refuse(parent, "holds no marker, expected at least one.");
  for (std::size_t i = 0; i < count; ++i) {
    calibration.markers.push_back(found[i].value_or(Vector3::Zero()));
    if (!found[i]) calibration.unseen_markers.push_back(static_cast<int>(i));
  }
}

CalibrationEffect read_effect(const XmlNode& node, Ignored& ignored) {
  note_unknown(ignored, node, {"id", "number"}, {"parameter"});
  CalibrationEffect effect{required_name(node, "id"), {}};
  std::unordered_set<std::string> names;
  for (const XmlNode& child : children(node, "parameter")) {
    note_unknown(ignored, child, {"of", "name", "value", "sigma", "unit"}, {});
    CalibrationParameter parameter{find_text(child, "of").value_or(""), required_name(child, "name"),
                                   required_number(child, "value"), find_unsigned(child, "sigma"),
                                   find_text(child, "unit").value_or("")};
    if (!names.insert(parameter.of + '\n' + parameter.name).second)
      refuse(child, message("is a second {} of {}, expected each parameter once.", in_quotes(parameter.name),
                            in_quotes(parameter.of)));
    effect.parameters.push_back(std::move(parameter));
  }
  return effect;
}

std::vector<CalibrationEffect> read_effects(const XmlNode& parent, Ignored& ignored) {
  std::vector<CalibrationEffect> effects;
  std::set<std::pair<std::string, std::int64_t>> seen;
  for (const XmlNode& node : children(parent, "effect")) {
    effects.push_back(read_effect(node, ignored));
    if (!seen.emplace(effects.back().id, find_integer(node, "number", 1, 100000).value_or(1)).second)
      refuse(node, message("has id={} a second time, expected each effect once, or with another number.",
                           in_quotes(effects.back().id)));
  }
  return effects;
}

CalibrationUncertainty read_model_uncertainty(const XmlNode& node, std::size_t effect_numbers, Ignored& ignored) {
  note_unknown(ignored, node, {}, {"effect", "covariance"});
  CalibrationUncertainty model_uncertainty;
  model_uncertainty.others = read_effects(node, ignored);
  const XmlNode covariance = required_child(node, "covariance");
  note_unknown(ignored, covariance, {"order"}, {}, true);
  model_uncertainty.covariance = read_model_covariance(
      covariance, warn_of_order, effect_numbers + number_count(model_uncertainty.others),
      "row by row: 6 of TCP->Body, one for each parameter of <effects> and one for each of <doubt>");
  return model_uncertainty;
}

/// Times of the observations, in their order.
std::vector<double> read_times(const XmlNode& node, Ignored& ignored) {
  note_unknown(ignored, node, {}, {}, true);
  const std::string text = inner_text(node);
  std::vector<double> times = inner_numbers(node, split_words(text).size(), "times in s", bounds::time);
  if (!std::is_sorted(times.begin(), times.end())) refuse(node, "has times that go back, expected them in order.");
  return times;
}

std::vector<Eigen::VectorXd> read_positions(const XmlNode& node, std::size_t joints, Ignored& ignored) {
  note_unknown(ignored, node, {}, {}, true);
  const std::size_t count = split_words(inner_text(node)).size();
  if (joints == 0 || count % joints != 0)
    refuse(node, message("has {} numbers, expected one for each of the {} <joints> in every pose.", count, joints));
  const std::vector<double> numbers = inner_numbers(node, count, "a pose a line", bounds::joint);
  std::vector<Eigen::VectorXd> positions;
  for (std::size_t i = 0; i < count; i += joints)
    positions.emplace_back(Eigen::Map<const Eigen::VectorXd>(numbers.data() + i, static_cast<Eigen::Index>(joints)));
  return positions;
}

void read_setting(const XmlNode& root, Calibration& calibration, Ignored& ignored) {
  if (const auto robot = find_child(root, "robot")) {
    note_unknown(ignored, *robot, {"tcp", "mount"}, {});
    calibration.tcp = find_text(*robot, "tcp").value_or("");
    calibration.mount = find_text(*robot, "mount").value_or("");
  }
  if (const auto gravity = find_child(root, "gravity")) {
    note_unknown(ignored, *gravity, {"xyz"}, {});
    calibration.gravity = Vector3(required_numbers(*gravity, "xyz", 3).data());
  }
  if (const auto joints = find_child(root, "joints")) {
    note_unknown(ignored, *joints, {}, {}, true);
    const std::string names = inner_text(*joints);
    std::unordered_set<std::string_view> seen;
    for (const std::string_view name : split_words(names)) {
      if (!seen.insert(name).second)
        refuse(*joints, message("names joint {} a second time, expected each joint once.", in_quotes(name)));
      calibration.joints.emplace_back(name);
    }
  }
  if (const auto repeatability = find_child(root, "tcp_scatter")) {
    note_unknown(ignored, *repeatability, {"order"}, {}, true);
    calibration.tcp_repeatability = read_covariance(*repeatability);
  }
  if (const auto repeatability = find_child(root, "hand_scatter")) {
    note_unknown(ignored, *repeatability, {"order"}, {}, true);
    calibration.hand_repeatability = read_covariance(*repeatability);
  }
  if (const auto times = find_child(root, "times")) calibration.times = read_times(*times, ignored);
  if (const auto positions = find_child(root, "positions"))
    calibration.positions = read_positions(*positions, calibration.joints.size(), ignored);
  if (const auto mount = find_child(root, "mount_from_sensor"))
    calibration.mount_from_sensor = read_motion(*mount, ignored);
}

}  // namespace

namespace {

/// What the root and each <session> hold.
void read_contents(const XmlNode& root, Calibration& calibration, Ignored& ignored) {
  calibration.tcp_from_body = read_motion(required_child(root, "tcp_from_body"), ignored);
  if (const auto fit = find_child(root, "fit")) calibration.fit = read_fit(*fit, ignored);
  read_markers(required_child(root, "markers"), calibration, ignored);
  if (const auto effects = find_child(root, "effects")) {
    note_unknown(ignored, *effects, {}, {"effect"});
    calibration.effects = read_effects(*effects, ignored);
  }
  if (const auto definitions = find_child(root, "effect_definitions")) {
    note_unknown(ignored, *definitions, {}, {"effect"});
    for (const XmlNode& node : children(*definitions, "effect"))
      calibration.definitions.push_back(read_effect_definition(node, ignored));
  }
  read_setting(root, calibration, ignored);
  if (const auto covariance = find_child(root, "model_covariance")) {
    note_unknown(ignored, *covariance, {"order"}, {}, true);
    calibration.model_covariance =
        read_model_covariance(*covariance, model_order, number_count(calibration.effects),
                              "row by row: 6 of TCP->Body and one for each parameter of <effects>");
  }
  if (const auto covariance = find_child(root, "hand_covariance")) {
    note_unknown(ignored, *covariance, {"order"}, {}, true);
    calibration.hand_covariance =
        read_model_covariance(*covariance, model_order, number_count(calibration.effects),
                              "row by row: 6 of the mount and one for each parameter of <effects>");
  }
  if (const auto model_uncertainty = find_child(root, "doubt"))
    calibration.model_uncertainty =
        read_model_uncertainty(*model_uncertainty, number_count(calibration.effects), ignored);
}

}  // namespace

Calibration parse_calibration(const std::string& text, const std::string& file) {
  const auto document = parse_xml(text, file);
  const XmlNode root = require_root(*document, file, "handsight_calibration");
  require_version_1(root);
  Ignored ignored;
  note_unknown(ignored, root, {"version", "session", "created", "software"},
               {"tcp_from_body", "fit", "markers", "effects", "effect_definitions", "robot", "gravity", "joints",
                "tcp_scatter", "model_covariance", "hand_scatter", "hand_covariance", "doubt", "mount_from_sensor",
                "times", "positions", "session"});
  Calibration calibration;
  calibration.session = find_name(root, "session").value_or("");
  calibration.created = find_text(root, "created").value_or("");
  calibration.software = find_text(root, "software").value_or("");
  read_contents(root, calibration, ignored);
  for (const XmlNode& node : children(root, "session")) {
    note_unknown(ignored, node, {"title"},
                 {"tcp_from_body", "fit", "markers", "effects", "effect_definitions", "robot", "gravity", "joints",
                  "tcp_scatter", "model_covariance", "hand_scatter", "hand_covariance", "doubt", "mount_from_sensor",
                  "times", "positions"});
    Calibration one;
    one.session = required_name(node, "title");
    one.created = calibration.created;
    one.software = calibration.software;
    read_contents(node, one, ignored);
    calibration.sessions.push_back(std::move(one));
  }
  calibration.notes = ignored_sentences(ignored, file);
  return calibration;
}

Calibration read_calibration(const std::filesystem::path& path) {
  return parse_calibration(read_file(path), path.filename().string());
}

}  // namespace handsight
