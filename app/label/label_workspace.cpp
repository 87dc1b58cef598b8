// SPDX-License-Identifier: GPL-3.0-or-later
#include "label/label_workspace.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>

#include "vision/corners/corner_detector.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/images/image_view.h"
#include "widgets/images/loupe.h"
#include "widgets/images/triangle_panel.h"
#include "words/counted.h"
#include "workbench/observation_views.h"
#include "workbench/session_parts.h"
#include "workbench/touch_views.h"

namespace handsight::app {

LabelWorkspace::LabelWorkspace(Workbench& workbench, QWidget* parent) : Workspace(workbench, parent) {
  setObjectName("label");
  make_layout();
  connect_left();
  connect_right();
  connect_panel();
  connect(&workbench.selection, &Selection::changed, this, [this] {
    if (is_active()) show_observation();
  });
  // What is shown is read again where it was changed elsewhere: corrected, undone, taken by a play.
  connect(&workbench.document, &Document::edited, this, [this](const std::vector<std::int64_t>& ids) {
    emit status_changed();
    if (is_own_edit_ || std::find(ids.begin(), ids.end(), observation_) == ids.end()) return;
    observation_ = -1;
    if (is_active()) show_observation();
  });
  connect(&workbench.document, &Document::draft_changed, this, [this](std::int64_t id) {
    if (is_own_edit_ || id != observation_) return;
    observation_ = -1;
    if (is_active()) show_observation();
  });
  connect(&workbench.images, &ImageSource::arrived, this, [this] {
    if (!was_coming_) return;
    observation_ = -1;
    if (is_active()) show_observation();
  });
  connect(&workbench, &Workbench::relabel_requested, this, [this](qint64 id) {
    workbench_.selection.select_observation(id);
    observation_ = -1;
  });
  connect(&workbench.document, &Document::closed, this, [this] {
    observation_ = corners_of_ = -1;
    corners_ = {};
    left_->clear({});
    right_->clear({});
  });
}

WorkStatus LabelWorkspace::status() const {
  const Session& s = workbench_.document.session();
  const auto labelled = std::count_if(s.observations.begin(), s.observations.end(), [](const Observation& o) {
    return std::any_of(o.sightings.begin(), o.sightings.end(),
                       [](const Sighting& x) { return x.by == MarkedBy::hand; });
  });
  if (is_joined(s)) return {WorkState::done, tr("in each session")};
  const bool any = std::any_of(s.observations.begin(), s.observations.end(),
                               [](const Observation& o) { return !o.sightings.empty(); });
  if (workbench_.document.session().is_touch()) return {WorkState::done, tr("needs no labels")};
  if (labelled > 0) return {WorkState::done, tr("%1 by hand").arg(labelled)};
  if (any) return {WorkState::done, tr("labels included")};
  if (s.target) return {WorkState::done, tr("needs no labels")};
  return {WorkState::open, tr("%1 wanted").arg(counted(std::min(3, s.marker_count), "%n marker(s)"))};
}

void LabelWorkspace::activate() { show_observation(); }

bool LabelWorkspace::key(QKeyEvent* event) {
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) return false;
  if (labeller_.will_do()) use();
  return true;
}

