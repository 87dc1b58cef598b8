// SPDX-License-Identifier: Apache-2.0
// The part of the Python module that is written in C++: sessions and calibrated robots, and every answer as the JSON
// that the command line writes; handsight/__init__.py makes arrays and plain objects of it.
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "base/error.h"
#include "compare/comparison.h"
#include "correct/robot_file.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "options/joined_source.h"
#include "options/named_effects.h"
#include "options/predict_source.h"
#include "printing/comparison_output.h"
#include "printing/diagnosis_output.h"
#include "printing/export_output.h"
#include "printing/first_look.h"
#include "printing/fit_output.h"
#include "printing/improvement_output.h"
#include "printing/reported_json.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"

namespace py = pybind11;

namespace handsight {
namespace {

using Names = std::vector<std::string>;
using Positions = Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
constexpr char software[] = "handsight " HANDSIGHT_VERSION;

std::string make_text(const cli::Json& json) { return cli::json_text(json, -1); }

/// A session of this text and robot; there are no images.
Session session_from_text(const std::string& text, const std::string& robot) {
  SessionLines lines;
  Session session = parse_session(text, "session", &lines);
  bind_robot(session, read_urdf(robot), lines);
  return session;
}

Eigen::MatrixXd positions_of(const Session& s) {
  Eigen::MatrixXd all(static_cast<Eigen::Index>(s.observations.size()), static_cast<Eigen::Index>(s.joints.size()));
  for (Eigen::Index i = 0; i < all.rows(); ++i) all.row(i) = s.observations[static_cast<std::size_t>(i)].position;
  return all;
}

std::vector<std::int64_t> list_ids(const Session& s) {
  std::vector<std::int64_t> ids;
  for (const Observation& o : s.observations) ids.push_back(o.id);
  return ids;
}

Names camera_names_of(const Session& s) { return s.rig ? camera_names(*s.rig) : Names{}; }

/// One row a marker of every observation, observation by observation: u v of a camera, x y z of the tracker (camera
/// -1); nan where it was not seen.
Eigen::MatrixXd measured(const Session& s, int camera) {
  const Eigen::Index markers = s.marker_count;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(s.observations.size()) * markers,
                                                   camera < 0 ? 3 : 2, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < s.observations.size(); ++i)
    for (const Sighting& g : s.observations[i].sightings) {
      const Eigen::Index row = static_cast<Eigen::Index>(i) * markers + g.marker;
      if (camera < 0 && g.point) rows.row(row) = *g.point;
      for (const CameraPoint& p : g.in_cameras)
        if (p.camera == camera) rows.row(row) = p.pixel;
    }
  return rows;
}

/// Ctrl-C while something takes long.
bool go_on() {
  const py::gil_scoped_acquire python;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return true;
}

using Fitted = std::pair<std::string, CalibratedRobot>;

FitOptions fit_options(const Session& session, const Names& effects, const std::string& objective,
                       const std::string& loss, bool fix_markers) {
  FitOptions options;
  if (objective == "camera")
    options.objective = Objective::camera;
  else if (objective == "angle-axis")
    options.objective = Objective::angle_axis;
  else if (objective != "image")
    throw InputError(message("objective is \"{}\"; expected image, camera or angle-axis.", objective));
  if (loss == "huber")
    options.loss = Loss::huber;
  else if (loss == "cauchy")
    options.loss = Loss::cauchy;
  else if (loss != "none")
    throw InputError(message("loss is \"{}\"; expected none, huber or cauchy.", loss));
  options.fix_markers = fix_markers;
  cli::add_effects(effects, session, options.effects, options.estimated);
  return options;
}

Fitted fitted(const Session& session, const Names& effects, const std::string& objective, const std::string& loss,
              bool fix_markers, bool without_wrong_points) {
  const FitOptions options = fit_options(session, effects, objective, loss, fix_markers);
  const CleanFit clean =
      without_wrong_points ? fit_without_outliers(session, options) : CleanFit{session, fit(session, options), {}};
  const FitReport reported = report(clean.session, clean.fit, options);
  cli::Json json = cli::fit_json(session, clean.fit, reported, options);
  if (without_wrong_points) json["wrong_points"] = cli::wrong_points_json(clean.wrong, clean.session);
  return {make_text(json), with_robot_file(calibrated_robot(session, clean.fit, reported, options, software), session)};
}

std::string checked(const Session& session) {
  SessionCheck check = check_session(session);
  const cli::FirstLook look = cli::first_look(session, check);
  return make_text(cli::first_look_json(session, check, look));
}

std::string diagnosis_text(const Session& session, const Names& effects) {
  DiagnosisOptions options;
  cli::add_effects(effects, session, options.effects, options.estimated);
  options.on_progress = [](double) { return go_on(); };
  return make_text(cli::diagnosis_json(session, diagnose(session, options)));
}

Fitted improvement_of(const Session& session, const Names& effects, bool names_only) {
  ImprovementOptions options;
  cli::add_effects(effects, session, options.effects, options.estimated);
  options.with_curves = !names_only;
  options.on_progress = [](double) { return go_on(); };
  const Improvement m = improve(session, options);
  return {make_text(cli::improvement_json(session, m)),
          with_robot_file(calibrated_robot(session, m.last.model.fit, m.last.report, m.last.model_options, software,
                                           m.inclusion_probabilities.model_uncertainty),
                          session)};
}

std::string comparison_text(const Session& before, const Session& after, const Names& effects) {
  std::vector<EffectTerm> held, estimated;
  cli::add_effects(effects, before, held, estimated);
  if (!held.empty()) throw InputError("effects of compare are estimated; name them without values.");
  return make_text(cli::comparison_json(compare(before, after, estimated, [](double) { return go_on(); })));
}

std::string comparison_since(const CalibratedRobot& before, const Session& after) {
  return make_text(cli::comparison_json(compare(before, after, [](double) { return go_on(); })));
}

/// What export --json tells, and the file's text.
std::pair<std::string, std::string> exported(const CalibratedRobot& robot, const std::string& kind,
                                             const std::string& file) {
  ExportOptions options;
  if (!file.empty()) options.file = std::filesystem::absolute(file);
  const ExportedFile made = exported_file(robot, kind, options);
  return {make_text(cli::export_json(kind, file, made)), made.text};
}

CalibratedRobot read_calibrated(const std::string& file, const std::string& robot) {
  return cli::predict_source(file, robot);
}

/// One pose a row, each at rest and from nowhere.
std::vector<ObservationState> poses_of(const CalibratedRobot& robot, const Positions& positions) {
  if (positions.cols() != static_cast<Eigen::Index>(robot.joint_names.size()))
    throw InputError(message("positions have {} columns; expected {}, one a joint: {}.", positions.cols(),
                             robot.joint_names.size(), fmt::join(robot.joint_names, " ")));
  if (!positions.allFinite())
    throw InputError("positions hold a number that is not finite (nan or inf); expected angles in rad (m).");
  std::vector<ObservationState> poses;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
    poses.push_back(states_at(robot.chain, Eigen::VectorXd(positions.row(i))));
  return poses;
}

std::string predicted(const CalibratedRobot& calibrated, const Positions& positions) {
  const CalibratedRobot robot = with_moved_hand(calibrated);
  cli::Json list = cli::Json::array();
  for (const ObservationState& pose : poses_of(robot, positions))
    list.push_back(cli::prediction_json(predict_tcp(pose, robot.model), robot.model.rotation_is_observed));
  return make_text(list);
}

std::optional<Rigid> target_of(const std::optional<Eigen::Matrix4d>& matrix) {
  if (!matrix) return std::nullopt;
  const Matrix3 r = matrix->topLeftCorner<3, 3>();
  const bool is_motion = matrix->allFinite() && (r * r.transpose()).isIdentity(1e-6) && r.determinant() > 0 &&
                         matrix->row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), 1e-9);
  if (!is_motion)
    throw InputError("target is no motion; expected a 4x4 matrix root_from_tcp with a rotation and 0 0 0 1 below.");
  return Rigid{r, matrix->topRightCorner<3, 1>()};
}

