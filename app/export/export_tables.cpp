// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the Export workspace: the numbers, and the observations that were not used.
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <algorithm>

#include "diagnosis/attribution/fresh_poses.h"
#include "export/export_workspace.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {

namespace {

using widgets::TextRole;

/// "hit: 4.1, limit 12"
QString fresh_text(const FreshPose& pose) {
  if (pose.is_known_bad && !pose.is_hit)
    return QObject::tr("known to be wrong: %1, limit %2")
        .arg(widgets::short_text(1e3 * pose.distance), widgets::short_text(1e3 * pose.allowed));
  return (pose.is_hit ? QObject::tr("hit: %1, limit %2") : QObject::tr("miss: %1, limit %2"))
      .arg(widgets::short_text(1e3 * pose.distance), widgets::short_text(1e3 * pose.allowed));
}

/// The column scrolls: a bar within it would hide what the first rows do not show. Of more rows than `most` it is
/// there.
int height_of_rows(const QTableWidget& table, int most) {
  int high = table.horizontalHeader()->sizeHint().height();
  for (int r = 0; r < std::min(table.rowCount(), most); ++r) high += table.rowHeight(r);
  return high;
}

}  // namespace

void ExportWorkspace::refresh_motion() {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit) return;
  auto lines = motion_lines(*model, form(), hand());
  if (form() != MotionForm::matrix)
    for (const MotionLine& line : effect_lines(workbench_.document.session(), *model->fit)) lines.push_back(line);
  motion_->setRowCount(static_cast<int>(lines.size()));
  for (int r = 0; r < motion_->rowCount(); ++r) {
    const MotionLine& l = lines[static_cast<std::size_t>(r)];
    const QString cells[] = {l.name, l.value, l.sigma, l.unit};
    for (int c = 0; c < 4; ++c) {
      auto* item = new QTableWidgetItem(cells[c]);
      item->setTextAlignment((c == 1 || c == 2 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      if (c == 1 || c == 2) item->setFont(widgets::number_font(TextRole::body));
      motion_->setItem(r, c, item);
    }
  }
  fit_columns();
}

/// Names as wide as they are, and in several lines where the numbers would be pushed out of sight.
void ExportWorkspace::fit_columns() {
  motion_->horizontalHeader()->setStretchLastSection(false);
  motion_->resizeColumnsToContents();
  int numbers = 0;
  for (int c = 1; c < motion_->columnCount(); ++c) numbers += motion_->columnWidth(c);
  constexpr int scroll_bar = 16, least = 120;
  const int room = std::max(motion_->width() - numbers - scroll_bar, least);
  if (form() != MotionForm::matrix && motion_->columnWidth(0) > room) motion_->setColumnWidth(0, room);
  motion_->horizontalHeader()->setStretchLastSection(true);
  motion_->resizeRowsToContents();
  constexpr int between = 6, one_line = 24;  // else two names of several lines read as one
  for (int r = 0; r < motion_->rowCount(); ++r)
    if (motion_->rowHeight(r) > one_line) motion_->setRowHeight(r, motion_->rowHeight(r) + between);
  const int high = height_of_rows(*motion_, 24);
  // A minimum above the maximum would be drawn over what stands below.
  motion_->setMaximumHeight(std::max(motion_->maximumHeight(), high));
  motion_->setMinimumHeight(high);
}

bool ExportWorkspace::eventFilter(QObject* watched, QEvent* event) {
  if (watched == motion_ && event->type() == QEvent::Resize && motion_->rowCount() > 0) fit_columns();
  return Workspace::eventFilter(watched, event);
}

void ExportWorkspace::refresh_excluded(const ModelVersion& model) {
  const auto& unused = model.report->rejected;
  excluded_title_->setText(
      unused.empty() ? tr("Every observation was used")
                     : tr("%1 not used").arg(counted(static_cast<qint64>(unused.size()), "%n observation(s)")));
  excluded_->setVisible(!unused.empty());
  const auto fresh = fresh_poses(*model.inspection);
  const auto count = [&](auto test) { return std::count_if(fresh.begin(), fresh.end(), test); };
  const auto hits = count([](const FreshPose& p) { return p.is_hit && !p.is_known_bad; });
  const auto bad = count([](const FreshPose& p) { return p.is_known_bad; });
  const auto tests = static_cast<qint64>(fresh.size()) - bad;
  QString sentence = tests == 0
                         ? tr("No fresh pose can test it: the fit has seen all that can be used.")
                         : tr("Fresh poses: of %1 that the fit has not seen, %2 within the 95 % ellipsoid of those "
                              "it has.")
                               .arg(tests)
                               .arg(hits == 1 ? tr("1 lies") : tr("%1 lie").arg(hits));
  if (bad > 0) sentence += ' ' + tr("Known to be wrong and not counted: %1.").arg(bad);
  fresh_->setVisible(!fresh.empty());
  fresh_->setText(sentence);
  excluded_->setRowCount(static_cast<int>(unused.size()));
  for (int r = 0; r < excluded_->rowCount(); ++r) {
    const Unused& u = unused[static_cast<std::size_t>(r)];
    excluded_->setItem(r, 0, new QTableWidgetItem(QString::number(u.id)));
    auto* why = new QTableWidgetItem(translated(u.reason));
    why->setToolTip(why->text());
    excluded_->setItem(r, 2, why);
    const auto pose = std::find_if(fresh.begin(), fresh.end(), [&](const FreshPose& p) { return p.id == u.id; });
    excluded_->setItem(r, 1, new QTableWidgetItem(pose == fresh.end() ? QStringLiteral("-") : fresh_text(*pose)));
  }
  constexpr int gap = 12;  // else a text that ends and one that begins read as one
  for (int column = 0; column < 2; ++column) {
    excluded_->resizeColumnToContents(column);
    excluded_->setColumnWidth(column, excluded_->columnWidth(column) + gap);
  }
  excluded_->resizeRowsToContents();
  constexpr int between = 6;  // else two reasons of several lines read as one
  for (int r = 0; r < excluded_->rowCount(); ++r) excluded_->setRowHeight(r, excluded_->rowHeight(r) + between);
  excluded_->setMinimumHeight(height_of_rows(*excluded_, 8));
}

}  // namespace handsight::app
