// SPDX-License-Identifier: Apache-2.0
// What a designer would see at once: words that are cut off, and inks that cannot be read.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <cmath>

#include "app/window/pages.h"
#include "temporary_folder.h"
#include "widgets/base/apply_theme.h"
#include "widgets/base/theme.h"

namespace handsight::test {
namespace {

double luminance(const QColor& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

void look_at_labels(QWidget* page, const QString& where) {
  for (QLabel* label : page->findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty() || label->textFormat() == Qt::RichText) continue;
    if (label->wordWrap()) {
      // A layout may have to follow a new theme or text still.
      (void)QTest::qWaitFor([label] { return label->height() + 2 >= label->heightForWidth(label->width()); }, 2000);
      EXPECT_GE(label->height() + 2, label->heightForWidth(label->width()))
          << where.toStdString() << ": " << label->text().toStdString();
    } else {
      EXPECT_GE(label->width() + 1, label->fontMetrics().horizontalAdvance(label->text()))
          << where.toStdString() << ": " << label->text().toStdString();
    }
    EXPECT_GE(contrast(label->palette().color(label->foregroundRole()), label->palette().color(QPalette::Window)), 4.5)
        << where.toStdString() << ": " << label->text().toStdString();
  }
}

void look_at_buttons(QWidget* page, const QString& where) {
  for (QAbstractButton* button : page->findChildren<QAbstractButton*>()) {
    const bool has_words = qobject_cast<QPushButton*>(button) || qobject_cast<QToolButton*>(button);
    if (!button->isVisible() || button->text().isEmpty() || !has_words) continue;
    EXPECT_GE(button->width(), button->fontMetrics().horizontalAdvance(button->text().remove('&')) + 4)
        << where.toStdString() << ": " << button->text().toStdString();
    if (!button->isEnabled()) continue;
    EXPECT_GE(contrast(button->palette().color(QPalette::ButtonText), button->palette().color(QPalette::Button)), 4.5)
        << where.toStdString() << ": " << button->text().toStdString();
  }
}

/// Widgets of one parent, laid out beside each other, do not cover each other.
void look_for_overlap(QWidget* page, const QString& where) {
  const auto has_words = [](QWidget* w) { return qobject_cast<QLabel*>(w) || qobject_cast<QAbstractButton*>(w); };
  for (QWidget* a : page->findChildren<QWidget*>()) {
    if (!a->isVisible() || !has_words(a) || a->testAttribute(Qt::WA_TransparentForMouseEvents)) continue;
    EXPECT_TRUE(a->parentWidget()->rect().adjusted(-1, -1, 1, 1).contains(a->geometry()))
        << where.toStdString() << ": " << a->objectName().toStdString() << " "
        << a->property("text").toString().toStdString() << " reaches out of what holds it";
    for (QObject* sibling : a->parentWidget()->children()) {
      auto* b = qobject_cast<QWidget*>(sibling);
      if (!b || b <= a || !b->isVisible() || !has_words(b) || b->testAttribute(Qt::WA_TransparentForMouseEvents))
        continue;
      EXPECT_FALSE(a->geometry().intersects(b->geometry()))
          << where.toStdString() << ": " << a->property("text").toString().toStdString() << " and "
          << b->property("text").toString().toStdString();
    }
  }
}

void look_at(QWidget* page, const QString& where) {
  look_at_labels(page, where);
  look_at_buttons(page, where);
  look_for_overlap(page, where);
}

/// A theme until the test ends, however it ends.
struct Theme {
  explicit Theme(widgets::ThemeKind kind) { widgets::apply_theme(*qApp, kind); }
  ~Theme() { widgets::apply_theme(*qApp, widgets::ThemeKind::light); }
};

void look_at_everything(widgets::ThemeKind kind) {
  const TemporaryFolder folder;
  const Theme theme(kind);
  const auto session = folder.path / "first_steps";
  std::filesystem::copy(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions/first_steps", session,
                        std::filesystem::copy_options::recursive);
  Desk desk;
  look_at(&desk.window, "start");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  const auto look = [&](const QString& state) {
    for (int i = 0; i < 5; ++i) {
      desk.key(Qt::Key_1 + i, Qt::ControlModifier);
      desk.settle();
      look_at(&desk.window, state + " " + QString::number(i));
    }
  };
  look("empty");
  desk.key(Qt::Key_1, Qt::ControlModifier);
  LabelPage label{desk};
  ASSERT_TRUE(label.corners_are_found());
  for (const Vector2& px : {Vector2(421, 338), Vector2(408, 411), Vector2(473, 378)}) label.click_left(px);
  label.use();
  CalibratePage calibrate{desk};
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  look("done");
}

TEST(Looks, NothingIsCutOffAndEverythingCanBeReadInLight) { look_at_everything(widgets::ThemeKind::light); }
TEST(Looks, NothingIsCutOffAndEverythingCanBeReadInDark) { look_at_everything(widgets::ThemeKind::dark); }

}  // namespace
}  // namespace handsight::test
