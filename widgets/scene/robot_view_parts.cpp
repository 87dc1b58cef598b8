// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/robot_view_parts.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkLightKit.h>
#include <vtkMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr double covered_px = 28;  // along the upper edge, by the standard views

double distance_to_segment(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF ab = b - a, ap = p - a;
  const double squared = QPointF::dotProduct(ab, ab);
  const double t = squared > 0 ? std::clamp(QPointF::dotProduct(ap, ab) / squared, 0.0, 1.0) : 0;
  const QPointF d = ap - t * ab;
  return std::hypot(d.x(), d.y());
}

/// A little darker than the ground, in the dark theme too.
QColor shadow_color() {
  const QColor ground = colors().panel, ink = ground.lightness() > 127 ? colors().ink1 : QColor(Qt::black);
  const double share = ground.lightness() > 127 ? 0.13 : 0.4;
  const auto mix = [share](int a, int b) { return static_cast<int>(std::lround((1 - share) * a + share * b)); };
  return {mix(ground.red(), ink.red()), mix(ground.green(), ink.green()), mix(ground.blue(), ink.blue())};
}

/// A link that is as dark as a dark ground would be lost on it.
QColor off_the_ground(const QColor& color) {
  constexpr int least = 88;
  if (colors().panel.lightness() > 127 || color.lightness() >= least) return color;
  return QColor::fromHsl(color.hslHue() < 0 ? 0 : color.hslHue(), color.hslSaturation(), least);
}

}  // namespace

const SceneArrow* RobotViewParts::find_arrow(ObservationId id) const {
  if (id == no_observation) return nullptr;
  const auto found = std::find_if(arrows.begin(), arrows.end(), [id](const auto& a) { return a.observation == id; });
  return found == arrows.end() ? nullptr : &*found;
}

void RobotViewParts::make_ready() {
  if (robot_changed) make_robot();
  if (theme_changed) set_colors();
  const bool has_moved_robot = posture_changed;
  if (posture_changed || ghost_changed) place_robot();
  if (marks_changed) make_marks();
  if (paths_changed) make_paths();
  if (wants_fit && has_robot() && !posture.empty()) {
    look(StandardView::all);
    wants_fit = false;
  } else if (is_framed && has_moved_robot && has_robot() && !is_in_sight()) {
    look(StandardView::all);
  }
  constexpr double much = 1.3;
  const double scale = metres_per_px() / std::max(arrow_scale, 1e-9);
  if (scale > much || scale < 1 / much) arrows_changed = true;
  if (arrows_changed || rings_changed) make_arrows();
  hide_ghost_within_robot();
  orbit.apply(*renderer->GetActiveCamera());
  set_clipping_range();
}

void RobotViewParts::set_clipping_range() {
  vtkBoundingBox all(renderer->ComputeVisiblePropBounds());
  all.AddBounds(after->ComputeVisiblePropBounds());
  double bounds[6];
  all.GetBounds(bounds);
  renderer->ResetCameraClippingRange(bounds);
}

QImage RobotViewParts::moved_picture(const QPointF& px) {
  vtkCamera& camera = *renderer->GetActiveCamera();
  camera.SetWindowCenter(2 * px.x() / picture.width(), 2 * px.y() / picture.height());
  QImage moved = gl.picture(picture.size());
  camera.SetWindowCenter(0, 0);
  return moved;
}

void RobotViewParts::make_robot() {
  remove_from(*renderer, links);
  remove_from(*after, ghost);
  remove_from(*renderer, shadow);
  std::vector<QString> notes = std::move(links.notes);
  links = std::exchange(read_links, {});
  ghost = make_ghost(links, *renderer);
  shadow = make_shadow_actors(links, shadow_color());
  links.notes = std::move(notes);
  add_to(*renderer, links);
  add_to(*after, ghost);
  add_to(*renderer, shadow);
  robot_changed = false;
  posture_changed = ghost_changed = theme_changed = true;
}

void RobotViewParts::set_colors() {
  const QColor ground = colors().panel;
  renderer->SetBackground(ground.redF(), ground.greenF(), ground.blueF());
  set_color(ghost, colors().candidate);
  for (const LinkActor& part : shadow.parts) set_color(*part.actor, shadow_color());
  const int selected_index = find_joint(robot, selected_joint.toStdString());
  const int tinted = selected_index < 0 ? -1 : robot.joints[static_cast<std::size_t>(selected_index)].child_link;
  for (const LinkActor& part : links.parts)
    set_color(*part.actor, part.link == tinted ? colors().accent : off_the_ground(part.color));
  theme_changed = false;
  marks_changed = arrows_changed = posture_changed = paths_changed = true;
}

