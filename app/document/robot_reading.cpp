// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/robot_reading.h"

#include <QRegularExpression>
#include <cmath>

namespace handsight::app {
namespace {

bool same_prediction(const CheckPrediction& a, const CheckPrediction& b) {
  return a.before == b.before && a.after == b.after && a.value == b.value && a.sigma == b.sigma && a.unit == b.unit &&
         a.observation == b.observation;
}

/// Of a number that was rounded to the last digit that is written.
double rounding_sigma(const QString& number) {
  const qsizetype mantissa_end = number.indexOf('e', 0, Qt::CaseInsensitive);
  const QString mantissa = mantissa_end < 0 ? number : number.left(mantissa_end);
  const qsizetype point = mantissa.indexOf('.');
  const auto places = point < 0 ? 0 : mantissa.size() - point - 1;
  const double exponent = mantissa_end < 0 ? 0 : number.mid(mantissa_end + 1).toDouble();
  return std::pow(10.0, exponent - static_cast<double>(places)) / std::sqrt(12.0);
}

}  // namespace

bool operator==(const RobotReading& a, const RobotReading& b) {
  return a.effect == b.effect && a.value == b.value && a.sigma == b.sigma && same_prediction(a.predicted, b.predicted);
}

std::optional<TypedReading> parse_reading(const QString& text) {
  QString plain = text.trimmed();
  plain.replace(QChar(0x2212), '-');  // a true minus
  // As much of the world writes it; but three digits behind a comma may be thousands.
  static const QRegularExpression thousands(QStringLiteral(",\\d{3}(?!\\d)"));
  if (!plain.contains('.') && !plain.contains(thousands)) plain.replace(',', '.');
  plain.replace("+-", QString(QChar(0x00B1)));
  plain.replace("+/-", QString(QChar(0x00B1)));
  const QStringList parts = plain.split(QChar(0x00B1));
  if (parts.size() > 2) return std::nullopt;
  bool is_number = false;
  TypedReading reading;
  const QString number = parts[0].trimmed();
  reading.value = number.toDouble(&is_number);
  if (!is_number || !std::isfinite(reading.value)) return std::nullopt;
  if (parts.size() == 1) {
    reading.sigma = rounding_sigma(number);
    return reading;
  }
  reading.sigma = parts[1].trimmed().toDouble(&is_number);
  if (!is_number || !std::isfinite(reading.sigma) || reading.sigma < 0) return std::nullopt;
  return reading;
}

}  // namespace handsight::app
