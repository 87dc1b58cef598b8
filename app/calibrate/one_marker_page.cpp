// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/one_marker_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/lists/whole_rows.h"
#include "words/counted.h"

namespace handsight::app {

OneMarkerPage::OneMarkerPage(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  constexpr int row_px = 22;
  marker_ = new QComboBox(this);
  marker_->setObjectName("one_marker");
  marker_->setFocusPolicy(Qt::StrongFocus);
  table_ = new QTableWidget(0, 5, this);
  table_->setObjectName("one_marker_table");
  table_->setHorizontalHeaderLabels({tr("obs"), tr("mass kg"), tr("before mm"), tr("after mm"), tr("angle deg")});
  table_->setToolTip(
      tr("Mass: the force at the TCP, as a mass, that pulls it toward the measured marker. Before and "
         "after: how far the marker is off. Angle: between that and what the springs can do at all."));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(row_px);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  sentence_ = new QLabel(this);
  sentence_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Pull toward"), this));
  row->addWidget(marker_);
  row->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 0);
  layout->addLayout(row);
  layout->addWidget(new widgets::WholeRows(table_, row_px, this), 1);
  layout->addWidget(sentence_);
  connect(marker_, &QComboBox::activated, this, &OneMarkerPage::compute);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int r) {
    if (!is_filling_ && r >= 0)
      workbench_.selection.select_observation(table_->item(r, 0)->data(Qt::UserRole).toLongLong());
  });
  connect(&workbench.document, &Document::model_changed, this, [this] {
    if (is_active_) compute();
  });
}

void OneMarkerPage::set_active(bool active) {
  is_active_ = active;
  if (!active) return;
  const int count = workbench_.document.session().marker_count;
  if (marker_->count() != count) {
    marker_->clear();
    for (int m = 0; m < count; ++m) marker_->addItem(tr("marker %1").arg(m), m);
  }
  compute();
}

void OneMarkerPage::compute() {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit) {
    table_->setRowCount(0);
    sentence_->setText(tr("Waits for a fit."));
    return;
  }
  OneMarkerOptions options;
  options.marker = std::max(0, marker_->currentIndex());
  options.marker_in_tcp = estimate(*model->fit).markers_in_tcp[static_cast<std::size_t>(options.marker)];
  workbench_.jobs.start<OneMarkerResult>(
      "one marker", tr("Effective masses"),
      [session = workbench_.document.shared_session(), options](JobControl&) {
        return effective_masses(*session, options);
      },
      [this](const OneMarkerResult& result) { show_result(result); },
      [this](const QString& refusal) {
        table_->setRowCount(0);
        sentence_->setText(refusal);
      });
}

void OneMarkerPage::show_result(const OneMarkerResult& result) {
  is_filling_ = true;
  table_->setRowCount(static_cast<int>(result.observations.size()));
  for (int r = 0; r < table_->rowCount(); ++r) {
    const EffectiveMass& m = result.observations[static_cast<std::size_t>(r)];
    const QString cells[] = {
        QString::number(m.id), widgets::fixed_text(m.mass, 2), widgets::fixed_text(1e3 * m.before.norm(), 2),
        widgets::fixed_text(1e3 * m.after.norm(), 2), widgets::fixed_text(57.29577951308232 * m.angle, 1)};
    for (int c = 0; c < 5; ++c) {
      auto* item = new QTableWidgetItem(cells[c]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setFont(widgets::number_font(widgets::TextRole::small));
      item->setData(Qt::UserRole, static_cast<qlonglong>(m.id));
      table_->setItem(r, c, item);
    }
  }
  is_filling_ = false;
  QString text = tr("Springs of %1").arg(counted(static_cast<qint64>(result.joints.size()), "%n joint(s)"));
  if (result.stiffness_is_assumed) text += tr("; 10,000 N m/rad where none is declared");
  if (!result.left_out.empty())
    text += tr(". %1 without it in both images")
                .arg(counted(static_cast<qint64>(result.left_out.size()), "%n observation(s)"));
  sentence_->setText(text + ".");
}

}  // namespace handsight::app
