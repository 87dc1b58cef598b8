// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/observation_strip.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/base/tool_tip.h"

namespace handsight::widgets {
namespace {

constexpr double outer_margin = 8, top_margin = 4, cells_height = 34, widest = 96;

}  // namespace

ObservationStrip::ObservationStrip(QWidget* parent)
    : QWidget(parent), empty_text_(QObject::tr("No observations yet.")) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(QObject::tr("Observation strip"));
}

QSize ObservationStrip::sizeHint() const { return {1152, 74}; }
QSize ObservationStrip::minimumSizeHint() const { return {240, 74}; }

void ObservationStrip::set_cells(std::vector<ObservationCell> cells) {
  cells_ = std::move(cells);
  if (find_index(hovered_) < 0) hovered_ = no_observation;
  clamp_view();
  invalidate();
}

void ObservationStrip::set_cell(const ObservationCell& cell) {
  const int index = find_index(cell.id);
  if (index < 0)
    cells_.push_back(cell);
  else
    cells_[static_cast<std::size_t>(index)] = cell;
  clamp_view();
  invalidate();
}

void ObservationStrip::set_selected(ObservationId id) {
  if (id == selected_) return;
  selected_ = id;
  const int index = find_index(id);
  if (index >= 0) show_index(index);
  setAccessibleDescription(index >= 0 ? cell_text(cells_[static_cast<std::size_t>(index)]) : QString());
  update();
}

void ObservationStrip::set_hovered(ObservationId id) {
  if (id == hovered_) return;
  hovered_ = id;
  update();
}

void ObservationStrip::set_highlighted(std::vector<ObservationId> ids) {
  std::sort(ids.begin(), ids.end());
  highlighted_ = std::move(ids);
  update();
}

void ObservationStrip::set_session_names(const QStringList& names) {
  session_names_ = names;
  invalidate();
}

void ObservationStrip::set_empty_text(const QString& sentence) {
  empty_text_ = sentence;
  update();
}

int ObservationStrip::find_index(ObservationId id) const {
  if (id < 0) return -1;
  // Ids are mostly in order of time: look there first, then everywhere.
  const auto is_it = [id](const ObservationCell& c) { return c.id == id; };
  const auto near = std::lower_bound(cells_.begin(), cells_.end(), id,
                                     [](const ObservationCell& c, ObservationId other) { return c.id < other; });
  if (near != cells_.end() && near->id == id) return static_cast<int>(near - cells_.begin());
  const auto found = std::find_if(cells_.begin(), cells_.end(), is_it);
  return found == cells_.end() ? -1 : static_cast<int>(found - cells_.begin());
}

QRectF ObservationStrip::cells_area() const {
  return {outer_margin, top_margin, width() - 2 * outer_margin, cells_height};
}

double ObservationStrip::cell_width() const {
  if (cells_.empty()) return widest;
  const double all = cells_area().width() / static_cast<double>(cells_.size());
  return std::min(all, widest) * zoom_;
}

double ObservationStrip::find_left(int index) const { return cells_area().left() + (index - first_) * cell_width(); }

int ObservationStrip::index_at(double x) const {
  const int index = static_cast<int>(std::floor((x - cells_area().left()) / cell_width() + first_));
  return index < 0 || index >= static_cast<int>(cells_.size()) ? -1 : index;
}

ObservationId ObservationStrip::cell_at(const QPointF& position) const {
  if (!cells_area().adjusted(0, -top_margin, 0, 4).contains(position)) return no_observation;
  const int index = index_at(position.x());
  return index < 0 ? no_observation : cells_[static_cast<std::size_t>(index)].id;
}

QRectF ObservationStrip::cell_rect(ObservationId id) const {
  const int index = find_index(id);
  if (index < 0) return {};
  const QRectF area = cells_area();
  return QRectF(find_left(index), area.top(), cell_width(), area.height()).intersected(area);
}

void ObservationStrip::show_index(int index) {
  const double shown = cells_area().width() / cell_width();
  const double before = first_;
  if (index < first_) first_ = index;
  if (index + 1 > first_ + shown) first_ = index + 1 - shown;
  clamp_view();
  if (first_ != before) invalidate();
}

