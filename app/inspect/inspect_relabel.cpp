// SPDX-License-Identifier: GPL-3.0-or-later
// Markers that are moved, renumbered or removed in Inspect's images.
#include <algorithm>

#include "inspect/inspect_workspace.h"
#include "inspect/snap.h"
#include "widgets/images/image_view.h"
#include "workbench/camera_strip.h"

namespace handsight::app {

/// While it is dragged only the mark moves; what is let go is the action.
void InspectWorkspace::relabel_in_place(int camera, int marker, const Vector2& px, bool finished, bool free) {
  const Observation* o = workbench_.selected_observation();
  if (!o || o->sightings.empty()) return;
  widgets::ImageView& view = cameras_->look_up_camera(left_) == camera ? *left_ : *right_;
  if (!finished) {
    std::vector<widgets::ImageMark> marks = view.marks();
    for (widgets::ImageMark& m : marks)
      if (m.marker == marker && m.role == widgets::MarkRole::measured) m.position = px;
    return view.set_marks(std::move(marks));
  }
  EditableState after = read_state(*o);
  for (Sighting& s : after.sightings) {
    if (s.marker != marker) continue;
    see(s, camera, free ? px : snapped(view.image(), px).value_or(px));  // without the sigma of what it was
    s.by = MarkedBy::hand;
  }
  relabel(tr("moved marker %1 of observation %2").arg(marker).arg(o->id), o->id, after);
}

void InspectWorkspace::relabel(const QString& sentence, std::int64_t id, const EditableState& after) {
  Edit edit = workbench_.document.make_edit(sentence, {{id, after}});
  if (edit.is_empty()) return refresh_observation();
  // Unfinished labels of before know nothing of it.
  edit.draft = workbench_.document.edit_of_draft({}, id, std::nullopt).draft;
  if (!workbench_.document.perform(std::move(edit))) refresh_observation();
}

void InspectWorkspace::remove_marker(int marker) {
  const Observation* o = workbench_.selected_observation();
  if (!o) return;
  EditableState after = read_state(*o);
  std::erase_if(after.sightings, [&](const Sighting& s) { return s.marker == marker; });
  relabel(tr("removed marker %1 of observation %2").arg(marker).arg(o->id), o->id, after);
}

void InspectWorkspace::renumber(int marker, int to) {
  const Observation* o = workbench_.selected_observation();
  if (!o) return;
  const int count = workbench_.document.session().marker_count;
  if (to >= count) {
    emit workbench_.document.noticed(
        tr("There is no marker %1: this session has markers 0 to %2.").arg(to).arg(count - 1));
    return;
  }
  EditableState after = read_state(*o);
  for (Sighting& s : after.sightings) s.marker = s.marker == marker ? to : s.marker == to ? marker : s.marker;
  std::sort(after.sightings.begin(), after.sightings.end(),
            [](const Sighting& a, const Sighting& b) { return a.marker < b.marker; });
  relabel(tr("made marker %1 of observation %2 marker %3").arg(marker).arg(o->id).arg(to), o->id, after);
}

}  // namespace handsight::app
