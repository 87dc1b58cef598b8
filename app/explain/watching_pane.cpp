// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/watching_pane.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <algorithm>

#include "document/bent_robot.h"
#include "document/effect_words.h"
#include "findings/bill_entries.h"
#include "widgets/base/motion.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/explain/bill_list.h"
#include "widgets/explain/cost_curve.h"
#include "widgets/explain/version_list.h"
#include "widgets/scene/robot_view.h"
#include "workbench/observation_views.h"
#include "workbench/touch_views.h"

namespace handsight::app {
namespace {

std::optional<double> shown(std::optional<double> error, bool in_pixels) {
  return error ? std::optional(in_pixels ? *error : 1e3 * *error) : std::nullopt;
}

widgets::VersionStep find_step(const ModelVersion& version, widgets::SizeUnit unit, std::optional<double> noise) {
  const VersionSizes sizes = list_sizes(version, noise);
  return {version.cause.isEmpty() ? QObject::tr("as opened") : version.cause, sizes.fitted.in(unit),
          sizes.held_out.in(unit)};
}

}  // namespace

ModelVersionPointer WatchingPane::version_at(int row) const {
  return row >= 0 && row < static_cast<int>(rows_.size()) ? rows_[static_cast<std::size_t>(row)].version : nullptr;
}

int WatchingPane::selected_index() const {
  const Session& s = workbench_.document.session();
  if (s.observations.empty()) return -1;
  return std::max(0, workbench_.document.find_index(
                         workbench_.selection.current().observation.value_or(s.observations.front().id)));
}

const RememberedStair* WatchingPane::find_memory(int index) const {
  const QUndoStack& stack = workbench_.document.undo_stack();
  for (const RememberedStair& s : memory_)
    if (s.index == index && index <= stack.count() && s.action == (index > 0 ? stack.text(index - 1) : QString()))
      return &s;
  return nullptr;
}

void WatchingPane::remember() {
  if (!workbench_.document.is_open()) return;
  const QUndoStack& stack = workbench_.document.undo_stack();
  std::vector<RememberedStair> stairs;
  const auto versions = workbench_.document.versions();
  for (int i = 0; i < static_cast<int>(versions.size()); ++i) {
    const ModelVersionPointer& v = versions[static_cast<std::size_t>(i)];
    const QString action = i > 0 ? stack.text(i - 1) : QString();
    if (v && v->fit) {
      stairs.push_back({i, action, v->cause, v->report->fitted, v->report->held_out});
    } else if (const RememberedStair* memory = find_memory(i)) {
      stairs.push_back(*memory);
    }
  }
  memory_ = stairs;
  if (stairs.size() > 1) remember_stairs(workbench_.document.file(), stairs);
}

void WatchingPane::refresh() {
  refresh_rows();
  refresh_bill();
  if (!adding_.is_running()) {
    refresh_cloud();
    show_robot();
  }
}

/// Versions and bill take the room of the cloud.
void WatchingPane::choose_tab(int tab) {
  left_->setCurrentIndex(tab);
  tabs_->button(tab)->setChecked(true);
  cloud_->setVisible(tab != tab_versions);
  columns_->setStretch(0, tab == tab_versions ? 664 : 332);
}

void WatchingPane::show_bill() {
  refresh_bill();
  if (!bill_->entries().empty()) choose_tab(tab_versions);
  expecting_.start();
}

void WatchingPane::refresh_bill() {
  const ModelVersionPointer shown = workbench_.document.shown_model();
  bill_->set_entries(bill_entries(workbench_, shown));
  bill_->set_note(expecting_.sentence(shown));
}

void WatchingPane::refresh_rows() {
  const ModelVersionPointer marked_a = compared_a(), marked_b = compared_b();
  rows_.clear();
  remember();
  const auto versions = workbench_.document.versions();
  for (std::size_t i = 0; i < versions.size(); ++i) {
    const auto index = static_cast<int>(i);
    if (versions[i] && versions[i]->fit) {
      rows_.push_back({versions[i], nullptr, index});
    } else if (const RememberedStair* memory = find_memory(index)) {
      rows_.push_back({nullptr, nullptr, index, memory});
    }
    for (const Refusal& r : adding_.refused())
      if (r.index == static_cast<int>(i)) rows_.push_back({nullptr, &r, static_cast<int>(i)});
  }
  a_ = b_ = -1;
  widgets::StaircaseState state;
  std::vector<widgets::VersionEntry> entries;
  std::optional<double> before;
  const ModelVersionPointer now = workbench_.document.shown_model();
  const widgets::SizeUnit unit = workbench_.units.unit();
  const auto noise = now && now->fit ? now->fit->noise : std::nullopt;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    if (row.memory) {
      const bool in_pixels = !workbench_.document.session().is_tracker();
      const widgets::VersionStep step{row.memory->cause.isEmpty() ? tr("as opened") : row.memory->cause,
                                      measure_size(row.memory->fitted, in_pixels, noise).in(unit),
                                      measure_size(row.memory->held_out, in_pixels, noise).in(unit)};
      state.versions.push_back(step);
      entries.push_back({.name = step.name, .held_out = step.held_out, .fitted = step.fitted});
      if (before && step.held_out) entries.back().change = *step.held_out - *before;
      before = step.held_out;
      continue;
    }
    if (!row.version) {
      const QString name = effect_text(row.refusal->id, row.refusal->where);
      state.versions.push_back({.name = name, .is_refused = true, .reason = row.refusal->reason});
      entries.push_back({.name = name, .detail = row.refusal->reason, .is_refused = true});
      continue;
    }
    const widgets::VersionStep step = find_step(*row.version, unit, noise);
    state.versions.push_back(step);
    entries.push_back({.name = step.name, .held_out = step.held_out, .fitted = step.fitted});
    if (before && step.held_out) entries.back().change = *step.held_out - *before;
    before = step.held_out;
    if (row.version == now) state.current = static_cast<int>(i);
    if (row.version == marked_a) a_ = static_cast<int>(i);
    if (row.version == marked_b) b_ = static_cast<int>(i);
  }
  if (now && now->fit) state.noise = list_sizes(*now, noise).noise.in(unit);
  state.unit = widgets::unit_name(unit);
  state.compared_a = a_;
  state.compared_b = b_;
  const int current = state.current;
  stairs_->set_state(std::move(state));
  versions_->set_versions(std::move(entries), widgets::unit_name(unit));
  versions_->set_current(current);
  versions_->set_compared(a_, b_);
}

