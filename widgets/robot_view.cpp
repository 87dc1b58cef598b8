// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/robot_view.h"

#include <vtkLightKit.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QSurfaceFormat>
#include <QToolButton>

#include "widgets/paint_tools.h"
#include "widgets/robot_view_parts.h"
#include "widgets/theme.h"

namespace handsight::widgets {

void set_surface_format() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  // VTK's own warnings would go to the console; what matters is told by notes().
  vtkObject::GlobalWarningDisplayOff();
}

RobotView::RobotView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>()) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(QObject::tr("Robot in 3D"));
  parts_->empty_text = QObject::tr("No robot yet.");
  parts_->gl.window()->AddRenderer(parts_->renderer);
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightWarmth(0.5);
  lights->SetFillLightWarmth(0.5);
  lights->SetKeyToFillRatio(2.2);
  lights->AddLightsToRenderer(parts_->renderer);
  parts_->buttons = new QWidget(this);
  auto* row = new QHBoxLayout(parts_->buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  const std::array<std::pair<const char*, StandardView>, 6> views = {
      std::pair{"All", StandardView::all},     std::pair{"TCP", StandardView::tcp},
      std::pair{"Front", StandardView::front}, std::pair{"Side", StandardView::left},
      std::pair{"Top", StandardView::top},     std::pair{"Camera", StandardView::camera}};
  for (const auto& [name, view] : views) {
    auto* button = new QToolButton(parts_->buttons);
    button->setText(QString::fromLatin1(name));
    button->setToolTip(tr("Looks from there (F, 1 to 6, 0)"));
    button->setAutoRaise(true);
    button->setFont(text_font(TextRole::small));
    button->setFixedHeight(kRowHeight);
    button->setFocusPolicy(Qt::NoFocus);  // keys 0 to 6 do the same
    connect(button, &QToolButton::clicked, this, [this, v = view] { look(v); });
    row->addWidget(button);
  }
}

RobotView::~RobotView() { parts_->gl.release(); }

QSize RobotView::sizeHint() const { return {460, 400}; }
QSize RobotView::minimumSizeHint() const { return {240, 200}; }

void RobotView::set_robot(const Robot& robot, const std::filesystem::path& mesh_folder) {
  Parts& p = *parts_;
  p.robot = robot;
  p.mesh_folder = mesh_folder;
  p.robot_changed = true;
  p.posture.clear();
  p.bent.reset();
  p.wants_fit = true;
  // Read at once, so that notes() knows; shown at the next picture.
  p.links.notes = make_robot_actors(robot, mesh_folder).notes;
  change();
}

const std::vector<QString>& RobotView::notes() const { return parts_->links.notes; }

void RobotView::set_posture(const std::vector<Rigid>& root_from_link) {
  parts_->posture = root_from_link;
  parts_->posture_changed = true;
  change();
}

void RobotView::set_ghost(const std::optional<std::vector<Rigid>>& root_from_link) {
  parts_->bent = root_from_link;
  parts_->ghost_changed = true;
  change();
}

void RobotView::set_ghost_magnification(double times) {
  parts_->ghost_times = times;
  parts_->ghost_changed = true;
  change();
}

void RobotView::set_cameras(std::vector<SceneCamera> cameras) {
  parts_->cameras = std::move(cameras);
  parts_->marks_changed = true;
  change();
}

void RobotView::set_tcp(const std::optional<Rigid>& root_from_tcp) {
  parts_->tcp = root_from_tcp;
  parts_->marks_changed = true;
  change();
}

void RobotView::set_tcp_est(const std::optional<Rigid>& root_from_tcp_est) {
  parts_->tcp_est = root_from_tcp_est;
  parts_->marks_changed = true;
  change();
}

void RobotView::set_markers(std::vector<SceneMarker> markers) {
  parts_->markers = std::move(markers);
  parts_->marks_changed = true;
  change();
}

void RobotView::set_arrows(std::vector<SceneArrow> arrows) {
  parts_->arrows = std::move(arrows);
  parts_->arrows_changed = true;
  change();
}

void RobotView::set_arrow_magnification(double times) {
  parts_->arrow_times = times;
  parts_->arrows_changed = true;
  change();
}

void RobotView::set_ellipsoid(const std::optional<SceneEllipsoid>& ellipsoid) {
  parts_->ellipsoid = ellipsoid;
  parts_->marks_changed = true;
  change();
}

void RobotView::set_selected_observation(ObservationId id) {
  if (id == parts_->selected) return;
  parts_->selected = id;
  parts_->rings_changed = true;
  change();
}

void RobotView::set_hovered_observation(ObservationId id) {
  if (id == parts_->hovered) return;
  parts_->hovered = id;
  parts_->rings_changed = true;
  change();
}

void RobotView::set_selected_joint(const QString& joint) {
  if (joint == parts_->selected_joint) return;
  parts_->selected_joint = joint;
  parts_->theme_changed = true;
  change();
}

void RobotView::set_empty_text(const QString& sentence) {
  parts_->empty_text = sentence;
  update();
}

void RobotView::look(StandardView view) {
  parts_->look(view);
  parts_->wants_fit = false;
  change();
}

std::optional<QPointF> RobotView::to_screen(const Vector3& in_root) const { return parts_->to_screen(in_root, size()); }

std::optional<Vector3> RobotView::arrow_tip(ObservationId id) const {
  const SceneArrow* arrow = parts_->arrow_of(id);
  if (!arrow) return std::nullopt;
  return Vector3(arrow->from + parts_->arrow_times * arrow->residual);
}

QImage RobotView::picture(double scale) {
  const double ratio = scale > 0 ? scale : devicePixelRatioF();
  draw((QSizeF(size()) * ratio).toSize());
  QImage image = parts_->picture;
  if (image.isNull())
    image = QImage((QSizeF(size()) * ratio).toSize(), QImage::Format_RGB32), image.fill(colors().panel);
  image.setDevicePixelRatio(ratio);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_labels(painter);
  return image;
}

void RobotView::change() {
  parts_->is_stale = true;
  update();
}

void RobotView::draw(const QSize& size) {
  Parts& p = *parts_;
  if (!p.is_stale && p.picture.size() == size) return;
  if (!p.gl.make_ready()) {
    p.empty_text = QObject::tr("The 3D view needs OpenGL 3.2, which this display does not offer.");
    return;
  }
  p.aspect = size.height() > 0 ? static_cast<double>(size.width()) / size.height() : 1;
  p.make_ready();
  p.picture = p.gl.picture(size);
  p.is_stale = false;
}

void RobotView::paintEvent(QPaintEvent*) {
  const double ratio = devicePixelRatioF();
  draw((QSizeF(size()) * ratio).toSize());
  QPainter painter(this);
  if (parts_->picture.isNull()) {
    painter.fillRect(rect(), colors().panel);
    draw_sentence(painter, rect(), parts_->empty_text);
    return;
  }
  painter.drawImage(QRectF(rect()), parts_->picture);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_labels(painter);
}

void RobotView::resizeEvent(QResizeEvent*) {
  parts_->buttons->adjustSize();
  parts_->buttons->move(width() - parts_->buttons->width() - 4, 2);
  parts_->buttons->setVisible(parts_->buttons->width() + 8 < width());
}

void RobotView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && parts_) {
    parts_->theme_changed = true;
    change();
  }
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