void LabelWorkspace::show_observation() {
  const Observation* o = workbench_.selected_observation();
  if (!o) {
    left_->clear(tr("Choose an observation in the strip."));
    right_->clear({});
    return;
  }
  if (o->id == observation_) return;
  const bool is_same = o->id == shown_;
  observation_ = shown_ = o->id;
  if (!is_same) marker_ = -1;
  sentence_.clear();
  can_take_back_ = false;
  nudged_ = -1;
  const Session& s = workbench_.document.session();
  labeller_.start(s, *o, corners_of_ == o->id ? corners_ : CornersOfPair{}, workbench_.document.find_draft(o->id));
  if (!labeller_.markers().contains(marker_)) marker_ = -1;
  const OwnSession own = take_own_session(s, o->part);
  const ShownImage left = workbench_.images.image(s, *o, own.first_camera),
                   right = workbench_.images.image(s, *o, own.first_camera + 1);
  const QString none = s.is_touch() ? tr("Touches have no images: there is nothing to label.") + '\n' +
                                          touched_text(s, *o, workbench_.row(o->id), workbench_.units)
                       : s.is_tracker() ? tr("A tracker session has no images; its markers are points already.")
                                        : tr("Observation %1 has no images to label.").arg(o->id);
  const auto show = [&](widgets::ImageView* view, widgets::Loupe* loupe, const ShownImage& shown, const QString& side,
                        const std::string& file) {
    view->set_title(file.empty() ? side : side + "  " + QString::fromStdString(std::filesystem::path(file).filename()));
    loupe->set_image(shown.image);
    loupe->set_center({});
    if (shown.image.isNull()) {
      const QString sentence = shown.is_coming           ? tr("The image is being read …")
                               : shown.refusal.isEmpty() ? none
                                                         : shown.refusal;
      view->clear(sentence);
      view->setAccessibleDescription(sentence);
    } else {
      view->setAccessibleDescription({});
      view->set_image(shown.image);
      if (!is_same || was_coming_) view->fit();
    }
  };
  is_labelled_here_ = !is_joined(s) && !s.is_touch() && (!s.rig || is_pair(*s.rig));
  const bool is_coming = left.is_coming || right.is_coming;
  const auto camera = [&](int c) {
    return c < own.camera_count ? camera_title(*s.rig, own.first_camera + c) : QString();
  };
  const auto file = [&](int c) {
    return c < own.camera_count ? o->images[static_cast<std::size_t>(own.first_camera + c)] : std::string();
  };
  show(left_, left_loupe_, left, camera(0), file(0));
  const bool has_second = own.camera_count != 1 && !s.is_touch();
  show(right_, right_loupe_, right, camera(1), file(1));
  was_coming_ = is_coming;
  for (QWidget* w : std::initializer_list<QWidget*>{right_, right_loupe_, together_}) w->setVisible(has_second);
  grid_->setColumnStretch(1, has_second ? 1 : 0);  // one image has the room of both
  // Of touches there is nothing to see but what was touched.
  for (QWidget* w : std::initializer_list<QWidget*>{left_loupe_, triangle_}) w->setVisible(!s.is_touch());
  for (widgets::ImageView* view : {left_, right_}) view->set_labelling(is_labelled_here_);
  hint_->setVisible(is_labelled_here_);
  refresh();
  if (is_labelled_here_ && corners_of_ != o->id && !left.image.isNull() && !right.image.isNull()) find_corners(o->id);
}

void LabelWorkspace::find_corners(std::int64_t id) {
  workbench_.background.start<CornersOfPair>(
      "corners", tr("Looking for corners"),
      [left = left_->image(), right = right_->image()](JobControl&) {
        return CornersOfPair{detect_corners(grey_image(left)), detect_corners(grey_image(right))};
      },
      [this, id](CornersOfPair corners) { corners_found(id, std::move(corners)); },
      [this](const QString& sentence) { say(sentence); });
}

void LabelWorkspace::corners_found(std::int64_t id, CornersOfPair corners) {
  if (id != observation_) return;
  corners_of_ = id;
  corners_ = std::move(corners);
  const Observation* o = workbench_.document.find(id);
  if (!o) return;
  labeller_.start(workbench_.document.session(), *o, corners_, workbench_.document.find_draft(id));
  refresh();
}

void LabelWorkspace::select_marker(int marker) {
  marker_ = marker;
  if (workbench_.selection.current().observation) {
    Selected s{.observation = workbench_.selection.current().observation};
    if (marker >= 0) s.marker = marker;
    workbench_.selection.select(s);
  }
  refresh();
}

void LabelWorkspace::say(const QString& sentence) {
  sentence_ = sentence;
  refresh_panel();
}

void LabelWorkspace::refresh() {
  std::vector<Vector2> left_corners, right_corners;
  for (const Corner& c : labeller_.corners().left) left_corners.push_back(c.position);
  for (const Corner& c : labeller_.corners().right) right_corners.push_back(c.position);
  left_->set_corners(std::move(left_corners));
  right_->set_corners(std::move(right_corners));
  std::vector<widgets::ImageMark> left_marks, right_marks;
  for (const auto& [number, m] : labeller_.markers()) {
    left_marks.push_back({.marker = number, .position = m.left.position});
    if (m.right) right_marks.push_back({.marker = number, .position = m.right->position});
  }
  const Session& s = workbench_.document.session();
  if (const Observation* o = workbench_.selected_observation(); o && s.rig && (is_joined(s) || !is_pair(*s.rig))) {
    const int first = take_own_session(s, o->part).first_camera;
    left_marks = label_marks(*o, first);
    right_marks = label_marks(*o, first + 1);
  }
  left_->set_marks(std::move(left_marks));
  right_->set_marks(std::move(right_marks));
  left_->set_selected_marker(marker_);
  right_->set_selected_marker(marker_);
  std::vector<widgets::ImageCandidate> candidates;
  std::vector<Vector2> line;
  const auto chosen = labeller_.markers().find(marker_);
  if (chosen != labeller_.markers().end()) {
    line = labeller_.epipolar_line(chosen->second.left.position);
    left_loupe_->set_center(chosen->second.left.position);
    if (chosen->second.right) right_loupe_->set_center(chosen->second.right->position);
    for (const LabelCandidate& c : labeller_.candidates(marker_))
      candidates.push_back(
          {.index = c.corner,
           .position = c.position,
           .label = tr("%1 px, %2 m").arg(widgets::fixed_text(c.distance, 1), widgets::fixed_text(c.depth, 2)),
           .is_taken = c.is_taken});
  }
  right_->set_epipolar_line(std::move(line));
  right_->set_candidates(std::move(candidates));
  refresh_panel();
}