std::vector<widgets::CloudPoint> WatchingPane::in_unit(std::vector<widgets::CloudPoint> points) const {
  std::erase_if(points, [this](const widgets::CloudPoint& p) {
    return !workbench_.sessions.is_observation_shown(p.observation);
  });
  for (widgets::CloudPoint& p : points) {
    p.du *= cloud_scale_;
    p.dv *= cloud_scale_;
  }
  return points;
}

void WatchingPane::refresh_cloud() {
  const ModelVersionPointer now = workbench_.document.shown_model();
  if (const auto& rig = workbench_.document.session().rig) cloud_->set_camera_names(camera_names_in_words(*rig));
  cloud_->set_predicted(false);
  cloud_->set_empty_text(now && now->fit && !now->fit->noise
                             ? tr("What is left of every point is shown against the noise, which is not known.")
                             : tr("What is left of every point comes here."));
  if (!now || !now->fit) {
    cloud_->set_before({}, {});
    return cloud_->clear_after();
  }
  const Session& session = workbench_.document.session();
  const auto points = [&](const ModelVersionPointer& version) {
    const auto residuals = workbench_.diagnosing.compute_residuals(version);
    if (!residuals) return std::vector<widgets::CloudPoint>{};
    return in_unit(make_cloud(residuals->views.corners, ids_of_places(residuals->views.problem, session)));
  };
  const auto title = [&](const ModelVersionPointer& v) {
    const QString name = v->cause.isEmpty() ? tr("as opened") : v->cause;
    const auto residuals = workbench_.diagnosing.compute_residuals(v);
    return residuals ? titled(name, *residuals) : name;
  };
  if (const auto residuals = workbench_.diagnosing.compute_residuals(now)) {
    const double noise = *shown(residuals->views.noise_model.noise, now->inspection->in_pixels);
    const bool in_sigma = workbench_.units.unit() == widgets::SizeUnit::sigma;
    cloud_scale_ = in_sigma ? 1 / noise : 1;
    // In an image there are no mm: what is no sigma stays as it is measured.
    cloud_->set_unit(in_sigma                     ? widgets::SizeUnit::sigma
                     : now->inspection->in_pixels ? widgets::SizeUnit::pixel
                                                  : widgets::SizeUnit::millimetre);
    cloud_->set_noise(cloud_scale_ * noise);
  }
  ModelVersionPointer first = compared_a(), second = compared_b();
  if (!first || !second) {
    // The version before this one, and this one.
    first = second = nullptr;
    for (const Row& row : rows_) {
      if (!row.version) continue;
      if (row.version == now) {
        second = now;
        break;
      }
      first = row.version;
    }
    if (!second) second = now;
    if (!first) {
      cloud_->set_before(points(second), title(second));
      return cloud_->clear_after();
    }
  }
  cloud_->set_before(points(first), title(first));
  cloud_->set_after(points(second), title(second));
}

