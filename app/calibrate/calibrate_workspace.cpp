// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/calibrate_workspace.h"

#include <QKeyEvent>
#include <QTabWidget>

#include "calibrate/fixtures_page.h"
#include "calibrate/hands_page.h"
#include "calibrate/objective_page.h"
#include "calibrate/one_marker_page.h"
#include "calibrate/own_pose_page.h"
#include "calibrate/transport.h"
#include "findings/recall.h"
#include "widgets/images/image_view.h"
#include "widgets/lists/decision_list.h"
#include "widgets/plots/convergence_plot.h"
#include "widgets/scene/robot_view.h"
#include "words/core_words.h"
#include "workbench/camera_strip.h"
#include "workbench/link_selection.h"
#include "workbench/observation_views.h"
#include "workbench/session_parts.h"

namespace handsight::app {
namespace {

/// With the error against `row`: the present model's where there is one, else that of the moment of the decision.
widgets::DecisionEntry find_entry(const PlayedStep& played, const InspectionRow* row, const DisplayUnits& units) {
  widgets::DecisionEntry e{.id = played.step.id, .reason = translated(played.step.reason)};
  e.state = played.step.accepted ? widgets::CellState::used : widgets::CellState::rejected;
  if (!row) row = &played.row;
  if (!row->markers.empty()) {
    e.size = units.shown(measure_size(*row));
    e.rms_over_sigma = row->ratio;
    e.coordinates = row->coordinates;
  }
  return e;
}

/// A decision as the session remembers it.
PlayedStep decided(const Observation& o) {
  PlayedStep played;
  played.step.id = o.id;
  played.step.accepted = o.decision == Decision::accepted;
  played.step.reason = o.reason;
  return played;
}

}  // namespace

CalibrateWorkspace::CalibrateWorkspace(Workbench& workbench, QWidget* parent)
    : Workspace(workbench, parent), player_(workbench) {
  setObjectName("calibrate");
  make_layout();
  connect_player();
  connect_selection();
  refresh_transport();
}

void CalibrateWorkspace::connect_player() {
  connect(&player_, &Player::stepped, this, [this](const std::vector<PlayedStep>& played) {
    unshown_.insert(unshown_.end(), played.begin(), played.end());
    if (!player_.is_playing()) {
      show_played();
    } else if (!show_timer_.isActive()) {
      show_timer_.start(100);
    }
  });
  show_timer_.setSingleShot(true);
  connect(&show_timer_, &QTimer::timeout, this, &CalibrateWorkspace::show_played);
  connect(&player_, &Player::rewound, this, [this] {
    unshown_.clear();
    shown_.clear();
    board_->set_points({});
    decisions_->set_entries({});
  });
  connect(&player_, &Player::state_changed, this, [this] {
    if (!player_.is_playing()) {
      show_played();
    } else if (!show_timer_.isActive()) {
      show_timer_.start(100);
    }
  });
}

void CalibrateWorkspace::show_played() {
  if (unshown_.empty()) {
    refresh_transport();
    return;
  }
  // Some may have been decided after all: then everything is shown anew, in its place. So it is where the decisions of
  // an earlier play are shown.
  const bool is_anew = shown_.empty() || std::any_of(unshown_.begin(), unshown_.end(), [this](const PlayedStep& p) {
                         return !shown_.insert(p.step.id).second;
                       });
  for (const PlayedStep& p : unshown_) shown_.insert(p.step.id);
  const std::vector<PlayedStep>& news = is_anew ? player_.steps() : unshown_;
  std::vector<widgets::ConvergencePoint> points;
  std::vector<widgets::DecisionEntry> entries;
  for (const PlayedStep& played : news) {
    if (played.step.has_estimate && played.step.accepted) points.push_back(convergence_point(played.step));
    entries.push_back(find_entry(played, nullptr, workbench_.units));
  }
  refresh_decision_title(false);
  if (is_anew) {
    board_->set_points(points);
    decisions_->set_entries(std::move(entries));
  } else {
    board_->append(points);
    decisions_->append(entries);
  }
  const std::int64_t last = unshown_.back().step.id;
  unshown_.clear();
  workbench_.selection.select_observation(last);
  if (is_active()) refresh_observation();
  refresh_transport();
}

void CalibrateWorkspace::connect_selection() {
  link_selection(board_, workbench_);
  link_selection(decisions_, workbench_);
  link_selection(scene_, workbench_);
  for (widgets::ImageView* view : {left_, right_}) {
    connect(view, &widgets::ImageView::read_out, &workbench_, &Workbench::pointed_at);
    connect(view, &widgets::ImageView::marker_selected, this, [this, view](int marker) {
      if (!workbench_.selection.current().observation || marker < 0) return;
      workbench_.selection.select({.observation = workbench_.selection.current().observation,
                                   .marker = marker,
                                   .camera = cameras_->look_up_camera(view)});
    });
  }
  connect(&workbench_.images, &ImageSource::arrived, this, [this] {
    if (is_active()) refresh_observation();
  });
  connect(&workbench_.selection, &Selection::changed, this, [this] {
    const auto id = workbench_.selection.current().observation.value_or(widgets::no_observation);
    board_->set_selected(id);
    decisions_->set_selected(id);
    if (is_active() && !player_.is_playing()) refresh_observation();
  });
  connect(&workbench_.selection, &Selection::hover_changed, this, [this] {
    if (is_active())
      scene_->set_hovered_observation(workbench_.selection.hovered().observation.value_or(widgets::no_observation));
  });
  connect(&workbench_.document, &Document::opened, this, [this] {
    robot_is_set_ = is_recalled_ = false;
    show_hands();
  });
  connect(&workbench_.document, &Document::edited, this, [this] {
    if (!player_.is_playing()) refresh_transport();
  });
  connect(&workbench_.document, &Document::model_changed, this, [this] {
    if (!player_.is_playing()) refresh_decisions();
    is_stale_ = true;
    if (is_active()) refresh_model();
  });
  connect(&workbench_.sessions, &SessionFilter::changed, this, [this] {
    is_stale_ = true;
    if (is_active()) refresh_model();
  });
  connect(&workbench_.units, &DisplayUnits::changed, this, [this] {
    show_played();
    refresh_decisions();
    if (is_active()) refresh_observation();
  });
  connect(own_pose_, &OwnPosePage::changed, this, [this] {
    if (is_active()) refresh_observation();
  });
  connect(tabs_, &QTabWidget::currentChanged, this, [this] {
    objectives_->set_active(tabs_->currentWidget() == objectives_);
    one_marker_->set_active(tabs_->currentWidget() == one_marker_);
    own_pose_->set_active(tabs_->currentWidget() == own_pose_);
    if (is_active()) refresh_observation();
  });
}

void CalibrateWorkspace::show_hands() {
  const bool is_collection = is_joined(workbench_.document.session());
  hands_->setVisible(is_collection);
  const bool are_touches = workbench_.document.session().is_touch();
  board_->setVisible(!is_collection && !are_touches);
  fixtures_->setVisible(are_touches);
  for (QWidget* page : std::initializer_list<QWidget*>{objectives_, one_marker_})  // of markers that are seen
    tabs_->setTabVisible(tabs_->indexOf(page), !are_touches);
  decisions_->set_empty_text(are_touches     ? tr("Touches are fitted all at once: there is nothing to play.")
                             : is_collection ? tr("Observations are taken or rejected in each session.")
                                             : tr("Play: each observation is taken, or rejected with its reason."));
  if (is_collection) hands_->refresh();
  if (are_touches) fixtures_->refresh();
}

WorkStatus CalibrateWorkspace::status() const {
  const Session& s = workbench_.document.session();
  if (is_joined(s)) {
    const ModelVersionPointer model = workbench_.document.shown_model();
    if (!model || !model->fit) return {WorkState::waiting, tr("waits for a fit")};
    return {WorkState::done, tr("%1 sessions").arg(s.parts.size())};
  }
  const bool is_labelled = s.target || std::any_of(s.observations.begin(), s.observations.end(),
                                                   [](const Observation& o) { return !o.sightings.empty(); });
  if (!is_labelled) return {WorkState::waiting, tr("waits for labels")};
  const auto taken = std::count_if(s.observations.begin(), s.observations.end(),
                                   [](const Observation& o) { return o.decision == Decision::accepted; });
  const auto rejected = std::count_if(s.observations.begin(), s.observations.end(),
                                      [](const Observation& o) { return o.decision == Decision::rejected; });
  if (player_.is_playing()) return {WorkState::open, tr("playing")};
  const bool any_images = std::any_of(s.observations.begin(), s.observations.end(),
                                      [](const Observation& o) { return !o.images[0].empty(); });
  if (taken == 0) {
    if (s.is_touch()) return {WorkState::done, tr("nothing to play")};
    return {any_images ? WorkState::open : WorkState::done, tr("ready to play")};  // labels that are there need no play
  }
  return {WorkState::done,
          rejected > 0 ? tr("%1 taken, %2 rejected").arg(taken).arg(rejected) : tr("%1 taken").arg(taken)};
}

void CalibrateWorkspace::set_robot() {
  if (robot_is_set_ || !workbench_.document.is_open()) return;
  const Session& s = workbench_.document.session();
  const std::filesystem::path urdf = folder(s) / s.robot_file;
  scene_->set_robot(s.robot, urdf.parent_path());
  say_notes();
  left_->setVisible(s.rig || s.is_touch());
  own_pose_->set_session();
  robot_is_set_ = true;
}

void CalibrateWorkspace::say_notes() {
  for (const QString& note : scene_->notes()) emit workbench_.document.noticed(note);
}

void CalibrateWorkspace::activate() {
  set_robot();
  refresh_transport();
  if (is_stale_) refresh_model();
  hands_->look();
  if (!player_.is_playing()) refresh_decisions();
  refresh_observation();
  recall();
}

void CalibrateWorkspace::recall() {
  const Session& s = workbench_.document.session();
  const bool was_played = std::any_of(s.observations.begin(), s.observations.end(),
                                      [](const Observation& o) { return o.decision == Decision::accepted; });
  if (is_joined(s)) return;
  if (is_recalled_ || player_.position() > 0 || player_.is_playing() || !was_played) return;
  is_recalled_ = true;
  workbench_.background.start<std::vector<OnlineStep>>(
      "recall", tr("Recalling the play"),
      [session = workbench_.document.shared_session()](JobControl& control) {
        return recalled_steps(*session, going_on(control));
      },
      [this](const std::vector<OnlineStep>& steps) {
        if (player_.position() > 0 || player_.is_playing()) return;
        board_->set_points(list_convergence(steps));
      },
      [](const QString&) {});
}

bool CalibrateWorkspace::key(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space) {
    transport_->toggle_play();
  } else if (event->key() == Qt::Key_Period) {
    player_.step();
  } else {
    return false;
  }
  return true;
}

