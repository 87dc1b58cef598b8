// SPDX-License-Identifier: Apache-2.0
#include "export/number_files.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "export/reported_motion.h"

namespace handsight {
namespace {

std::string number(double x) { return std::isnan(x) ? "nan" : format_number(x); }
std::string number(const std::optional<double>& x) { return x ? format_number(*x) : ""; }

/// Not a number as YAML writes it, and cv::FileStorage too, whose letters are others.
std::string with_nan(std::string text, std::string_view written) {
  for (std::size_t at = text.find("nan"); at != std::string::npos; at = text.find("nan", at + written.size()))
    text.replace(at, 3, written);
  return text;
}

template <class Derived>
std::string joined(const Eigen::DenseBase<Derived>& v, const std::string& between = ", ") {
  std::string text;
  for (Eigen::Index i = 0; i < v.size(); ++i) text += (i ? between : "") + number(v(i));
  return text;
}

/// Row by row.
std::string rows(const Eigen::MatrixXd& m) {
  const Eigen::MatrixXd by_columns = m.transpose();
  return joined(by_columns.reshaped());
}

/// NaN all of it where the rotation is.
Eigen::Vector4d reported_quaternion(const ReportedMotion& m) {
  return m.is_rotation ? make_quaternion(m.rotation) : Eigen::Vector4d(Eigen::Vector4d::Constant(m.rotation(0, 0)));
}

Eigen::Matrix4d make_matrix(const ReportedMotion& m) { return matrix_from_rigid(Rigid{m.rotation, m.place}); }

std::string yaml_motion(const ReportedMotion& m) {
  return with_nan(fmt::format("  xyz: [{}]\n  quaternion_xyzw: [{}]\n  matrix: [{}]\n", joined(m.place),
                              joined(reported_quaternion(m)), rows(make_matrix(m))),
                  ".nan");
}

std::string comments(const std::vector<Message>& texts) {
  std::string lines;
  for (const Message& text : texts) lines += "# " + text.english() + "\n";
  return lines;
}

std::string yaml_effects(const Calibration& c) {
  if (c.effects.empty()) return "effects: []\n";
  std::string text = "effects:\n";
  for (const CalibrationEffect& e : c.effects) {
    text += fmt::format("  - id: {}\n    parameters:\n", quoted_text(e.id));
    for (const CalibrationParameter& p : e.parameters)
      text +=
          fmt::format("      - {{of: {}, name: {}, value: {}, sigma: {}, unit: {}}}\n", quoted_text(p.of),
                      quoted_text(p.name), number(p.value), p.sigma ? number(*p.sigma) : "null", quoted_text(p.unit));
  }
  return text;
}

std::string sensor_name(const CalibratedRobot& r) { return r.rig ? r.rig->at(0).name + "_camera" : "sensor"; }

/// Where the sensor sits after the session, the effects on its mount in it.
std::optional<Rigid> mount_after(const CalibratedRobot& r) {
  if (!r.model.mount_from_sensor) return std::nullopt;
  const ObservationState c =
      states_at(r.chain, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(r.chain.joints.size())));
  return *r.model.mount_from_sensor * observed_ends(c, moved_sites(c, r.model.effects)).mount_motion;
}

std::string opencv_matrix(const std::string& name, const Eigen::MatrixXd& m) {
  return fmt::format("{}: !!opencv-matrix\n   rows: {}\n   cols: {}\n   dt: d\n   data: [ {} ]\n", name, m.rows(),
                     m.cols(), with_nan(rows(m), ".Nan"));
}

std::string opencv_camera(const Camera& c, const std::string& index) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(3, 3), distortion(1, c.is_fisheye ? 4 : is_plain(c) ? 5 : 8);
  matrix(0, 0) = c.fx;
  matrix(0, 1) = c.skew;
  matrix(0, 2) = c.cx;
  matrix(1, 1) = c.fy;
  matrix(1, 2) = c.cy;
  if (c.is_fisheye)
    distortion << c.k1, c.k2, c.k3, c.k4;  // of cv::fisheye
  else if (is_plain(c))
    distortion << c.k1, c.k2, c.p1, c.p2, c.k3;
  else
    distortion << c.k1, c.k2, c.p1, c.p2, c.k3, c.k4, c.k5, c.k6;
  return opencv_matrix("M" + index, matrix) + opencv_matrix("D" + index, distortion);
}

