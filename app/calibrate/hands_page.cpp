// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/hands_page.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

#include "base/degrees.h"
#include "geometry/rigid.h"
#include "widgets/base/number_text.h"
#include "widgets/base/session_mark.h"
#include "widgets/base/theme.h"
#include "widgets/lists/whole_rows.h"
#include "workbench/heading.h"

namespace handsight::app {
namespace {

constexpr int held_out_row = 8;  // with the robot of the others

/// "12.34 ± 0.05", and what cannot be determined without a figure.
QString with_sigma(double value, double sigma) {
  return std::isfinite(sigma) ? widgets::with_sigma_text(value, sigma) : QObject::tr("not determined");
}

QString error_text(const PartReport& part, const ErrorSummary& error) {
  if (part.has_cameras) return error.rms_pixel ? widgets::short_text(*error.rms_pixel) + " px" : QStringLiteral("-");
  return error.rms_m ? widgets::short_text(1e3 * *error.rms_m) + " mm" : QStringLiteral("-");
}

/// The six numbers, and the errors.
QStringList split_cells(const HandModel& hand, const PartReport& part) {
  QStringList cells;
  const Vector3 rpy = degrees * rpy_from_rotation(hand.tcp_from_body.rotation);
  for (int i = 0; i < 3; ++i) cells << with_sigma(1e3 * hand.tcp_from_body.translation[i], 1e3 * hand.sigma[i]);
  for (int i = 0; i < 3; ++i) cells << with_sigma(rpy[i], degrees * hand.sigma[i + 3]);
  return cells << error_text(part, part.fitted) << error_text(part, part.held_out) << QStringLiteral("-")
               << QString::number(part.used);
}

}  // namespace

HandsPage::HandsPage(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  setObjectName("hands");
  sentence_ = new QLabel(this);
  sentence_->setWordWrap(true);
  sentence_->setObjectName("hands_sentence");
  const QStringList rows{tr("x mm"),        tr("y mm"),      tr("z mm"),
                         tr("roll deg"),    tr("pitch deg"), tr("yaw deg"),
                         tr("fitted"),      tr("held out"),  tr("with the robot of the others"),
                         tr("observations")};
  table_ = new QTableWidget(static_cast<int>(rows.size()), 0, this);
  table_->setObjectName("hands_table");
  table_->setAccessibleName(tr("TCP→Body of each hand"));
  table_->setVerticalHeaderLabels(rows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  constexpr int row_height = 20;
  table_->verticalHeader()->setMinimumSectionSize(18);
  table_->verticalHeader()->setDefaultSectionSize(row_height);
  table_->verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->setFrameShape(QFrame::NoFrame);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(heading(tr("TCP→Body of each hand"), this));
  layout->addWidget(sentence_);
  layout->addWidget(new widgets::WholeRows(table_, row_height, this), 1);
}

void HandsPage::refresh() {
  const ModelVersionPointer model = workbench_.document.shown_model();
  const bool is_known = model && model->fit && !model->hands.empty();
  sentence_->setText(is_known
                         ? tr("The robot is one for all sessions; each hand is its own, or shared where you said so.")
                     : model && !model->refusal.isEmpty() ? model->refusal
                                                          : tr("Waits for a fit."));
  table_->setVisible(is_known);
  if (!is_known) return;
  const QStringList names = workbench_.sessions.names();
  table_->setColumnCount(static_cast<int>(model->hands.size()));
  for (int c = 0; c < table_->columnCount(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    auto* title = new QTableWidgetItem(names.value(c));
    title->setIcon(QIcon(widgets::session_mark_picture(c, 16, devicePixelRatioF())));
    title->setToolTip(names.value(c));
    table_->setHorizontalHeaderItem(c, title);
    const QStringList cells = split_cells(model->hands[at], model->parts[at]);
    for (int r = 0; r < cells.size(); ++r) {
      auto* item = new QTableWidgetItem(cells[r]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setFont(widgets::number_font(widgets::TextRole::body));
      table_->setItem(r, c, item);
    }
  }
  show_held_out();
  table_->resizeColumnsToContents();
}

/// Was the robot learned, or the fixture? Of longer collections it takes too long, and blunders would rule it.
void HandsPage::look() {
  const ModelVersionPointer model = workbench_.document.model();
  const bool is_wanted = model && model->fit && !model->hands.empty() && model->report->used <= most_shown &&
                         model->wrong_points.empty() && model->lone.empty();
  if (!is_wanted || model == held_out_of_) return;
  held_out_of_ = model;
  held_out_.clear();
  for (int c = 0; c < table_->columnCount(); ++c)
    if (QTableWidgetItem* item = table_->item(held_out_row, c)) item->setText(QStringLiteral("…"));
  workbench_.background.start<std::vector<ErrorSummary>>(
      "sessions held out", tr("Sessions held out one by one"),
      [model, session = workbench_.document.shared_session()](JobControl& control) {
        FitReport reported = *model->report;
        hold_out_sessions(*session, *model->fit, model->options, reported, [&] { return !control.is_cancelled(); });
        std::vector<ErrorSummary> errors;
        for (const PartReport& part : part_reports(*session, *model->fit, reported))
          errors.push_back(part.held_out_session);
        return errors;
      },
      [this, model](const std::vector<ErrorSummary>& errors) {
        if (model != held_out_of_) return;
        held_out_ = errors;
        show_held_out();
      },
      [](const QString&) {});
}

void HandsPage::show_held_out() {
  const ModelVersionPointer model = workbench_.document.shown_model();
  if (!model || model != held_out_of_ || model->parts.size() != held_out_.size()) return;
  for (int c = 0; c < table_->columnCount() && c < static_cast<int>(held_out_.size()); ++c) {
    const auto at = static_cast<std::size_t>(c);
    if (QTableWidgetItem* item = table_->item(held_out_row, c))
      item->setText(error_text(model->parts[at], held_out_[at]));
  }
}

}  // namespace handsight::app
