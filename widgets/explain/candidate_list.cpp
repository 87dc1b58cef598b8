// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/candidate_list.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/base/theme.h"
#include "widgets/explain/main_button.h"

namespace handsight::widgets {
namespace {

constexpr int least_add_width = 128;

}  // namespace

CandidateList::CandidateList(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(0, 0, layout_gap, 0);
  title_ = new QLabel(tr("What is missing"), this);
  title_->setFont(text_font(TextRole::title));
  title_->setFixedHeight(control_height);
  resort_ = new QPushButton(tr("Order changed: sort again"), this);
  resort_->setFont(text_font(TextRole::small));
  resort_->hide();
  head->addWidget(title_);
  head->addStretch(1);
  head->addWidget(resort_);
  layout->addLayout(head);

  scroll_ = new QScrollArea(this);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  content_ = new QWidget(scroll_);
  list_ = new QVBoxLayout(content_);
  list_->setContentsMargins(0, 0, 2, 0);
  list_->setSpacing(layout_gap);
  empty_ = new QLabel(content_);
  empty_->setWordWrap(true);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setMargin(wide_gap);
  list_->addWidget(empty_);
  list_->addStretch(1);
  scroll_->setWidget(content_);
  layout->addWidget(scroll_, 1);

  why_not_ = new QPushButton(tr("Why not …?"), this);
  why_not_->setToolTip(tr("All effects, with one verdict each"));
  why_not_->setFixedHeight(control_height);
  add_ = new MainButton(this);
  add_->setObjectName("add_first");
  add_->setFixedHeight(control_height);
  add_->setEnabled(false);
  connect(add_, &QPushButton::clicked, this, [this] {
    if (const CandidateCard* card = first_to_add()) emit add(card->state().id);
  });
  foot_ = new QHBoxLayout;
  foot_->setContentsMargins(0, 0, layout_gap, 4);
  foot_->addWidget(add_, 100);  // as wide as its longest text
  foot_->addWidget(why_not_);
  foot_->addStretch(1);
  layout->addLayout(foot_);
  second_foot_ = new QHBoxLayout;
  second_foot_->setContentsMargins(0, 0, layout_gap, 4);
  second_foot_->addStretch(1);
  layout->addLayout(second_foot_);
  connect(why_not_, &QPushButton::clicked, this, &CandidateList::why_not_requested);
  connect(resort_, &QPushButton::clicked, this, &CandidateList::resort);
}

QSize CandidateList::sizeHint() const { return {464, 560}; }

CandidateCard* CandidateList::card(int index) const { return cards_.at(static_cast<std::size_t>(index)); }

std::vector<QString> CandidateList::shown() const {
  std::vector<QString> ids;
  for (const CandidateCard* card : cards_) ids.push_back(card->state().id);
  return ids;
}

CandidateCard* CandidateList::make_card() {
  auto* card = new CandidateCard(content_);
  card->installEventFilter(this);
  connect(card, &CandidateCard::preview, this, [this](const QString& id) {
    attended_.push_back(id);
    emit preview(id);
  });
  connect(card, &CandidateCard::preview_ended, this, &CandidateList::let_go);
  connect(card, &CandidateCard::add, this, &CandidateList::add);
  connect(card, &CandidateCard::show_poses, this, &CandidateList::show_poses);
  connect(card, &CandidateCard::what_if, this, &CandidateList::what_if);
  connect(card, &CandidateCard::action, this, &CandidateList::action);
  connect(card, &CandidateCard::measured, this, &CandidateList::measured);
  return card;
}

void CandidateList::set_cards(std::vector<CardState> cards, CardOrder order) {
  wanted_ = std::move(cards);
  // What is said of all of them stands first, whatever stood there.
  const bool is_said_of_all = !wanted_.empty() && wanted_.front().kind != CardKind::candidate &&
                              (cards_.empty() || cards_.front()->state().id != wanted_.front().id);
  if (order == CardOrder::fresh || is_said_of_all) return resort();
  std::vector<CardState> in_order;
  const auto wanted = [this](const QString& id) {
    return std::find_if(wanted_.begin(), wanted_.end(), [&](const CardState& card) { return card.id == id; });
  };
  const std::vector<QString> before = shown();
  for (const QString& id : before)
    if (const auto found = wanted(id); found != wanted_.end()) in_order.push_back(*found);
  for (const CardState& card : wanted_)
    if (std::find(before.begin(), before.end(), card.id) == before.end()) in_order.push_back(card);
  const bool is_other = !std::equal(in_order.begin(), in_order.end(), wanted_.begin(), wanted_.end(),
                                    [](const CardState& a, const CardState& b) { return a.id == b.id; });
  show_cards(in_order);
  resort_->setVisible(is_other);
}

void CandidateList::resort() {
  show_cards(wanted_);
  resort_->hide();
  // What is best stands on top, and the next click on Add belongs to it.
  const auto to_the_top = [this] { scroll_->verticalScrollBar()->setValue(0); };
  to_the_top();
  QTimer::singleShot(0, scroll_, to_the_top);  // and after what the new layout and the focus make of it
}

void CandidateList::show_cards(const std::vector<CardState>& in_order) {
  // A card keeps its widget (and with it hover and focus) as long as its id is shown.
  std::vector<CandidateCard*> old = cards_, now;
  for (const CardState& state : in_order) {
    const auto found =
        std::find_if(old.begin(), old.end(), [&](const CandidateCard* card) { return card->state().id == state.id; });
    CandidateCard* card = found != old.end() ? *found : make_card();
    if (found != old.end()) old.erase(found);
    CardState shown_state = state;
    if (!can_add_) shown_state.can_add = false, shown_state.why_not = tr("A fit runs.");
    if (!can_add_ && card->isAncestorOf(QApplication::focusWidget())) setFocus();  // before its button goes grey
    card->set_state(std::move(shown_state));
    now.push_back(card);
  }
  for (CandidateCard* card : old) {  // its own click may be what led here: it must outlive its signal
    let_go(card->state().id);
    // Else the focus would wander through the window, and what it comes to would scroll.
    QWidget* const focused = QApplication::focusWidget();
    if (card == focused || card->isAncestorOf(focused)) setFocus();
    list_->removeWidget(card);
    card->hide();
    card->deleteLater();
  }
  cards_ = now;
  for (int i = 0; i < count(); ++i) {
    list_->removeWidget(cards_[static_cast<std::size_t>(i)]);
    list_->insertWidget(i, cards_[static_cast<std::size_t>(i)]);
    cards_[static_cast<std::size_t>(i)]->show();
    if (i > 0) QWidget::setTabOrder(cards_[static_cast<std::size_t>(i - 1)], cards_[static_cast<std::size_t>(i)]);
  }
  empty_->setVisible(cards_.empty());
  mark_main();
}

void CandidateList::let_go(const QString& id) {
  const auto found = std::find(attended_.begin(), attended_.end(), id);
  if (found == attended_.end()) return;
  attended_.erase(found);
  emit preview_ended(id);
  if (!attended_.empty()) emit preview(attended_.back());
}

void CandidateList::mark_main() {
  for (std::size_t i = 0; i < cards_.size(); ++i) cards_[i]->set_main(i == 0);
  show_add();
}

void CandidateList::add_at_foot(QWidget* widget, FootPlace place) {
  widget->setFixedHeight(control_height);
  if (place == FootPlace::after_why_not) {
    // What comes and goes would have no room there, or push the others aside: it stands above, beside the title.
    static_cast<QHBoxLayout*>(layout()->itemAt(0)->layout())->addWidget(widget);
    return;
  }
  foot_->insertWidget(foot_->indexOf(why_not_), widget);
  at_foot_.push_back(widget);
}

/// What has no room beside the main button gets a line of its own: by the width and the longest text that the button
/// had, so that nothing changes its place while the user looks.
void CandidateList::lay_out_foot() {
  longest_add_ = std::max({longest_add_, least_add_width, add_->sizeHint().width()});
  int wanted = longest_add_ + why_not_->sizeHint().width() + 3 * layout_gap;
  for (const QWidget* w : at_foot_)  // the hidden ones too: they will come
    wanted += std::max(w->sizeHint().width(), w->minimumWidth()) + layout_gap;
  const bool has_second = wanted > width();
  add_->setMaximumWidth(longest_add_);
  if (has_second == has_second_foot_) return;
  has_second_foot_ = has_second;
  std::vector<QWidget*> others;
  for (QHBoxLayout* row : {foot_, second_foot_})
    for (int i = 0; i < row->count(); ++i)
      if (QWidget* w = row->itemAt(i)->widget(); w && w != add_) others.push_back(w);
  for (QWidget* w : others) {
    (has_second ? foot_ : second_foot_)->removeWidget(w);
    QHBoxLayout* const row = has_second ? second_foot_ : foot_;
    row->insertWidget(row->count() - 1, w);  // before what stretches
  }
}

const CandidateCard* CandidateList::first_to_add() const {
  for (const CandidateCard* card : cards_)
    if (card->state().kind == CardKind::candidate && (card->state().can_add || !can_add_)) return card;
  return nullptr;
}

/// The button below the cards is always there and says which card it adds.
void CandidateList::show_add() {
  const CandidateCard* first = first_to_add();
  const QString text = first && !first->state().add_text.isEmpty() ? first->state().add_text : tr("Add");
  add_->setText(text);
  add_->setToolTip(first ? tr("Adds it to the model and fits (Enter)") : tr("There is nothing to add."));
  add_->setEnabled(first && can_add_);
  lay_out_foot();
}

void CandidateList::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  QTimer::singleShot(0, this, &CandidateList::show_add);
}

