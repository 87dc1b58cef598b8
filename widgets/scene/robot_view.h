// SPDX-License-Identifier: GPL-3.0-or-later
// The robot, its cameras and what they saw, in 3D.
#pragma once

#include <QWidget>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "robot/robot.h"
#include "widgets/base/cells.h"
#include "widgets/scene/scene_marks.h"
#include "widgets/scene/standard_view.h"

namespace handsight::widgets {

struct RobotViewParts;
struct ReadMesh;
using ReadMeshes = std::map<std::string, ReadMesh>;

/// What goes before QApplication: the surface format that the 3D view needs (3.2 core, depth 24, stencil 8).
void set_surface_format();

/// Left button orbits about the z axis up, middle or Shift+left pans, wheel and right button zoom. F fits, 1 to 6 the
/// standard views, 0 the cameras' view. Hover names what is there, click takes it.
class RobotView : public QWidget {
  Q_OBJECT
 public:
  explicit RobotView(QWidget* parent = nullptr);
  ~RobotView() override;

  /// Links are drawn by their visuals; meshes are looked for under `mesh_folder`. A link without any gets a plausible
  /// limb between its joints. Sentences about meshes that could not be shown are in notes().
  void set_robot(const Robot& robot, const std::filesystem::path& mesh_folder);
  /// Meshes that take longer than a moment to read are shown when they are there; notes_changed tells.
  const std::vector<QString>& notes() const;
  bool is_reading() const;
  /// One motion per link of the robot, in its order.
  void set_posture(const std::vector<Rigid>& root_from_link);
  /// The same with what the model bends; the ghost is drawn where posture + magnification * (ghost - posture) is.
  void set_ghost(const std::optional<std::vector<Rigid>>& root_from_link);
  void set_ghost_magnification(double times);
  /// Places that are to be in sight where neither cameras nor the TCP are shown.
  void set_interest(std::vector<Vector3> in_root);
  void set_cameras(std::vector<SceneCamera> cameras);
  void set_tcp(const std::optional<Rigid>& root_from_tcp);          // red, green, blue
  void set_other_hands(std::vector<SceneHand> hands);               // of other sessions, in the same colours
  void set_tcp_est(const std::optional<Rigid>& root_from_tcp_est);  // cyan, yellow, magenta
  void set_markers(std::vector<SceneMarker> markers);
  void set_arrows(std::vector<SceneArrow> arrows);
  void set_arrow_magnification(double times);
  void set_fixtures(std::vector<SceneFixture> fixtures);
  const std::vector<SceneFixture>& fixtures() const;
  const std::vector<SceneArrow>& arrows() const;
  void set_paths(std::vector<ScenePath> paths);
  void set_ellipsoid(const std::optional<SceneEllipsoid>& ellipsoid);
  void set_selected_observation(ObservationId id);
  void set_hovered_observation(ObservationId id);
  void set_selected_joint(const QString& joint);  // its link is tinted
  void set_empty_text(const QString& sentence);   // where there is no robot
  void look(StandardView view);

  /// Where a point of the root frame is in widget coordinates; nothing behind the eye. For labels and tests.
  std::optional<QPointF> to_screen(const Vector3& in_root) const;
  /// The end of an observation's arrow as drawn; nothing where it has none.
  std::optional<Vector3> arrow_tip(ObservationId id) const;
  /// As shown when nothing moves: with smooth edges and labels; px of the picture for each of the widget's, 0: its own.
  QImage picture(double scale = 0);
  /// A PNG, written whole or not at all; returns an empty text, or the sentence that says why not.
  QString save(const QString& path);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void notes_changed();
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);
  void joint_selected(const QString& joint);  // a link was clicked: the joint that carries it
  void read_out(const QString& text);
  void message(const QString& sentence);  // "Saved robot.png.", or why not

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void take_meshes(const ReadMeshes& meshes);
  void finish_reading();
  void change();  // the scene: the next painting draws it anew
  void draw(const QSize& size);
  void show_buttons();
  void smooth();     // a step nearer to a picture with smooth edges
  void smooth_on();  // the same, while nothing moves, until it is there
  void show_menu(const QPoint& position);
  void save_picture();
  void pick(const QPointF& position, bool take);
  void paint_labels(QPainter& painter);
  std::unique_ptr<RobotViewParts> parts_;
};

}  // namespace handsight::widgets
