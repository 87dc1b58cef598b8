// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/proof_plots.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <random>

#include "document/effect_words.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

constexpr double weak = 2.5;  // times the median sigma: such a point says little

QString number_text(const ProofNumber& n) {
  const ShownUnit unit = shown_unit(n.unit);
  const auto sigma = n.sigma > 0 ? std::optional(unit.scale * n.sigma) : std::nullopt;
  return (widgets::with_sigma_text(unit.scale * n.value, sigma) + ' ' + unit.unit).trimmed();
}

QString size_in_translated(double size, const std::string& unit) {
  const ShownUnit shown = shown_unit(unit);
  return widgets::with_unit_text(shown.scale * size, shown.unit);
}

QString at_most(const ProofPlot& p) {
  const QString size = size_in_translated(p.largest, p.unit);
  return p.hand_m > 0 ? QObject::tr("%1, %2 mm at the hand").arg(size, widgets::short_text(1e3 * p.hand_m)) : size;
}

bool is_spring(const ProofPlot& plot) {
  return plot.numbers.size() == 1 && plot.against_unit.starts_with("N") &&
         plot.numbers.front().unit.ends_with("/(" + plot.against_unit + ")");
}

/// One number that grows with time: no curve without a name, which has more.
bool is_drift(const ProofPlot& plot) {
  return plot.numbers.size() == 1 && plot.against == "time" && plot.quantity.english().ends_with(" of the mount");
}

}  // namespace

bool is_level(const ProofPlot& plot) {
  return plot.numbers.size() == 1 && std::all_of(plot.points.begin(), plot.points.end(), [&](const ProofPoint& p) {
           return p.share[0] == plot.points.front().share[0];
         });
}

widgets::PatternPlot proof_plot(const ProofPlot& proof, const Workbench& workbench, double added) {
  const ShownUnit unit = shown_unit(proof.unit);
  widgets::PatternPlot plot;
  plot.id = QString::fromStdString("proof " + proof.of + " " + proof.quantity.english());
  plot.what = number_title(proof.quantity);
  plot.against = translated(proof.against);
  if (proof.against_unit != "number") plot.x_unit = translated(proof.against_unit);  // an order has no unit
  plot.y_unit = unit.unit;
  const double noise = unit.scale * proof.noise;
  for (const ProofPoint& p : proof.points) {
    const InspectionRow* row = workbench.row(p.id);
    plot.points.push_back({.observation = p.id,
                           .x = p.x,
                           .y = unit.scale * (p.y - added * p.curve),
                           .rms_over_sigma = row ? row->ratio : std::nullopt,
                           .coordinates = row && row->coordinates > 0 ? row->coordinates : 12,
                           .bar = unit.scale * p.sigma,
                           .is_weak = p.sigma > weak * proof.noise});
    if (!workbench.sessions.is_observation_shown(p.id)) continue;
    const double y = unit.scale * (1 - added) * p.curve;
    plot.candidate.push_back({p.x, y, y - noise, y + noise});
  }
  workbench.sessions.apply(plot.points);
  std::stable_sort(plot.candidate.begin(), plot.candidate.end(),
                   [](const widgets::TrendPoint& a, const widgets::TrendPoint& b) { return a.x < b.x; });
  if (added >= 1) plot.trend = std::exchange(plot.candidate, {});
  plot.noise = noise;
  plot.strength = proof.strength / (proof.strength + static_cast<double>(proof.points.size()));
  return plot;
}

QString proof_sentence(const ProofPlot& p) {
  const QString of = place_text(p.of), against = translated(p.against_unit);
  if (is_spring(p)) {
    const ShownUnit unit = shown_unit(p.numbers.front().unit);
    const QString slope =
        widgets::with_sigma_text(unit.scale * p.numbers.front().value, unit.scale * p.numbers.front().sigma);
    const QString per = unit.unit.section('/', 0, 0);
    const QString load = widgets::with_unit_text(p.largest_x, against);
    return p.quantity.english().starts_with("bend")
               ? QObject::tr("%1 bends across its axis by %2 %3 for each %4: %5 at most here, so %6.")
                     .arg(of, slope, per, against, load, at_most(p))
               : QObject::tr("%1 gives way by %2 %3 for each %4: %5 at most here, so %6.")
                     .arg(of, slope, per, against, load, at_most(p));
  }
  QString quantity = number_title(p.quantity);
  quantity[0] = quantity[0].toUpper();
  if (is_level(p)) {
    const bool says_where = p.of.empty() || quantity.contains(of);
    const QString what = says_where ? quantity : QObject::tr("%1 of %2").arg(quantity, of);
    return p.hand_m > 0 ? QObject::tr("%1: %2 in every pose, %3 mm at the hand at most.")
                              .arg(what, number_text(p.numbers.front()), widgets::short_text(1e3 * p.hand_m))
                        : QObject::tr("%1: %2 in every pose.").arg(what, number_text(p.numbers.front()));
  }
  if (is_drift(p)) {
    const QString drift = number_text(p.numbers.front()), what = number_title(p.quantity);
    return p.hand_m > 0 ? QObject::tr("The mount drifts: %1 over the session (%2), %3 mm at the hand at most.")
                              .arg(drift, what, widgets::short_text(1e3 * p.hand_m))
                        : QObject::tr("The mount drifts: %1 over the session (%2).").arg(drift, what);
  }
  QStringList numbers;
  for (const ProofNumber& n : p.numbers)
    numbers << (p.numbers.size() > 1 ? number_title(n.name) + ' ' + number_text(n) : number_text(n));
  return QObject::tr("%1 against the %2: %3; at most %4 here.")
      .arg(quantity, translated(p.against), numbers.join(", "), at_most(p));
}

ProofPlot put_noise_in_place(ProofPlot plot, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> one;
  for (ProofPoint& p : plot.points) p.y = p.sigma * one(random);
  return plot;
}

std::vector<ProofPlot> in_same_order(const std::vector<ProofPlot>& before, std::vector<ProofPlot> after) {
  const auto place = [&](const ProofPlot& plot) {
    return std::find_if(before.begin(), before.end(),
                        [&](const ProofPlot& b) { return b.of == plot.of && b.quantity == plot.quantity; }) -
           before.begin();
  };
  std::stable_sort(after.begin(), after.end(),
                   [&](const ProofPlot& a, const ProofPlot& b) { return place(a) < place(b); });
  return after;
}

}  // namespace handsight::app
