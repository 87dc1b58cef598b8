// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/robot_view.h"

#include <vtkLightKit.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QSurfaceFormat>
#include <QToolButton>
#include <utility>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/scene/robot_view_parts.h"

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
  // VTK's own warnings would go to the console; what matters is reported by notes().
  vtkObject::GlobalWarningDisplayOff();
}

RobotView::RobotView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<RobotViewParts>()) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(QObject::tr("Robot in 3D"));
  parts_->empty_text = QObject::tr("No robot yet.");
  connect(&parts_->reading_poll, &QTimer::timeout, this, &RobotView::finish_reading);
  parts_->still.setSingleShot(true);
  connect(&parts_->still, &QTimer::timeout, this, &RobotView::smooth_on);
  parts_->gl.window()->SetNumberOfLayers(2);
  parts_->gl.window()->AddRenderer(parts_->renderer);
  parts_->after->SetLayer(1);
  parts_->after->SetActiveCamera(parts_->renderer->GetActiveCamera());
  parts_->after->PreserveDepthBufferOn();
  parts_->gl.window()->AddRenderer(parts_->after);
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightWarmth(0.5);
  lights->SetFillLightWarmth(0.5);
  lights->SetKeyToFillRatio(2.2);
  lights->AddLightsToRenderer(parts_->renderer);
  parts_->buttons = new QWidget(this);
  parts_->buttons->setAutoFillBackground(true);  // over the robot, where it reaches so far
  parts_->buttons->setBackgroundRole(QPalette::Base);
  auto* row = new QHBoxLayout(parts_->buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  const std::array<std::pair<QString, StandardView>, 6> views = {
      std::pair{tr("All"), StandardView::all},     std::pair{tr("TCP"), StandardView::tcp},
      std::pair{tr("Front"), StandardView::front}, std::pair{tr("Side"), StandardView::left},
      std::pair{tr("Top"), StandardView::top},     std::pair{tr("Camera"), StandardView::camera}};
  for (const auto& [name, view] : views) {
    auto* button = new QToolButton(parts_->buttons);
    button->setText(name);
    button->setToolTip(tr("Looks from there (F, 1 to 6, 0)"));
    button->setAutoRaise(true);
    button->setFont(text_font(TextRole::small));
    button->setFixedHeight(row_height_px);
    button->setFocusPolicy(Qt::NoFocus);  // keys 0 to 6 do the same
    connect(button, &QToolButton::clicked, this, [this, v = view] { look(v); });
    row->addWidget(button);
  }
  show_buttons();
}

RobotView::~RobotView() { parts_->gl.release(); }

QSize RobotView::sizeHint() const { return {460, 400}; }
QSize RobotView::minimumSizeHint() const { return {240, 200}; }

void RobotView::set_robot(const Robot& robot, const std::filesystem::path& mesh_folder) {
  RobotViewParts& p = *parts_;
  p.robot = robot;
  p.posture.clear();
  p.bent.reset();
  show_buttons();
  if (p.reading.valid()) p.abandoned.push_back(std::move(p.reading));
  take_meshes({});
  if (!has_meshes(robot)) return;
  constexpr std::chrono::milliseconds moment(30), poll(20);
  p.reading = std::async(std::launch::async, [robot, mesh_folder] { return read_meshes(robot, mesh_folder); });
  if (p.reading.wait_for(moment) == std::future_status::ready) return take_meshes(p.reading.get());
  p.reading_poll.start(poll);
}

void RobotView::take_meshes(const ReadMeshes& meshes) {
  RobotViewParts& p = *parts_;
  p.read_links = make_robot_actors(p.robot, meshes);  // shown at the next picture
  p.links.notes = p.read_links.notes;
  p.robot_changed = p.wants_fit = true;
  change();
}

