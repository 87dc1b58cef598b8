// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/bill_entries.h"

#include <algorithm>

#include "base/percent.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "widgets/base/number_text.h"

namespace handsight::app {
namespace {

QString cause_of(const BillRow& row, const Fit& fit) {
  QString name = effect_text(row.id, row.is_small ? std::vector<std::string>{} : row.where);
  if (row.unnamed)
    for (const FittedEffect& f : fit.effects)
      if (f.term.id == row.id) name = make_title(f.term, fit.problem.source->chain.robot);
  return name.left(1).toUpper() + name.mid(1);
}

QString built_text(const BillRow& row) {
  if (row.stands_in() && !row.stands_in_at.empty()) {
    QStringList places;
    for (const std::string& place : row.stands_in_at) places << QString::fromStdString(place);
    const QString at = places.join(", ");
    return row.pushes_back
               ? QObject::tr("at %1 a spring that pushes back: there it stands in for another cause").arg(at)
               : QObject::tr("at %1 larger than robots are built: there it stands in for another cause").arg(at);
  }
  if (row.pushes_back) return QObject::tr("a spring that pushes back: it stands in for another cause");
  if (row.too_large) return QObject::tr("larger than robots are built: it stands in for another cause");
  if (row.held) return QObject::tr("held, not estimated");
  if (row.is_small) return QObject::tr("a little at each joint, as in every robot");
  return row.unnamed ? QObject::tr("no name in the catalogue") : QObject::tr("plausible");
}

QString reported_text(const BillRow& row) {
  if (!row.indistinguishable_from || row.held) return {};
  if (row.indistinguishable_from->empty()) return QObject::tr("told from all others");
  QStringList others;
  for (const std::string& id : *row.indistinguishable_from) others << effect_text(id, {});
  return QObject::tr("not told from %1").arg(others.join(", "));
}

/// Nothing is quite sure.
QString sure_text(const BillRow& row) {
  if (!row.probability || row.held) return {};
  const double shown = std::clamp(*row.probability, 0.001, 0.999);
  return QObject::tr("sure to %1 %").arg(widgets::short_text(100 * shown, 3));
}

}  // namespace

std::vector<widgets::BillEntry> bill_entries(const std::vector<BillRow>& rows, const Fit& fit) {
  std::vector<widgets::BillEntry> entries;
  for (const BillRow& row : rows) {
    const auto sigma = row.hand_sigma_m > 0 ? std::optional(1e3 * row.hand_sigma_m) : std::nullopt;
    entries.push_back({.id = QString::fromStdString(row.id),
                       .cause = cause_of(row, fit),
                       .worth = widgets::with_sigma_unit_text(1e3 * row.hand_m, sigma, QObject::tr("mm")),
                       .sure = sure_text(row),
                       .built = built_text(row),
                       .reported = reported_text(row),
                       .is_stand_in = row.stands_in()});
  }
  return entries;
}

std::vector<widgets::BillEntry> bill_entries(const Workbench& workbench, const ModelVersionPointer& model) {
  if (!model || !model->fit) return {};
  return bill_entries(workbench.make_bill(model), *model->fit);
}

}  // namespace handsight::app
