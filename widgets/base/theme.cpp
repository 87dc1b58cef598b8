// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/theme.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <map>

namespace handsight::widgets {
namespace {

ThemeKind& current() {
  static ThemeKind kind = ThemeKind::light;
  return kind;
}

int list_pixels(TextRole role) {
  switch (role) {
    case TextRole::small:
      return 12;
    case TextRole::body:
      return 13;
    case TextRole::title:
      return 15;
    case TextRole::number:
      return 24;
  }
  return 13;
}

bool has_equal_digits(const QFont& font) {
  const QFontMetricsF metrics(font);
  const double first = metrics.horizontalAdvance(QLatin1Char('0'));
  for (char digit = '1'; digit <= '9'; ++digit)
    if (std::abs(metrics.horizontalAdvance(QLatin1Char(digit)) - first) > 1e-6) return false;
  return true;
}

}  // namespace

const Colors& colors() { return theme_colors(current()); }

ThemeKind theme() { return current(); }

void set_colors(ThemeKind kind) { current() = kind; }

QFont text_font(TextRole role) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setPixelSize(list_pixels(role));
  font.setWeight(role == TextRole::title || role == TextRole::number ? QFont::DemiBold : QFont::Normal);
  return font;
}

QFont number_font(TextRole role) {
  QFont font = text_font(role);
  if (has_equal_digits(font)) return font;
  font.setFamily(QStringLiteral("DejaVu Sans"));
  return font;
}

double noise_limit(int coordinates) {
  static std::map<int, double> known;  // the window has one thread for its widgets
  if (coordinates < 1) coordinates = 1;
  const auto found = known.find(coordinates);
  if (found != known.end()) return found->second;
  const boost::math::chi_squared distribution(coordinates);
  return known[coordinates] = std::sqrt(boost::math::quantile(distribution, 0.99) / coordinates);
}

int residual_step(double rms_over_sigma, int coordinates) {
  if (!(rms_over_sigma >= 1)) return 0;
  if (rms_over_sigma < noise_limit(coordinates)) return 1;
  if (rms_over_sigma < 3) return 2;
  if (rms_over_sigma < 5) return 3;
  return rms_over_sigma < 10 ? 4 : 5;
}

QColor residual_color(std::optional<double> rms_over_sigma, int coordinates) {
  if (!rms_over_sigma || std::isnan(*rms_over_sigma)) return colors().ink3;
  return colors().residual[static_cast<std::size_t>(residual_step(*rms_over_sigma, coordinates))];
}

QString residual_step_name(int step) {
  static const std::array<QString, 6> names = {QStringLiteral("noise"), QStringLiteral("noise"), QStringLiteral("3"),
                                               QStringLiteral("5"),     QStringLiteral("10"),    QStringLiteral("10+")};
  return step < 0 || step > 5 ? QString() : names[static_cast<std::size_t>(step)];
}

}  // namespace handsight::widgets
