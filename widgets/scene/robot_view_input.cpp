// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QSaveFile>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/scene/robot_view.h"
#include "widgets/scene/robot_view_parts.h"

namespace handsight::widgets {

void RobotView::pick(const QPointF& position, bool take) {
  RobotViewParts& p = *parts_;
  if (!p.has_robot()) return;
  const ObservationId id = p.arrow_at(position, size());
  if (!take && id != p.hovered) {
    set_hovered_observation(id);
    emit observation_hovered(id);
  }
  if (id != no_observation) {
    const SceneArrow* arrow = p.find_arrow(id);
    emit read_out(QObject::tr("obs %1: %2 mm").arg(id).arg(short_text(1000 * arrow->residual.norm())));
    if (take) emit observation_selected(id);
    return;
  }
  const double ratio = devicePixelRatioF();
  const int link = p.link_at(position.x() * ratio, (height() - position.y()) * ratio);
  if (link < 0) {
    emit read_out({});
    return;
  }
  // The joint that moves it: above the fixed ones.
  const Link* at = &p.robot.links[static_cast<std::size_t>(link)];
  const QString name = QString::fromStdString(at->name);
  while (at->parent_joint >= 0 && !p.robot.joints[static_cast<std::size_t>(at->parent_joint)].moves())
    at = &p.robot
              .links[static_cast<std::size_t>(p.robot.joints[static_cast<std::size_t>(at->parent_joint)].parent_link)];
  const QString joint = at->parent_joint < 0
                            ? QString()
                            : QString::fromStdString(p.robot.joints[static_cast<std::size_t>(at->parent_joint)].name);
  emit read_out(joint.isEmpty() ? QObject::tr("link %1").arg(name)
                                : QObject::tr("link %1, moved by %2").arg(name, joint));
  if (take && !joint.isEmpty()) emit joint_selected(joint);
}

void RobotView::mousePressEvent(QMouseEvent* event) {
  RobotViewParts& p = *parts_;
  p.button = event->button();
  if (p.button == Qt::LeftButton && event->modifiers() & Qt::ShiftModifier) p.button = Qt::MiddleButton;
  p.pressed_at = p.last_at = event->position();
  p.has_moved = false;
}

void RobotView::mouseMoveEvent(QMouseEvent* event) {
  RobotViewParts& p = *parts_;
  if (!event->buttons()) {
    pick(event->position(), false);
    return;
  }
  if ((event->position() - p.pressed_at).manhattanLength() > 4) p.has_moved = true;
  if (!p.has_moved) return;
  const QPointF d = event->position() - p.last_at;
  p.last_at = event->position();
  if (p.button == Qt::LeftButton) p.by_hand().turn(-0.008 * d.x(), 0.008 * d.y());
  if (p.button == Qt::MiddleButton) p.by_hand().pan(d.x(), d.y(), height());
  if (p.button == Qt::RightButton) p.by_hand().zoom(std::exp(-0.008 * d.y()));
  change();
}

void RobotView::mouseReleaseEvent(QMouseEvent* event) {
  if (!parts_->has_moved && event->button() == Qt::LeftButton) {
    const auto face = face_at(parts_->cube(size()), event->position());
    face ? look(*face) : pick(event->position(), true);
  }
  parts_->button = Qt::NoButton;
  if (!parts_->has_moved && event->button() == Qt::RightButton) show_menu(event->globalPosition().toPoint());
}

void RobotView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) look(StandardView::all);
}

void RobotView::wheelEvent(QWheelEvent* event) {
  parts_->by_hand().zoom(std::pow(1.15, event->angleDelta().y() / 120.0));
  event->accept();
  change();
}

void RobotView::leaveEvent(QEvent*) {
  if (parts_->hovered != no_observation) {
    set_hovered_observation(no_observation);
    emit observation_hovered(no_observation);
  }
  emit read_out({});
}

void RobotView::keyPressEvent(QKeyEvent* event) {
  RobotViewParts& p = *parts_;
  const bool is_plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (!is_plain) return QWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_F:
      return look(StandardView::all);
    case Qt::Key_1:
      return look(StandardView::front);
    case Qt::Key_2:
      return look(StandardView::back);
    case Qt::Key_3:
      return look(StandardView::left);
    case Qt::Key_4:
      return look(StandardView::right);
    case Qt::Key_5:
      return look(StandardView::top);
    case Qt::Key_6:
      return look(StandardView::tcp);
    case Qt::Key_0:
      return look(StandardView::camera);
    case Qt::Key_Plus:
      p.by_hand().zoom(1.15);
      return change();
    case Qt::Key_Minus:
      p.by_hand().zoom(1 / 1.15);
      return change();
    case Qt::Key_Left:
      p.by_hand().turn(0.1, 0);
      return change();
    case Qt::Key_Right:
      p.by_hand().turn(-0.1, 0);
      return change();
    case Qt::Key_Up:
      p.by_hand().turn(0, 0.1);
      return change();
    case Qt::Key_Down:
      p.by_hand().turn(0, -0.1);
      return change();
    default:
      QWidget::keyPressEvent(event);
  }
}

void RobotView::contextMenuEvent(QContextMenuEvent* event) {
  // Of the mouse it comes when the button goes down, before anybody knows whether that begins a zoom.
  if (event->reason() != QContextMenuEvent::Mouse) show_menu(event->globalPos());
}

void RobotView::save_picture() {
  const QString path = QFileDialog::getSaveFileName(this, QObject::tr("Save the picture"), QStringLiteral("robot.png"),
                                                    QStringLiteral("PNG (*.png)"));
  if (path.isEmpty()) return;
  const QString reason = save(path);
  emit message(reason.isEmpty() ? QObject::tr("Saved %1.").arg(path) : reason);
}

QString RobotView::save(const QString& path) {
  QSaveFile file(path);
  // Of the robot, not of who looks at it.
  const ObservationId selected = parts_->selected, hovered = parts_->hovered;
  const QString joint = parts_->selected_joint;
  set_selected_observation(no_observation);
  set_hovered_observation(no_observation);
  set_selected_joint({});
  const QImage image = picture(2);
  set_selected_observation(selected);
  set_hovered_observation(hovered);
  set_selected_joint(joint);
  if (!file.open(QIODevice::WriteOnly) || !image.save(&file, "PNG") || !file.commit())
    return QObject::tr("%1 cannot be written: %2. Choose another folder.").arg(path, file.errorString());
  return {};
}

void RobotView::show_menu(const QPoint& position) {
  QMenu menu(this);
  menu.addAction(QObject::tr("See all"), this, [this] { look(StandardView::all); });
  menu.addAction(QObject::tr("See the TCP"), this, [this] { look(StandardView::tcp); });
  menu.addAction(QObject::tr("As the left camera sees it"), this, [this] { look(StandardView::camera); });
  menu.addSeparator();
  menu.addAction(QObject::tr("Copy the picture"), this, [this] { QApplication::clipboard()->setImage(picture(2)); });
  menu.addAction(QObject::tr("Save as %1 ...").arg(QStringLiteral("PNG")), this, &RobotView::save_picture);
  menu.exec(position);
}

}  // namespace handsight::widgets
