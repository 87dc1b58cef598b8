// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/observation_views.h"

#include <algorithm>
#include <set>

#include "chain/chain.h"
#include "workbench/session_parts.h"
#include "workbench/touch_views.h"

namespace handsight::app {
namespace {

std::optional<double> corner_ratio(const Vector2& residual, std::optional<double> noise) {
  return noise && *noise > 0 ? std::optional(residual.norm() / std::sqrt(2.0) / *noise) : std::nullopt;
}

std::optional<widgets::ImageAxes> axes_of(const RigCamera& seen_by, const Rigid& sensor_from_frame, bool is_estimate) {
  const Rigid camera_from_frame = seen_by.camera_from_first * sensor_from_frame;
  widgets::ImageAxes axes{.is_estimate = is_estimate};
  const Vector3 origin = camera_from_frame.translation;
  if (origin.z() < 0.02) return std::nullopt;
  axes.origin = project(seen_by.camera, origin);
  for (int i = 0; i < 3; ++i) {
    const Vector3 tip = camera_from_frame * Vector3(0.05 * Vector3::Unit(i));
    if (tip.z() < 0.02) return std::nullopt;
    axes.tips[static_cast<std::size_t>(i)] = project(seen_by.camera, tip);
  }
  return axes;
}

const ImageCorner* corner_of(const MarkerResidual& marker, int camera) {
  const auto i = static_cast<std::size_t>(camera);
  return i < marker.corners.size() ? &marker.corners[i] : nullptr;
}

std::vector<int> links_beyond_last_joint(const Robot& robot, int tcp_link) {
  const std::vector<int> chain = joints_to(robot, tcp_link);
  int last = -1;
  for (const int j : chain)
    if (robot.joints[static_cast<std::size_t>(j)].moves()) last = j;
  std::vector<int> links;
  for (int l = 0; l < static_cast<int>(robot.links.size()); ++l)
    if (last >= 0 && is_distal(robot, last, l)) links.push_back(l);
  return links;
}

}  // namespace

QString camera_name(const Rig& rig, int camera) {
  const std::string& name = rig.at(camera).name;
  return name == "left" ? QObject::tr("left") : name == "right" ? QObject::tr("right") : QString::fromStdString(name);
}

QString camera_title(const Rig& rig, int camera) {
  const std::string& name = rig.at(camera).name;
  return name == "left" ? QObject::tr("Left") : name == "right" ? QObject::tr("Right") : QString::fromStdString(name);
}

QStringList camera_names_in_words(const Rig& rig) {
  QStringList names;
  for (int camera = 0; camera < rig.count(); ++camera) names << camera_name(rig, camera);
  return names;
}

std::vector<widgets::ImageMark> image_marks(const InspectionRow& row, int camera, const Rig& rig,
                                            std::optional<double> noise, const DisplayUnits& units) {
  std::vector<widgets::ImageMark> marks;
  for (const MarkerResidual& m : row.markers) {
    const ImageCorner* corner = corner_of(m, camera);
    if (!corner) continue;
    if (corner->predicted)
      marks.push_back({.marker = m.marker, .position = *corner->predicted, .role = widgets::MarkRole::predicted});
    if (!corner->measured) continue;
    widgets::ImageMark mark{.marker = m.marker, .position = *corner->measured};
    if (corner->predicted) {
      mark.rms_over_sigma = corner_ratio(*corner->measured - *corner->predicted, noise);
      mark.text = QObject::tr("marker %1, %2 from where it was predicted")
                      .arg(m.marker)
                      .arg(units.text(size_of_corner(m, camera, rig, noise)));
    }
    marks.push_back(mark);
  }
  return marks;
}

std::vector<widgets::ImageArrow> image_arrows(const InspectionRow& row, int camera, std::optional<double> noise) {
  std::vector<widgets::ImageArrow> arrows;
  for (const MarkerResidual& m : row.markers) {
    const ImageCorner* corner = corner_of(m, camera);
    if (!corner || !corner->is_compared()) continue;
    const Vector2 residual = *corner->measured - *corner->predicted;
    arrows.push_back(
        {.from = *corner->predicted, .residual = residual, .rms_over_sigma = corner_ratio(residual, noise)});
  }
  return arrows;
}

std::vector<widgets::ImageAxes> image_axes(const InspectionRow& row, const Rig& rig, int camera) {
  std::vector<widgets::ImageAxes> all;
  const Rigid sensor_from_tcp = inverse(row.root_from_sensor) * row.root_from_tcp;
  if (const auto tcp = axes_of(rig.at(camera), sensor_from_tcp, false)) all.push_back(*tcp);
  if (row.tcp_from_tcp_est)
    if (const auto est = axes_of(rig.at(camera), sensor_from_tcp * *row.tcp_from_tcp_est, true)) all.push_back(*est);
  return all;
}

std::vector<widgets::ImageMark> label_marks(const Observation& observation, int camera) {
  std::vector<widgets::ImageMark> marks;
  for (const Sighting& s : observation.sightings)
    if (const CameraPoint* const seen = seen_by(s, camera))
      marks.push_back({.marker = s.marker, .position = seen->pixel});
  return marks;
}

void show_images(Workbench& workbench, const Observation& observation, const InspectionRow* row,
                 const std::vector<ShownCamera>& shown_cameras, bool with_axes, bool at_once) {
  const Session& s = workbench.document.session();
  for (const auto& [view, camera] : shown_cameras) {
    if (touched_fixture(s, observation)) {
      view->set_title(QObject::tr("Touch"));
      const QString text = touched_text(s, observation, row, workbench.units);
      view->clear(text);
      view->setAccessibleDescription(text);
      continue;
    }
    if (!s.rig || camera < 0 || camera >= s.rig->count()) {
      view->set_title({});
      view->clear(s.pose_sensor ? QObject::tr("A sensor that tells poses has no images.")
                                : QObject::tr("A tracker session has no images."));
      continue;
    }
    const Camera& seen_by = s.rig->at(camera).camera;
    const std::string& file = observation.images[static_cast<std::size_t>(camera)];
    const ShownImage shown =
        at_once ? workbench.images.image_now(s, observation, camera) : workbench.images.image(s, observation, camera);
    const QString side = camera_title(*s.rig, camera);
    view->set_title(file.empty() ? side + QObject::tr(", no image")
                                 : side + "  " + QString::fromStdString(std::filesystem::path(file).filename()) +
                                       (shown.is_coming ? QObject::tr(", is being read …") : QString()));
    view->set_stretched(true);  // as bright as where it is labelled
    if (!shown.image.isNull()) {
      view->set_image(shown.image);
    } else if (!shown.refusal.isEmpty()) {
      view->clear(shown.refusal);
    } else {
      view->show_frame(seen_by.width, seen_by.height);
    }
    const auto noise = workbench.inspection() ? workbench.inspection()->noise : std::nullopt;
    view->set_marks(row ? image_marks(*row, camera, *s.rig, noise, workbench.units) : label_marks(observation, camera));
    view->set_arrows(row ? image_arrows(*row, camera, noise) : std::vector<widgets::ImageArrow>{});
    view->set_axes(row && with_axes ? image_axes(*row, *s.rig, camera) : std::vector<widgets::ImageAxes>{});
    view->set_selected_marker(workbench.selection.current().marker.value_or(-1));
  }
}

std::vector<Rigid> link_motions(const Session& session, const Eigen::VectorXd& position) {
  std::vector<int> joints;
  for (const std::string& name : session.joints) joints.push_back(find_joint(session.robot, name));
  return solve_posture(session.robot, joint_values(session.robot, joints, position), session.gravity).root_from_link;
}

namespace {

/// Hands of a collection's other sessions, each once.
std::vector<widgets::SceneHand> other_hands(const Session& s, const std::string& own, const std::vector<Rigid>& links) {
  std::vector<widgets::SceneHand> hands;
  std::set<std::string> known{own};
  if (is_joined(s))
    for (const SessionPart& part : s.parts)
      if (known.insert(part.tcp).second)
        hands.push_back({QObject::tr("hand of %1").arg(QString::fromStdString(part.title)),
                         links[static_cast<std::size_t>(find_link(s.robot, part.tcp))]});
  return hands;
}

/// Cameras of all rigs; those that saw the observation where it was seen from. A mount of which nothing is known yet
/// has no place.
std::vector<widgets::SceneCamera> scene_cameras(const Session& s, const ModelVersion* model, int part,
                                                const InspectionRow* row, const std::vector<Rigid>& links) {
  std::vector<widgets::SceneCamera> cameras;
  std::set<int> known;
  const int parts = is_joined(s) ? static_cast<int>(s.parts.size()) : 1;
  for (int k = 0; k < parts; ++k) {
    const int p = k == 0 ? part : k <= part ? k - 1 : k;  // the observation's own first
    const OwnSession own = take_own_session(s, p);
    const bool is_seen = p == part && row;
    if (!is_seen && !own.mount->known && !(model && model->fit)) continue;
    const Rigid root_from_sensor =
        is_seen ? row->root_from_sensor
                : links[static_cast<std::size_t>(find_link(s.robot, own.mount->link))] * mount_from_sensor(s, p, model);
    for (int c = own.first_camera; c < own.first_camera + own.camera_count; ++c)
      if (known.insert(c).second)
        cameras.push_back(
            {camera_name(*s.rig, c), root_from_sensor * inverse(s.rig->at(c).camera_from_first), s.rig->at(c).camera});
  }
  return cameras;
}

}  // namespace

void show_pose(const Document& document, const Observation& observation, const InspectionRow* row,
               widgets::RobotView& view) {
  const Session& s = document.session();
  const std::vector<Rigid> links = link_motions(s, observation.position);
  const ModelVersionPointer model = document.shown_model();
  const OwnSession own = take_own_session(s, observation.part);
  const int tcp = find_link(s.robot, own.tcp);
  const Rigid root_from_tcp = row ? row->root_from_tcp : links[static_cast<std::size_t>(tcp)];
  view.set_posture(links);
  view.set_tcp(root_from_tcp);
  view.set_other_hands(other_hands(s, own.tcp, links));
  if (s.rig) view.set_cameras(scene_cameras(s, model.get(), observation.part, row, links));
  view.set_fixtures(scene_fixtures(document, observation, links));
  view.set_selected_observation(observation.id);
  std::vector<widgets::SceneMarker> markers;
  if (!row) {
    view.set_tcp_est(std::nullopt);
    view.set_ghost(std::nullopt);
    view.set_markers({});
    return;
  }
  if (touched_fixture(s, observation)) {
    const TouchResidual touch = touch_residual(*row);
    const int marker = row->markers.front().marker;
    markers.push_back({.marker = marker, .in_root = touch.tip, .role = widgets::SceneMarkerRole::predicted});
    markers.push_back({.marker = marker, .in_root = touch.tip + touch.off, .rms_over_sigma = row->ratio});
    view.set_markers(std::move(markers));
    view.set_tcp_est(std::nullopt);
    view.set_ghost(std::nullopt);
    return;
  }
  for (const MarkerResidual& m : row->markers) {
    if (s.pose_sensor) break;  // it tells where the whole is; the points that stand for it are nowhere
    markers.push_back({.marker = m.marker,
                       .in_root = row->root_from_sensor * m.predicted_in_sensor,
                       .role = widgets::SceneMarkerRole::predicted});
    if (m.measured_in_sensor)
      markers.push_back({.marker = m.marker, .in_root = row->root_from_sensor * *m.measured_in_sensor});
  }
  view.set_markers(std::move(markers));
  if (!row->tcp_from_tcp_est) {
    view.set_tcp_est(std::nullopt);
    view.set_ghost(std::nullopt);
    return;
  }
  const Rigid root_from_tcp_est = root_from_tcp * *row->tcp_from_tcp_est;
  view.set_tcp_est(root_from_tcp_est);
  std::vector<Rigid> ghost = links;
  const Rigid displaced = root_from_tcp_est * inverse(root_from_tcp);
  for (const int l : links_beyond_last_joint(s.robot, tcp))
    ghost[static_cast<std::size_t>(l)] = displaced * ghost[static_cast<std::size_t>(l)];
  view.set_ghost(ghost);
}

std::vector<widgets::SceneArrow> scene_arrows(const Session& session, const Inspection& inspection,
                                              const SessionFilter& shown) {
  // More than so many are a cloud, and slow without a graphics card: then every n-th, and all that stand out.
  constexpr std::size_t most = 1000;
  const std::size_t every = inspection.rows.size() / most + 1;
  std::vector<widgets::SceneArrow> arrows;
  for (std::size_t i = 0; i < inspection.rows.size(); ++i) {
    const InspectionRow& row = inspection.rows[i];
    if (!shown.is_observation_shown(row.id)) continue;
    const auto at = static_cast<std::size_t>(row.index);  // of a session that may have grown or shrunk since
    const bool is_touch = at < session.observations.size() && touched_fixture(session, session.observations[at]);
    if (is_touch && !row.markers.empty() && (i % every == 0 || row.outlier)) arrows.push_back(touch_arrow(row));
    if (is_touch || !row.tcp_from_tcp_est || (i % every != 0 && !row.outlier)) continue;
    arrows.push_back({.observation = row.id,
                      .from = row.root_from_tcp.translation,
                      .residual = row.root_from_tcp.rotation * row.tcp_from_tcp_est->translation,
                      .rms_over_sigma = row.ratio,
                      .coordinates = row.coordinates});
  }
  return arrows;
}

double round_magnification(double size, double wanted) {
  if (!(size > 0)) return 1;
  const double exact = wanted / size;
  double best = 1;
  for (const double decade : {1.0, 10.0, 100.0, 1e3, 1e4})
    for (const double step : {1.0, 2.0, 5.0})
      if (decade * step <= exact) best = decade * step;
  return best;
}

double magnification_over_noise(double size, std::optional<double> noise, double wanted) {
  constexpr double sigmas = 6;  // as the axes of plots
  return round_magnification(std::max(size, sigmas * noise.value_or(0)), wanted);
}

double arrow_magnification(const Inspection& inspection) {
  double largest = 0;
  for (const InspectionRow& row : inspection.rows)
    if (row.is_used && row.rms_m) largest = std::max(largest, *row.rms_m);
  constexpr double wanted = 0.1;  // m
  return magnification_over_noise(largest, inspection.noise_m, wanted);
}

}  // namespace handsight::app
