// SPDX-License-Identifier: Apache-2.0
#include "widgets/base/theme.h"

#include <gtest/gtest.h>

#include <QPainter>
#include <QPushButton>
#include <cmath>

#include "widgets/base/icons.h"
#include "widgets/base/number_text.h"

namespace handsight::widgets {
namespace {

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

double luminance(const QColor& c) {
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double high = std::max(luminance(a), luminance(b)), low = std::min(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

TEST(Theme, ALongButtonHasRoomBesideItsText) {
  QPushButton button(QStringLiteral("Try it with the simulated robot"));
  constexpr int least = 16;  // px, both sides together
  EXPECT_GE(button.sizeHint().width(), button.fontMetrics().horizontalAdvance(button.text()) + least);
}

TEST(Theme, InksCanBeReadOnEveryGround) {
  for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
    const Colors& c = theme_colors(kind);
    for (const QColor& ground : {c.window, c.panel, c.sunken})
      for (const QColor& ink : {c.ink1, c.ink2, c.ink3}) EXPECT_GE(contrast(ink, ground), 4.5);
    EXPECT_GE(contrast(c.good, c.good_tint), 4.5);
    EXPECT_GE(contrast(c.care, c.care_tint), 4.5);
    EXPECT_GE(contrast(c.bad, c.bad_tint), 4.5);
  }
}

TEST(Theme, ResidualRampGrowsInContrastWithTheGround) {
  for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
    const Colors& c = theme_colors(kind);
    for (std::size_t i = 1; i < 6; ++i)
      EXPECT_GT(contrast(c.residual[i], c.panel), contrast(c.residual[i - 1], c.panel)) << i;
  }
}

// The figures of the chi-square distribution's 99 % quantile: 9.210, 13.277, 26.217 for 2, 4, 12 degrees of freedom.
TEST(Theme, NoiseLimitIsThatOfTheChiSquare) {
  EXPECT_NEAR(noise_limit(2), std::sqrt(9.210 / 2), 1e-3);
  EXPECT_NEAR(noise_limit(4), std::sqrt(13.277 / 4), 1e-3);
  EXPECT_NEAR(noise_limit(12), std::sqrt(26.217 / 12), 1e-3);
}

TEST(Theme, StepsAreAbsolute) {
  EXPECT_EQ(residual_step(0.5, 12), 0);
  EXPECT_EQ(residual_step(1.4, 12), 1);
  EXPECT_EQ(residual_step(1.6, 12), 2);
  EXPECT_EQ(residual_step(1.6, 2), 1);
  EXPECT_EQ(residual_step(4, 12), 3);
  EXPECT_EQ(residual_step(9.9, 12), 4);
  EXPECT_EQ(residual_step(1e9, 12), 5);
}

TEST(NumberText, SigmaHasTwoDigitsAndTheValueTheSamePlace) {
  EXPECT_EQ(with_sigma_text(12.3456, 0.0512), QString("12.346 ± 0.051"));
  EXPECT_EQ(with_sigma_text(-103.2, 1.6), QString("−103.2 ± 1.6"));
  EXPECT_EQ(with_sigma_text(1.18e-4, 3e-6), QString("(1.180 ± 0.030)·10⁻⁴"));
  EXPECT_EQ(with_sigma_text(std::nullopt, 1.0), QString("-"));
  EXPECT_EQ(with_sigma_text(47.0, std::nullopt), QString("47"));  // exact: held, chosen, a truth
  EXPECT_EQ(with_sigma_text(-0.8, 0.0), QString("−0.8"));
  EXPECT_EQ(with_sigma_text(1200.0, std::nullopt), QString("1200"));
}

TEST(NumberText, SmallSizesAreInAUnitThatAPersonReads) {
  EXPECT_EQ(with_unit_text(-5.7e-4, "mm"), QString("−0.57\u00a0µm"));
  EXPECT_EQ(with_unit_text(0.0123, "mm"), QString("0.012\u00a0mm"));
  EXPECT_EQ(with_unit_text(5.7e-4, "px"), QString("0.00057\u00a0px"));
  EXPECT_EQ(with_unit_text(5.7e-8, "mm"), QString("0.000057\u00a0µm"));
  EXPECT_EQ(with_unit_text(1.18e-4, "rad/(N m)"), QString("1.2·10⁻⁴\u00a0rad/(N m)"));
  EXPECT_EQ(with_sigma_unit_text(-5.7e-4, 1.2e-5, "mm"), QString("−0.570 ± 0.012\u00a0µm"));
  EXPECT_EQ(with_sigma_unit_text(5.7e-4, 2.0, "mm"), QString("0.0 ± 2.0\u00a0mm"));
}

TEST(NumberText, NothingUglyIsEverShown) {
  EXPECT_EQ(fixed_text(-1e-16, 3), QString("0.000"));
  EXPECT_EQ(fixed_text(std::nan(""), 3), QString("-"));
  EXPECT_EQ(short_text(0.2399), QString("0.24"));
  EXPECT_EQ(short_text(9.96), QString("10"));
  EXPECT_EQ(short_text(45.3), QString("45"));
  EXPECT_EQ(short_text(-2.5), QString("−2.5"));
}

TEST(DesktopTheme, NoPreferenceAfterDarkMeansLight) {
  DesktopTheme desktop;
  std::vector<ThemeKind> reported;
  QObject::connect(&desktop, &DesktopTheme::changed, [&](ThemeKind kind) { reported.push_back(kind); });
  const auto say = [&](unsigned scheme) {
    QMetaObject::invokeMethod(&desktop, "setting_changed", Q_ARG(QString, "org.freedesktop.appearance"),
                              Q_ARG(QString, "color-scheme"), Q_ARG(QDBusVariant, QDBusVariant(scheme)));
  };
  say(1);
  EXPECT_EQ(desktop.kind(), ThemeKind::dark);
  say(0);  // what GNOME says when its dark style is switched off
  EXPECT_EQ(desktop.kind(), ThemeKind::light);
  EXPECT_EQ(reported.back(), ThemeKind::light);
}

TEST(Icons, EveryOneThatTheWindowNamesIsThereAndTakesTheThemesInk) {
  for (const char* name : {"label", "calibrate", "inspect", "explain", "export", "undo", "redo", "play", "pause",
                           "step", "rewind", "watch", "open", "new_session"}) {
    ASSERT_TRUE(has_icon(name)) << name;
    QImage image(48, 48, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    draw_icon(painter, QRectF(0, 0, 48, 48), name, QColor(200, 10, 10));
    painter.end();
    int inked = 0;
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const QColor c = image.pixelColor(x, y);
        if (c.alpha() < 250) continue;
        ++inked;
        EXPECT_NEAR(c.red(), 200, 4) << name;
      }
    EXPECT_GT(inked, 40) << name;
  }
  EXPECT_FALSE(has_icon("no such icon"));
}

}  // namespace
}  // namespace handsight::widgets