void RobotViewParts::place_robot() {
  set_visible(links, !posture.empty());
  place_links(links, posture);
  const bool has_ghost = bent.has_value() && !posture.empty();
  ghost_posture = has_ghost ? magnified(posture, *bent, ghost_times) : std::vector<Rigid>();
  place(ghost, ghost_posture);
  if (posture_changed) {
    double lowest = 0;
    for (const LinkActor& part : links.parts)
      if (part.actor->GetVisibility()) lowest = std::min(lowest, part.actor->GetBounds()[4]);
    floor.clear(*renderer);
    if (has_robot()) show_floor(*renderer, floor, lowest);
    set_visible(shadow, !posture.empty());
    place_shadow(shadow, posture, lowest);
  }
  posture_changed = ghost_changed = false;
}

void RobotViewParts::make_marks() {
  for (ActorGroup* group : {&camera_actors, &fixture_actors, &axes, &marker_actors, &ellipsoid_actors})
    group->clear(*renderer);
  for (const SceneCamera& camera : cameras) show_camera(*renderer, camera_actors, camera);
  for (const SceneFixture& fixture : fixtures) show_fixture(*renderer, fixture_actors, fixture);
  if (tcp) show_axes(*renderer, axes, *tcp, false);
  if (tcp_est) show_axes(*renderer, axes, *tcp_est, true);
  for (const SceneHand& hand : other_hands) show_axes(*renderer, axes, hand.root_from_tcp, false);
  show_markers(*renderer, marker_actors, markers);
  if (ellipsoid) show_ellipsoid(*renderer, ellipsoid_actors, *ellipsoid);
  marks_changed = false;
}

void RobotViewParts::make_paths() {
  path_actors.clear(*renderer);
  for (const ScenePath& path : paths) show_path(*renderer, path_actors, path);
  paths_changed = false;
}

double RobotViewParts::metres_per_px() const {
  return 2 * orbit.distance * std::tan(Orbit::view_angle / 2 * M_PI / 180) / std::max(shown_size.height(), 1.0);
}

void RobotViewParts::hide_ghost_within_robot() {
  constexpr double least_px = 3;
  const auto moves = [&](const LinkActor& part) {
    const auto link = static_cast<std::size_t>(part.link);
    if (link >= ghost_posture.size()) return false;
    double bounds[6];
    part.actor->GetMapper()->GetBounds(bounds);
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 at = part.link_from_shape *
                         Vector3(bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)]);
      const auto a = to_screen(posture[link] * at, shown_size), b = to_screen(ghost_posture[link] * at, shown_size);
      if (a && b && std::hypot(a->x() - b->x(), a->y() - b->y()) >= least_px) return true;
    }
    return false;
  };
  for (std::size_t part = 0; part < ghost.outline.parts.size(); ++part)
    set_visible(ghost, part, moves(ghost.outline.parts[part]));
  after->SetDraw(!ghost_posture.empty());
}

void RobotViewParts::make_arrows() {
  if (arrows_changed) {
    arrow_scale = metres_per_px();
    arrow_actors.clear(*renderer);
    show_arrows(*renderer, arrow_actors, arrows, arrow_times, arrow_scale);
  }
  ring_actors.clear(*renderer);
  if (const SceneArrow* arrow = find_arrow(hovered); arrow && hovered != selected)
    show_arrow(*renderer, ring_actors, *arrow, arrow_times, arrow_scale, colors().ink2);
  if (const SceneArrow* arrow = find_arrow(selected))
    show_arrow(*renderer, ring_actors, *arrow, arrow_times, arrow_scale, colors().accent);
  arrows_changed = rings_changed = false;
}

std::vector<Vector3> RobotViewParts::points_of_interest() const {
  std::vector<Vector3> points = interest;
  for (const SceneArrow& arrow : arrows) points.push_back(arrow.from);
  for (const SceneCamera& camera : cameras) points.push_back(camera.root_from_camera.translation);
  for (const SceneFixture& fixture : fixtures) points.push_back(find_middle(fixture));
  for (const SceneMarker& marker : markers) points.push_back(marker.in_root);
  for (const ScenePath& path : paths) points.insert(points.end(), path.points.begin(), path.points.end());
  if (tcp) points.push_back(tcp->translation);
  for (const SceneHand& hand : other_hands) points.push_back(hand.root_from_tcp.translation);
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (const Vector3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  constexpr double reach = 0.35;                                 // m: links this near belong to it
  const bool has_focus = !cameras.empty() || !interest.empty();  // else the whole robot
  const Vector3 from = low - Vector3::Constant(reach), to = high + Vector3::Constant(reach);
  for (const LinkActor& part : links.parts) {
    const double* b = part.actor->GetBounds();
    const Vector3 middle(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]));
    if (has_focus && ((middle - from).minCoeff() < 0 || (to - middle).minCoeff() < 0)) continue;
    for (int corner = 0; corner < 8; ++corner)
      points.emplace_back(b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2 & 1)]);
  }
  if (points.empty()) return {Vector3(-0.5, -0.5, 0), Vector3(0.5, 0.5, 1)};
  if (links.parts.empty()) {  // only frames: their axes and the camera's body reach as far
    points.push_back(low - Vector3::Constant(0.2));
    points.push_back(high + Vector3::Constant(0.2));
  }
  return points;
}

