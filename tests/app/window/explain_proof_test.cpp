// SPDX-License-Identifier: Apache-2.0
// What proves a cause: each observation against what the cause follows, in the model and out of it; and what has no
// name.
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QTableView>

#include "app/window/explain_fixture.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/explain/effect_table.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/staircase.h"
#include "widgets/plots/scatter_plot.h"

namespace handsight::test {
namespace {

/// Springs in three joints: the card that is looked at shows each against its own torque, with its slope in words.
TEST_F(Explain, TheCardThatIsLookedAtShowsItsProofAndAfterTheAdditionItIsLevel) {
  open("hidden_3");
  auto* page = desk.find<widgets::PatternPage>("pattern_page");
  auto* plot = desk.find<widgets::ScatterPlot>("pattern_large");
  auto* words = desk.find<QLabel>("proof_sentence");
  const auto is_proof = [&](int place) {
    return page->plots()[static_cast<std::size_t>(place)].id.startsWith("proof");
  };
  explain.look_at(0);
  ASSERT_TRUE(desk.wait([&] { return page->plots().size() == 3 && is_proof(2); }))
      << "a spring a plot; the patterns have a tab of their own";
  for (int i = 0; i < 3; ++i) {
    const widgets::PatternPlot& proof = page->plots()[static_cast<std::size_t>(i)];
    EXPECT_EQ(proof.against, "gravity torque at " + QString(proof.what).remove("error of ")) << i;
    EXPECT_EQ(proof.y_unit, "mrad");
    EXPECT_FALSE(proof.candidate.empty());
    for (std::size_t p = 1; p < proof.candidate.size(); ++p) EXPECT_LE(proof.candidate[p - 1].x, proof.candidate[p].x);
  }
  const auto reported = run_cli(folder.path, {"diagnose", session.string(), "--json", "-"}).json();
  const auto& best = reported["candidates"][0]["proof"][0];
  const QString of = QString::fromStdString(best["of"].get<std::string>());
  EXPECT_TRUE(words->text().startsWith(of + " gives way by ")) << words->text().toStdString();
  EXPECT_TRUE(words->text().contains(widgets::with_sigma_text(1e6 * best["numbers"][0]["value"].get<double>(),
                                                              1e6 * best["numbers"][0]["sigma"].get<double>()) +
                                     QString::fromUtf8(" µrad for each N m")))
      << words->text().toStdString();
  const auto points = plot->points();
  double largest = 0;
  for (const auto& p : points) largest = std::max(largest, std::abs(p.y));
  EXPECT_GT(largest, 1) << "mrad";

  const auto before = plot->plot()->yAxis->range();
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  ASSERT_TRUE(desk.wait([&] { return plot->candidate().empty(); })) << "it falls for a moment";
  ASSERT_EQ(plot->points().size(), points.size());
  double left = 0;
  for (const auto& p : plot->points()) left = std::max(left, std::abs(p.y));
  EXPECT_LT(left, 0.3 * largest);
  EXPECT_TRUE(before.contains(0)) << "the level line is in sight before they fall onto it";
  EXPECT_EQ(plot->plot()->yAxis->range().lower, before.lower) << "on the same axes";
  EXPECT_EQ(plot->plot()->yAxis->range().upper, before.upper);
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled());
  // The card has the focus again, so it is looked at: what it would do, and nothing is said to be in the model.
  EXPECT_TRUE(desk.wait([&] { return !is_proof(0) || !plot->candidate().empty(); }));
  EXPECT_FALSE(plot->accessibleName().startsWith("In the model")) << plot->accessibleName().toStdString();
}

/// Who looks at another card's proof may go there and touch it; elsewhere that of the cause that leads comes again.
/// Three plots need one row: the large one takes what a second would have had.
TEST_F(Explain, AProofOfThreePlotsLeavesNoEmptyRow) {
  open("hidden_3");
  desk.window.resize(1600, 1000);
  auto* page = desk.find<widgets::PatternPage>("pattern_page");
  auto* plot = desk.find<widgets::ScatterPlot>("pattern_large");
  ASSERT_TRUE(desk.wait([&] { return page->plots().size() == 3 && page->rows() == 1; }));
  EXPECT_GT(plot->height(), 2 * page->height());
  desk.press_button("tab_patterns");
  ASSERT_TRUE(desk.wait([&] { return page->rows() == 2; }));
}

/// Name and verdict of every effect are whole, at the laptop's width too.
TEST_F(Explain, WhyNotSaysEachVerdictWhole) {
  open("hidden_3");
  desk.window.resize(1366, 768);
  desk.click(explain.cards()->why_not_button());
  auto* table = desk.find<widgets::EffectTable>("effect_table");
  auto* view = table->findChild<QTableView*>();
  ASSERT_GT(view->model()->rowCount(), 20);
  const QFontMetrics metrics(widgets::text_font(widgets::TextRole::body));
  for (int row = 0; row < view->model()->rowCount(); ++row)
    for (int column = 0; column < 2; ++column) {
      const QString text = view->model()->index(row, column).data().toString();
      EXPECT_LT(metrics.horizontalAdvance(text) + (column == 1 ? 24 : 0), view->columnWidth(column))
          << text.toStdString();
    }
}

TEST_F(Explain, TheProofStaysWhileThePointerIsOnIt) {
  open("hidden_3");
  ASSERT_GT(explain.cards()->count(), 1);
  auto* page = desk.find<widgets::PatternPage>("pattern_page");
  const auto is_proof = [&](int place) {
    return page->plots()[static_cast<std::size_t>(place)].id.startsWith("proof");
  };
  ASSERT_TRUE(desk.wait([&] { return page->plots().size() == 3 && is_proof(2); }));
  desk.click(page, page->plot_rect(1).center().toPoint());
  auto* words = desk.find<QLabel>("proof_sentence");
  const QString of = QString(page->plots()[1].what).remove("error of ");
  EXPECT_TRUE(words->text().startsWith(of + " gives way by ")) << words->text().toStdString();
  const auto is_of_lead = [&] { return words->text().contains(" gives way by "); };  // backlash, the second, does not
  for (auto* area : explain.cards()->findChildren<QScrollArea*>()) area->ensureWidgetVisible(explain.cards()->card(1));
  explain.look_at(1);
  ASSERT_TRUE(desk.wait([&] { return !is_of_lead(); }));
  const QString of_second = words->text();
  auto* large = desk.find<QWidget>("pattern_large");
  QTest::mouseMove(desk.window.windowHandle(), large->mapTo(&desk.window, large->rect().center()));
  QTest::qWait(600);
  EXPECT_EQ(words->text(), of_second) << "while the pointer is on it";
  QTest::mouseMove(desk.window.windowHandle(), QPoint(5, 5));
  EXPECT_TRUE(desk.wait(is_of_lead));
}

/// What has no name is a card too: added, undone, remembered, in the model panel.
TEST_F(Explain, ACurveWithoutANameIsACardLikeAnyOther) {
  open("hidden_8");
  EXPECT_EQ(explain.verdict().state, widgets::SessionState::unexplained);
  EXPECT_TRUE(
      explain.verdict().sentence.contains(QString::fromUtf8("axis_3 has an error that repeats three times a turn (± ")))
      << explain.verdict().sentence.toStdString();
  ASSERT_TRUE(explain.can_add_first());
  EXPECT_TRUE(explain.first().title.startsWith("An error of axis_3 that repeats three times a turn"))
      << explain.first().title.toStdString();
  EXPECT_TRUE(explain.first().words.contains("no name in the catalogue"));
  const double before = held_out();
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  const double after = held_out();
  EXPECT_LT(after, 0.8 * before);
  EXPECT_EQ(effects_in_the_model(), std::set<std::string>{"curve_1 axis_3"});
  EXPECT_EQ(explain.verdict().state, widgets::SessionState::unnamed) << "at the noise, but not all of it has a name";
  EXPECT_TRUE(explain.verdict().sentence.contains("not all of it has a name"));
  EXPECT_TRUE(desk.find<QAbstractButton>("effect_curve_1")->isChecked());
  EXPECT_TRUE(
      desk.document().undo_stack().undoText().startsWith("added an error of axis_3 that repeats three times a turn"));
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  EXPECT_EQ(effects_in_the_model(), std::set<std::string>{"curve_1 axis_3"}) << "from the journal";
  EXPECT_NEAR(held_out(), after, 1e-6);
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled());
  EXPECT_NEAR(held_out(), before, 1e-6);
  EXPECT_TRUE(explain.can_add_first());
}

}  // namespace
}  // namespace handsight::test
