// SPDX-License-Identifier: GPL-3.0-or-later
// What a RobotView holds. Internal to robot_view*.cpp.
#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QImage>
#include <QTimer>
#include <array>
#include <future>

#include "widgets/scene/fixture_marks.h"
#include "widgets/scene/ghost.h"
#include "widgets/scene/gl_window.h"
#include "widgets/scene/marks.h"
#include "widgets/scene/orbit.h"
#include "widgets/scene/robot_actors.h"
#include "widgets/scene/scene_marks.h"
#include "widgets/scene/smooth_picture.h"
#include "widgets/scene/standard_view.h"
#include "widgets/scene/view_cube.h"

class QToolButton;

namespace handsight::widgets {

struct RobotViewParts {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderer> after;  // draws the ghost over the scene, by the same eye and depths
  GlWindow gl;
  QImage picture;        // the scene as it was drawn last, device px
  bool is_stale = true;  // the scene or the eye changed since
  SmoothPicture smooth;  // of a scene that stands still
  QTimer still;
  Orbit orbit;
  QWidget* buttons = nullptr;

  Robot robot;
  std::future<ReadMeshes> reading;                 // meshes that are on their way
  std::vector<std::future<ReadMeshes>> abandoned;  // of robots that are no longer shown: nobody waits for them
  QTimer reading_poll;
  std::vector<Rigid> posture;
  std::optional<std::vector<Rigid>> bent;
  double ghost_times = 20, arrow_times = 20;
  std::vector<SceneCamera> cameras;
  std::vector<Vector3> interest;  // places that are to be in sight
  std::optional<Rigid> tcp, tcp_est;
  std::vector<SceneHand> other_hands;
  std::vector<SceneMarker> markers;
  std::vector<SceneArrow> arrows;
  std::vector<SceneFixture> fixtures;
  std::vector<ScenePath> paths;
  std::optional<SceneEllipsoid> ellipsoid;
  ObservationId selected = no_observation, hovered = no_observation;
  QString selected_joint, empty_text;

  RobotActors read_links;  // not yet in the scene
  RobotActors links, shadow;
  Ghost ghost;
  std::vector<Rigid> ghost_posture;  // as it is drawn, magnified
  double arrow_scale = 0;            // m for each px with which the arrows were made
  ActorGroup floor, camera_actors, fixture_actors, path_actors, axes, marker_actors, arrow_actors, ring_actors,
      ellipsoid_actors;
  // What has to be made anew before the next picture: actors may only go while the context is current.
  bool robot_changed = false, posture_changed = true, ghost_changed = true, marks_changed = true, paths_changed = true,
       arrows_changed = true, rings_changed = true, theme_changed = true;
  bool wants_fit = true;
  bool is_framed = false;    // the eye is where the view itself put it: it may follow a robot that leaves the picture
  bool was_painted = false;  // once at least, with the scene or before there was one
  QSizeF shown_size{400, 300};  // px of the widget

  // What the pointer does.
  Qt::MouseButton button = Qt::NoButton;
  QPointF pressed_at, last_at;
  bool has_moved = false;

  /// The eye, moved by the user: from then on it stays.
  Orbit& by_hand() {
    is_framed = false;
    return orbit;
  }
  void make_ready();
  /// The scene as it was made ready, seen from an eye whose picture is moved by part of a pixel.
  QImage moved_picture(const QPointF& px);
  void make_robot();
  /// Near and far enough for the robot and its ghost.
  void set_clipping_range();
  void place_robot();
  void make_marks();
  void make_paths();
  void make_arrows();
  void set_colors();
  bool has_robot() const { return !robot.links.empty(); }
  const SceneArrow* find_arrow(ObservationId id) const;
  /// Points round what the session is about (hand, markers, arrows, cameras and the links near them), else round the
  /// robot; m, root frame.
  std::vector<Vector3> points_of_interest() const;
  /// Where the target is.
  double metres_per_px() const;
  /// Of the ghost only what is seen to differ from the robot.
  void hide_ghost_within_robot();
  void look(StandardView view);
  /// Is most of what the session is about in the picture?
  bool is_in_sight() const;
  /// The cube in the corner as it is painted now; empty where the view is too narrow for it.
  std::vector<CubeFace> cube(const QSizeF& size) const;
  std::optional<QPointF> to_screen(const Vector3& in_root, const QSizeF& size) const;
  /// The observation whose arrow is under a position; no_observation where there is none.
  ObservationId arrow_at(const QPointF& position, const QSizeF& size) const;
  /// The link under a position (device px, origin below); -1.
  int link_at(double x, double y);
};

}  // namespace handsight::widgets
