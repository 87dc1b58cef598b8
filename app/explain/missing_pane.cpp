// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/missing_pane.h"

#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

#include "base/error.h"
#include "explain/adding_on.h"
#include "explain/poses_pane.h"
#include "explain/truth.h"
#include "findings/robot_checks.h"
#include "widgets/base/theme.h"
#include "widgets/explain/candidate_list.h"
#include "widgets/explain/effect_table.h"
#include "words/core_words.h"

namespace handsight::app {

using widgets::CandidateList;
using widgets::EffectTable;

MissingPane::MissingPane(Workbench& workbench, Adding& adding, QWidget* parent)
    : QWidget(parent), workbench_(workbench), adding_(adding) {
  make_layout();
  connect_all();
}

QWidget* MissingPane::page_with_way_back(QWidget* content, const QString& title, const char* name) {
  auto* page = new QWidget(this);
  auto* label = new QLabel(title, page);
  label->setFont(widgets::text_font(widgets::TextRole::title));
  auto* back = new QPushButton(tr("Back to the candidates"), page);
  back->setObjectName(name);
  connect(back, &QPushButton::clicked, this, &MissingPane::show_cards);
  auto* head = new QHBoxLayout;
  head->addWidget(label);
  head->addStretch(1);
  head->addWidget(back);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(head);
  layout->addWidget(content, 1);
  return page;
}

void MissingPane::make_layout() {
  cards_ = new CandidateList(this);
  cards_->setObjectName("cards");
  table_ = new EffectTable(this);
  table_->setObjectName("effect_table");
  constexpr int why_column = 3;  // it stands in full below the table
  table_->view()->setColumnHidden(why_column, true);
  truth_ = new widgets::TruthPanel(this);
  truth_->setObjectName("truth");
  poses_ = new PosesPane(workbench_, this);
  poses_->setObjectName("poses");
  row_reason_ = new QLabel(tr("Point at an effect, and here stands why. A double click opens its slider."), this);
  row_reason_->setObjectName("row_reason");
  row_reason_->setWordWrap(true);
  row_reason_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  row_reason_->setMinimumHeight(54);
  table_page_ = page_with_way_back(table_, tr("Why not ...? All effects"), "table_back");
  table_page_->layout()->addWidget(row_reason_);
  truth_page_ = page_with_way_back(truth_, tr("The truth"), "truth_back");
  auto* cards = new QWidget(this);
  auto* column = new QVBoxLayout(cards);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(cards_, 1);
  make_until_it_stops();
  cards_->add_at_foot(until_it_stops_, widgets::FootPlace::before_why_not);
  cards_->add_at_foot(pause_, widgets::FootPlace::after_why_not);
  pages_ = new QStackedWidget(this);
  for (QWidget* page : {cards, table_page_, truth_page_, static_cast<QWidget*>(poses_)}) pages_->addWidget(page);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);
  setMinimumSize(360, 200);
}

void MissingPane::make_until_it_stops() {
  adding_on_ = new AddingOn(workbench_, adding_, *cards_, this);
  until_it_stops_ = new QPushButton(this);
  until_it_stops_->setObjectName("until_it_stops");
  pause_ = new QPushButton(this);
  pause_->setObjectName("pause_adding");
  pause_->setToolTip(tr("Rests after the cause that is being added, so that its proof can be looked at"));
  const auto show_state = [this] {
    pause_->setText(adding_on_->is_paused() ? tr("Go on") : tr("Pause"));
    pause_->setVisible(adding_on_->is_running());
    show_until_it_stops();
  };
  show_state();
  until_it_stops_->setMinimumWidth(until_it_stops_->sizeHint().width());  // Stop stands in the same place
  connect(adding_on_, &AddingOn::changed, this, show_state);
  connect(adding_on_, &AddingOn::done, this, &MissingPane::added_until_it_stopped);
  connect(until_it_stops_, &QPushButton::clicked, this,
          [this] { adding_on_->is_running() ? adding_on_->stop() : adding_on_->start(); });
  connect(pause_, &QPushButton::clicked, this,
          [this] { adding_on_->is_paused() ? adding_on_->go_on() : adding_on_->pause(); });
}

