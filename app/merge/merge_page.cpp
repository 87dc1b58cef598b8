// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge/merge_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {
namespace {

enum Column { observation, what, here, there };

QString by_text(MarkedBy by) {
  return by == MarkedBy::hand      ? QObject::tr("by hand")
         : by == MarkedBy::tracker ? QObject::tr("found by the program")
                                   : QObject::tr("imported");
}

QString labels_text(const Observation& o) {
  if (o.sightings.empty()) return QObject::tr("no markers");
  return QObject::tr("%1, %2").arg(counted(static_cast<qint64>(o.sightings.size()), "%n marker(s)"),
                                   by_text(o.sightings.front().by));
}

QString decision_text(const Observation& o) {
  const QString word = o.decision == Decision::accepted   ? QObject::tr("accepted")
                       : o.decision == Decision::rejected ? QObject::tr("rejected")
                       : o.decision == Decision::excluded ? QObject::tr("excluded")
                                                          : QObject::tr("not decided");
  return o.reason.empty() ? word : QObject::tr("%1: %2").arg(word, translated(o.reason));
}

/// How far the same marker is apart in the two, at most: px, or mm of a tracker; negative where no marker is in both.
double farthest(const Collision& c) {
  double most = -1;
  for (const Sighting& a : c.mine.sightings)
    for (const Sighting& b : c.theirs.sightings) {
      if (a.marker != b.marker) continue;
      if (a.point && b.point) most = std::max(most, 1e3 * (*a.point - *b.point).norm());
      for (const CameraPoint& p : a.in_cameras)
        if (const CameraPoint* q = seen_by(b, p.camera)) most = std::max(most, (p.pixel - q->pixel).norm());
    }
  return most;
}

QString what_text(const Collision& c, bool is_tracker) {
  switch (c.what) {
    case Collision::What::labels: {
      const double apart = farthest(c);
      return apart < 0    ? QObject::tr("markers")
             : is_tracker ? QObject::tr("markers, up to %1 mm apart").arg(widgets::short_text(apart))
                          : QObject::tr("markers, up to %1 px apart").arg(widgets::short_text(apart));
    }
    case Collision::What::decision:
      return QObject::tr("whether it counts");
    case Collision::What::gone:
      return QObject::tr("whether it is there");
    case Collision::What::session:
      break;
  }
  return QObject::tr("cameras, markers or joints");
}

QTableWidgetItem* cell(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setToolTip(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  return item;
}

}  // namespace

QString collision_text(const Collision& c, bool mine) {
  const Observation& o = mine ? c.mine : c.theirs;
  switch (c.what) {
    case Collision::What::labels:
      return labels_text(o);
    case Collision::What::decision:
      return decision_text(o);
    case Collision::What::gone:
      return mine ? QObject::tr("%1; %2").arg(labels_text(o), decision_text(o)) : QObject::tr("removed");
    case Collision::What::session:
      break;
  }
  return mine ? QObject::tr("the session as it is here; the file is kept beside it")
              : QObject::tr("the session as it was written; what was done here is kept beside the journal");
}

MergePage::MergePage(Workbench& workbench, QWidget* parent) : Workspace(workbench, parent) {
  setObjectName("merge");
  make_layout();
  connect(table_, &QTableWidget::cellClicked, this, [this](int row, int column) {
    if (column == here || column == there) choose(row, column == here);
  });
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
    const auto& all = workbench_.document.collisions();
    if (row < 0 || row >= static_cast<int>(all.size())) return;
    const std::int64_t id = all[static_cast<std::size_t>(row)].id;
    if (workbench_.document.find(id)) workbench_.selection.select_observation(id);
  });
  connect(all_mine_, &QPushButton::clicked, this, [this] { choose_all(true); });
  connect(all_theirs_, &QPushButton::clicked, this, [this] { choose_all(false); });
  connect(decide_, &QPushButton::clicked, this, &MergePage::decide);
  connect(later_, &QPushButton::clicked, this, [this] {
    workbench_.document.put_off_collisions();
    emit done();
  });
  connect(&workbench.document, &Document::collided, this, [this] {
    mine_.assign(workbench_.document.collisions().size(), true);
    refusal_->clear();
    refresh();
  });
}

