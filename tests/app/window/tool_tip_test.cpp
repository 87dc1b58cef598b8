// SPDX-License-Identifier: Apache-2.0
// Tool tips: wrapped, beside what they explain and not over it, and none that says again what can be read there.
#include "widgets/base/tool_tip.h"

#include <gtest/gtest.h>

#include <QFontMetrics>
#include <QHelpEvent>
#include <QToolTip>

#include "app/window/explain_fixture.h"
#include "app/window/painted_text.h"

namespace handsight::test {
namespace {

QWidget* shown_tip() {
  for (QWidget* top : QApplication::topLevelWidgets())
    if (top->inherits("QTipLabel") && top->isVisible()) return top;
  return nullptr;
}

QString flat(QString text) { return text.replace('\n', ' ').replace(QChar(0x00A0), ' ').simplified(); }

QString read_there(QWidget& widget) {
  QString all;
  for (const PaintedText& text : texts_of(widget)) all += text.text + ' ';
  return flat(all);
}

std::string named(const QWidget& widget, const char* state) {
  const QWidget* w = &widget;
  while (w->objectName().isEmpty() && w->parentWidget()) w = w->parentWidget();
  return std::string(state) + ": " + widget.metaObject()->className() + " in " + w->objectName().toStdString() +
         ": \"" + QToolTip::text().toStdString() + '"';
}

class ToolTips : public Explain {
 protected:
  void ask(QWidget& widget, const QPoint& at, const char* state) {
    if (QWidget* before = shown_tip()) before->hide();
    QHelpEvent help(QEvent::ToolTip, at, widget.mapToGlobal(at));
    QApplication::sendEvent(&widget, &help);
    const QWidget* tip = shown_tip();
    if (!tip) return;
    ++count_;
    const QString text = QToolTip::text();
    for (const QString& line : text.split('\n'))
      EXPECT_TRUE(QFontMetrics(tip->font()).horizontalAdvance(line) <= widgets::tip_width + 8 || !line.contains(' '))
          << named(widget, state) << " is one long line";
    constexpr int large = 120;  // px: of a plot it explains a point
    const QRect area(widget.mapToGlobal(QPoint()), widget.size()), pointer(widget.mapToGlobal(at), QSize(1, 1));
    EXPECT_FALSE(tip->geometry().intersects(area.height() <= large ? area : pointer))
        << named(widget, state) << " covers what it explains";
    EXPECT_FALSE(read_there(widget).contains(flat(text))) << named(widget, state) << " stands there already";
  }
  void ask_all(const char* state) {
    for (QWidget* w : desk.window.findChildren<QWidget*>())
      if (w->isVisible() && w->isEnabled() && !w->visibleRegion().isEmpty())
        for (const double x : {0.15, 0.5, 0.85})
          ask(*w, QPoint(static_cast<int>(x * w->width()), w->height() / 2), state);
  }
  int count_ = 0;
};

TEST_F(ToolTips, AreWrappedStandBesideAndSayNothingTwice) {
  desk.window.resize(1366, 768);
  ask_all("start");
  open("hidden_3");
  ask_all("explain");
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  desk.press_button("tab_versions");
  ask_all("added");
  for (const int place : {1, 2, 3, 5, 6}) {
    desk.key(Qt::Key_0 + place, Qt::ControlModifier);
    ASSERT_TRUE(desk.settle());
    ask_all(("workspace " + std::to_string(place)).c_str());
  }
  EXPECT_GT(count_, 40) << "tool tips that were looked at";
}

TEST(PlaceOfTip, IsBelowOrWhereThereIsNoRoomAbove) {
  const QRect screen(0, 0, 800, 600), button(700, 560, 90, 28);
  EXPECT_EQ(widgets::place_of_tip({200, 40}, {10, 10, 90, 28}, screen), QRect(10, 41, 200, 40));
  const QRect above = widgets::place_of_tip({200, 40}, button, screen);
  EXPECT_LT(above.bottom(), button.top());
  EXPECT_LE(above.right(), screen.right());
}

}  // namespace
}  // namespace handsight::test
