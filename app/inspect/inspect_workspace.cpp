// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/inspect_workspace.h"

#include <QAbstractProxyModel>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <algorithm>

#include "findings/explain_texts.h"
#include "findings/inspection_rows.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/images/image_view.h"
#include "widgets/lists/attribution_bar.h"
#include "widgets/lists/observation_table.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/plots/residual_map.h"
#include "widgets/scene/robot_view.h"
#include "workbench/camera_strip.h"
#include "workbench/link_selection.h"
#include "workbench/observation_views.h"
#include "workbench/touch_views.h"

namespace handsight::app {

InspectWorkspace::InspectWorkspace(Workbench& workbench, QWidget* parent) : Workspace(workbench, parent) {
  setObjectName("inspect");
  make_layout();
  connect_table();
  connect_images();
  connect_plots();
  connect_workbench();
}

std::vector<std::int64_t> InspectWorkspace::chosen() const {
  const auto& many = workbench_.selection.many();
  return {many.begin(), many.end()};
}

void InspectWorkspace::connect_table() {
  using widgets::ObservationTable;
  link_selection(table_, workbench_);
  connect(table_, &ObservationTable::exclude_requested, this, [this](const std::vector<qint64>& ids) {
    workbench_.exclude({ids.begin(), ids.end()});
  });
  connect(table_, &ObservationTable::include_requested, this, [this](const std::vector<qint64>& ids) {
    workbench_.include({ids.begin(), ids.end()});
  });
  connect(table_, &ObservationTable::relabel_requested, &workbench_, &Workbench::relabel_requested);
  connect(table_, &ObservationTable::empty_action_requested, this,
          [this] { emit workbench_.workspace_requested(Place::calibrate); });
  connect(exclude_, &QPushButton::clicked, this, [this] { workbench_.exclude(chosen()); });
  connect(include_, &QPushButton::clicked, this, [this] { workbench_.include(chosen()); });
  connect(relabel_, &QPushButton::clicked, this, [this] {
    if (const auto id = workbench_.selection.current().observation) emit workbench_.relabel_requested(*id);
  });
  connect(look_, &QPushButton::clicked, this, [this] {
    const InspectionRow* row = workbench_.selected_row();
    if (!row || row->worst_marker < 0) return;
    for (const MarkerResidual& m : row->markers) {
      if (m.marker != row->worst_marker) continue;
      if (row->worst_camera >= 0) cameras_->show_camera(row->worst_camera);
      for (const auto& [view, camera] : cameras_->shown())
        if (static_cast<std::size_t>(camera) < m.corners.size())
          if (const auto& seen = m.corners[static_cast<std::size_t>(camera)].measured) view->show_point(*seen, 4);
    }
  });
}

void InspectWorkspace::connect_images() {
  using widgets::ImageView;
  connect(cameras_, &CameraStrip::changed, this, &InspectWorkspace::refresh_observation);
  for (ImageView* view : {left_, right_}) {
    connect(view, &ImageView::read_out, &workbench_, &Workbench::pointed_at);
    connect(view, &ImageView::marker_selected, this, [this, view](int marker) {
      const auto id = workbench_.selection.current().observation;
      if (!id || marker < 0) return;
      workbench_.selection.select({.observation = id, .marker = marker, .camera = cameras_->look_up_camera(view)});
    });
    connect(view, &ImageView::marker_dragged, this,
            [this, view](int marker, const Vector2& px, bool finished, Qt::KeyboardModifiers keys) {
              relabel_in_place(cameras_->look_up_camera(view), marker, px, finished, keys.testFlag(Qt::AltModifier));
            });
    connect(view, &ImageView::marker_removed, this, &InspectWorkspace::remove_marker);
    connect(view, &ImageView::marker_renumbered, this, &InspectWorkspace::renumber);
    connect(view, &ImageView::marker_hovered, this, [this](int marker) {
      left_->set_hovered_marker(marker);
      right_->set_hovered_marker(marker);
    });
    connect(view, &ImageView::marker_nudged, this, [this, view](int marker, const Vector2& delta) {
      const Observation* o = workbench_.selected_observation();
      if (!o) return;
      const int camera = cameras_->look_up_camera(view);
      for (const Sighting& s : o->sightings)
        if (const CameraPoint* const px = seen_by(s, camera); s.marker == marker && px)
          return relabel_in_place(camera, marker, px->pixel + delta, true, true);
    });
  }
}

void InspectWorkspace::connect_plots() {
  using widgets::HistogramPlot;
  link_selection(histogram_, workbench_);
  link_selection(map_, workbench_);
  link_selection(scene_, workbench_);
  connect(histogram_, &HistogramPlot::threshold_changed, this, [this](double) {
    const auto beyond = histogram_->beyond_threshold();
    table_->set_highlighted(beyond);
    if (!beyond.empty()) workbench_.selection.select_many({beyond.begin(), beyond.end()});
  });
  connect(histogram_, &HistogramPlot::threshold_set, this, [this](double threshold, const std::vector<qint64>& ids) {
    try_threshold(threshold, {ids.begin(), ids.end()});
  });
  connect(exclude_beyond_, &QPushButton::clicked, this, [this] { workbench_.exclude(beyond_, beyond_the_threshold); });
}

void InspectWorkspace::try_threshold(double threshold, const std::vector<std::int64_t>& beyond) {
  beyond_ = beyond;
  exclude_beyond_->setEnabled(false);
  const ModelVersionPointer now = workbench_.document.model();
  if (beyond.empty() || !now || !now->fit) {
    beyond_text_->setText(tr("Nothing lies beyond %1.").arg(widgets::size_text({threshold, workbench_.units.unit()})));
    return;
  }
  Session without = workbench_.document.session();
  for (const std::int64_t id : beyond)
    without.observations[static_cast<std::size_t>(workbench_.document.find_index(id))].decision = Decision::excluded;
  workbench_.jobs.start<ModelVersionPointer>(
      "threshold", tr("Fitting without them"),
      [without, settings = workbench_.document.settings(), revision = now->revision](JobControl& control) {
        return make_version(without, settings, revision, {}, {}, going_on(control));
      },
      [this, now, beyond](const ModelVersionPointer& then) {
        if (then->revision != workbench_.document.revision()) return;
        beyond_text_->setText(exclusion_sentence(*now, *then, beyond.size(),
                                                 static_cast<std::size_t>(now->report->used), workbench_.units));
        exclude_beyond_->setEnabled(then->fit != nullptr);
      },
      [this](const QString& sentence) { beyond_text_->setText(sentence); });
}

void InspectWorkspace::connect_workbench() {
  connect(&workbench_.document, &Document::opened, this, [this] {
    robot_is_set_ = false;
    is_stale_ = true;
    histogram_->set_threshold(std::nullopt);  // that of another session
    beyond_.clear();
  });
  const auto stale = [this] {
    is_stale_ = true;
    emit status_changed();
    if (is_active()) refresh_all();
  };
  connect(&workbench_.document, &Document::model_changed, this, [this, stale] {
    exclude_beyond_->setEnabled(false);
    stale();
  });
  connect(&workbench_.units, &DisplayUnits::changed, this, stale);
  connect(&workbench_.sessions, &SessionFilter::changed, this, stale);
  connect(&workbench_.diagnosing, &Diagnosing::diagnosis_changed, this,
          [this] {  // what is missing is to blame here too
            emit status_changed();
            if (is_active()) refresh_observation();
          });
  connect(&workbench_.document, &Document::edited, this, [this] {
    if (is_active()) refresh_rows();
    is_stale_ = true;
  });
  connect(&workbench_.images, &ImageSource::arrived, this, [this] {
    if (is_active()) refresh_observation();
  });
  connect(&workbench_.selection, &Selection::changed, this, [this] {
    if (!is_active()) return;
    const auto id = workbench_.selection.current().observation.value_or(widgets::no_observation);
    table_->set_selected_many(chosen(), id);
    if (tabs_->currentIndex() == 0) {
      histogram_->set_selected(id);
    } else {
      map_->set_selected(id);
    }
    refresh_observation();
  });
  connect(tabs_, &QTabWidget::currentChanged, this, [this] {
    const auto id = workbench_.selection.current().observation.value_or(widgets::no_observation);
    histogram_->set_selected(id);
    map_->set_selected(id);
  });
  connect(&workbench_.selection, &Selection::hover_changed, this, [this] {
    if (!is_active()) return;
    const auto id = workbench_.selection.hovered().observation.value_or(widgets::no_observation);
    table_->set_hovered(id);
    if (map_->isVisible()) map_->set_hovered(id);
    scene_->set_hovered_observation(id);
  });
}

WorkStatus InspectWorkspace::status() const {
  const Inspection* all = workbench_.inspection();
  if (!all) return {WorkState::waiting, tr("waits for a fit")};
  const auto odd = std::count_if(all->rows.begin(), all->rows.end(), [](const InspectionRow& r) { return r.outlier; });
  const auto& observations = workbench_.document.session().observations;
  const auto rejected = std::count_if(observations.begin(), observations.end(),
                                      [](const Observation& o) { return o.decision == Decision::rejected; });
  const Story& story = workbench_.story();
  // Where many are beyond the noise the model is wrong, and the few that stand out of them are not what to say of it.
  WorkStatus beyond{WorkState::care, tr("%1 of %2 beyond 3 σ").arg(story.beyond).arg(story.used)};
  if (story.many_beyond()) return beyond;
  if (odd + rejected > 0) return {WorkState::care, tr("%1 odd").arg(odd + rejected)};
  if (story.beyond > 0) return beyond;  // which the histogram counts too
  if (!story.error.noise) return {WorkState::open, tr("noise unknown")};
  return {WorkState::done, tr("nothing odd")};
}

void InspectWorkspace::activate() {
  if (!robot_is_set_ && workbench_.document.is_open()) {
    const Session& s = workbench_.document.session();
    scene_->set_robot(s.robot, (folder(s) / s.robot_file).parent_path());
    robot_is_set_ = true;
  }
  if (is_stale_) {
    refresh_all();
  } else {
    refresh_observation();
  }
}

void InspectWorkspace::refresh_all() {
  is_stale_ = false;
  refresh_rows();
  refresh_plots();
  refresh_observation();
}

void InspectWorkspace::refresh_rows() {
  if (!workbench_.document.is_open()) return;
  const bool has_fit = workbench_.inspection() != nullptr;
  refresh_units();
  table_->set_rows(has_fit ? table_rows(workbench_) : std::vector<widgets::ObservationRow>{});
  table_->set_selected_many(chosen(), workbench_.selection.current().observation.value_or(widgets::no_observation));
}

/// A touch has one tip: in place of the worst marker stands what it touched.
static void name_columns(QAbstractItemModel& table, bool are_touches, widgets::SizeUnit unit) {
  constexpr int size = 1, worst = 4;
  const auto call = [&](int column, Qt::ItemDataRole role, const QString& name, bool is_otherwise) {
    table.setHeaderData(column, Qt::Horizontal, is_otherwise ? QVariant(name) : QVariant(), role);
  };
  call(worst, Qt::DisplayRole, QObject::tr("fixture"), are_touches);
  call(worst, Qt::ToolTipRole, QObject::tr("What was touched; sorts by how far off"), are_touches);
  call(size, Qt::ToolTipRole, QObject::tr("How far off along what was read, mm"),
       are_touches && unit == widgets::SizeUnit::millimetre);
}

void InspectWorkspace::refresh_units() {
  using widgets::SizeUnit;
  const DisplayUnits& units = workbench_.units;
  const SizeUnit unit = units.unit();
  // Beside the unit in force stands the other of px and mm.
  std::optional<SizeUnit> second = SizeUnit::millimetre;
  if (unit == SizeUnit::millimetre) second = units.has(SizeUnit::pixel) ? std::optional(SizeUnit::pixel) : std::nullopt;
  table_->set_units(unit, second);
  histogram_->set_unit(unit);
  map_->set_unit(unit);
  const bool are_touches = workbench_.document.session().is_touch();
  const Session& session = workbench_.document.session();
  histogram_->set_distance_name(are_touches           ? tr("off along the reading (mm)")
                                : session.pose_sensor ? tr("error of the pose (mm)")
                                                      : QString());
  // Through the filter columns cannot be named as long as there are no rows.
  const auto* filter = qobject_cast<QAbstractProxyModel*>(table_->view()->model());
  name_columns(*filter->sourceModel(), are_touches, unit);
  constexpr int degree = 3, worst = 4, of_a_name = 112;  // px
  // A tip and a marker alone are points, which have no turn; of one marker none is the worst, and a sensor of poses has
  // none.
  const bool is_one_marker = session.is_tracker() && session.marker_count == 1;
  table_->view()->setColumnHidden(degree, are_touches || is_one_marker);
  table_->view()->setColumnHidden(worst, !are_touches && (is_one_marker || session.pose_sensor));
  if (are_touches) table_->view()->setColumnWidth(worst, std::max(of_a_name, table_->view()->columnWidth(worst)));
}

void InspectWorkspace::refresh_plots() {
  const Inspection* all = workbench_.inspection();
  const Session& s = workbench_.document.session();
  histogram_->set_noise(all && all->noise ? std::optional((all->in_pixels ? 1 : 1e3) * *all->noise) : std::nullopt,
                        s.is_tracker() ? tr("mm") : tr("px"));
  histogram_->set_cells(workbench_.shown_cells());
  histogram_->fit();
  if (!histogram_->threshold()) {
    const auto noise = all ? noise_in(workbench_.units.unit(), *all) : std::nullopt;
    histogram_->set_threshold(noise ? std::optional(beyond_noise * *noise) : std::nullopt);
    beyond_text_->setText(tr("Drag the threshold: what lies beyond it can be excluded."));
    exclude_beyond_->setEnabled(false);
  }
  refresh_cameras();
  map_->set_points(map_points(workbench_));
  map_->fit();
  if (!all) return;
  scene_->set_arrows(scene_arrows(s, *all, workbench_.sessions));
  scene_->set_arrow_magnification(arrow_magnification(*all));
}

/// The choice of cameras over the image plane: of more than one.
void InspectWorkspace::refresh_cameras() {
  const auto& rig = workbench_.document.session().rig;
  images_->setVisible(rig || workbench_.document.session().is_touch());
  tabs_->setTabVisible(1, rig.has_value());
  const QStringList names = rig ? camera_names_in_words(*rig) : QStringList();
  map_camera_->setVisible(names.size() > 1);
  if (rig) map_->set_image_size(rig->at(0).camera.width, rig->at(0).camera.height);
  map_->set_camera_names(names);
  const QStringList wanted = QStringList(names.size() == 2 ? tr("both") : tr("all cameras")) + names;
  QStringList offered;
  for (int i = 0; i < map_camera_->count(); ++i) offered << map_camera_->itemText(i);
  if (offered == wanted) return;
  map_camera_->clear();
  map_camera_->addItems(wanted);
}

void InspectWorkspace::refresh_observation() {
  const Observation* o = workbench_.selected_observation();
  const InspectionRow* row = workbench_.selected_row();
  const auto ids = chosen();
  const auto any = [&](auto test) {
    return std::any_of(ids.begin(), ids.end(), [&](std::int64_t id) {
      const Observation* one = workbench_.document.find(id);
      return one && test(*one);
    });
  };
  exclude_->setEnabled(any([](const Observation& x) { return x.decision != Decision::excluded; }));
  include_->setEnabled(any([](const Observation& x) {
    return x.decision == Decision::excluded || (x.decision == Decision::rejected && !x.sightings.empty());
  }));
  look_->setEnabled(row && row->worst_marker >= 0 && o && !o->images[0].empty());
  const auto& rig = workbench_.document.session().rig;
  relabel_->setEnabled(o && !o->images[0].empty() && rig && is_pair(*rig));
  attribution_->set_sentence(attribution_sentence(workbench_, row, o));
  const bool is_noise = row && row->ratio && *row->ratio < widgets::noise_limit(row->coordinates);
  const Session& s = workbench_.document.session();
  attribution_->set_none_text(is_noise                     ? tr("Nothing stands out of the noise")
                              : row && !row->ratio         ? QObject::tr("whose fault: noise unknown")
                              : row && s.is_touch()        ? tr("Cannot be split by touches")
                              : row && s.marker_count == 1 ? cannot_be_split_text()
                                                           : QString());
  attribution_->set_attribution(row ? shown_attribution(workbench_, *row) : std::nullopt);
  if (!o) {
    left_->clear(tr("Choose an observation in the strip, a plot or the 3D view."));
    right_->clear({});
    return;
  }
  show_images(workbench_, *o, row, cameras_->shown(), true);
  const Inspection* all = workbench_.inspection();
  const double times = row && rig ? magnification_over_noise(row->worst_size, all->noise, 60) : 1;
  left_->set_magnification(times);
  right_->set_magnification(times);
  show_pose(workbench_.document, *o, row, *scene_);
  scene_->set_ghost_magnification(
      row && row->tcp_from_tcp_est
          ? magnification_over_noise(row->tcp_from_tcp_est->translation.norm(), all->noise_m, 0.05)
          : 1);
}

std::vector<Action> InspectWorkspace::own_actions() const {
  const auto explained = [](const char* id, const QString& gesture, const QString& what) {
    return Action{.id = id, .group = tr("Inspect"), .text = what, .gesture = gesture};
  };
  return {explained("inspect_keys", tr("Delete, Insert"), tr("exclude, include the chosen observations")),
          explained("inspect_marker", tr("0 … 9, Delete on a marker"), tr("renumber, remove it"))};
}

}  // namespace handsight::app
