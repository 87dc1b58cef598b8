// SPDX-License-Identifier: Apache-2.0
// The bill of a model in Versions and in the report, and the proof that is shown first.
#include <gtest/gtest.h>

#include <QListView>

#include "app/window/explain_fixture.h"
#include "app/window/painted_text.h"
#include "app/window/reported_story.h"
#include "findings/explain_texts.h"
#include "widgets/base/number_text.h"
#include "widgets/explain/bill_list.h"
#include "widgets/explain/pattern_page.h"
#include "widgets/explain/version_list.h"
#include "widgets/plots/scatter_plot.h"

namespace handsight::test {
namespace {

class Bill : public Explain {
 protected:
  Told reported{desk};
  widgets::BillList* bill() { return desk.find<widgets::BillList>("bill"); }
  const widgets::PatternPage* page() { return desk.find<widgets::PatternPage>("pattern_page"); }
  bool is_proof() { return !page()->plots().empty() && page()->plots()[0].id.startsWith("proof"); }
  QStringList plot_ids() {
    QStringList ids;
    for (const auto& plot : page()->plots()) ids << plot.id;
    return ids;
  }
  bool add_until_it_stops() {
    desk.press_button("until_it_stops");
    const auto* button = desk.find<QAbstractButton>("until_it_stops");
    return desk.wait([&] { return button->text() != "Stop"; }, 120000) && explain.is_settled() &&
           desk.wait([&] { return desk.window.workbench().diagnosing.inclusion_probabilities() != nullptr; });
  }
};

TEST_F(Bill, ComesAfterAddUntilItStopsAndSaysWhatTheCommandSays) {
  open("hidden_3");
  desk.press_button("tab_versions");
  EXPECT_TRUE(bill()->entries().empty());
  desk.press_button("tab_stairs");
  EXPECT_FALSE(bill()->isVisible());
  ASSERT_TRUE(add_until_it_stops());
  ASSERT_TRUE(bill()->isVisible()) << "nobody has to look for it";
  const auto cli = run_cli(folder.path, {"improve", session.string(), "--json", "-"}).json()["bill"];
  ASSERT_EQ(bill()->entries().size(), cli.size());
  for (std::size_t i = 0; i < cli.size(); ++i) {
    const widgets::BillEntry& row = bill()->entries()[i];
    EXPECT_EQ(row.id.toStdString(), cli[i]["id"].get<std::string>());
    const auto mm = [&](const char* key) { return std::optional(1e3 * cli[i][key].get<double>()); };
    EXPECT_TRUE(row.worth.startsWith(widgets::with_sigma_text(mm("hand_m"), mm("hand_sigma_m"))))
        << row.worth.toStdString();
    EXPECT_EQ(row.is_stand_in, cli[i]["too_large"].get<bool>() || cli[i]["pushes_back"].get<bool>());
    EXPECT_TRUE(row.sure.startsWith("sure to ")) << row.sure.toStdString();
    EXPECT_FALSE(row.reported.isEmpty());
  }
  EXPECT_TRUE(bill()->entries()[0].cause.startsWith("Joint elasticity of ")) << "what, and where";
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled());
  EXPECT_TRUE(bill()->entries().empty()) << "taken back";
}

TEST_F(Bill, IsThatOfTheCommandWhereTheLikeliestIsNotWhatRobotsUsuallyHave) {
  open("panda_sockets");  // the bending of its links has more evidence than its base's, and is larger than usual
  ASSERT_TRUE(add_until_it_stops());
  const auto cli = run_cli(folder.path, {"improve", session.string(), "--json", "-"}).json();
  ASSERT_EQ(bill()->entries().size(), cli["bill"].size());
  for (std::size_t i = 0; i < cli["bill"].size(); ++i)
    EXPECT_EQ(bill()->entries()[i].id.toStdString(), cli["bill"][i]["id"].get<std::string>());
  EXPECT_NEAR(*reported.header().now, 1e3 * cli["left"]["story"]["error"].get<double>(), 0.005);
}

TEST_F(Bill, OfFewPosesSaysWhatToExpectOnNewOnesAsTheCommandDoes) {
  ASSERT_TRUE(simulate(
      {"--observations", "24", "--noise", "0.2", "--effect", "joint_offset:axis_2.offset=0.01", "--images", "none"}));
  desk.window.resize(1440, 900);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  auto* note = desk.find<QLabel>("bill_note");
  ASSERT_TRUE(add_until_it_stops());
  ASSERT_TRUE(desk.wait([&] { return note->isVisible(); }, 60000));
  const auto cli = run_cli(folder.path, {"improve", session.string(), "--json", "-"}).json();
  ASSERT_TRUE(cli.contains("held_out_choosing_pixel"));
  const double expected = cli["held_out_choosing_pixel"].get<double>();
  EXPECT_TRUE(note->text().startsWith("Expect " + app::error_with_unit(expected, true) + " on new poses"))
      << note->text().toStdString() << ", not " << expected;
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled());
  EXPECT_TRUE(note->text().isEmpty()) << "it is of the model that was taken back";
}

