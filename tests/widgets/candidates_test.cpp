// SPDX-License-Identifier: Apache-2.0
// Cards, their list, and the table "Why not ...?".
#include <gmock/gmock.h>

#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

#include "effects/effect.h"
#include "widgets/base/theme.h"
#include "widgets/explain/candidate_list.h"
#include "widgets/explain_samples.h"
#include "widgets/mouse.h"

namespace handsight::widgets {
namespace {

using testing::ElementsAre;

void enter(QWidget& widget) {
  QEnterEvent event(QPointF(4, 4), QPointF(4, 4), widget.mapToGlobal(QPointF(4, 4)));
  QApplication::sendEvent(&widget, &event);
}

void leave(QWidget& widget) {
  QEvent event(QEvent::Leave);
  QApplication::sendEvent(&widget, &event);
}

TEST(CandidateCard, APointerThatRestsPointsAtNothingThatComesBelowIt) {
  CandidateList list;
  list.set_cards({test::elasticity_card(), test::predicted_card()}, CardOrder::fresh);
  test::show(list, {464, 600});
  CandidateCard* const card = list.card(0);
  const QPointF rests = card->mapFromGlobal(QPointF(QCursor::pos()));
  QSignalSpy preview(&list, &CandidateList::preview), ended(&list, &CandidateList::preview_ended);
  QEnterEvent below(rests, rests, QCursor::pos());
  QApplication::sendEvent(card, &below);
  test::hover(card, rests);
  EXPECT_EQ(preview.size(), 0) << "nobody has moved the pointer";
  test::hover(card, rests + QPointF(3, 0));
  EXPECT_EQ(preview.size(), 1);
  card->move(card->pos() + QPoint(2000, 0));
  EXPECT_EQ(ended.size(), 1) << "it has been moved away";
}

TEST(CandidateCard, HoverTriesAndEnterAdds) {
  CandidateList list;
  list.set_cards({test::elasticity_card(), test::predicted_card()}, CardOrder::fresh);
  test::show(list, {464, 600});
  QSignalSpy preview(&list, &CandidateList::preview), ended(&list, &CandidateList::preview_ended);
  QSignalSpy add(&list, &CandidateList::add);
  enter(*list.card(1));
  EXPECT_EQ(preview.size(), 0) << "a dialog may have closed over it: nobody points";
  QTest::mouseMove(list.card(1)->window()->windowHandle(), list.card(1)->mapTo(list.card(1)->window(), QPoint(30, 30)));
  QTRY_COMPARE(preview.size(), 1);
  EXPECT_EQ(preview[0][0].toString(), "payload");
  leave(*list.card(1));
  ASSERT_EQ(ended.size(), 1);
  EXPECT_EQ(ended[0][0].toString(), "payload");
  QTest::keyClick(list.card(0), Qt::Key_Return);
  ASSERT_EQ(add.size(), 1);
  EXPECT_EQ(add[0][0].toString(), test::elasticity_card().id);
  test::click(list.card(1)->add_button(), list.card(1)->add_button()->rect().center());
  ASSERT_EQ(add.size(), 2);
  EXPECT_EQ(add[1][0].toString(), "payload");
}

CardState card_with_a_check() {
  CardState card = test::elasticity_card();
  card.check_number = CardCheck{"Hang 1 kg on the hand: it should sag 1.40 ± 0.20 mm further (pose 37).", "mm", {}, {}};
  return card;
}

TEST(CandidateCard, WhatWasMeasuredIsToldOnceAndDoesNotAdd) {
  CandidateList list;
  list.set_cards({card_with_a_check(), test::predicted_card()}, CardOrder::fresh);
  test::show(list, {464, 700});
  list.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&list));
  QSignalSpy measured(&list, &CandidateList::measured), add(&list, &CandidateList::add);
  CandidateCard* card = list.card(0);
  EXPECT_FALSE(list.card(1)->measured_field()->isVisible()) << "no number, no field";
  const int height = card->height();
  test::click(card->measured_field(), card->measured_field()->rect().center());
  QTest::keyClicks(card->measured_field(), "1.3 +- 0.1");
  QTest::keyClick(card->measured_field(), Qt::Key_Return);
  ASSERT_EQ(measured.size(), 1);
  EXPECT_EQ(measured[0][0].toString(), card->state().id);
  EXPECT_EQ(measured[0][1].toString(), "1.3 +- 0.1");
  EXPECT_EQ(add.size(), 0);
  EXPECT_TRUE(card->hasFocus());
  // The answer comes; nothing on the card moves.
  CardState answered = card_with_a_check();
  answered.check_number->measured = "1.30 ± 0.10";
  answered.check_number->answer = "Inside: 0.4 sigma from the prediction. That speaks for this cause.";
  answered.check_number->is_inside = true;
  list.set_cards({answered, test::predicted_card()}, CardOrder::kept);
  EXPECT_EQ(card->measured_field()->text(), "1.30 ± 0.10");
  EXPECT_EQ(card->height(), height);
  list.setFocus();
  EXPECT_EQ(measured.size(), 1);
}

