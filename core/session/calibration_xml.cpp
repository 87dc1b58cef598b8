// SPDX-License-Identifier: Apache-2.0
// The writer; calibration_reader.cpp reads.
#include "session/calibration_xml.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "robot/xml_rigid.h"

namespace handsight {

namespace {

using tinyxml2::XMLElement;

void set(XMLElement& element, const char* attribute, const std::optional<double>& number) {
  if (number) element.SetAttribute(attribute, format_number(*number).c_str());
}

void set(XMLElement& element, const char* attribute, const Vector3& vector) {
  element.SetAttribute(attribute, format_numbers({vector.data(), 3}).c_str());
}

/// Row by row.
template <int rows, int columns>
std::string matrix_text(const Eigen::Matrix<double, rows, columns>& matrix) {
  const Eigen::Matrix<double, rows, columns, Eigen::RowMajor> by_rows = matrix;
  return format_numbers({by_rows.data(), static_cast<std::size_t>(by_rows.size())});
}

void write_motion(XMLElement& parent, const char* tag, const EstimatedMotion& estimated) {
  XMLElement& element = *parent.InsertNewChildElement(tag);
  write_rigid(element, estimated.motion);
  element.InsertNewChildElement("matrix")->SetText(matrix_text(matrix_from_rigid(estimated.motion)).c_str());
  XMLElement& covariance = *element.InsertNewChildElement("covariance");
  covariance.SetAttribute("order", "x y z rx ry rz");
  covariance.SetText(matrix_text(estimated.covariance).c_str());
}

void write_fit(XMLElement& root, const CalibrationFit& fit) {
  XMLElement& element = *root.InsertNewChildElement("fit");
  element.SetAttribute("observations", fit.observations);
  element.SetAttribute("used", fit.used);
  element.SetAttribute("rejected", fit.rejected);
  set(element, "rms_pixel", fit.rms_pixel);
  set(element, "held_out_rms_pixel", fit.held_out_rms_pixel);
  set(element, "noise_pixel", fit.noise_pixel);
  set(element, "rms_m", fit.rms_m);
  set(element, "held_out_rms_m", fit.held_out_rms_m);
  set(element, "noise_m", fit.noise_m);
  set(element, "chi2_per_dof", fit.chi2_per_dof);
}

void write_markers(XMLElement& root, const Calibration& calibration) {
  XMLElement& parent = *root.InsertNewChildElement("markers");
  const std::vector<int>& unseen = calibration.unseen_markers;
  for (int i = 0; i < static_cast<int>(calibration.markers.size()); ++i) {
    if (std::find(unseen.begin(), unseen.end(), i) != unseen.end()) continue;
    XMLElement& element = *parent.InsertNewChildElement("marker");
    element.SetAttribute("index", i);
    set(element, "xyz", calibration.markers[static_cast<std::size_t>(i)]);
  }
}

void write_effects(XMLElement& parent, const std::vector<CalibrationEffect>& effects) {
  std::map<std::string, int> written;
  for (const CalibrationEffect& effect : effects) {
    XMLElement& element = *parent.InsertNewChildElement("effect");
    element.SetAttribute("id", effect.id.c_str());
    if (const int number = ++written[effect.id]; number > 1) element.SetAttribute("number", number);
    for (const CalibrationParameter& parameter : effect.parameters) {
      XMLElement& child = *element.InsertNewChildElement("parameter");
      child.SetAttribute("of", parameter.of.c_str());
      child.SetAttribute("name", parameter.name.c_str());
      set(child, "value", parameter.value);
      set(child, "sigma", parameter.sigma);
      child.SetAttribute("unit", parameter.unit.c_str());
    }
  }
}

/// A pose a line.
void write_positions(XMLElement& root, const std::vector<Eigen::VectorXd>& positions) {
  if (positions.empty()) return;
  std::string text;
  for (const Eigen::VectorXd& p : positions)
    text += "\n    " + format_numbers({p.data(), static_cast<std::size_t>(p.size())});
  root.InsertNewChildElement("positions")->SetText((text + "\n  ").c_str());
}

void write_square(XMLElement& root, const char* tag, const char* order, const Eigen::MatrixXd& symmetric) {
  XMLElement& element = *root.InsertNewChildElement(tag);
  element.SetAttribute("order", order);
  const auto count = static_cast<std::size_t>(symmetric.size());
  element.SetText(format_numbers({symmetric.data(), count}).c_str());  // columns are rows
}

/// Beyond the export's contract: what a prediction needs of the session. Other readers ignore it.
void write_setting(XMLElement& root, const Calibration& calibration) {
  if (!calibration.tcp.empty() || !calibration.mount.empty()) {
    XMLElement& robot = *root.InsertNewChildElement("robot");
    if (!calibration.tcp.empty()) robot.SetAttribute("tcp", calibration.tcp.c_str());
    if (!calibration.mount.empty()) robot.SetAttribute("mount", calibration.mount.c_str());
  }
  if (calibration.gravity) set(*root.InsertNewChildElement("gravity"), "xyz", *calibration.gravity);
  if (!calibration.joints.empty())
    root.InsertNewChildElement("joints")->SetText(fmt::format("{}", fmt::join(calibration.joints, " ")).c_str());
  if (calibration.tcp_repeatability) {
    XMLElement& repeatability = *root.InsertNewChildElement("tcp_scatter");
    repeatability.SetAttribute("order", "x y z rx ry rz");
    repeatability.SetText(matrix_text(*calibration.tcp_repeatability).c_str());
  }
  if (calibration.model_covariance) write_square(root, "model_covariance", model_order, *calibration.model_covariance);
  if (calibration.hand_repeatability) {
    XMLElement& repeatability = *root.InsertNewChildElement("hand_scatter");
    repeatability.SetAttribute("order", "x y z rx ry rz");
    repeatability.SetText(matrix_text(*calibration.hand_repeatability).c_str());
  }
  if (calibration.hand_covariance) write_square(root, "hand_covariance", model_order, *calibration.hand_covariance);
  if (calibration.model_uncertainty) {
    XMLElement& model_uncertainty = *root.InsertNewChildElement("doubt");
    write_effects(model_uncertainty, calibration.model_uncertainty->others);
    write_square(model_uncertainty, "covariance", warn_of_order, calibration.model_uncertainty->covariance);
  }
  if (!calibration.times.empty())
    root.InsertNewChildElement("times")->SetText(format_numbers(calibration.times).c_str());
  write_positions(root, calibration.positions);
  if (calibration.mount_from_sensor) write_motion(root, "mount_from_sensor", *calibration.mount_from_sensor);
}

bool is_finite(const EstimatedMotion& estimated) {
  return estimated.motion.rotation.allFinite() && estimated.motion.translation.allFinite() &&
         estimated.covariance.allFinite();
}

}  // namespace

void require_finite(const Calibration& c) {
  for (const Calibration& one : c.sessions) require_finite(one);
  const auto require = [](bool holds, const Message& what) {
    if (!holds)
      throw InputError(
          message("The calibration cannot be written: {} is not finite; the observations do not "
                  "determine it. Look at the session with check and diagnose.",
                  what));
  };
  require(is_finite(c.tcp_from_body), "TCP->Body or its covariance");
  require(!c.mount_from_sensor || is_finite(*c.mount_from_sensor), "the mount or its covariance");
  require(!c.tcp_repeatability || c.tcp_repeatability->allFinite(), "the scatter of the TCP");
  require(!c.model_covariance || c.model_covariance->allFinite(), "the covariance of the effects");
  require(!c.hand_repeatability || c.hand_repeatability->allFinite(), "the scatter of the hand");
  require(!c.hand_covariance || c.hand_covariance->allFinite(), "the covariance of the hand");
  require(!c.model_uncertainty || c.model_uncertainty->covariance.allFinite(),
          "what the choice of the effects leaves open");
  for (const Vector3& marker : c.markers) require(marker.allFinite(), "a marker");
  for (const CalibrationEffect& effect : c.effects)
    for (const CalibrationParameter& p : effect.parameters)
      require(std::isfinite(p.value) && std::isfinite(p.sigma.value_or(0)), message("{} of {}", p.name, effect.id));
  for (const auto& number : {c.fit.rms_pixel, c.fit.held_out_rms_pixel, c.fit.noise_pixel, c.fit.rms_m,
                             c.fit.held_out_rms_m, c.fit.noise_m, c.fit.chi2_per_dof})
    require(std::isfinite(number.value_or(0)), "an error of the fit");
}

namespace {

void write_contents(XMLElement& root, const Calibration& calibration) {
  write_motion(root, "tcp_from_body", calibration.tcp_from_body);
  write_fit(root, calibration.fit);
  write_markers(root, calibration);
  write_effects(*root.InsertNewChildElement("effects"), calibration.effects);
  if (!calibration.definitions.empty()) {
    XMLElement& definitions = *root.InsertNewChildElement("effect_definitions");
    for (const EffectDefinition& d : calibration.definitions) write_effect_definition(definitions, d);
  }
  write_setting(root, calibration);
}

}  // namespace

std::string calibration_text(const Calibration& calibration) {
  tinyxml2::XMLDocument document;
  document.InsertEndChild(document.NewDeclaration());
  XMLElement& root = *document.NewElement("handsight_calibration");
  document.InsertEndChild(&root);
  root.SetAttribute("version", 1);
  root.SetAttribute("session", calibration.session.c_str());
  root.SetAttribute("created", calibration.created.c_str());
  root.SetAttribute("software", calibration.software.c_str());
  write_contents(root, calibration);
  for (const Calibration& one : calibration.sessions) {
    XMLElement& session = *root.InsertNewChildElement("session");
    session.SetAttribute("title", one.session.c_str());
    write_contents(session, one);
  }
  return xml_text(document);
}

const Calibration& find_session(const Calibration& calibration, const std::string& title) {
  std::string known;
  for (const Calibration& one : calibration.sessions) {
    if (one.session == title) return one;
    known += (known.empty() ? "" : ", ") + one.session;
  }
  throw InputError(known.empty()
                       ? message("--session {}: this calibration is of one session alone; leave the option out.", title)
                       : message("--session {}: the calibration has no such session; it has {}.", title, known));
}

std::string readable_text(const Calibration& calibration) {
  require_finite(calibration);
  std::string text = calibration_text(calibration);
  try {
    parse_calibration(text, "The calibration");
  } catch (const InputError& refusal) {
    throw BrokenPromise(fmt::format("a calibration that could not be read again was not written: {}", refusal.what()));
  }
  return text;
}

void write_calibration(const std::filesystem::path& path, const Calibration& calibration) {
  replace_file(path, readable_text(calibration));
}

}  // namespace handsight