void RobotView::finish_reading() {
  RobotViewParts& p = *parts_;
  const auto is_ready = [](const std::future<ReadMeshes>& f) {
    return f.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  std::erase_if(p.abandoned, is_ready);
  if (p.reading.valid() && is_ready(p.reading)) {
    take_meshes(p.reading.get());
    emit notes_changed();
  }
  if (!p.reading.valid() && p.abandoned.empty()) p.reading_poll.stop();
}

bool RobotView::is_reading() const { return parts_->reading.valid(); }

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

void RobotView::set_interest(std::vector<Vector3> in_root) {
  parts_->interest = std::move(in_root);
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

void RobotView::set_other_hands(std::vector<SceneHand> hands) {
  parts_->other_hands = std::move(hands);
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

void RobotView::set_fixtures(std::vector<SceneFixture> fixtures) {
  parts_->fixtures = std::move(fixtures);
  parts_->marks_changed = true;
  change();
}

const std::vector<SceneFixture>& RobotView::fixtures() const { return parts_->fixtures; }

const std::vector<SceneArrow>& RobotView::arrows() const { return parts_->arrows; }

void RobotView::set_paths(std::vector<ScenePath> paths) {
  parts_->paths = std::move(paths);
  parts_->paths_changed = true;
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
  parts_->shown_size = QSizeF(size());
  parts_->look(view);
  parts_->wants_fit = false;
  change();
}

std::optional<QPointF> RobotView::to_screen(const Vector3& in_root) const { return parts_->to_screen(in_root, size()); }

std::optional<Vector3> RobotView::arrow_tip(ObservationId id) const {
  const SceneArrow* arrow = parts_->find_arrow(id);
  if (!arrow) return std::nullopt;
  return Vector3(arrow->from + parts_->arrow_times * arrow->residual);
}

QImage RobotView::picture(double scale) {
  const double ratio = scale > 0 ? scale : devicePixelRatioF();
  if (parts_->reading.valid()) {  // a picture is of the whole robot
    parts_->reading.wait();
    finish_reading();
  }
  draw((QSizeF(size()) * ratio).toSize());
  for (std::size_t i = 0; i < SmoothPicture::pictures; ++i) smooth();
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
  RobotViewParts& p = *parts_;
  if (!p.is_stale && p.picture.size() == size) return;
  if (!p.gl.make_ready()) {
    p.empty_text = QObject::tr("The 3D view needs OpenGL 3.2, which this display does not offer.");
    return;
  }
  if (p.is_framed && p.shown_size != QSizeF(this->size())) p.wants_fit = true;
  p.shown_size = QSizeF(this->size());
  p.make_ready();
  set_line_width(p.ghost, size.width() / std::max(1.0, p.shown_size.width()));
  p.picture = p.gl.picture(size);
  p.is_stale = false;
  p.smooth.begin_anew();
  p.still.stop();
}

void RobotView::smooth() {
  RobotViewParts& p = *parts_;
  if (p.gl.is_smooth() || p.smooth.is_done() || p.picture.isNull()) return;
  p.smooth.add(p.moved_picture(p.smooth.next_offset()));
  if (p.smooth.is_done()) p.picture = p.smooth.mean();
}

void RobotView::smooth_on() {
  RobotViewParts& p = *parts_;
  if (p.is_stale || !isVisible()) return;
  smooth();
  if (p.smooth.is_done()) return update();
  p.still.start(0);
}

void RobotView::paintEvent(QPaintEvent*) {
  const double ratio = devicePixelRatioF();
  QPainter painter(this);
  // OpenGL takes as long to load as all the rest of the window: that is shown first.
  if (!std::exchange(parts_->was_painted, true) && !parts_->gl.is_ready()) {
    painter.fillRect(rect(), colors().panel);
    QTimer::singleShot(0, this, [this] { update(); });
    return;
  }
  draw((QSizeF(size()) * ratio).toSize());
  constexpr std::chrono::milliseconds rest(150);
  if (!parts_->gl.is_smooth() && !parts_->smooth.is_done() && !parts_->still.isActive()) parts_->still.start(rest);
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
  show_buttons();
}

/// There is nothing to look at from anywhere before there is a robot.
void RobotView::show_buttons() {
  parts_->buttons->setVisible(!parts_->robot.links.empty() && parts_->buttons->width() + 8 < width());
}

void RobotView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && parts_) {
    parts_->theme_changed = true;
    change();
  }
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