std::string correction_text(const CalibratedRobot& calibrated, const Positions& positions,
                            const std::optional<Eigen::Matrix4d>& target) {
  const CalibratedRobot robot = with_moved_hand(calibrated);
  const std::optional<Rigid> wanted = target_of(target);
  cli::Json list = cli::Json::array();
  for (const ObservationState& pose : poses_of(robot, positions))
    list.push_back(cli::correction_json(cli::commanded_position(pose), corrected(pose, robot.model, wanted)));
  return make_text(list);
}

}  // namespace
}  // namespace handsight

PYBIND11_MODULE(_core, m) {
  using namespace handsight;
  using py::arg;
  const py::call_guard<py::gil_scoped_release> without_python;
  m.attr("version") = HANDSIGHT_VERSION;
  py::register_exception<InputError>(m, "InputError", PyExc_ValueError);
  py::class_<Session>(m, "Session")
      .def_property_readonly("joints", [](const Session& s) { return s.joints; })
      .def_property_readonly("title", [](const Session& s) { return s.title; })
      .def_property_readonly("marker_count", [](const Session& s) { return s.marker_count; })
      .def_property_readonly("notes", [](const Session& s) { return english(s.notes); })
      .def_property_readonly("cameras", &camera_names_of)
      .def_property_readonly("ids", &list_ids)
      .def_property_readonly("positions", &positions_of)
      .def("measured", &measured, arg("camera"))
      .def("text", &session_text);
  py::class_<CalibratedRobot>(m, "CalibratedRobot")
      .def_property_readonly("joints", [](const CalibratedRobot& r) { return r.joint_names; })
      .def("text", [](const CalibratedRobot& r) { return readable_text(r.calibration); });
  m.def(
      "read_session",
      [](const std::string& path) {
        const auto one = [](const std::string& file) { return read_session(file); };
        return is_collection(path) ? join_collection(read_collection(path), one) : one(path);
      },
      arg("path"));
  m.def("session_of", &session_from_text, arg("text"), arg("robot"));
  m.def("check", &checked, without_python);
  m.def("fit", &fitted, without_python);
  m.def("diagnose", &diagnosis_text, without_python);
  m.def("improve", &improvement_of, without_python);
  m.def("compare", &comparison_text, without_python);
  m.def("compare_since", &comparison_since, without_python);
  m.def("export_robot", &exported, without_python);
  m.def("read_calibration", &read_calibrated, arg("path"), arg("robot"));
  m.def("predict", &predicted, without_python);
  m.def("correct", &correction_text, without_python);
}