void MissingPane::connect_all() {
  connect(cards_, &CandidateList::preview, this, &MissingPane::tried);
  connect(cards_, &CandidateList::preview_ended, this, [this] { emit tried({}); });
  connect(cards_, &CandidateList::add, this, [this](const QString& id) { adding_.add(id.toStdString()); });
  connect(cards_, &CandidateList::what_if, this, &MissingPane::what_if);
  connect(cards_, &CandidateList::show_poses, this, [this](const QString& id) { show_poses(id.toStdString()); });
  connect(cards_, &CandidateList::measured, this, [this](const QString& id, const QString& text) {
    const auto diagnosis = workbench_.diagnosing.diagnosis();
    if (!diagnosis) return;
    const QString refusal = take_reading(workbench_.document, *diagnosis, id.toStdString(), text);
    if (!refusal.isEmpty()) cards_->set_measured_note(id, refusal);
  });
  connect(&workbench_.document, &Document::readings_changed, this, &MissingPane::refresh);
  connect(cards_, &CandidateList::why_not_requested, this, [this] { pages_->setCurrentWidget(table_page_); });
  connect(cards_, &CandidateList::action, this, [this](const QString& action) {
    if (action == "plan") show_poses({});
    if (action == "curve") emit curve_wanted();
    if (action == "export") emit export_wanted();
    if (action == "look") emit look_wanted();
  });
  connect(table_, &EffectTable::chosen, this, &MissingPane::what_if);
  connect(table_, &EffectTable::hovered, this, &MissingPane::tried);
  connect(table_, &EffectTable::hovered, this, &MissingPane::explain_row);
  connect(table_->view()->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& now) {
            const auto shown = table_->shown();
            if (now.isValid() && now.row() < static_cast<int>(shown.size()))
              explain_row(shown[static_cast<std::size_t>(now.row())]);
          });
  connect(poses_, &PosesPane::closed, this, &MissingPane::show_cards);
  connect(truth_, &widgets::TruthPanel::row_chosen, this, [this] { pages_->setCurrentWidget(table_page_); });
  connect(&adding_, &Adding::began, this, [this] {
    show_cards();
    cards_->set_can_add(false);
  });
  connect(&adding_, &Adding::ended, this, [this] { cards_->set_can_add(true); });  // the workspace refreshes
  connect(&workbench_.document, &Document::opened, this, [this] {
    show_cards();
    shown_for_.reset();
  });
}

void MissingPane::explain_row(const QString& id) {
  for (const widgets::EffectRow& row : rows_)
    if (row.id == id)
      row_reason_->setText(row.name + (row.where.isEmpty() ? QString() : " (" + row.where + ")") + ": " +
                           widgets::effect_verdict_text(row.verdict) +
                           (row.same_as.isEmpty() ? QString() : ' ' + row.same_as) + ". " + row.reason);
}

bool MissingPane::can_reveal() const {
  return workbench_.document.is_open() && knows_truth(workbench_.document.session());
}

void MissingPane::reveal() {
  refresh_truth();
  pages_->setCurrentWidget(truth_page_);
}

void MissingPane::add_until_it_stops() {
  if (until_it_stops_->isEnabled() && !adding_on_->is_running()) adding_on_->start();
}

bool MissingPane::is_paused() const { return adding_on_->is_paused(); }

void MissingPane::show_why_not() { pages_->setCurrentWidget(table_page_); }

void MissingPane::show_cards() { pages_->setCurrentIndex(0); }

void MissingPane::show_poses(const std::string& id) {
  pages_->setCurrentWidget(poses_);
  poses_->plan_for(id);
}

