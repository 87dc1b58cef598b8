// SPDX-License-Identifier: Apache-2.0
// No text is cut off by the widget that paints it, and no two lie over each other: in any state of the story, at four
// sizes of the window.
#include "app/window/painted_text.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QTabBar>

#include "app/window/pages.h"
#include "app/window/rig_sessions.h"
#include "start/session_places.h"
#include "temporary_folder.h"
#include "widgets/scene/robot_view.h"
#include "window/language.h"

namespace handsight::test {
namespace {

std::string reported(const PaintedText& t) {
  std::string name;
  for (const QWidget* w = t.widget; w && name.empty(); w = w->parentWidget()) name = w->objectName().toStdString();
  return std::string(t.widget->metaObject()->className()) + " in " + name + ": \"" + t.text.toStdString() + "\"";
}

/// What may be scrolled or shortens its own texts.
bool is_left_out(const QWidget& w) {
  if (qobject_cast<const QHeaderView*>(w.parentWidget()) || qobject_cast<const QAbstractItemView*>(w.parentWidget()))
    return true;
  if (qobject_cast<const QPlainTextEdit*>(w.parentWidget())) return true;
  return qobject_cast<const QLineEdit*>(&w) || qobject_cast<const QComboBox*>(&w) || qobject_cast<const QTabBar*>(&w) ||
         qobject_cast<const widgets::RobotView*>(&w);
}

/// What cannot be scrolled sideways is no wider than what is seen of it.
void expect_nothing_beside(QWidget& window, const std::string& state) {
  for (const QScrollArea* area : window.findChildren<QScrollArea*>()) {
    if (!area->isVisible() || !area->widget() || area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) continue;
    EXPECT_LE(area->widget()->width(), area->viewport()->width())
        << state << ": " << area->parentWidget()->objectName().toStdString();
  }
}

/// What is there in another language is not painted in English.
void expect_translated(const QString& text, const std::string& state) {
  // German: left, English: a robot's links; and what a recent session calls itself.
  if (text == "Links") return;
  for (const app::RecentSession& recent : app::recent_sessions())
    if (text == recent.title) return;
  const QString other = QCoreApplication::translate("", text.toUtf8());
  EXPECT_EQ(other, text) << state << ": not translated: " << text.toStdString();
}

void expect_readable(QWidget& window, const std::string& state) {
  expect_nothing_beside(window, state);
  for (const QHeaderView* head : window.findChildren<QHeaderView*>())
    for (int c = 0; head->isVisible() && c < head->count(); ++c)
      expect_translated(head->model()->headerData(c, head->orientation()).toString(), state);
  for (QWidget* w : window.findChildren<QWidget*>()) {
    if (!w->isVisible() || is_left_out(*w) || w->width() < 8 || w->height() < 8) continue;
    const std::vector<PaintedText> texts = texts_of(*w);
    constexpr double slack = 2;  // px
    const QRectF room = QRectF(w->rect()).adjusted(-slack, -slack, slack, slack);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      expect_translated(texts[i].text, state);
      EXPECT_TRUE(room.contains(texts[i].place)) << state << ": cut off: " << reported(texts[i]);
      for (std::size_t j = 0; j < i; ++j) {
        if (texts[i].text == texts[j].text) continue;  // a rim is the same text again
        const QRectF both = texts[i].place.adjusted(1, 1, -1, -1).intersected(texts[j].place.adjusted(1, 1, -1, -1));
        EXPECT_TRUE(both.isEmpty()) << state << ": over each other: " << reported(texts[i]) << " and \""
                                    << texts[j].text.toStdString() << "\"";
      }
    }
  }
}

struct Look {
  QSize size;
  const char* language = "en";
};

class PaintedTexts : public testing::TestWithParam<Look> {
 protected:
  PaintedTexts() : translation(GetParam().language) {
    if (!translation.isEmpty()) QCoreApplication::installTranslator(&translation);
  }
  ~PaintedTexts() override { QCoreApplication::removeTranslator(&translation); }
  const QSize size = GetParam().size;
  app::Translation translation;
};

TEST_P(PaintedTexts, AreWholeAndApartInTheStory) {
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(size);
  QTest::qWait(50);
  ASSERT_EQ(desk.window.size(), size);
  const auto look = [&](const char* state) {
    desk.settle();
    QTest::qWait(30);
    expect_readable(desk.window, state);
    EXPECT_EQ(desk.window.size(), size) << state << " makes the window grow";
  };
  look("start");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "first_steps").string())));
  look("label");
  LabelPage label{desk};
  ASSERT_TRUE(label.corners_are_found());
  // In images of a thumb's size the numbers of near markers lie over each other.
  if (size.width() > 1200) {
    for (const Vector2& px : {Vector2(421, 338), Vector2(408, 411), Vector2(473, 378)}) label.click_left(px);
    look("label, three markers");
  }
  const auto go = [&](int n) { desk.key(Qt::Key_0 + n, Qt::ControlModifier); };
  go(2);
  look("calibrate, nothing played");
  go(5);
  look("export, nothing to export");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "hidden_3").string())));
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  look("explain");
  explain.look_at(0);
  ASSERT_TRUE(desk.wait([&] { return desk.window.workbench().predicted_error().has_value(); }));
  look("explain, a card is looked at");
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  QTest::qWait(800);
  look("explain, added");
  go(3);
  look("inspect");
  go(2);
  look("calibrate");
  go(5);
  look("export");
  desk.key(Qt::Key_Question);
  look("keys");
}