TEST(CandidateCard, WhatIsBeingTypedIsNotOverwritten) {
  CandidateList list;
  list.set_cards({card_with_a_check()}, CardOrder::fresh);
  test::show(list, {464, 700});
  CandidateCard* card = list.card(0);
  QTest::keyClicks(card->measured_field(), "1.");
  list.set_cards({card_with_a_check()}, CardOrder::kept);
  EXPECT_EQ(card->measured_field()->text(), "1.");
  list.set_measured_note(card->state().id, "That is no number.");
  EXPECT_EQ(card->state().check_number->answer, "That is no number.");
}

TEST(CandidateCard, FocusTriesAsHoverDoesAndStaysWithinTheCard) {
  CandidateList list;
  list.set_cards({test::elasticity_card(), test::predicted_card()}, CardOrder::fresh);
  test::show(list, {464, 600});
  list.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&list));
  QSignalSpy preview(&list, &CandidateList::preview), ended(&list, &CandidateList::preview_ended);
  list.card(0)->setFocus();
  QTest::qWait(20);
  EXPECT_EQ(preview.size(), 1);
  list.card(0)->what_if_button()->setFocus();
  QTest::qWait(20);
  EXPECT_EQ(ended.size(), 0);  // still the same card
  list.card(0)->setFocus();
  QTest::keyClick(list.card(0), Qt::Key_Down);
  QTest::qWait(20);
  EXPECT_TRUE(list.card(1)->hasFocus());
  ASSERT_EQ(ended.size(), 1);
  ASSERT_EQ(preview.size(), 2);
  EXPECT_EQ(preview[1][0].toString(), "payload");
}

TEST(CandidateCard, WhatCannotBeAddedIsNotAdded) {
  CandidateList list;
  list.set_cards({test::unnamed_card()}, CardOrder::fresh);
  test::show(list, {464, 300});
  QSignalSpy add(&list, &CandidateList::add);
  QTest::keyClick(list.card(0), Qt::Key_Return);
  test::click(list.card(0)->add_button(), list.card(0)->add_button()->rect().center());
  EXPECT_EQ(add.size(), 0);
  EXPECT_FALSE(list.card(0)->add_button()->isEnabled());
  list.set_cards({test::elasticity_card()}, CardOrder::fresh);
  list.set_can_add(false);
  EXPECT_FALSE(list.card(0)->add_button()->isEnabled());
  QTest::keyClick(list.card(0), Qt::Key_Return);
  EXPECT_EQ(add.size(), 0);
  list.set_can_add(true);
  EXPECT_TRUE(list.card(0)->add_button()->isEnabled());
}

TEST(CandidateCard, HonestOnesHaveTheirOwnButtonAndAreNotTried) {
  CandidateList list;
  list.set_cards(test::honest_cards(), CardOrder::fresh);
  test::show(list, {464, 1100});
  QSignalSpy action(&list, &CandidateList::action), preview(&list, &CandidateList::preview);
  QTest::mouseMove(list.card(1)->window()->windowHandle(), list.card(1)->mapTo(list.card(1)->window(), QPoint(30, 30)));
  QTest::qWait(30);
  EXPECT_EQ(preview.size(), 0);
  EXPECT_TRUE(list.card(1)->add_button()->isHidden());
  QPushButton* button = list.card(1)->action_button();
  EXPECT_EQ(button->text(), "Show the poses");
  test::click(button, button->rect().center());
  ASSERT_EQ(action.size(), 1);
  EXPECT_EQ(action[0][0].toString(), "poses");
  EXPECT_TRUE(list.card(4)->action_button()->isHidden());  // scatter: nothing can be done
}

TEST(CandidateList, TheOrderChangesOnlyWhenAsked) {
  CandidateList list;
  const CardState first = test::elasticity_card(), second = test::predicted_card(), third = test::unnamed_card();
  list.set_cards({first, second}, CardOrder::fresh);
  test::show(list, {464, 700});
  CandidateCard* widget = list.card(0);
  EXPECT_TRUE(list.resort_chip()->isHidden());
  list.set_cards({third, second, first}, CardOrder::kept);
  EXPECT_THAT(list.shown(), ElementsAre(first.id, second.id, third.id));
  EXPECT_EQ(list.card(0), widget);  // hover and focus stay with it
  ASSERT_TRUE(list.resort_chip()->isVisible());
  test::click(list.resort_chip(), list.resort_chip()->rect().center());
  EXPECT_THAT(list.shown(), ElementsAre(third.id, second.id, first.id));
  EXPECT_TRUE(list.resort_chip()->isHidden());
  list.set_cards({second}, CardOrder::fresh);
  EXPECT_THAT(list.shown(), ElementsAre(second.id));
}

