// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/report_pictures.h"

#include <QPainter>
#include <algorithm>

#include "findings/fit_watch.h"
#include "findings/inspection_rows.h"
#include "findings/pattern_plots.h"
#include "findings/proof_plots.h"
#include "widgets/base/theme.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/residual_cloud.h"
#include "widgets/explain/staircase.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/plots/residual_map.h"
#include "workbench/observation_views.h"

namespace handsight::app {
namespace {

using widgets::SizeUnit;

constexpr double sharpness = 2;  // px of a picture for each of the page's

/// Paper is light, whatever the window is; back to the window's own at the end.
class OnPaper {
 public:
  OnPaper() : before_(widgets::theme()) { widgets::set_colors(widgets::ThemeKind::light); }
  ~OnPaper() { widgets::set_colors(before_); }
  OnPaper(const OnPaper&) = delete;
  OnPaper& operator=(const OnPaper&) = delete;

 private:
  widgets::ThemeKind before_;
};

/// A widget that is laid out and painted as if it were shown, at this size.
template <class Widget>
void lay_out(Widget& widget, int width, int height) {
  widget.setAttribute(Qt::WA_DontShowOnScreen);
  widget.resize(width, height);
  widget.show();
}

QImage painted(QWidget& widget) {
  QImage image(widget.size() * sharpness, QImage::Format_RGB32);
  image.setDevicePixelRatio(sharpness);
  image.fill(widgets::colors().panel);
  widget.render(&image, {}, {}, QWidget::DrawChildren);
  return image;
}

std::vector<ModelVersionPointer> fitted_versions(const Document& document) {
  std::vector<ModelVersionPointer> fitted;
  for (const ModelVersionPointer& v : document.versions())
    if (v && v->fit && (fitted.empty() || !same_fit(*fitted.back(), *v))) fitted.push_back(v);
  return fitted;
}

QString version_name(const ModelVersion& version) {
  return version.cause.isEmpty() ? QObject::tr("as opened") : version.cause;
}

void add_staircase(const Workbench& workbench, const std::vector<ModelVersionPointer>& versions,
                   std::vector<ReportPicture>& pictures) {
  if (versions.size() < 2) return;
  const SizeUnit unit = workbench.units.unit();
  const auto noise = versions.back()->fit->noise;
  widgets::StaircaseState state;
  state.unit = widgets::unit_name(unit);
  for (const ModelVersionPointer& v : versions) {
    const VersionSizes sizes = list_sizes(*v, noise);
    state.versions.push_back({version_name(*v), sizes.fitted.in(unit), sizes.held_out.in(unit)});
  }
  state.noise = list_sizes(*versions.back(), noise).noise.in(unit);
  widgets::Staircase stairs;
  stairs.set_state(std::move(state));  // before it is shown: nothing is on its way
  lay_out(stairs, 640, 240);
  pictures.push_back(
      {QObject::tr("How the error fell from step to step, fitted and held out; hatched: the noise"), painted(stairs)});
}

std::vector<widgets::CloudPoint> cloud_of_version(Workbench& workbench, const ModelVersionPointer& version) {
  const auto residuals = workbench.diagnosing.compute_residuals(version);
  if (!residuals) return {};
  return make_cloud(residuals->views.corners, ids_of_places(residuals->views.problem, workbench.document.session()));
}

void add_cloud(Workbench& workbench, const std::vector<ModelVersionPointer>& versions,
               std::vector<ReportPicture>& pictures) {
  const ModelVersionPointer &first = versions.front(), &last = versions.back();
  auto before = cloud_of_version(workbench, first), after = cloud_of_version(workbench, last);
  if (after.empty()) return;
  const bool in_pixels = last->inspection->in_pixels;
  widgets::ResidualCloud cloud;
  cloud.set_unit(in_pixels ? SizeUnit::pixel : SizeUnit::millimetre);
  if (last->fit->noise) cloud.set_noise((in_pixels ? 1 : 1e3) * *last->fit->noise);
  const bool is_one = first == last || before.empty();
  cloud.set_before(is_one ? after : std::move(before), version_name(is_one ? *last : *first));
  if (!is_one) cloud.set_after(std::move(after), version_name(*last));
  cloud.fit();
  lay_out(cloud, 640, 330);
  // A tracker has no corners.
  const QString of =
      in_pixels ? QObject::tr("The residual of every corner") : QObject::tr("The residual of every marker");
  const QString caption =
      is_one ? QObject::tr("%1; the rings are one and three sigma").arg(of)
             : QObject::tr("%1, at first and now, on the same axes; the rings are one and three sigma").arg(of);
  pictures.push_back({titled(caption, *workbench.diagnosing.compute_residuals(last)), painted(cloud)});
}

void add_patterns(Workbench& workbench, const ModelVersionPointer& version, const std::vector<PlotKey>& keys,
                  const QString& caption, std::vector<ReportPicture>& pictures) {
  const auto residuals = workbench.diagnosing.compute_residuals(version);
  if (!residuals) return;
  std::vector<widgets::PatternPlot> plots;
  for (const PlotKey& key : keys)
    if (auto plot = pattern_plot(key, *residuals, workbench)) plots.push_back(std::move(*plot));
  if (plots.empty()) return;
  widgets::PatternPage page;
  lay_out(page, 660, 420);
  page.set_plots(std::move(plots));
  pictures.push_back({titled(caption, *residuals), painted(page)});
}

/// Where the first model failed, and the same plots of the last one.
void add_failures(Workbench& workbench, const std::vector<ModelVersionPointer>& versions,
                  std::vector<ReportPicture>& pictures) {
  const auto residuals = workbench.diagnosing.compute_residuals(versions.front());
  if (!residuals) return;
  const std::vector<PlotKey> keys = strongest_plots(*residuals);
  const bool is_one = versions.size() < 2;
  add_patterns(workbench, versions.front(), keys,
               is_one ? QObject::tr("The residual against what it may follow, strongest first")
                      : QObject::tr("Where the first model failed: the residual against what it followed most"),
               pictures);
  if (!is_one)
    add_patterns(workbench, versions.back(), keys, QObject::tr("The same with the model as it is now"), pictures);
}

void add_proof(const Workbench& workbench, const ProofPlot& proof, bool is_in_model,
               std::vector<ReportPicture>& pictures) {
  widgets::PatternPlot shown = proof_plot(proof, workbench, 0);
  widgets::ScatterPlot plot;
  lay_out(plot, 640, 230);
  plot.set_axes(shown.against, shown.x_unit, shown.what, shown.y_unit);
  plot.set_points(std::move(shown.points));
  is_in_model ? plot.set_trend(std::move(shown.candidate)) : plot.set_candidate(std::move(shown.candidate));  // dashed
  plot.fit();
  pictures.push_back({proof_sentence(proof), plot.picture(sharpness)});
}

/// What every observation says of each site that the model's effects move, with the curve of what was estimated.
void add_proofs(const Workbench& workbench, const ModelVersion& version, std::vector<ReportPicture>& pictures) {
  std::vector<EffectTerm> estimated;
  for (const FittedEffect& f : version.fit->effects)
    if (std::any_of(f.sigmas.begin(), f.sigmas.end(), [](double sigma) { return sigma > 0; }))
      estimated.push_back(f.term);
  constexpr std::size_t most = 8;
  const std::vector<ProofPlot> proofs = make_proof(workbench.document.session(), *version.fit, estimated);
  for (std::size_t i = 0; i < std::min(most, proofs.size()); ++i) add_proof(workbench, proofs[i], true, pictures);
}

/// The plot that proves the cause by which the story goes.
void add_lead(const Workbench& workbench, std::vector<ReportPicture>& pictures) {
  const StoryCause* lead = workbench.story().lead();
  const auto view = lead ? workbench.diagnosing.find_view(lead->id) : nullptr;
  if (view && !view->proof.empty()) add_proof(workbench, view->proof.front(), false, pictures);
}

void add_histogram(const Workbench& workbench, const Inspection& all, std::vector<ReportPicture>& pictures) {
  widgets::HistogramPlot histogram;
  lay_out(histogram, 640, 300);
  histogram.set_noise(all.noise ? std::optional((all.in_pixels ? 1 : 1e3) * *all.noise) : std::nullopt,
                      all.in_pixels ? "px" : "mm");
  histogram.set_unit(workbench.units.unit());
  histogram.set_cells(workbench.shown_cells());
  histogram.fit();
  pictures.push_back({QObject::tr("Error of each observation against the noise (hatched: what noise alone shows)"),
                      histogram.picture()});
}

void add_map(const Workbench& workbench, std::vector<ReportPicture>& pictures) {
  const Session& s = workbench.document.session();
  if (!s.rig) return;
  widgets::ResidualMap map;
  lay_out(map, 640, 480);
  map.set_image_size(s.rig->at(0).camera.width, s.rig->at(0).camera.height);
  map.set_unit(workbench.units.unit());
  map.set_points(map_points(workbench));
  map.fit();
  pictures.push_back({QObject::tr("Residuals over the image, arrows magnified"), map.picture()});
}

/// The worst of the observations that count; with images where any has them.
const Observation* shown_observation(const Workbench& workbench, const Inspection& all) {
  const Observation* best = nullptr;
  double worst = -1;
  for (const InspectionRow& row : all.rows) {
    const Observation* o = workbench.document.find(row.id);
    if (!o || !row.is_used || !row.rms || row.markers.empty()) continue;
    const double rank = *row.rms + (o->images[0].empty() ? 0 : 1e6);
    if (rank <= worst) continue;
    worst = rank;
    best = o;
  }
  return best;
}

void add_robot(const Workbench& workbench, const Observation& o, const Inspection& all,
               std::vector<ReportPicture>& pictures) {
  const Session& s = workbench.document.session();
  widgets::RobotView view;
  lay_out(view, 640, 480);
  view.set_robot(s.robot, (folder(s) / s.robot_file).parent_path());
  const InspectionRow* row = workbench.row(o.id);
  show_pose(workbench.document, o, row, view);
  view.set_arrows(scene_arrows(workbench.document.session(), all, workbench.sessions));
  if (row && row->tcp_from_tcp_est)
    view.set_ghost_magnification(
        magnification_over_noise(row->tcp_from_tcp_est->translation.norm(), all.noise_m, 0.05));
  const double times = arrow_magnification(all);
  view.set_arrow_magnification(times);
  view.look(widgets::StandardView::all);
  pictures.push_back({QObject::tr("The robot in observation %1, with the deviation of every observation, times %2")
                          .arg(o.id)
                          .arg(times),
                      view.picture(sharpness)});
}

void add_images(Workbench& workbench, const Observation& o, std::vector<ReportPicture>& pictures) {
  if (!workbench.document.session().rig || o.images[0].empty()) return;
  QWidget pair;
  const int count = std::min(2, workbench.document.session().rig->count());
  lay_out(pair, count == 2 ? 660 : 480, count == 2 ? 262 : 380);
  std::vector<ShownCamera> shown;
  for (int camera = 0; camera < count; ++camera) {
    shown.push_back({new widgets::ImageView(&pair), camera});
    const int wide = (pair.width() - 6 * (count - 1)) / count;
    shown.back().view->setGeometry(camera * (wide + 6), 0, wide, pair.height());
    shown.back().view->show();
  }
  const InspectionRow* row = workbench.row(o.id);
  show_images(workbench, o, row, shown, true, true);
  const double times = row ? magnification_over_noise(row->worst_size, workbench.inspection()->noise, 40) : 1;
  for (const ShownCamera& one : shown) {
    one.view->set_magnification(times);
    one.view->fit();
  }
  pictures.push_back(
      {QObject::tr("Observation %1: markers measured and predicted, residuals times %2").arg(o.id).arg(times),
       painted(pair)});
}

}  // namespace

std::vector<ReportPicture> report_pictures(Workbench& workbench) {
  std::vector<ReportPicture> pictures;
  const Inspection* all = workbench.inspection();
  if (!all) return pictures;
  const OnPaper paper;
  const std::vector<ModelVersionPointer> versions = fitted_versions(workbench.document);
  add_lead(workbench, pictures);
  if (!versions.empty()) {
    add_staircase(workbench, versions, pictures);
    add_cloud(workbench, versions, pictures);
    add_failures(workbench, versions, pictures);
    add_proofs(workbench, *versions.back(), pictures);
  }
  add_histogram(workbench, *all, pictures);
  add_map(workbench, pictures);
  if (const Observation* o = shown_observation(workbench, *all)) {
    add_images(workbench, *o, pictures);
    add_robot(workbench, *o, *all, pictures);
  }
  return pictures;
}

}  // namespace handsight::app