TEST_P(PaintedTexts, AreWholeAndApartInTheWizard) {
  Desk desk;
  desk.window.resize(size);
  QTest::qWait(30);  // the start page lays itself out anew on a large screen
  desk.press_button("start_new");
  auto* wizard = desk.window.findChild<QDialog*>("wizard");
  ASSERT_NE(wizard, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(wizard));
  const auto samples = QString(HANDSIGHT_SOURCE_DIR) + "/sample_sessions";
  desk.find<QLineEdit>("wizard_robot")->setText(samples + "/robots/six_axis.urdf");
  desk.find<QLineEdit>("wizard_angles")->setText(samples + "/nowhere.csv");
  for (int known = 0; known < 7; ++known) {
    desk.find<QAbstractButton>(("known_" + std::to_string(known)).c_str())->click();
    QTest::qWait(30);
    expect_readable(*wizard, "wizard, known " + std::to_string(known));
  }
  wizard->reject();
}

TEST_P(PaintedTexts, AreWholeAndApartWithOneCameraAndWithThree) {
  for (const int cameras : {1, 3}) {
    const TemporaryFolder folder;
    Desk desk;
    desk.window.resize(size);
    ASSERT_TRUE(
        desk.window.open(QString::fromStdString(sample_with_cameras(folder.path, "hidden_3", cameras).string())));
    for (int workspace = 1; workspace <= 5; ++workspace) {
      desk.key(Qt::Key_0 + workspace, Qt::ControlModifier);
      // What comes from the background while one waits is laid out after it.
      for (int i = 0; i < 2; ++i) {
        desk.settle();
        QTest::qWait(30);
      }
      expect_readable(desk.window, std::to_string(cameras) + " cameras, workspace " + std::to_string(workspace));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, PaintedTexts,
                         testing::Values(Look{{960, 540}}, Look{{1366, 768}}, Look{{1440, 900}}, Look{{1920, 1080}},
                                         Look{{2560, 1440}}, Look{{960, 540}, "de"}, Look{{1366, 768}, "de"}),
                         [](const auto& one) {
                           return one.param.language + std::to_string(one.param.size.width()) + "x" +
                                  std::to_string(one.param.size.height());
                         });

}  // namespace
}  // namespace handsight::test