void MissingPane::refresh_truth() {
  const ModelVersionPointer model = workbench_.document.shown_model();
  truth_->set_empty_text(tr("This session does not know its truth."));
  if (!model || !model->fit || !knows_truth(workbench_.document.session())) return truth_->set_rows({}, {});
  try {
    const TruthComparison c =
        compare_with_truth(workbench_.document.session(), read_truth(workbench_.document.session()), *model->fit,
                           workbench_.diagnosing.diagnosis().get());
    if (c.rows.empty()) truth_->set_empty_text(c.sentence);
    truth_->set_rows(c.rows, c.sentence);
  } catch (const InputError& error) {
    truth_->set_empty_text(translated_error(error));
    truth_->set_rows({}, {});
  }
}

void MissingPane::refresh() {
  refresh_cards();
  show_until_it_stops();
  adding_on_->look();
}

/// Where nothing is left to add it would do nothing. What no robot is built like stands behind what is said of it.
void MissingPane::show_until_it_stops() {
  bool can_begin = adding_on_->can_seek() && workbench_.blunders().empty();
  for (int i = 0; i < cards_->count(); ++i) {
    const widgets::CardState& card = cards_->card(i)->state();
    can_begin = can_begin || (card.kind == widgets::CardKind::candidate && card.can_add);
  }
  const bool runs = adding_on_->is_running();
  const bool can_seek_longer = !can_begin && workbench_.blunders().empty() && adding_on_->can_seek_longer();
  until_it_stops_->setText(runs ? tr("Stop") : can_seek_longer ? tr("Seek longer") : tr("Add until it stops"));
  until_it_stops_->setToolTip(
      runs ? tr("Stops; what was taken so far stays")
      : can_seek_longer
          ? tr("Begins again with each other name, and without each of those that were added: takes minutes; what it "
               "finds is taken where it is clearly likelier and predicts as well")
          : tr("Adds the first card, and the first of what is left, until nothing more helps; then seeks other names "
               "that explain what was added better"));
  const bool is_ending = !runs && adding_.is_running();
  until_it_stops_->setEnabled(runs || ((can_begin || can_seek_longer) && !is_ending));
}

void MissingPane::refresh_cards() {
  const ModelVersionPointer model = workbench_.document.model();
  const auto diagnosis = workbench_.diagnosing.diagnosis();
  if (pages_->currentWidget() == truth_page_) refresh_truth();
  if (!model || !model->fit) {
    const auto& observations = workbench_.document.session().observations;
    const auto used = std::count_if(observations.begin(), observations.end(), is_used);
    cards_->set_empty_text(workbench_.refit.is_pending()
                               ? tr("Comes with the fit of %1 observations.").arg(used)
                               : tr("Waits for a fit of at least 8 observations; %1 so far.").arg(used));
    if (!workbench_.refit.is_pending()) cards_->set_cards({}, widgets::CardOrder::fresh);
    return;
  }
  if (!workbench_.blunders().empty()) return cards_->set_cards({mistake_card()}, widgets::CardOrder::fresh);
  if (!diagnosis) {
    const bool runs = workbench_.diagnosing.is_running();
    cards_->set_empty_text(runs ? tr("Trying every effect of the catalogue ...") : QString());
    std::vector<widgets::CardState> stopped;
    if (!runs)
      stopped.push_back({.id = "honest",
                         .kind = widgets::CardKind::too_few,
                         .title = tr("Stopped"),
                         .words = tr("The search for what is missing was stopped before it was done."),
                         .can_add = false,
                         .can_what_if = false,
                         .action = tr("Look again"),
                         .action_id = "look"});
    cards_->set_cards(std::move(stopped), widgets::CardOrder::fresh);
    table_->set_rows({});
    shown_for_.reset();
    return;
  }
  const bool news = shown_for_ && same_fit(*shown_for_, *model);
  shown_for_ = model;
  cards_->set_empty_text(tr("Nothing to add."));
  cards_->set_cards(candidate_cards(workbench_, model, *diagnosis, adding_.refused()),
                    news ? widgets::CardOrder::kept : widgets::CardOrder::fresh);
  rows_ = effect_rows(workbench_, *model, *diagnosis, adding_.refused());
  table_->set_rows(rows_);
}

}  // namespace handsight::app