TEST(CandidateList, TheMainActionStandsBelowTheCardsAndNamesItsCard) {
  CandidateList list;
  CardState first = test::elasticity_card();
  first.add_text = "Add joint elasticity";
  list.set_cards({first, test::predicted_card()}, CardOrder::fresh);
  for (const int card : {0, 1})
    EXPECT_NE(list.card(card)->add_button()->palette().color(QPalette::Button), colors().accent);
  EXPECT_EQ(list.add_button()->palette().color(QPalette::Button), colors().accent);
  EXPECT_EQ(list.add_button()->text(), "Add joint elasticity");
  QSignalSpy why_not(&list, &CandidateList::why_not_requested), add(&list, &CandidateList::add);
  test::show(list, {464, 600});
  const QRect where = list.add_button()->geometry(), beside = list.why_not_button()->geometry();
  test::click(list.add_button(), list.add_button()->rect().center());
  ASSERT_EQ(add.size(), 1);
  EXPECT_EQ(add[0][0].toString(), first.id);
  test::click(list.why_not_button(), list.why_not_button()->rect().center());
  EXPECT_EQ(why_not.size(), 1);
  list.set_can_add(false);
  EXPECT_FALSE(list.add_button()->isEnabled());
  EXPECT_EQ(list.add_button()->text(), "Add joint elasticity") << "while it is added, too";
  list.set_cards({}, CardOrder::fresh);
  EXPECT_FALSE(list.add_button()->isEnabled());
  EXPECT_TRUE(list.add_button()->isVisible());
  EXPECT_EQ(list.add_button()->geometry(), where) << "it neither goes nor moves";
  EXPECT_EQ(list.why_not_button()->geometry(), beside);
}

// Nothing of a card lies over its buttons or outside of it, whatever it has to say.
TEST(CandidateCard, IsAsHighAsItsTextNeeds) {
  CardState wordy = test::predicted_card();
  wordy.words = QString("many words ").repeated(60);
  wordy.evidence = wordy.words;
  wordy.check = wordy.words;
  for (int i = 0; i < 8; ++i) wordy.sizes.push_back(wordy.sizes[0]);
  CandidateCard plain, full;
  CardState empty;
  plain.set_state(empty);
  full.set_state(wordy);
  for (const int width : {360, 464, 900}) {
    EXPECT_EQ(plain.heightForWidth(width), 168);
    EXPECT_GT(full.heightForWidth(width), 250);
    EXPECT_LT(full.heightForWidth(width), 420);
  }
  test::show(full, {464, full.heightForWidth(464)});
  EXPECT_EQ(full.height(), full.heightForWidth(464));
  for (const int width : {360, 464, 900}) {
    full.resize(width, full.heightForWidth(width));
    for (const QPushButton* button : {full.add_button(), full.what_if_button(), full.poses_button()})
      EXPECT_TRUE(full.rect().contains(button->geometry())) << width;
  }
}

TEST(EffectTable, FiltersByNameAndEnterChooses) {
  EffectTable table;
  table.set_rows(test::effect_rows());
  test::show(table, {760, 640});
  EXPECT_EQ(table.shown().size(), catalogue().size());
  EXPECT_EQ(table.view()->rowHeight(0), 24);
  QSignalSpy chosen(&table, &EffectTable::chosen);
  QTest::keyClicks(table.filter_field(), "time la");
  EXPECT_THAT(table.shown(), ElementsAre("time_lag"));
  QTest::keyClick(table.filter_field(), Qt::Key_Return);
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toString(), "time_lag");
  table.set_filter("same as joint offset");
  EXPECT_THAT(table.shown(), ElementsAre("joint_scale"));
  table.set_filter("gravity on the moon");
  EXPECT_TRUE(table.shown().empty());
  table.set_filter("");
  const QPoint at = table.view()->visualRect(table.view()->model()->index(2, 0)).center();
  QTest::mouseClick(table.view()->viewport(), Qt::LeftButton, {}, at);
  QTest::mouseDClick(table.view()->viewport(), Qt::LeftButton, {}, at);
  ASSERT_EQ(chosen.size(), 2);
  EXPECT_EQ(chosen[1][0].toString(), QString::fromStdString(catalogue()[2].id));
}

}  // namespace
}  // namespace handsight::widgets