void LabelWorkspace::refresh_panel() {
  widgets::TriangleState state;
  state.selected_marker = marker_;
  for (const auto& [number, m] : labeller_.markers()) {
    widgets::TriangleMarker t{.number = number, .has_left = true, .has_right = m.right.has_value()};
    if (m.point) {
      t.in_left_camera = m.point->point;
      t.depth_sigma_m = std::sqrt(m.point->covariance(2, 2));
      t.epipolar_distance = m.point->epipolar_distance;
    }
    state.markers.push_back(t);
  }
  for (auto a = labeller_.markers().begin(); a != labeller_.markers().end(); ++a)
    for (auto b = std::next(a); b != labeller_.markers().end(); ++b)
      if (a->second.point && b->second.point) {
        const auto sigma = labeller_.side_sigma(a->first, b->first);
        state.sides.push_back({a->first, b->first, 1e3 * (b->second.point->point - a->second.point->point).norm(),
                               sigma ? std::optional(1e3 * *sigma) : std::nullopt});
      }
  const int missing = labeller_.wanted() - static_cast<int>(labeller_.markers().size());
  const bool has_images = !left_->image().isNull();
  state.can_use = labeller_.will_do();
  state.can_discard = has_images || workbench_.document.session().observations.size() > 1;
  state.verdict = widgets::TriangleVerdict::waiting;
  if (can_take_back_) state.action = tr("As I clicked them");
  for (std::size_t m = 0; m < labeller_.known().in_body.size(); ++m)
    if (const auto& x = labeller_.known().in_body[m])
      state.known.push_back({.number = static_cast<int>(m), .in_left_camera = *x});
  if (!sentence_.isEmpty()) {
    state.verdict = widgets::TriangleVerdict::care;
    state.sentence = sentence_;
  } else if (!labeller_.refusal().isEmpty()) {
    state.verdict = widgets::TriangleVerdict::bad;
    state.sentence = labeller_.refusal();
  } else if (is_joined(workbench_.document.session())) {
    state.can_use = false;
    state.sentence = tr("Markers are clicked in one session: open it by itself.");
  } else if (const auto& rig = workbench_.document.session().rig; rig && !is_pair(*rig)) {
    state.can_use = false;
    state.sentence = tr("Markers are clicked in sessions of two cameras. These labels came with the session.");
  } else if (!has_images) {
    state.sentence = tr("Nothing to label here.");
  } else if (missing == labeller_.wanted()) {
    state.sentence =
        corners_of_ == observation_ ? tr("Click a marker's corner in the left image.") : tr("Looking for corners…");
  } else if (missing > 0) {
    state.sentence = missing == 1 ? tr("One more marker.") : tr("%1 more markers.").arg(missing);
  } else if (state.can_use) {
    state.verdict = widgets::TriangleVerdict::good;
    state.sentence = tr("This will do.");
  } else {
    state.verdict = widgets::TriangleVerdict::bad;
    state.sentence = tr("A marker has no partner in the right image. Choose it, then click its corner there.");
  }
  triangle_->set_state(std::move(state));
  std::vector<widgets::TriangleCandidate> rows;
  for (const LabelCandidate& c : labeller_.candidates(marker_)) {
    widgets::TriangleCandidate row{.index = c.corner, .distance = c.distance, .depth_m = c.depth};
    row.is_taken = c.is_taken;
    if (c.misfit_m)
      row.sides = c.is_taken || std::abs(*c.misfit_m) < 5e-5
                      ? tr("fits")
                      : tr("%1 mm").arg((*c.misfit_m > 0 ? "+" : "") + widgets::fixed_text(1e3 * *c.misfit_m, 0));
    rows.push_back(row);
  }
  triangle_->set_candidates(marker_, std::move(rows));
}

