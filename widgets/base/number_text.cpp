// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/number_text.h"

#include <QObject>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handsight::widgets {
namespace {

const QString not_known_text = QStringLiteral("-");

QChar mark = u'.';

bool is_known(std::optional<double> value) { return value && std::isfinite(*value); }

QString with_true_minus(QString text) { return text.replace(QLatin1Char('-'), QChar(0x2212)); }

/// The power of ten of a number after it was rounded to so many significant digits.
int exponent_of(double value, int digits) {
  if (value == 0) return 0;
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double scale = std::pow(10.0, digits - 1 - exponent);
  return std::round(std::abs(value) * scale) >= std::pow(10.0, digits) ? exponent + 1 : exponent;
}

QString superscript(int number) {
  static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString text = number < 0 ? QStringLiteral("⁻") : QString();
  for (const QChar c : QString::number(std::abs(number))) text += digits[c.digitValue()];
  return text;
}

QString times_power(double value, int exponent, int decimals) {
  return fixed_text(value / std::pow(10.0, exponent), decimals) + QStringLiteral("·10") + superscript(exponent);
}

}  // namespace

void set_decimal_mark(QChar m) { mark = m; }
QChar decimal_mark() { return mark; }

QString with_decimal_point(QString typed) {
  if (!typed.contains(u'.')) typed.replace(u',', u'.');
  return typed.replace(QChar(0x2212), u'-');
}

QString fixed_text(std::optional<double> value, int decimals) {
  if (!is_known(value)) return not_known_text;
  QString text = QString::number(*value, 'f', std::max(decimals, 0));
  const bool is_zero = std::none_of(text.begin(), text.end(), [](QChar c) { return c.isDigit() && c != u'0'; });
  if (is_zero && text.startsWith(QLatin1Char('-'))) text.remove(0, 1);
  return with_true_minus(text).replace(u'.', mark);
}

QString short_text(std::optional<double> value, int digits) {
  if (!is_known(value)) return not_known_text;
  if (*value == 0) return QStringLiteral("0");
  const int exponent = exponent_of(*value, digits);
  if (exponent < -3 || exponent > 6) return times_power(*value, exponent, digits - 1);
  return fixed_text(value, std::max(digits - 1 - exponent, 0));
}

/// 1.200 as 1.2 and 47.00 as 47: a number that is exact shows no doubt of its last digits.
static QString exact_text(double value) {
  QString text = short_text(value, 4);
  if (!text.contains(mark) || text.contains(QChar(0x00B7))) return text;
  while (text.endsWith('0')) text.chop(1);
  if (text.endsWith(mark)) text.chop(1);
  return text;
}

QString times_text(double factor) { return exact_text(factor); }

QString with_sigma_text(std::optional<double> value, std::optional<double> sigma) {
  if (!is_known(value)) return not_known_text;
  if (!is_known(sigma) || *sigma <= 0) return exact_text(*value);
  const int sigma_exponent = exponent_of(*sigma, 2);
  const int exponent = std::max(exponent_of(*value, 2), sigma_exponent);
  const QString plus_minus = QStringLiteral(" ± ");
  if (exponent < -3 || exponent > 6) {
    const int decimals = std::clamp(exponent - sigma_exponent + 1, 0, 9);
    const double scale = std::pow(10.0, exponent);
    return QLatin1Char('(') + fixed_text(*value / scale, decimals) + plus_minus + fixed_text(*sigma / scale, decimals) +
           QStringLiteral(")·10") + superscript(exponent);
  }
  const int decimals = std::clamp(1 - sigma_exponent, 0, 9);
  return fixed_text(value, decimals) + plus_minus + fixed_text(sigma, decimals);
}

/// What a number in `unit` is multiplied by to be read, and the unit that it then has.
static std::pair<double, QString> readable(double value, const QString& unit) {
  const bool is_small = value != 0 && std::abs(value) < 1e-3;
  if (is_small && unit == QLatin1String("mm")) return {1e3, QStringLiteral("µm")};
  return {1, unit};
}

QString with_unit_text(std::optional<double> value, const QString& unit, int digits) {
  if (!is_known(value)) return not_known_text;
  if (unit.isEmpty()) return short_text(value, digits);
  const auto [scale, shown] = readable(*value, unit);
  const double number = scale * *value;
  constexpr int most_places = 7;  // beyond it a row of zeros is no easier to read
  const int places = digits - 1 - exponent_of(number, digits);
  const bool is_plain = shown == QLatin1String("px") || shown == QStringLiteral("µm");
  const QString text = is_plain && number != 0 && places > 0 && places <= most_places ? fixed_text(number, places)
                                                                                      : short_text(number, digits);
  return text + QChar(0x00A0) + shown;
}

QString with_sigma_unit_text(std::optional<double> value, std::optional<double> sigma, const QString& unit) {
  if (!is_known(value)) return not_known_text;
  const double larger = std::max(std::abs(*value), is_known(sigma) ? std::abs(*sigma) : 0.0);
  const auto [scale, shown] = readable(larger, unit);
  const QString text = with_sigma_text(scale * *value, is_known(sigma) ? std::optional(scale * *sigma) : sigma);
  return shown.isEmpty() ? text : text + QChar(0x00A0) + shown;
}

QString size_text(const ShownSize& size, int digits) {
  return with_unit_text(size.value, unit_name(size.unit), digits);
}

QString unbroken(QString text) {
  static const QRegularExpression before_unit(
      QString::fromUtf8("(?<=[\\d×]) (?=(%|px|mm|[µum]?m|[µmu]?rad|deg|Grad|σ|kg|s|N)(?![\\w]))"));
  text.replace(before_unit, QString(QChar(0x00A0)));
  return text.replace(QString::fromUtf8(" ± "), QString::fromUtf8("\u00a0±\u00a0"))
      .replace(QString::fromUtf8("± "), QString::fromUtf8("±\u00a0"));
}

QString duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return not_known_text;
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 60) return QStringLiteral("%1 s").arg(whole);
  if (whole < 3600) return QObject::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
  return QObject::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

}  // namespace handsight::widgets