TEST_F(Bill, LeadsTheReport) {
  open("hidden_3");
  ASSERT_TRUE(add_until_it_stops());
  desk.key(Qt::Key_5, Qt::ControlModifier);
  desk.type_into(desk.find<QLineEdit>("export_path"), QString::fromStdString((folder.path / "out.xml").string()));
  desk.press_button("report_html");
  const auto file = folder.path / "out.html";
  ASSERT_TRUE(desk.wait([&] { return std::filesystem::exists(file); }, 20000));
  const QString html = QString::fromStdString(read_file(file));
  const auto at = [&](const QString& text) { return html.indexOf(text.toHtmlEscaped()); };
  const qsizetype verdict = at(explain.verdict().sentence), picture = html.indexOf("<img"),
                  bill_at = at("The bill: what each cause is worth"), numbers = at("As a matrix, in m:");
  EXPECT_GT(verdict, 0);
  EXPECT_GT(picture, verdict) << "the story has its picture";
  EXPECT_GT(bill_at, picture);
  EXPECT_GT(numbers, bill_at) << "and numbers come after it";
  for (const widgets::BillEntry& row : bill()->entries()) {
    EXPECT_GT(at(row.cause), bill_at) << row.cause.toStdString();
    EXPECT_GT(at(row.worth), bill_at) << row.worth.toStdString();
  }
}

TEST_F(Bill, TheProofOfWhatLeadsIsShownFromTheStart) {
  open("hidden_3");
  ASSERT_NE(reported.story().lead(), nullptr);
  ASSERT_TRUE(desk.wait([&] { return is_proof(); })) << "without any pointer on a card";
  EXPECT_EQ(desk.find<QLabel>("failing_title")->text(), "Where it fails: the proof");
  EXPECT_TRUE(desk.find<QLabel>("proof_sentence")->text().contains(" gives way by "));
  EXPECT_EQ(page()->plots().size(), 3U) << "a spring a plot, and nothing else beside them";
  EXPECT_FALSE(desk.find<widgets::ScatterPlot>("pattern_large")->candidate().empty()) << "the curve of the cause";
  desk.press_button("tab_patterns");
  ASSERT_FALSE(is_proof());
  ASSERT_EQ(page()->plots().size(), 9U);
  const QString lead = app::effect_text(reported.story().lead()->id, {});
  QTest::qWait(500);  // what shows there comes plot by plot
  for (const auto& plot : page()->plots())
    EXPECT_TRUE(plot.shows.isEmpty() || plot.shows == lead)
        << "named by the verdict alone: " << plot.shows.toStdString();
  desk.press_button("tab_proof");
  EXPECT_TRUE(is_proof());
}

TEST_F(Bill, WhereNoNameLeadsThePatternsNameNone) {
  open("hidden_8");
  QTest::qWait(500);
  if (is_proof()) desk.press_button("tab_patterns");
  for (const auto& plot : page()->plots())
    for (const Effect& effect : catalogue())
      EXPECT_FALSE(plot.shows.contains(app::effect_text(effect.id, {}))) << plot.shows.toStdString();
}

/// Fault 6: what was sorted by what the last model left is no order of what the first one fails at.
TEST_F(Bill, ReopenedAndTakenBackThePlotsAreTheFirstOnesAgain) {
  open("hidden_3");
  ASSERT_TRUE(desk.wait([&] { return is_proof(); }));
  desk.press_button("tab_patterns");
  const QStringList before = plot_ids();
  desk.press_button("tab_proof");
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(explain.is_settled());
  EXPECT_TRUE(desk.wait([&] { return is_proof(); })) << "the proof leads again";
  desk.press_button("tab_patterns");
  EXPECT_EQ(plot_ids(), before);
  EXPECT_FALSE(page()->plots()[0].is_chance) << "no patternless scatter first";
}

TEST_F(Bill, TheLargePlotIsOneOfTheSmallOnesWhateverBecameOfThose) {
  open("panda_sockets");  // its first plots are of motions that the last model has no more
  ASSERT_TRUE(add_until_it_stops());
  ASSERT_FALSE(is_proof());
  const auto& small = page()->plots()[static_cast<std::size_t>(std::max(0, page()->selected_plot()))];
  const auto& large = desk.find<widgets::ScatterPlot>("pattern_large")->points();
  ASSERT_EQ(large.size(), small.points.size());
  for (std::size_t i = 0; i < large.size(); ++i) {
    EXPECT_DOUBLE_EQ(large[i].x, small.points[i].x);
    EXPECT_DOUBLE_EQ(large[i].y, small.points[i].y);
  }
}

/// What a list paints: each of its texts.
QStringList painted_in(QAbstractItemView* view) {
  QStringList texts;
  for (const PaintedText& t : texts_of(*view->viewport())) texts << t.text.trimmed();
  return texts;
}

TEST_F(Bill, NamesAreWholeOnALaptopInBillAndVersions) {
  open("hidden_3");
  desk.window.resize(1366, 768);
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  desk.press_button("tab_versions");
  QTest::qWait(50);
  for (QListView* view : {bill()->view(), desk.find<widgets::VersionList>("versions")->view()}) {
    const QStringList texts = painted_in(view);
    EXPECT_TRUE(texts.filter("…").isEmpty()) << texts.join(" | ").toStdString();
    EXPECT_TRUE(texts.join(' ').contains("right_arm_1, right_arm_2 and right_arm_4"))
        << texts.join(" | ").toStdString();
  }
}

}  // namespace
}  // namespace handsight::test
