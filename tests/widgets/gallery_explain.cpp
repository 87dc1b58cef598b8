// SPDX-License-Identifier: Apache-2.0
#include "widgets/gallery_explain.h"

#include <QElapsedTimer>
#include <QPainter>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "effects/effect.h"
#include "widgets/drawings/effect_drawing.h"
#include "widgets/explain/candidate_list.h"
#include "widgets/explain/cost_curve.h"
#include "widgets/explain_samples.h"

namespace handsight::test {
namespace {

using namespace widgets;

/// All drawings with their titles.
class Sheet : public QWidget {
 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), colors().panel);
    painter.setFont(text_font(TextRole::small));
    std::vector<std::pair<std::string, std::string>> all;
    for (const Effect& effect : catalogue()) all.emplace_back(effect.id, effect.title);
    all.emplace_back("", "the unnamed curve");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const QPointF at(12 + 120.0 * static_cast<double>(i % 6), 8 + 128.0 * static_cast<double>(i / 6));
      paint_effect(painter, QRectF(at, QSizeF(96, 96)), all[i].first, colors());
      painter.setPen(colors().ink2);
      painter.drawText(QRectF(at + QPointF(-12, 98), QSizeF(120, 18)), Qt::AlignCenter,
                       QString::fromStdString(all[i].second));
    }
  }
};

void verdicts(const KeepPicture& keep) {
  VerdictLine line;
  line.set_verdict(missing_verdict());
  keep(line, "verdict_missing", {1056, 72});
  SessionVerdict v;
  v.state = SessionState::adequate;
  v.sentence =
      "The model agrees with the measurements down to the cameras' noise (0.21 against 0.20 px). These poses could not "
      "show: base tilt, time lag.";
  v.error_px = 0.21;
  v.noise_px = 0.2;
  v.error_mm = 0.28;
  v.noise_mm = 0.3;
  v.attribution = ErrorAttribution{0.9, 0.06, 0.04};
  line.set_verdict(v);
  keep(line, "verdict_adequate", {1056, 72});
  v = missing_verdict();
  v.state = SessionState::looking;
  v.sentence = "The model misses by 9.1 px (12 mm at the hand) where the cameras' noise is 0.2 px.";
  v.predicted = {0.24, SizeUnit::pixel};
  line.set_verdict(v);
  keep(line, "verdict_looking", {1056, 72});
  SessionVerdict none;
  none.sentence = "Waits for a fit of at least 8 observations; 3 so far.";
  line.set_verdict(none);
  keep(line, "verdict_waiting", {760, 72});
}

void patterns(const KeepPicture& keep) {
  PatternPage page;
  page.set_plots(nine_patterns(100));
  page.set_selected_plot(0);
  page.set_selected(80);
  page.set_highlighted({10, 11, 12, 13, 14});
  keep(page, "patterns", {592, 230});
  page.set_progress("from 40 of 100");
  keep(page, "patterns_large", {900, 420});
  page.set_plots(nine_patterns(1000));
  keep(page, "patterns_1000", {592, 300});
  PatternPage empty;
  keep(empty, "patterns_empty", {592, 230});
}

void cards(const KeepPicture& keep) {
  CandidateList list;
  list.set_cards({elasticity_card(), predicted_card(), unnamed_card()}, CardOrder::fresh);
  list.set_previewed(predicted_card().id);
  keep(list, "cards", {464, 760});
  CardState better = predicted_card();
  list.set_cards({better, elasticity_card()}, CardOrder::kept);
  keep(list, "cards_resort", {464, 420});
  CandidateList honest;
  honest.set_cards(honest_cards(), CardOrder::fresh);
  keep(honest, "cards_honest", {464, 1140});
  CandidateList empty;
  empty.set_empty_text("Waits for a fit of at least 8 observations; 3 so far.");
  keep(empty, "cards_empty", {464, 200});
}

void stairs(const KeepPicture& keep) {
  Staircase staircase;
  StaircaseState state = four_versions();
  state.compared_a = 0;
  state.compared_b = 3;
  staircase.set_state(state);
  keep(staircase, "staircase", {332, 172});
  state.current = 1;
  state.preview = VersionStep{"+ joint offset", {}, 0.24, false, {}};
  staircase.set_state(state);
  keep(staircase, "staircase_preview", {480, 200});
  StaircaseState one = four_versions();
  one.versions.resize(1);
  staircase.set_state(one);
  keep(staircase, "staircase_one", {332, 172});
  Staircase empty;
  keep(empty, "staircase_empty", {332, 172});
  CostCurve curve;
  curve.start("rms of a coordinate", "px");
  curve.set_floor(0.2);
  for (int i = 0; i < 7; ++i) curve.append(i, 0.21 + 9 * std::exp(-1.3 * i));
  keep(curve, "cost_running", {332, 172});
  curve.finish("settled after 6 iterations");
  keep(curve, "cost_done", {332, 172});
}