std::string python_string(const std::string& text) { return quoted_text(shortened(text, 500)); }

std::string transform_node(const std::string& parent, const std::string& child, const Rigid& m) {
  const Eigen::Vector4d q = make_quaternion(m.rotation);
  const Vector3& t = m.translation;
  return fmt::format(
      "        Node(package=\"tf2_ros\", executable=\"static_transform_publisher\", name={},\n"
      "             arguments=[\"--x\", \"{}\", \"--y\", \"{}\", \"--z\", \"{}\",\n"
      "                        \"--qx\", \"{}\", \"--qy\", \"{}\", \"--qz\", \"{}\", \"--qw\", \"{}\",\n"
      "                        \"--frame-id\", {}, \"--child-frame-id\", {}]),\n",
      python_string(child), number(t.x()), number(t.y()), number(t.z()), number(q.x()), number(q.y()), number(q.z()),
      number(q.w()), python_string(parent), python_string(child));
}

}  // namespace

std::string quoted_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else if (c == '\n')
      out += "\\n";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      out += c;
  }
  return out + "\"";
}

std::string field_of_table(const std::string& text) {
  if (text.find_first_of(",\"\n\r;#") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return out + "\"";
}

Eigen::Vector4d make_quaternion(const Matrix3& rotation) {
  const Eigen::Vector4d q = Eigen::Quaterniond(rotation).normalized().coeffs();
  return q.w() < 0 ? Eigen::Vector4d(-q) : q;
}

std::string yaml_file(const CalibratedRobot& r) {
  const Calibration& c = r.calibration;
  std::string text = fmt::format(
      "# A calibration by Handsight. Units: m, rad, s, kg, N m, px.\nsession: {}\ncreated: {}\nsoftware: {}\n",
      quoted_text(c.session), quoted_text(c.created), quoted_text(c.software));
  text += fmt::format("tcp: {}\nmount: {}\ngravity: [{}]\njoints: [", quoted_text(r.tcp), quoted_text(r.mount),
                      joined(r.chain.gravity));
  for (std::size_t i = 0; i < r.joint_names.size(); ++i) text += (i ? ", " : "") + quoted_text(r.joint_names[i]);
  const ReportedMotion body = reported_body(r);
  text += "]\n" + comments(undetermined_texts(r, nan_instead)) + "tcp_from_body:\n" + yaml_motion(body);
  text += fmt::format("  covariance: [{}]  # of xi in exp(xi) tcp_from_body: x y z rx ry rz, row by row\n",
                      with_nan(rows(body.covariance), ".nan"));
  if (r.model.mount_from_sensor)
    text += "mount_from_sensor:\n" + yaml_motion(reported_mount(r, *r.model.mount_from_sensor));
  text += "markers:  # in the body frame\n";
  for (std::size_t m = 0; m < c.markers.size(); ++m)
    if (std::count(c.unseen_markers.begin(), c.unseen_markers.end(), static_cast<int>(m)) == 0)
      text += fmt::format("  - {{index: {}, xyz: [{}]}}\n", m, joined(c.markers[m]));
  text += yaml_effects(c);
  if (c.definitions.empty()) return text;
  text += "effect_definitions:  # by formulas, as effects.xml writes them\n";
  for (const EffectDefinition& d : c.definitions) text += "  - " + quoted_text(effect_definition_text(d)) + "\n";
  return text;
}

std::string csv_file(const CalibratedRobot& r) {
  const Calibration& c = r.calibration;
  std::string text = "quantity,of,name,value,sigma,unit\n";
  const auto line = [&](const std::string& quantity, const std::string& of, const std::string& name,
                        const std::string& value, const std::string& sigma, const std::string& unit) {
    text += fmt::format("{},{},{},{},{},{}\n", quantity, field_of_table(of), field_of_table(name),
                        field_of_table(value), sigma, unit);
  };
  const auto motion = [&](const std::string& quantity, const std::string& of, const ReportedMotion& m) {
    const Eigen::Vector4d q = reported_quaternion(m);
    const auto sigma = [&](int i) {  // nothing where nothing is known
      const double variance = m.covariance(i, i);
      return std::isnan(variance) ? "" : number(std::sqrt(std::max(variance, 0.0)));
    };
    for (int i = 0; i < 3; ++i)
      line(quantity, of, std::string(1, "xyz"[i]), number(m.place[i]), std::isnan(m.place[i]) ? "" : sigma(i), "m");
    for (int i = 0; i < 4; ++i) line(quantity, of, std::string("q") + "xyzw"[i], number(q[i]), "", "1");
    for (int i = 0; i < 3; ++i)  // of the small rotation about the TCP's axes, whose value is 0
      line(quantity, of, std::string("r") + "xyz"[i], "0", sigma(i + 3), "rad");
  };
  motion("tcp_from_body", r.tcp, reported_body(r));
  if (r.model.mount_from_sensor) motion("mount_from_sensor", r.mount, reported_mount(r, *r.model.mount_from_sensor));
  for (std::size_t m = 0; m < c.markers.size(); ++m)
    for (int i = 0; i < 3; ++i)
      line("marker", std::to_string(m), std::string(1, "xyz"[i]), number(c.markers[m][i]), "", "m");
  for (const CalibrationEffect& e : c.effects)
    for (const CalibrationParameter& p : e.parameters)
      line(e.id, p.of, p.name, number(p.value), number(p.sigma), p.unit);
  for (const EffectDefinition& d : c.definitions) line("definition", d.id, "xml", effect_definition_text(d), "", "");
  return text;
}

std::string opencv_file(const CalibratedRobot& r) {
  std::string text = "%YAML:1.0\n---\n" + comments(undetermined_texts(r, nan_instead));
  const ReportedMotion body = reported_body(r);
  text +=
      opencv_matrix("tcp_from_body", make_matrix(body)) + opencv_matrix("tcp_from_body_covariance", body.covariance);
  if (const auto mount = mount_after(r))
    text += opencv_matrix("mount_from_sensor", make_matrix(reported_mount(r, *mount)));
  if (!r.rig) return text;
  text += fmt::format("image_width: {}\nimage_height: {}\n", r.rig->at(0).camera.width, r.rig->at(0).camera.height);
  for (int c = 0; c < r.rig->count(); ++c) {
    const RigCamera& camera = r.rig->at(c);
    const std::string number = std::to_string(c + 1), motion = is_pair(*r.rig) ? "" : number;
    text += opencv_camera(camera.camera, number);
    if (c == 0) continue;
    text += opencv_matrix("R" + motion, camera.camera_from_first.rotation) +
            opencv_matrix("T" + motion, camera.camera_from_first.translation);
  }
  return text;
}

std::string static_tf_file(const CalibratedRobot& r) {
  std::string text = fmt::format(
      "# Static transforms of a calibration by Handsight, for ros2 launch. They hold what is the same in all poses;\n"
      "# effects that bend or turn the arm are not in them ({} in the model).\n"
      "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
      "def generate_launch_description():\n    return LaunchDescription([\n",
      r.model.effects.size());
  for (const Message& untold : undetermined_texts(r, left_out_instead)) text += "        # " + untold.english() + "\n";
  if (reported_body(r).is_whole()) text += transform_node(r.tcp, "handsight_body", r.model.tcp_from_body);
  if (const auto mount = mount_after(r); mount && reported_mount(r, *mount).is_whole())
    text += transform_node(r.mount, "handsight_" + sensor_name(r), *mount);
  return text + "    ])\n";
}

}  // namespace handsight