void ObservationStrip::clamp_view() {
  const double most = static_cast<double>(cells_.size()) - cells_area().width() / cell_width();
  first_ = std::clamp(first_, 0.0, std::max(most, 0.0));
}

void ObservationStrip::invalidate() {
  is_stale_ = true;
  update();
}

void ObservationStrip::take(int index) {
  if (index < 0 || index >= static_cast<int>(cells_.size())) return;
  const ObservationId id = cells_[static_cast<std::size_t>(index)].id;
  show_index(index);
  if (id == selected_) return;
  selected_ = id;
  update();
  emit observation_selected(id);
}

void ObservationStrip::resizeEvent(QResizeEvent*) {
  clamp_view();
  invalidate();
}

void ObservationStrip::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) invalidate();
  QWidget::changeEvent(event);
}

void ObservationStrip::mousePressEvent(QMouseEvent* event) {
  const int index = index_at(event->position().x());
  if (event->button() == Qt::MiddleButton) {
    pan_x_ = event->position().x();
    pan_first_ = first_;
  } else if (event->button() == Qt::LeftButton && cell_at(event->position()) >= 0) {
    if (event->modifiers() & Qt::ShiftModifier) {
      brush_from_ = std::max(find_index(selected_), 0);
      brush_to_ = index;
      is_brushing_ = true;
      update();
    } else {
      brush_from_ = brush_to_ = index;
      is_brushing_ = false;
      take(index);
    }
  }
}

void ObservationStrip::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (event->buttons() & Qt::MiddleButton) {
    first_ = pan_first_ - (x - pan_x_) / cell_width();
    clamp_view();
    invalidate();
    return;
  }
  if ((event->buttons() & Qt::LeftButton) && brush_from_ >= 0) {
    const QRectF area = cells_area();
    const int index = index_at(std::clamp(x, area.left(), area.right() - 0.01));
    if (index >= 0 && index != brush_to_) {
      brush_to_ = index;
      is_brushing_ = true;
      update();
    }
  }
  const ObservationId id = cell_at(event->position());
  if (id == hovered_) {
    if (cell_width() < 4) update();  // the lens follows the pointer
    return;
  }
  hovered_ = id;
  update();
  emit observation_hovered(id);
}

void ObservationStrip::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || brush_from_ < 0) return;
  if (is_brushing_ && brush_to_ >= 0) {
    std::vector<qint64> ids;
    for (int i = std::min(brush_from_, brush_to_); i <= std::max(brush_from_, brush_to_); ++i)
      ids.push_back(cells_[static_cast<std::size_t>(i)].id);
    emit observations_selected(ids);
  }
  brush_from_ = brush_to_ = -1;
  is_brushing_ = false;
  update();
}

void ObservationStrip::leaveEvent(QEvent*) {
  if (hovered_ == no_observation) return;
  hovered_ = no_observation;
  update();
  emit observation_hovered(no_observation);
}

void ObservationStrip::wheelEvent(QWheelEvent* event) {
  if (cells_.empty()) return;
  const double turns = event->angleDelta().y() / 120.0;
  const double x = event->position().x();
  const double under = (x - cells_area().left()) / cell_width() + first_;
  const double one = cell_width() / zoom_;
  zoom_ = std::clamp(zoom_ * std::pow(1.25, turns), 1.0, std::max(widest / one, 1.0));
  first_ = under - (x - cells_area().left()) / cell_width();
  clamp_view();
  invalidate();
  event->accept();
}

void ObservationStrip::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(cells_.size()) - 1;
  const int at = find_index(selected_);
  switch (event->key()) {
    case Qt::Key_Left:
      return take(at < 0 ? last : std::max(at - 1, 0));
    case Qt::Key_Right:
      return take(std::min(at + 1, last));
    case Qt::Key_PageUp:
      return take(std::max(at - 10, 0));
    case Qt::Key_PageDown:
      return take(std::min(at + 10, last));
    case Qt::Key_Home:
      return take(0);
    case Qt::Key_End:
      return take(last);
    default:
      QWidget::keyPressEvent(event);
  }
}

bool ObservationStrip::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int index = find_index(cell_at(help->pos()));
    show_tip(this, *help, rect(), index < 0 ? QString() : cell_text(cells_[static_cast<std::size_t>(index)]));
    return true;
  }
  return QWidget::event(event);
}

}  // namespace handsight::widgets