void MergePage::make_layout() {
  title_ = new QLabel(tr("Another program has written this session since it was read"), this);
  title_->setFont(widgets::text_font(widgets::TextRole::title));
  title_->setWordWrap(true);
  sentence_ = new QLabel(this);
  sentence_->setObjectName("merge_sentence");
  sentence_->setWordWrap(true);
  table_ = new QTableWidget(0, 4, this);
  table_->setObjectName("merge_table");
  table_->setAccessibleName(tr("What both have changed"));
  table_->setHorizontalHeaderLabels({tr("obs"), tr("what"), tr("done here"), tr("written there")});
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(28);
  table_->setShowGrid(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(observation, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(what, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  refusal_ = new QLabel(this);
  refusal_->setObjectName("merge_refusal");
  refusal_->setWordWrap(true);
  const auto button = [&](const char* name, const QString& text) {
    auto* b = new QPushButton(text, this);
    b->setObjectName(name);
    b->setMinimumHeight(widgets::control_height);
    b->setAutoDefault(false);
    return b;
  };
  all_mine_ = button("merge_all_mine", tr("All as done here"));
  all_theirs_ = button("merge_all_theirs", tr("All as written there"));
  decide_ = button("merge_decide", tr("Put together"));
  decide_->setDefault(true);
  later_ = button("merge_later", tr("Not now"));
  later_->setToolTip(tr("Nothing is written; saving asks again"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(all_mine_);
  row->addWidget(all_theirs_);
  row->addStretch(1);
  row->addWidget(later_);
  row->addWidget(decide_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 12, 16, 12);
  layout->setSpacing(8);
  layout->addWidget(title_);
  layout->addWidget(sentence_);
  layout->addWidget(table_, 1);
  layout->addWidget(refusal_);
  layout->addLayout(row);
}

void MergePage::refresh() {
  const std::vector<Collision>& all = workbench_.document.collisions();
  if (mine_.size() != all.size()) mine_.assign(all.size(), true);
  const bool is_whole = !all.empty() && all.front().what == Collision::What::session;
  sentence_->setText(is_whole
                         ? tr("It now has other cameras, markers or joints, so that nothing of here can be put into "
                              "it. Which of the two is to be the session? The other one is kept.")
                         : tr("What only one side has changed is put together by itself. Here both have changed the "
                              "same: click on what is to count."));
  const bool is_tracker = workbench_.document.session().is_tracker();
  table_->setColumnHidden(observation, is_whole);
  table_->setRowCount(static_cast<int>(all.size()));
  for (int r = 0; r < table_->rowCount(); ++r) {
    const Collision& c = all[static_cast<std::size_t>(r)];
    table_->setItem(r, observation, cell(QString::number(c.id)));
    table_->setItem(r, what, cell(what_text(c, is_tracker)));
    table_->setItem(r, here, cell(collision_text(c, true)));
    table_->setItem(r, there, cell(collision_text(c, false)));
  }
  show_choices();
}

/// The one that counts is ticked and in full ink.
void MergePage::show_choices() {
  for (int r = 0; r < table_->rowCount(); ++r)
    for (const int column : {here, there}) {
      QTableWidgetItem* item = table_->item(r, column);
      const bool counts = mine_[static_cast<std::size_t>(r)] == (column == here);
      item->setCheckState(counts ? Qt::Checked : Qt::Unchecked);
      item->setForeground(counts ? widgets::colors().ink1 : widgets::colors().ink3);
      QFont font = item->font();
      font.setWeight(counts ? QFont::DemiBold : QFont::Normal);
      item->setFont(font);
    }
}

void MergePage::choose(int row, bool mine) {
  if (row < 0 || row >= static_cast<int>(mine_.size())) return;
  mine_[static_cast<std::size_t>(row)] = mine;
  show_choices();
}

void MergePage::choose_all(bool mine) {
  mine_.assign(mine_.size(), mine);
  show_choices();
}

void MergePage::decide() {
  try {
    if (workbench_.document.decide_collisions(mine_)) emit done();
  } catch (const std::exception& error) {
    refusal_->setText(QString::fromUtf8("✗ ") + translated_error(error));
  }
}

/// Left and right say which of the two counts in the row that is chosen.
bool MergePage::key(QKeyEvent* event) {
  const bool is_left = event->key() == Qt::Key_Left;
  if (!is_left && event->key() != Qt::Key_Right) return false;
  choose(table_->currentRow(), is_left);
  return true;
}

}  // namespace handsight::app