bool RobotViewParts::is_in_sight() const {
  constexpr double enough = 0.95;
  const std::vector<Vector3> points = points_of_interest();
  const auto is_seen = [&](const Vector3& point) {
    const auto at = to_screen(point, shown_size);
    return at && QRectF(QPointF(0, covered_px), shown_size - QSizeF(0, covered_px)).contains(*at);
  };
  const auto seen = std::count_if(points.begin(), points.end(), is_seen);
  return static_cast<double>(seen) >= enough * static_cast<double>(points.size()) &&
         (!tcp || is_seen(tcp->translation));
}

void RobotViewParts::look(StandardView view) {
  is_framed = view == StandardView::all;
  const auto from = [this](double azimuth, double elevation) {
    orbit.azimuth = azimuth;
    orbit.elevation = elevation;
    orbit.see_points(points_of_interest(), shown_size.width() / std::max(shown_size.height(), 1.0),
                     covered_px / std::max(shown_size.height(), 1.0));
  };
  switch (view) {
    case StandardView::front:
      return from(0, 0);
    case StandardView::back:
      return from(M_PI, 0);
    case StandardView::left:
      return from(M_PI / 2, 0);
    case StandardView::right:
      return from(-M_PI / 2, 0);
    case StandardView::top:
      return from(M_PI, 1.569);
    case StandardView::all:
      return from(0.7, 0.3);
    case StandardView::tcp:
      if (tcp) orbit.see(tcp->translation, 0.2);
      return;
    case StandardView::camera:
      break;
  }
  if (cameras.empty()) return;
  const Rigid& camera = cameras.front().root_from_camera;
  // Along its axis, or at the TCP, which it watches: the 3D view shows less to the sides than a camera does.
  const Vector3 along =
      tcp ? Vector3((tcp->translation - camera.translation).normalized()) : Vector3(camera.rotation.col(2));
  orbit.elevation = std::asin(std::clamp(-along.z(), -1.0, 1.0));
  orbit.azimuth = std::atan2(-along.y(), -along.x());
  // A little in front of it: the camera itself sits in a head.
  orbit.distance = 0.7;
  orbit.target = camera.translation + 0.9 * along;
  orbit.turn(0, 0);
}

std::vector<CubeFace> RobotViewParts::cube(const QSizeF& size) const {
  constexpr double wide_enough = 340;
  if (size.width() < wide_enough || !has_robot()) return {};
  return cube_faces(orbit, {84, size.height() - 34}, 34);
}

std::optional<QPointF> RobotViewParts::to_screen(const Vector3& in_root, const QSizeF& size) const {
  const Vector3 forward = orbit.direction();
  const Vector3 right = forward.cross(Vector3::UnitZ()).normalized();
  const Vector3 up = right.cross(forward);
  const Vector3 d = in_root - orbit.eye();
  const double depth = d.dot(forward);
  if (depth <= 1e-6) return std::nullopt;
  const double scale = size.height() / 2 / std::tan(Orbit::view_angle / 2 * M_PI / 180) / depth;
  return QPointF(size.width() / 2 + scale * d.dot(right), size.height() / 2 - scale * d.dot(up));
}

ObservationId RobotViewParts::arrow_at(const QPointF& position, const QSizeF& size) const {
  ObservationId best = no_observation;
  double nearest = 8;
  for (const SceneArrow& arrow : arrows) {
    const auto from = to_screen(arrow.from, size), to = to_screen(arrow.from + arrow_times * arrow.residual, size);
    if (!from || !to) continue;
    const double distance = distance_to_segment(position, *from, *to);
    if (distance >= nearest) continue;
    nearest = distance;
    best = arrow.observation;
  }
  return best;
}

int RobotViewParts::link_at(double x, double y) {
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0005);
  if (!picker->Pick(x, y, 0, renderer)) return -1;
  for (const LinkActor& part : links.parts)
    if (part.actor == picker->GetActor()) return part.link;
  return -1;
}

}  // namespace handsight::widgets
