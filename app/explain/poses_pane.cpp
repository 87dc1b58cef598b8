// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/poses_pane.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "base/degrees.h"
#include "base/files.h"
#include "base/numbers.h"
#include "document/effect_words.h"
#include "findings/explain_texts.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

constexpr int poses_planned = 6;

/// A header of joint names, one pose a line, as `handsight-cli predict` reads it.
std::string poses_csv(const Session& session, const Plan& plan) {
  std::string text;
  const auto put = [&](bool is_first, const std::string& cell) {
    if (!is_first) text += ',';
    text += cell;
  };
  const bool are_touches = session.is_touch();  // then the fixture comes first
  if (are_touches) put(true, "fixture");
  for (std::size_t j = 0; j < session.joints.size(); ++j) put(j == 0 && !are_touches, session.joints[j]);
  text += '\n';
  for (const PlannedPose& pose : plan.poses) {
    if (are_touches) put(true, session.fixtures.at(static_cast<std::size_t>(pose.fixture)).id);
    for (Eigen::Index j = 0; j < pose.position.size(); ++j)
      put(j == 0 && !are_touches, format_number(pose.position[j]));
    text += '\n';
  }
  return text;
}

}  // namespace

PosesPane::PosesPane(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  title_ = new QLabel(tr("Poses that would tell"), this);
  title_->setFont(widgets::text_font(widgets::TextRole::title));
  back_ = new QPushButton(tr("Back to the candidates"), this);
  back_->setObjectName("poses_back");
  sentence_ = new QLabel(this);
  sentence_->setObjectName("poses_sentence");
  sentence_->setWordWrap(true);
  table_ = new QTableWidget(this);
  table_->setObjectName("poses_table");
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->verticalHeader()->setDefaultSectionSize(24);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->setHighlightSections(false);
  path_ = new QLineEdit(this);
  path_->setObjectName("poses_path");
  save_ = new QPushButton(tr("Save as a table"), this);
  save_->setObjectName("poses_save");
  said_ = new QLabel(this);
  said_->setObjectName("poses_said");
  said_->setWordWrap(true);
  auto* head = new QHBoxLayout;
  head->addWidget(title_);
  head->addStretch(1);
  head->addWidget(back_);
  auto* row = new QHBoxLayout;
  row->addWidget(path_, 1);
  row->addWidget(save_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(head);
  layout->addWidget(sentence_);
  layout->addWidget(table_, 1);
  layout->addLayout(row);
  layout->addWidget(said_);
  connect(back_, &QPushButton::clicked, this, &PosesPane::closed);
  connect(save_, &QPushButton::clicked, this, &PosesPane::save);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int chosen) {
    if (plan_ && chosen >= 0 && chosen < static_cast<int>(plan_->poses.size()))
      emit pose_chosen(plan_->poses[static_cast<std::size_t>(chosen)].position);
  });
  connect(&workbench.explaining, &Jobs::stopped, this, [this] {
    if (!plan_ && table_->rowCount() == 0) sentence_->setText(tr("Stopped before poses were found."));
  });
  connect(&workbench.document, &Document::opened, this, [this] {
    path_->setText(QString::fromStdString((folder(workbench_.document.session()) / "poses.csv").string()));
    plan_.reset();
  });
}

void PosesPane::plan_for(const std::string& id) {
  const ModelSettings settings = workbench_.document.settings();
  PlanOptions options;
  options.count = poses_planned;
  options.effects = settings.held;
  options.estimated = settings.estimated;
  QString what = tr("make the estimate surer");
  std::string rival;
  if (const auto diagnosis = workbench_.diagnosing.diagnosis(); diagnosis && !id.empty())
    for (const DiagnosisCandidate& c : diagnosis->candidates)
      if (c.id == id && !c.indistinguishable_from.empty()) {
        rival = c.indistinguishable_from.front();
        what = tr("tell %1 from %2").arg(effect_text(id, c.where), effect_text(rival, {}));
        for (const DiagnosisCandidate& other : diagnosis->candidates)
          if (other.id == rival) options.between = CompetingEffects{id, rival, c.terms, other.terms};
      }
  plan_.reset();
  said_->clear();
  table_->setRowCount(0);
  save_->setEnabled(false);
  sentence_->setText(tr("Looking for poses that would %1 ...").arg(what));
  workbench_.explaining.start<Plan>(
      "plan", tr("Planning poses"),
      [session = workbench_.document.shared_session(), options](JobControl&) { return plan(*session, options); },
      [this, what](const Plan& made) { show_plan(made, what); },
      [this](const QString& sentence) { sentence_->setText(sentence); });
}

void PosesPane::show_plan(const Plan& made, const QString& what) {
  plan_ = made;
  const Session& session = workbench_.document.session();
  QString text = tr("%1 more poses would %2. Choose one to see it in 3D.").arg(made.poses.size()).arg(what);
  if (session.is_touch())
    text = tr("%1 more touches would %2. Choose one to see it in 3D.").arg(made.poses.size()).arg(what);
  if (!made.tells_apart)
    text = session.is_touch() ? tr("No touch of these fixtures would %1.").arg(what)
                              : tr("No pose that the cameras could see would %1.").arg(what);
  if (made.tells_apart && !made.poses.empty() && made.poses.back().ln_bayes_factor)
    text += ' ' + tr("Expected odds after them: %1.").arg(odds_text(made.poses.back().ln_bayes_factor->minCoeff()));
  sentence_->setText(text);
  QStringList names;
  for (const std::string& joint : session.joints) names << QString::fromStdString(joint);
  table_->setColumnCount(static_cast<int>(names.size()));
  table_->setHorizontalHeaderLabels(names);
  table_->setRowCount(static_cast<int>(made.poses.size()));
  QStringList rows;
  for (std::size_t r = 0; r < made.poses.size(); ++r) {
    const int fixture = made.poses[r].fixture;
    rows << (fixture < 0 ? QString::number(r + 1)
                         : QString::fromStdString(session.fixtures.at(static_cast<std::size_t>(fixture)).id));
  }
  table_->setVerticalHeaderLabels(rows);
  for (int r = 0; r < table_->rowCount(); ++r)
    for (int c = 0; c < table_->columnCount(); ++c) {
      const int joint = find_joint(session.robot, session.joints[static_cast<std::size_t>(c)]);
      const bool slides = session.robot.joints[static_cast<std::size_t>(joint)].kind == JointKind::prismatic;
      const double value = made.poses[static_cast<std::size_t>(r)].position[c];
      auto* item = new QTableWidgetItem(slides ? widgets::fixed_text(1e3 * value, 1) + tr(" mm")
                                               : widgets::fixed_text(degrees * value, 1) + QChar(0x00B0));
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setFont(widgets::number_font(widgets::TextRole::small));
      table_->setItem(r, c, item);
    }
  table_->resizeColumnsToContents();
  save_->setEnabled(!made.poses.empty());
  if (table_->rowCount() > 0) table_->setCurrentCell(0, 0);
}

void PosesPane::save() {
  if (!plan_) return;
  try {
    replace_file(path_->text().trimmed().toStdString(), poses_csv(workbench_.document.session(), *plan_));
    said_->setText(tr("Written: %1, in rad and m.").arg(path_->text().trimmed()));
  } catch (const std::exception& error) {
    said_->setText(translated_error(error));
  }
}

}  // namespace handsight::app
