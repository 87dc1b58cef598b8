// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/fixtures_page.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "session/fixtures/fixture_kind.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"
#include "workbench/heading.h"
#include "workbench/touch_views.h"

namespace handsight::app {
namespace {

QString in_mm(std::optional<double> metres) {
  return metres ? widgets::fixed_text(1e3 * *metres, 3) : QStringLiteral("-");
}

/// Where its frame's origin is on its link; of what has no place along itself, how far out it is.
QString place_text(const Session& s, const SessionPart& part, const FitPart& found) {
  if (!found.place_is_determined) return QObject::tr("not determined");
  const Rigid& m = found.mount_from_sensor;
  const FixtureKind& kind = *s.fixtures[static_cast<std::size_t>(part.fixture)].kind;
  const Vector3 z = m.rotation.col(2);
  const auto three = [](const Vector3& v, int decimals) {
    return QStringList{widgets::fixed_text(v.x(), decimals), widgets::fixed_text(v.y(), decimals),
                       widgets::fixed_text(v.z(), decimals)}
        .join(' ');
  };
  if (kind.place == FixturePlace::height)
    return QObject::tr("%1 mm along %2").arg(widgets::fixed_text(1e3 * z.dot(m.translation), 2), three(z, 3));
  return QObject::tr("%1 mm").arg(three(1e3 * m.translation, 2));
}

QStringList split_cells(const Session& s, const SessionPart& part, const PartReport& report) {
  return {translated(s.fixtures[static_cast<std::size_t>(part.fixture)].kind->name()), QString::number(report.used),
          in_mm(report.fitted.rms_m), in_mm(report.held_out.rms_m), place_text(s, part, report.found)};
}

}  // namespace

FixturesPage::FixturesPage(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  setObjectName("fixtures");
  sentence_ = new QLabel(this);
  sentence_->setWordWrap(true);
  const QStringList columns{tr("kind"), tr("touches"), tr("error mm"), tr("held out mm"), tr("where it stands")};
  table_ = new QTableWidget(0, static_cast<int>(columns.size()), this);
  table_->setObjectName("fixtures_table");
  table_->setAccessibleName(tr("What was touched"));
  table_->setHorizontalHeaderLabels(columns);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->verticalHeader()->setDefaultSectionSize(22);
  table_->verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setStretchLastSection(true);
  // Where a plane stands is long: in two lines rather than cut off.
  connect(table_->horizontalHeader(), &QHeaderView::sectionResized, table_, &QTableWidget::resizeRowsToContents,
          Qt::QueuedConnection);
  table_->setFrameShape(QFrame::NoFrame);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(heading(tr("What was touched"), this));
  layout->addWidget(sentence_);
  layout->addWidget(table_, 1);
}

/// Once the last column has the width that is left.
void FixturesPage::fit_rows() {
  QMetaObject::invokeMethod(table_, &QTableWidget::resizeRowsToContents, Qt::QueuedConnection);
}

void FixturesPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit_rows();
}

void FixturesPage::refresh() {
  const Session& s = workbench_.document.session();
  const ModelVersionPointer model = workbench_.document.shown_model();
  const bool is_known = s.is_touch() && model && model->fit && model->parts.size() == s.parts.size();
  sentence_->setText(is_known                             ? tr("The fixtures and the tip are found with the robot.")
                     : model && !model->refusal.isEmpty() ? model->refusal
                                                          : tr("Waits for a fit."));
  table_->setVisible(is_known);
  if (!is_known) return;
  table_->setRowCount(static_cast<int>(s.parts.size()));
  for (int r = 0; r < table_->rowCount(); ++r) {
    const SessionPart& part = s.parts[static_cast<std::size_t>(r)];
    table_->setVerticalHeaderItem(r, new QTableWidgetItem(QString::fromStdString(part.title)));
    const QStringList cells = split_cells(s, part, model->parts[static_cast<std::size_t>(r)]);
    for (int c = 0; c < cells.size(); ++c) {
      auto* item = new QTableWidgetItem(cells[c]);
      const bool is_number = c >= 1 && c <= 3;
      item->setTextAlignment((is_number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      item->setFont(c == 0 ? widgets::text_font(widgets::TextRole::body)
                           : widgets::number_font(widgets::TextRole::body));
      table_->setItem(r, c, item);
    }
  }
  table_->resizeColumnsToContents();
  fit_rows();
}

}  // namespace handsight::app