void LabelWorkspace::remember(const QString& sentence, std::int64_t join) {
  Edit edit = workbench_.document.edit_of_draft(sentence, observation_, labeller_.draft());
  edit.joins = join;
  is_own_edit_ = true;
  const bool is_done = workbench_.document.perform(std::move(edit));
  is_own_edit_ = false;
  if (!is_done) {  // what cannot be written down is not there
    observation_ = -1;
    return show_observation();
  }
  refresh();
}

void LabelWorkspace::placed(const Vector2& px, bool free) {
  can_take_back_ = false;
  sentence_ = labeller_.point(px, free);
  if (labeller_.placed() < 0) return refresh();
  marker_ = labeller_.placed();
  remember(tr("placed marker %1 of observation %2").arg(marker_).arg(observation_));
  number_by_sides();
}

/// Three corners in another order than in the other observations are the same markers still.
void LabelWorkspace::number_by_sides() {
  if (static_cast<int>(labeller_.markers().size()) < labeller_.wanted()) return;
  const std::map<int, int> numbers = labeller_.numbers_by_sides();
  if (numbers.empty()) return;
  QStringList order;
  for (const auto& [from, to] : numbers) order << QString::number(to);
  labeller_.renumber_all(numbers);
  if (const auto found = numbers.find(marker_); found != numbers.end()) marker_ = found->second;
  remember(tr("renumbered the markers of observation %1 by their sides").arg(observation_));
  sentence_ = tr("By their sides these are markers %1 of the other observations: renumbered.").arg(order.join(", "));
  can_take_back_ = true;
  refresh();
}

void LabelWorkspace::remove_marker(int marker) {
  can_take_back_ = false;
  labeller_.remove(marker);
  marker_ = -1;
  remember(tr("removed marker %1 of observation %2").arg(marker).arg(observation_));
}

void LabelWorkspace::renumber(int marker, int to) {
  can_take_back_ = false;
  labeller_.renumber(marker, to);
  if (labeller_.markers().contains(to)) marker_ = to;
  remember(tr("made marker %1 of observation %2 marker %3").arg(marker).arg(observation_).arg(to));
}

void LabelWorkspace::choose_partner(int corner) {
  labeller_.choose_partner(marker_, corner);
  remember(tr("chose the partner of marker %1 of observation %2").arg(marker_).arg(observation_));
}

void LabelWorkspace::use() {
  const Observation* o = workbench_.document.find(observation_);
  if (!o || !labeller_.will_do()) return;
  const EditableState after{labeller_.sightings(), Decision::none, ""};
  Edit edit = workbench_.document.make_edit(tr("labelled observation %1").arg(o->id), {{o->id, after}});
  if (edit.is_empty()) return workbench_.workspace_requested(Place::calibrate);
  edit.draft = workbench_.document.edit_of_draft({}, o->id, std::nullopt).draft;
  const auto& all = workbench_.document.session().observations;
  const bool is_first =
      std::none_of(all.begin(), all.end(), [](const Observation& x) { return x.decision == Decision::accepted; });
  const bool is_waited_for = workbench_.label_wanted.has_value();
  if (workbench_.document.perform(edit) && (is_first || is_waited_for))
    emit workbench_.workspace_requested(Place::calibrate);
}

void LabelWorkspace::next_observation() {
  const auto& all = workbench_.document.session().observations;
  const int index = workbench_.document.find_index(observation_);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const Observation& o = all[(static_cast<std::size_t>(std::max(0, index)) + k) % all.size()];
    const auto& rig = workbench_.document.session().rig;
    if (o.images[0].empty() || (rig && rig->count() > 1 && o.images[1].empty())) continue;
    workbench_.selection.select_observation(o.id);
    return;
  }
  say(tr("No other observation has images."));
}

std::vector<Action> LabelWorkspace::own_actions() const {
  const auto explained = [](const char* id, const QString& gesture, const QString& what) {
    return Action{.id = id, .group = tr("Label"), .text = what, .gesture = gesture};
  };
  return {explained("marker_snap", tr("Click, Alt+click"), tr("marker on the nearest corner, exactly there")),
          explained("marker_nudge", tr("Arrows, Shift+arrows"), tr("nudge the chosen marker by 0.1 px, 1 px")),
          explained("marker_number", tr("0 … 9, Delete"), tr("renumber, remove the chosen marker")),
          explained("labels_use", tr("Enter"), tr("use the labels"))};
}

}  // namespace handsight::app