void CalibrateWorkspace::refresh_transport() {
  transport_->refresh();
  emit status_changed();
}

void CalibrateWorkspace::refresh_observation() {
  const Observation* o = workbench_.selected_observation();
  if (!o) {
    left_->clear(tr("Choose an observation in the strip, a plot or the 3D view."));
    right_->clear({});
    return;
  }
  // While it is played, against the estimate of that moment; afterwards against the model.
  const PlayedStep* played = player_.find_step(o->id);
  const bool use_played =
      played && !played->row.markers.empty() && (player_.is_playing() || !workbench_.document.model());
  const InspectionRow* row = use_played ? &played->row : workbench_.row(o->id);
  show_images(workbench_, *o, row, cameras_->shown(), true);
  if (tabs_->currentWidget() == own_pose_) {
    own_pose_->show(*scene_);
  } else {
    scene_->set_ellipsoid(std::nullopt);
    show_pose(workbench_.document, *o, row, *scene_);
  }
}

void CalibrateWorkspace::refresh_decisions() {
  const bool is_present = workbench_.document.model() && workbench_.document.model()->fit && !player_.is_playing();
  std::vector<widgets::DecisionEntry> entries;
  for (const PlayedStep& played : player_.steps())
    entries.push_back(find_entry(played, is_present ? workbench_.row(played.step.id) : nullptr, workbench_.units));
  if (player_.steps().empty() && !player_.is_playing())  // played before it was opened
    for (const Observation& o : workbench_.document.session().observations)
      if (o.decision == Decision::accepted || o.decision == Decision::rejected)
        entries.push_back(find_entry(decided(o), workbench_.row(o.id), workbench_.units));
  if (!entries.empty() || player_.steps().empty()) decisions_->set_entries(std::move(entries));
  refresh_decision_title(is_present);
}

void CalibrateWorkspace::refresh_decision_title(bool is_present) {
  const int place = tabs_->indexOf(decisions_->parentWidget());
  tabs_->setTabText(place, is_present || player_.steps().empty() ? tr("Decisions") : tr("Decisions, errors of then"));
  tabs_->setTabToolTip(place, is_present ? tr("The errors are those of the present model")
                                         : tr("The errors are those of the moment of the decision"));
}

void CalibrateWorkspace::refresh_model() {
  is_stale_ = false;
  show_hands();
  if (is_active()) hands_->look();
  if (const Inspection* all = workbench_.inspection())
    scene_->set_arrows(scene_arrows(workbench_.document.session(), *all, workbench_.sessions));
  refresh_observation();
}

std::vector<Action> CalibrateWorkspace::own_actions() const {
  const auto explained = [](const char* id, const QString& gesture, const QString& what) {
    return Action{.id = id, .group = tr("Calibrate"), .text = what, .gesture = gesture};
  };
  return {explained("play_keys", tr("Space, ."), tr("play or pause, one observation"))};
}

}  // namespace handsight::app