void clouds(const KeepPicture& keep) {
  ResidualCloud pair;
  pair.set_noise(0.2);
  pair.set_before(cloud(100, 9), "before, 9.1 px");
  keep(pair, "cloud_before", {332, 200});
  pair.set_after(cloud(100, 0), "after, 0.24 px");
  pair.set_selected(17);
  keep(pair, "cloud", {332, 200});
  pair.set_linear(true);
  keep(pair, "cloud_linear", {332, 200});
  pair.set_linear(false);
  pair.set_before(cloud(1300, 9), "before, 9.1 px");
  pair.set_after(cloud(1300, 2), "with payload, predicted 3.4 px");
  pair.set_predicted(true);
  keep(pair, "cloud_8000", {640, 360});
  ResidualCloud empty;
  keep(empty, "cloud_empty", {332, 172});
}

void tables(const KeepPicture& keep) {
  EffectTable table;
  table.set_rows(effect_rows());
  keep(table, "effects", {760, 640});
  table.set_filter("gravity on the moon");
  keep(table, "effects_none", {460, 200});
  WhatIfSlider slider;
  slider.set_state(eccentricity());
  keep(slider, "what_if", {592, 130});
  VersionList versions;
  versions.set_versions(version_entries(), "px");
  versions.set_current(1);
  versions.set_compared(0, 3);
  versions.set_comparison("A to B: 9.1 → 0.24 px; TCP→Body moves by 3.2 mm and 0.4 deg.");
  keep(versions, "versions", {420, 300});
  TruthPanel truth;
  truth.set_rows(truth_rows(), "Of three hidden effects one was found right, one is off, one was missed.");
  keep(truth, "truth", {464, 260});
  TruthPanel none;
  keep(none, "truth_empty", {464, 120});
}

/// The median of repaints, ms.
double repaint_ms(QWidget& widget, int times, const std::function<void(int)>& change) {
  std::vector<double> all;
  for (int i = 0; i < times; ++i) {
    QElapsedTimer timer;
    timer.start();
    change(i);
    widget.repaint();
    all.push_back(static_cast<double>(timer.nsecsElapsed()) * 1e-6);
  }
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

}  // namespace

void explain_pictures(const KeepPicture& keep) {
  Sheet sheet;
  keep(sheet, "drawings", {732, 520});
  verdicts(keep);
  patterns(keep);
  cards(keep);
  stairs(keep);
  clouds(keep);
  tables(keep);
}

void explain_times() {
  PatternPage page;
  page.set_plots(nine_patterns(1000));
  page.resize(592, 300);
  page.show();
  ResidualCloud pair;
  pair.set_noise(0.2);
  const std::vector<CloudPoint> before = cloud(1000, 9);
  pair.set_before(before, "before");
  pair.resize(332, 200);
  pair.show();
  if (!QTest::qWaitForWindowExposed(&page) || !QTest::qWaitForWindowExposed(&pair)) qFatal("no display");
  QTest::qWait(300);
  std::printf("pattern page, 9 x 1000 points: %.2f ms a repaint\n",
              repaint_ms(page, 50, [&](int i) { page.set_selected(i); }));
  std::printf("pattern page, with 200 highlighted: %.2f ms a repaint\n", repaint_ms(page, 50, [&](int i) {
                std::vector<ObservationId> ids;
                for (int k = 0; k < 200; ++k) ids.push_back(k + i);
                page.set_highlighted(ids);
              }));
  std::vector<CloudPoint> live = before;
  const auto shrink = [&](int i) {
    for (std::size_t k = 0; k < live.size(); ++k) {
      live[k].du = before[k].du * std::exp(-0.05 * i);
      live[k].dv = before[k].dv * std::exp(-0.05 * i);
    }
    pair.set_live(live, "iteration");
  };
  const double small = repaint_ms(pair, 60, shrink);
  std::printf("residual cloud, 2 x 6000 points, 332 x 200: %.2f ms an iteration, %.0f a second\n", small, 1000 / small);
  pair.resize(1000, 520);
  QTest::qWait(200);
  const double large = repaint_ms(pair, 60, shrink);
  std::printf("residual cloud, 2 x 6000 points, 1000 x 520: %.2f ms an iteration, %.0f a second\n", large,
              1000 / large);
}

}  // namespace handsight::test
