// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/objective_page.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QRadioButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "base/degrees.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/lists/whole_rows.h"

namespace handsight::app {
namespace {

constexpr int row_height = 22;  // px
constexpr Objective objectives[] = {Objective::image, Objective::camera, Objective::angle_axis};

QString objective_name(Objective o) {
  return o == Objective::image    ? QObject::tr("Image")
         : o == Objective::camera ? QObject::tr("Camera")
                                  : QObject::tr("Angle-axis");
}

}  // namespace

ObjectivePage::ObjectivePage(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(new QLabel(tr("Fit by"), this));
  choices_ = new QButtonGroup(this);
  const QString tips[] = {tr("Least error in the images, px (thesis 4.42): the one to use"),
                          tr("Least distance of the triangulated markers, m (thesis 4.41)"),
                          tr("Least error of each observation's body pose (thesis 4.39)")};
  for (int i = 0; i < 3; ++i) {
    auto* button = new QRadioButton(objective_name(objectives[i]), this);
    button->setObjectName("objective_" + QString::number(i));
    button->setToolTip(tips[i]);
    choices_->addButton(button, i);
    row->addWidget(button);
  }
  row->addStretch(1);
  fix_ = new QCheckBox(tr("Hold the body's shape at its average"), this);
  fix_->setObjectName("fix_markers");
  fix_->setToolTip(tr("Thesis (4.19-4.23): the markers move as one body"));
  table_ = new QTableWidget(9, 3, this);
  table_->setObjectName("objective_table");
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->verticalHeader()->setDefaultSectionSize(row_height);
  table_->verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  for (QHeaderView* header : {table_->verticalHeader(), table_->horizontalHeader()})
    header->setFont(widgets::text_font(widgets::TextRole::small));
  QStringList names;
  for (const Objective o : objectives) names << objective_name(o);
  table_->setHorizontalHeaderLabels(names);
  table_->setVerticalHeaderLabels({tr("x mm"), tr("y mm"), tr("z mm"), tr("roll deg"), tr("pitch deg"), tr("yaw deg"),
                                   tr("error px"), tr("held out px"), tr("error mm")});
  sentence_ = new QLabel(this);
  sentence_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 0);
  layout->addLayout(row);
  layout->addWidget(fix_);
  layout->addWidget(new widgets::WholeRows(table_, row_height, this), 1);
  layout->addWidget(sentence_);
  connect(choices_, &QButtonGroup::idClicked, this, [this](int id) {
    ModelSettings settings = workbench_.document.settings();
    settings.objective = objectives[id];
    choose(settings);
  });
  connect(fix_, &QCheckBox::clicked, this, [this](bool on) {
    ModelSettings settings = workbench_.document.settings();
    settings.fix_markers = on;
    choose(settings);
  });
  connect(&workbench.document, &Document::model_changed, this, [this] {
    if (is_active_) compare();
  });
  connect(&workbench.document, &Document::closed, this, [this] {
    compared_ = -1;
    table_->clearContents();
  });
}

void ObjectivePage::set_active(bool active) {
  is_active_ = active;
  if (active) compare();
}

void ObjectivePage::choose(const ModelSettings& settings) {
  const ModelSettings before = workbench_.document.settings();
  if (settings == before) return;
  const QString sentence = settings.objective != before.objective
                               ? tr("fitted by the %1 objective").arg(objective_name(settings.objective).toLower())
                           : settings.fix_markers ? tr("held the body's shape")
                                                  : tr("let the body's shape free");
  workbench_.document.perform({.sentence = sentence, .settings = SettingsEdit{before, settings}});
}

void ObjectivePage::compare() {
  const ModelSettings& settings = workbench_.document.settings();
  for (int i = 0; i < 3; ++i) choices_->button(i)->setChecked(settings.objective == objectives[i]);
  fix_->setChecked(settings.fix_markers);
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || compared_ == workbench_.document.revision()) return;
  compared_ = workbench_.document.revision();
  workbench_.jobs.start<std::array<ModelVersionPointer, 3>>(
      "objectives", tr("Comparing the three objectives"),
      [session = workbench_.document.shared_session(), settings, revision = compared_](JobControl& control) {
        std::array<ModelVersionPointer, 3> results;
        for (std::size_t i = 0; i < 3 && !control.is_cancelled(); ++i) {
          ModelSettings one = settings;
          one.objective = objectives[i];
          results[i] = make_version(*session, one, revision, {}, {}, going_on(control));
          control.report(static_cast<double>(i + 1) / 3);
        }
        return results;
      },
      [this](const std::array<ModelVersionPointer, 3>& results) {
        if (results[0] && results[0]->revision == workbench_.document.revision()) show_results(results);
      },
      [this](const QString& sentence) {
        sentence_->setText(sentence);
        sentence_->show();
      });
}

void ObjectivePage::show_results(const std::array<ModelVersionPointer, 3>& results) {
  QString refusals;
  for (int column = 0; column < 3; ++column) {
    const ModelVersion& v = *results[static_cast<std::size_t>(column)];
    QStringList cells;
    if (v.fit) {
      const Vector6 sigma = origin_sigma(*v.fit);
      const Vector3 rpy = rpy_from_rotation(v.fit->tcp_from_body.rotation);
      for (int i = 0; i < 3; ++i)
        cells << widgets::with_sigma_text(1e3 * v.fit->tcp_from_body.translation[i], 1e3 * sigma[i]);
      for (int i = 0; i < 3; ++i) cells << widgets::with_sigma_text(degrees * rpy[i], degrees * sigma[i + 3]);
      const ErrorSummary& e = v.report->fitted;
      cells << widgets::short_text(e.rms_pixel, 3) << widgets::short_text(v.report->held_out.rms_pixel, 3)
            << widgets::short_text(e.rms_m ? std::optional(1e3 * *e.rms_m) : std::nullopt, 3);
    } else {
      refusals += objective_name(objectives[column]) + ": " + v.refusal + "\n";
    }
    for (int r = 0; r < table_->rowCount(); ++r) {
      auto* item = new QTableWidgetItem(r < cells.size() ? cells[r] : QString("-"));
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setFont(widgets::number_font(widgets::TextRole::small));
      table_->setItem(r, column, item);
    }
  }
  sentence_->setText(refusals.trimmed());
  sentence_->setVisible(!refusals.isEmpty());
}

}  // namespace handsight::app
