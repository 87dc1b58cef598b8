// SPDX-License-Identifier: Apache-2.0
// Trying before adding: a card that is looked at, an effect of any size, what brushed observations have in common.
#include <gtest/gtest.h>

#include "app/window/explain_fixture.h"
#include "cli/hidden_sessions.h"
#include "widgets/explain/staircase.h"
#include "widgets/explain/what_if_slider.h"
#include "widgets/explain/what_if_track.h"
#include "widgets/plots/scatter_plot.h"

namespace handsight::test {
namespace {

TEST_F(Explain, LookingAtACardShowsWhatItWouldDoAndChangesNothing) {
  open("hidden_3");
  auto* card = explain.cards()->card(0);
  const QPoint at = card->mapTo(card->window(), QPoint(20, 20));
  QTest::mouseMove(card->window()->windowHandle(), at);
  ASSERT_TRUE(desk.wait([this] { return desk.window.workbench().predicted_error().has_value(); }));
  EXPECT_NEAR(*desk.window.workbench().predicted_error(), 0.2, 0.05);
  auto* strip = desk.find<widgets::ObservationStrip>("strip");
  EXPECT_TRUE(strip->isVisible());
  int predicted = 0;
  for (const auto& cell : desk.window.workbench().cells()) predicted += cell.predicted ? 1 : 0;
  EXPECT_EQ(predicted, 80);
  EXPECT_TRUE(desk.find<widgets::Staircase>("staircase")->state().preview);
  QTest::mouseMove(desk.window.windowHandle(), QPoint(5, 5));
  ASSERT_TRUE(desk.wait([this] { return !desk.window.workbench().predicted_error(); }));
  EXPECT_EQ(desk.document().undo_stack().index(), 0);
}

/// A dialog that closes over a card, a workspace that comes: the pointer is there and points at nothing.
TEST_F(Explain, APointerThatOnlyRestsWhereACardAppearsTriesNothing) {
  open("hidden_3");
  auto* card = explain.cards()->card(0);
  const QPointF at(60, 40);
  QEnterEvent enter(at, card->mapTo(card->window(), at), card->mapToGlobal(at));
  QApplication::sendEvent(card, &enter);
  QTest::qWait(400);
  EXPECT_FALSE(desk.window.workbench().predicted_error()) << "nobody has moved the pointer";
  QTest::mouseMove(card->window()->windowHandle(), card->mapTo(card->window(), QPoint(64, 44)));
  EXPECT_TRUE(desk.wait([this] { return desk.window.workbench().predicted_error().has_value(); }));
}

/// Also where it comes to the card at a button of it.
TEST_F(Explain, APointerOnACardsButtonTriesTheCard) {
  open("hidden_3");
  auto* button = explain.cards()->card(0)->what_if_button();
  desk.scroll_to(button, button->rect().center());
  QTest::mouseMove(button->window()->windowHandle(), button->mapTo(button->window(), button->rect().center()));
  EXPECT_TRUE(desk.wait([this] { return desk.window.workbench().predicted_error().has_value(); }));
}

TEST_F(Explain, BrushedObservationsSayWhatTheyHaveInCommon) {
  open("hidden_3");
  auto* plot = desk.find<widgets::ScatterPlot>("pattern_large");
  desk.drag(plot, {plot->width() * 6 / 10, 30}, {plot->width() - 20, plot->height() - 40}, Qt::ShiftModifier);
  ASSERT_GT(desk.window.workbench().selection.many().size(), 1U);
  auto* common = desk.find<QPushButton>("common");
  ASSERT_TRUE(common->isVisible());
  EXPECT_GE(common->text().size(), 20) << common->text().toStdString();
}

class TriedSizes : public Explain {
 protected:
  /// The slider of hidden_3's first card, at the size that explains most.
  widgets::WhatIfSlider* first_card_at_its_best() {
    open("hidden_3");
    desk.click(explain.cards()->card(0)->what_if_button());
    auto* slider = desk.find<widgets::WhatIfSlider>("what_if");
    slider->track()->setFocus();
    desk.key(Qt::Key_B);
    return slider;
  }
};

TEST_F(TriedSizes, AreThoseOfTheSlider) {
  auto* slider = first_card_at_its_best();
  ASSERT_TRUE(slider->isVisible());
  const double best = slider->value();
  EXPECT_GT(std::abs(best), 0);
  const QString at_best = [&] {
    for (auto* label : slider->findChildren<QLabel*>())
      if (label->text().startsWith("With this")) return label->text();
    return QString();
  }();
  EXPECT_FALSE(at_best.isEmpty());
  const double left = *desk.window.workbench().predicted_error();
  desk.key(Qt::Key_Home);
  EXPECT_LT(left, *desk.window.workbench().predicted_error()) << "without it the error is larger";
  for (auto* button : slider->findChildren<QAbstractButton*>())
    if (button->text() == "Close") desk.click(button);
  EXPECT_FALSE(slider->isVisible());
  EXPECT_FALSE(desk.window.workbench().predicted_error());
}

TEST_F(TriedSizes, FollowWhenObservationsGo) {
  auto* slider = first_card_at_its_best();
  ASSERT_TRUE(slider->isVisible());
  const double best = slider->value(), left = *desk.window.workbench().predicted_error();
  InspectPage inspect{desk};
  desk.key(Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(desk.settle());
  inspect.click_row(0);
  desk.press_button("exclude");
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  ASSERT_TRUE(slider->isVisible());
  EXPECT_EQ(slider->value(), best) << "its size stays";
  slider->track()->setFocus();
  desk.key(Qt::Key_B);
  EXPECT_NE(slider->value(), best) << "and what fits best is of the observations that are left";
  EXPECT_NEAR(slider->value(), best, 0.1 * std::abs(best));
  EXPECT_NEAR(*desk.window.workbench().predicted_error(), left, 0.1 * left);
}

}  // namespace
}  // namespace handsight::test
