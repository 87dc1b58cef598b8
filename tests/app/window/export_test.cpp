// SPDX-License-Identifier: Apache-2.0
// What Export says before the numbers are used, and that the numbers are in sight.
#include <gtest/gtest.h>

#include <QHeaderView>
#include <QScrollBar>
#include <QTableWidget>

#include "app/window/explain_fixture.h"
#include "base/files.h"
#include "export/export_texts.h"
#include "findings/explain_texts.h"
#include "session/session_xml.h"
#include "widgets/base/number_text.h"
#include "widgets/lists/model_panel.h"

namespace handsight::test {
namespace {

class Export : public Explain {
 protected:
  void go() {
    desk.key(Qt::Key_5, Qt::ControlModifier);
    ASSERT_TRUE(desk.settle());
  }
  /// Those above the table, without their signs.
  QStringList remarks() {
    QStringList list;
    for (const QLabel* label : desk.find<QWidget>("export")->findChildren<QLabel*>())
      for (const char* sign : {"▲  ", "✓  "})
        if (label->text().startsWith(QString::fromUtf8(sign)))
          list << label->text().mid(QString::fromUtf8(sign).size());
    return list;
  }
};

TEST_F(Export, SaysWhatExplainSays) {
  open("hidden_3");
  go();
  ASSERT_FALSE(remarks().isEmpty());
  EXPECT_EQ(remarks().front(), explain.verdict().sentence) << "an effect is missing";
  ASSERT_TRUE(explain.open());
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  go();
  EXPECT_EQ(remarks().front(), explain.verdict().sentence) << "at the noise";
}

TEST_F(Export, NearTheNoiseIsNotDownToTheNoise) {
  open("hidden_3");
  app::ModelVersion model = *desk.document().model();
  auto fit = std::make_shared<Fit>(*model.fit);
  fit->covariance_kind = CovarianceKind::repeatability;
  auto report = std::make_shared<FitReport>(*model.report);
  report->held_out.rms_pixel = 1.2 * *fit->noise;
  model.fit = fit;
  model.report = report;
  const Story story =
      find_story({.fit = *model.fit, .report = *model.report, .attribution = model.inspection->attribution});
  const widgets::SessionVerdict verdict = app::session_verdict(model, story, nullptr, false, widgets::SizeUnit::pixel);
  EXPECT_TRUE(verdict.sentence.contains("comes near the noise")) << verdict.sentence.toStdString();
  EXPECT_TRUE(app::verdict_remark(verdict, model).is_warning);
}

/// What differs by a hair between two places is two truths to a reader.
TEST_F(Export, HowFarAPoseIsOffIsTheFigureOfInspect) {
  session = make_copy("hidden_3");
  Session s = read_session(session);
  s.observations[5].decision = Decision::rejected;
  s.observations[5].reason = "a mark that is none";
  replace_session(s);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  go();
  const auto* table = desk.find<QTableWidget>("not_used");
  ASSERT_EQ(table->rowCount(), 1);
  const InspectionRow* row = desk.window.workbench().row(s.observations[5].id);
  ASSERT_TRUE(row && row->hand_m);
  EXPECT_TRUE(table->item(0, 1)->text().contains(": " + widgets::short_text(1e3 * *row->hand_m) + ","))
      << table->item(0, 1)->text().toStdString();
}

/// A wrapped name makes its row higher: what stands below begins below it.
TEST_F(Export, NothingOfTheColumnLiesOverTheNumbers) {
  open("hidden_8");
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  const auto* motion = desk.find<QTableWidget>("motion");
  for (const QSize& size : {QSize(1366, 768), QSize(1920, 1040), QSize(1280, 760)}) {
    desk.window.resize(size);
    go();
    QTest::qWait(200);
    int rows = motion->horizontalHeader()->height();
    for (int r = 0; r < motion->rowCount(); ++r) rows += motion->rowHeight(r);
    EXPECT_GE(motion->height(), rows) << size.width();
    for (const QWidget* other : motion->parentWidget()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
      if (other != motion && other->isVisible())
        EXPECT_FALSE(other->geometry().intersects(motion->geometry())) << size.width();
  }
}

TEST_F(Export, MarkersThatAreNeverSeenAreOneRemark) {
  session = make_copy("hidden_3");
  std::string xml = read_file(session / "session.xml");
  const std::string three = "<markers count=\"3\"/>";
  const auto at = xml.find(three);
  ASSERT_NE(at, std::string::npos);
  replace_file(session / "session.xml", xml.replace(at, three.size(), "<markers count=\"9\"/>"));
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  go();
  EXPECT_EQ(remarks().filter("no used observation"),
            QStringList("Markers 3, 4, 5, 6, 7, 8 are seen in no used observation and have no position."));
}

TEST_F(Export, HoweverMuchIsSaidTheButtonThatSavesIsInSight) {
  session = make_copy("hidden_1");
  std::string xml = read_file(session / "session.xml");
  const std::pair<std::string, std::string> changes[] = {
      {"<markers count=\"3\" sigma_pixel=\"0.2\"/>", "<markers count=\"9\" sigma_pixel=\"2\"/>"},
      {"estimate=\"no\"", "estimate=\"yes\""}};
  for (const auto& [was, is] : changes) {
    ASSERT_NE(xml.find(was), std::string::npos);
    xml.replace(xml.find(was), was.size(), is);
  }
  replace_file(session / "session.xml", xml);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  auto* panel = desk.find<widgets::ModelPanel>("model_panel");
  for (const char* id : {"link_geometry", "encoder_eccentricity", "transmission_ripple"}) {
    emit panel->effect_toggled(id, true);
    ASSERT_TRUE(desk.settle());
  }
  desk.window.resize(1200, 700);
  go();
  QTest::qWait(50);
  const auto* reported = desk.find<QScrollArea>("export_remarks");
  EXPECT_GT(reported->widget()->height(), reported->height()) << "there is more than has room";
  const auto* save = desk.find<QWidget>("save_xml");
  EXPECT_EQ(save->visibleRegion().boundingRect(), save->rect());
}

TEST_F(Export, OnALaptopWhatIsSaidIsWholeAndNothingScrolls) {
  open("hidden_3");
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  desk.window.resize(1366, 768);
  go();
  const auto* correction = desk.find<QWidget>("correction_bars");
  ASSERT_TRUE(desk.wait([&] { return correction->isVisible(); }));
  QTest::qWait(50);
  const auto* reported = desk.find<QScrollArea>("export_remarks");
  EXPECT_EQ(reported->widget()->heightForWidth(reported->width()), reported->height());
  EXPECT_GE(reported->height(), 40) << "two remarks at least";
  for (const QWidget* w = correction; w; w = w->parentWidget())
    if (const auto* column = qobject_cast<const QScrollArea*>(w))
      EXPECT_EQ(column->verticalScrollBar()->maximum(), 0) << "the column has all it says in sight";
}

TEST_F(Export, TheNumbersTakeNoMoreRoomThanTheirRows) {
  open("hidden_3");
  desk.window.workbench().exclude({1, 2, 5, 7, 11, 13});
  ASSERT_TRUE(desk.settle());
  go();
  QTest::qWait(50);
  const auto* numbers = desk.find<QTableWidget>("motion");
  const auto* unused = desk.find<QTableWidget>("not_used");
  EXPECT_LE(numbers->viewport()->height(), numbers->verticalHeader()->length() + 1);
  EXPECT_GE(unused->viewport()->height(), unused->verticalHeader()->length()) << "there is room for all of them";
}

TEST_F(Export, LongNamesDoNotPushTheNumbersOutOfSight) {
  open("hidden_8");
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  for (const QSize& size : {QSize(1440, 900), QSize(1200, 640)}) {
    desk.window.resize(size);
    go();
    auto* table = desk.find<QTableWidget>("motion");
    const QFontMetrics metrics(table->font());
    for (int row = 0; row < table->rowCount(); ++row) {
      const QRect name = table->visualItemRect(table->item(row, 0)), unit = table->visualItemRect(table->item(row, 3));
      EXPECT_LE(unit.left() + metrics.horizontalAdvance(table->item(row, 3)->text()), table->viewport()->width());
      const QRect text =
          metrics.boundingRect(QRect(0, 0, name.width() - 6, 1000), Qt::TextWordWrap, table->item(row, 0)->text());
      EXPECT_LE(text.height(), name.height()) << table->item(row, 0)->text().toStdString();
      EXPECT_LE(text.width(), name.width());
    }
  }
}

}  // namespace
}  // namespace handsight::test