void WatchingPane::compare(int a, int b) {
  a_ = version_at(a) ? a : -1;
  b_ = version_at(b) ? b : -1;
  versions_->set_compared(a_, b_);
  const ModelVersionPointer first = compared_a(), second = compared_b();
  QString sentence;
  if (first && second) {
    const auto reported = [&](const ModelVersion& version) {
      return workbench_.units.text(list_sizes(version, first->fit->noise).error());
    };
    const double moved = (first->fit->tcp_from_body.translation - second->fit->tcp_from_body.translation).norm();
    sentence = tr("A to B: %1 → %2 held out; TCP→Body moves %3 mm.")
                   .arg(reported(*first), reported(*second), widgets::short_text(1e3 * moved));
    refresh_cloud();
  }
  versions_->set_comparison(sentence);
}

void WatchingPane::take_back(int row) {
  if (row < 0 || row >= static_cast<int>(rows_.size())) return;
  const int index = rows_[static_cast<std::size_t>(row)].index;
  while (workbench_.document.undo_stack().index() > index) {
    const int before = workbench_.document.undo_stack().index();
    workbench_.document.undo();
    if (workbench_.document.undo_stack().index() == before) return;
  }
}

void WatchingPane::set_blinking(bool blinking) { cloud_->set_blinking(blinking); }

void WatchingPane::set_prediction(const ModelResiduals* residuals, const CandidateView* view,
                                  const Eigen::VectorXd& numbers, const std::vector<EffectTerm>& terms,
                                  const QString& name) {
  if (adding_.is_running()) return;
  if (!residuals || !view) {
    stairs_->set_preview(std::nullopt);
    refresh_cloud();
    return show_robot();
  }
  const Session& session = workbench_.document.session();
  const ResidualViews& v = residuals->views;
  const std::vector<std::int64_t> ids = ids_of_places(v.problem, session);
  std::vector<CornerResidual> after = v.corners;
  const Eigen::VectorXd change = view->effect.corners * numbers;
  for (std::size_t c = 0; c < after.size(); ++c)
    after[c].residual -= change.segment<2>(static_cast<Eigen::Index>(2 * c));
  cloud_->set_before(in_unit(make_cloud(v.corners, ids)), tr("now"));
  cloud_->set_after(in_unit(make_cloud(after, ids)), tr("predicted with it"));
  cloud_->set_predicted(true);
  // In mm the staircase cannot show it before it is fitted; the header tells it in px.
  ResidualSize left = size_of_error(rms_left(v, view->effect, numbers), !session.is_tracker(), v.noise_model.noise);
  if (const ModelVersionPointer now = workbench_.document.shown_model()) left = as_read(left, *now);
  stairs_->set_preview(widgets::VersionStep{.name = name, .held_out = left.in(workbench_.units.unit())});
  std::vector<EffectTerm> bent = v.problem.terms;
  bent.insert(bent.end(), terms.begin(), terms.end());
  straight_ = bent_links(*v.problem.source, selected_index(), {});
  robot_->set_posture(straight_);
  set_ghost(bent_links(*v.problem.source, selected_index(), bent));
}

void WatchingPane::began(const QString&) {
  const bool in_pixels = !workbench_.document.session().is_tracker();
  stairs_->set_preview(std::nullopt);
  cloud_->set_predicted(false);
  cloud_->clear_after();
  show_robot();
  magnification_ = 1;
  bent_now_.clear();
  cost_->start(tr("rms of a coordinate"), in_pixels ? "px" : "mm");
  const ModelVersionPointer now = workbench_.document.model();
  cost_->set_floor(now && now->fit ? shown(now->fit->noise, in_pixels) : std::nullopt);
  const Tab tab = adding_.offered().name.isEmpty() ? tab_stairs : tab_fit;  // other names are sought without pictures
  choose_tab(tab);
  if (const auto residuals = workbench_.diagnosing.residuals())
    cloud_->set_before(in_unit(make_cloud(residuals->views.corners,
                                          ids_of_places(residuals->views.problem, workbench_.document.session()))),
                       tr("before"));
}

void WatchingPane::picture(const FitPicture& picture) {
  // From iterate to iterate everything moves, so that the eye can follow; the fit does not wait for it.
  if (adding_.pictures() <= 1) {
    cloud_->set_live(in_unit(picture.cloud), tr("as it is fitted"));
  } else {
    cloud_->set_after(in_unit(picture.cloud), tr("as it is fitted"));
  }
  if (picture.bent.empty()) return;
  bending_.stop();
  bent_from_ = bent_now_.size() == picture.bent.size() ? bent_now_ : picture.bent;
  bent_to_ = picture.bent;
  widgets::motion_is_reduced() ? bend(1) : bending_.start();
}

void WatchingPane::ended(AdditionEnd end) {
  const bool is_taken = end == AdditionEnd::taken;
  cost_->finish(is_taken                      ? tr("settled after %1 iterations").arg(cost_->count() - 1)
                : end == AdditionEnd::stopped ? tr("stopped")
                                              : tr("not taken"));
  bending_.stop();  // the workspace shows what is the case now
  if (!is_taken && end != AdditionEnd::stopped) return;
  // The step is what counts now; the curve stays a click away.
  choose_tab(tab_stairs);
}

}  // namespace handsight::app
