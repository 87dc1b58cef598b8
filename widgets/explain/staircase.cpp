// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/staircase.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/base/motion.h"
#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/base/tool_tip.h"
#include "widgets/explain/staircase_paint.h"

namespace handsight::widgets {
namespace {

constexpr double most_slot = 72;

}  // namespace

Staircase::Staircase(QWidget* parent) : QWidget(parent), empty_text_(tr("No version of the model yet.")) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Error of each version of the model"));
  animation_.setDuration(short_motion);
  animation_.setStartValue(0.0);
  animation_.setEndValue(1.0);
  animation_.setEasingCurve(QEasingCurve::OutCubic);
  connect(&animation_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    fallen_ = value.toDouble();
    update();
  });
}

void Staircase::set_state(StaircaseState state) {
  const bool is_longer = !state_.versions.empty() && state.versions.size() == state_.versions.size() + 1;
  state_ = std::move(state);
  hovered_ = -1;
  animation_.stop();
  fallen_ = 1;
  falling_ = is_longer ? static_cast<int>(state_.versions.size()) - 1 : -1;
  if (is_longer && !motion_is_reduced() && isVisible()) {
    fallen_ = 0;
    animation_.start();
  }
  update();
}

void Staircase::set_preview(std::optional<VersionStep> step) {
  state_.preview = std::move(step);
  update();
}

void Staircase::set_empty_text(const QString& sentence) {
  empty_text_ = sentence;
  update();
}

QSize Staircase::sizeHint() const { return {332, 172}; }
QSize Staircase::minimumSizeHint() const { return {160, 96}; }

QRectF Staircase::area() const { return {44, 22, width() - 44.0 - layout_gap, height() - 22.0 - 20}; }

int Staircase::current() const {
  if (state_.current >= 0) return state_.current;
  for (int i = static_cast<int>(state_.versions.size()) - 1; i >= 0; --i)
    if (!state_.versions[static_cast<std::size_t>(i)].is_refused) return i;
  return -1;
}

QRectF Staircase::step_rect(int version) const {
  // One place more, so that the next step, tried or taken, does not move those that are there.
  const int count = static_cast<int>(state_.versions.size()), places = std::max(count + 1, 4);
  if (version < 0 || version >= places) return {};
  const QRectF room = area();
  const double wide = std::min(room.width() / places, most_slot);
  return {room.left() + version * wide, room.top(), wide, room.height()};
}

int Staircase::step_at(const QPointF& position) const {
  for (int i = 0; i < static_cast<int>(state_.versions.size()); ++i)
    if (step_rect(i).adjusted(0, 0, 0, 20).contains(position)) return i;
  return -1;
}

QString Staircase::step_text(int version) const {
  const VersionStep& step = state_.versions[static_cast<std::size_t>(version)];
  QString text =
      tr("%1: held out %2, fitted %3")
          .arg(step.name, with_unit_text(step.held_out, state_.unit), with_unit_text(step.fitted, state_.unit));
  if (step.is_refused) text += tr(", not added");
  if (!step.reason.isEmpty()) text += QStringLiteral(": ") + step.reason;
  return text;
}

StaircaseScene Staircase::scene() const {
  StaircaseScene scene{&state_, area(), {}, {}, current(), hovered_, fallen_ < 1 ? falling_ : -1, fallen_};
  double low = 1e300, high = 0;
  const auto see = [&](std::optional<double> value) {
    if (!value || !(*value > 0)) return;
    low = std::min(low, *value);
    high = std::max(high, *value);
  };
  for (const VersionStep& step : state_.versions) see(step.fitted), see(step.held_out);
  if (state_.noise && *state_.noise > 0) see(*state_.noise / 1.3);  // room for the floor
  scene.axis = LogAxis::over(low, high, scene.area.bottom(), scene.area.top());
  for (int i = 0; i <= static_cast<int>(state_.versions.size()); ++i) scene.slots_.push_back(step_rect(i));
  return scene;
}

void Staircase::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), c.panel);
  if (state_.versions.empty())
    draw_sentence(painter, rect(), empty_text_);
  else
    paint_staircase(painter, scene(), width());
  if (hasFocus()) draw_focus(painter, rect());
}

void Staircase::mark(int version, bool as_b) {
  (as_b ? state_.compared_b : state_.compared_a) = version;
  int& other = as_b ? state_.compared_a : state_.compared_b;
  if (other == version) other = -1;
  update();
  emit compared(state_.compared_a, state_.compared_b);
}

void Staircase::mousePressEvent(QMouseEvent* event) {
  const int step = step_at(event->position());
  if (event->button() != Qt::LeftButton || step < 0) return;
  if (event->modifiers() & Qt::ControlModifier)
    mark(step, state_.compared_a >= 0 && state_.compared_a != step);
  else
    emit version_selected(step);
}

void Staircase::mouseMoveEvent(QMouseEvent* event) {
  const int step = step_at(event->position());
  if (step == hovered_) return;
  hovered_ = step;
  emit read_out(step < 0 ? QString() : step_text(step));
  update();
}

void Staircase::leaveEvent(QEvent*) {
  if (hovered_ < 0) return;
  hovered_ = -1;
  emit read_out({});
  update();
}

void Staircase::keyPressEvent(QKeyEvent* event) {
  const int count = static_cast<int>(state_.versions.size()), now = current();
  int to = -1;
  switch (event->key()) {
    case Qt::Key_Left:
      to = now - 1;
      break;
    case Qt::Key_Right:
      to = now + 1;
      break;
    case Qt::Key_Home:
      to = 0;
      break;
    case Qt::Key_End:
      to = count - 1;
      break;
    case Qt::Key_A:
    case Qt::Key_B:
      if (now >= 0) mark(now, event->key() == Qt::Key_B);
      return;
    default:
      return QWidget::keyPressEvent(event);
  }
  if (to >= 0 && to < count && to != now) emit version_selected(to);
}

bool Staircase::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int step = step_at(help->pos());
  show_tip(this, *help, rect(),
           step >= 0 ? step_text(step)
                     : tr("The error of each version on observations that the fit has not seen, and on those "
                          "that it has. A gap between the two is over-fitting. Ctrl and click marks two "
                          "versions for a comparison."));
  return true;
}

}  // namespace handsight::widgets
