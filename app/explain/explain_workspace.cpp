// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/explain_workspace.h"

#include <QLabel>
#include <QVBoxLayout>

#include "widgets/histogram_plot.h"
#include "widgets/number_text.h"
#include "widgets/theme.h"

namespace handsight::app {
namespace {

/// Shares of the excess over all used observations, weighed by its size.
QString shares_sentence(const Inspection& all) {
  double c = 0, b = 0, r = 0, sum = 0;
  for (const InspectionRow& row : all.rows) {
    if (!row.is_used || !row.rms) continue;
    const double weight = *row.rms * *row.rms * row.coordinates;
    c += weight * row.blame.cameras;
    b += weight * row.blame.body;
    r += weight * row.blame.robot;
  }
  sum = c + b + r;
  if (!(sum > 0)) return QObject::tr("Nothing stands out of the noise.");
  return QObject::tr(
             "Of what exceeds the noise %1 % comes from the robot, %2 % from the marker body, %3 % from the "
             "cameras.")
      .arg(std::lround(100 * r / sum))
      .arg(std::lround(100 * b / sum))
      .arg(std::lround(100 * c / sum));
}

}  // namespace

QString comparison_sentence(const ModelVersion& model) {
  if (!model.fit) return model.refusal;
  const ErrorAndNoise e = error_and_noise(model);
  const double scale = e.in_pixels ? 1 : 1e3;
  const QString unit = e.in_pixels ? QObject::tr("px") : QObject::tr("mm");
  if (!e.error) return QObject::tr("The error is not known.");
  const QString error = widgets::with_unit_text(scale * *e.error, unit);
  if (!e.noise)
    return QObject::tr(
               "The model misses by %1. Without three markers the noise is not known, so that the program cannot "
               "say whether that is much.")
        .arg(error);
  const QString noise = widgets::with_unit_text(scale * *e.noise, unit);
  if (*e.ratio() < 1.25)
    return QObject::tr("The model agrees with the measurements down to the noise (%1 against %2).").arg(error, noise);
  const auto m = model.report->held_out.rms_m ? model.report->held_out.rms_m : model.report->fitted.rms_m;
  const QString at_hand =
      e.in_pixels && m ? QObject::tr(" (%1 at the hand)").arg(widgets::with_unit_text(1e3 * *m, QObject::tr("mm")))
                       : QString();
  return QObject::tr("The model misses by %1%2 where the noise is %3.").arg(error, at_hand, noise);
}

ExplainWorkspace::ExplainWorkspace(Workbench& bench, QWidget* parent) : Workspace(bench, parent) {
  setObjectName("explain");
  verdict_ = new QLabel(this);
  verdict_->setObjectName("verdict");
  verdict_->setFont(widgets::text_font(widgets::TextRole::title));
  verdict_->setWordWrap(true);
  shares_ = new QLabel(this);
  shares_->setWordWrap(true);
  histogram_ = new widgets::HistogramPlot(this);
  histogram_->set_title(tr("Error of each observation against the noise"));
  later_ = new QLabel(tr("Which effect is missing is not worked out in this version. Inspect shows which observations "
                         "miss most, and whose fault it is."),
                      this);
  later_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 16);
  layout->setSpacing(8);
  layout->addWidget(verdict_);
  layout->addWidget(shares_);
  layout->addWidget(histogram_, 1);
  layout->addWidget(later_);
  connect(&bench.document, &Document::model_changed, this, [this] {
    emit status_changed();
    if (is_active()) activate();
  });
  connect(histogram_, &widgets::HistogramPlot::observations_selected, this, [this](const std::vector<qint64>& ids) {
    bench_.selection.select_many({ids.begin(), ids.end()});
  });
  connect(histogram_, &widgets::HistogramPlot::read_out, &bench, &Workbench::pointed_at);
  connect(&bench.selection, &Selection::changed, this, [this] {
    histogram_->set_selected(bench_.selection.current().observation.value_or(widgets::kNoObservation));
  });
}

WorkStatus ExplainWorkspace::status() const {
  const ModelVersionPointer model = bench_.document.shown_model();
  if (!model || !model->fit) return {WorkState::waiting, tr("waits for a fit")};
  const auto ratio = error_and_noise(*model).ratio();
  if (!ratio) return {WorkState::open, tr("noise unknown")};
  return *ratio < 1.25 ? WorkStatus{WorkState::done, tr("down at the noise")}
                       : WorkStatus{WorkState::open, tr("%1 x the noise").arg(widgets::short_text(*ratio))};
}

void ExplainWorkspace::activate() {
  const ModelVersionPointer model = bench_.document.shown_model();
  const bool has_fit = model && model->fit;
  verdict_->setText(!model ? tr("Waits for a fit: label, then play.") : comparison_sentence(*model));
  shares_->setVisible(has_fit);
  later_->setVisible(has_fit);
  histogram_->setVisible(has_fit);
  if (!has_fit) return;
  shares_->setText(shares_sentence(*model->inspection));
  const bool pixels = model->inspection->in_pixels;
  histogram_->set_noise(model->fit->noise ? std::optional((pixels ? 1 : 1e3) * *model->fit->noise) : std::nullopt,
                        pixels ? tr("px") : tr("mm"));
  histogram_->set_cells(bench_.cells());
  histogram_->fit();
}

}  // namespace handsight::app