void CandidateList::set_previewed(const QString& id) {
  for (CandidateCard* card : cards_) card->set_previewed(!id.isEmpty() && card->state().id == id);
}

void CandidateList::set_measured_note(const QString& id, const QString& sentence) {
  for (CandidateCard* card : cards_)
    if (card->state().id == id) card->set_measured_note(sentence);
}

void CandidateList::set_empty_text(const QString& sentence) { empty_->setText(sentence); }

void CandidateList::set_can_add(bool can_add) {
  if (can_add == can_add_) return;
  can_add_ = can_add;
  std::vector<CardState> states;
  for (const CandidateCard* card : cards_) {
    const auto found = std::find_if(wanted_.begin(), wanted_.end(),
                                    [&](const CardState& state) { return state.id == card->state().id; });
    if (found != wanted_.end()) states.push_back(*found);
  }
  show_cards(states);
}

bool CandidateList::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn)
    if (auto* card = qobject_cast<CandidateCard*>(watched)) scroll_->ensureWidgetVisible(card, 0, 0);
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const auto found = std::find(cards_.begin(), cards_.end(), watched);
    if (found != cards_.end() && (key == Qt::Key_Down || key == Qt::Key_Up)) {
      const auto at = found - cards_.begin() + (key == Qt::Key_Down ? 1 : -1);
      if (at >= 0 && at < static_cast<std::ptrdiff_t>(cards_.size()))
        cards_[static_cast<std::size_t>(at)]->setFocus(Qt::TabFocusReason);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace handsight::widgets
