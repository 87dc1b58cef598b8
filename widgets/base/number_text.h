// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for people: a true minus, sigma to two digits and the value to the same place, "-" for what is not known.
#pragma once

#include <QString>
#include <optional>

#include "widgets/base/cells.h"

namespace handsight::widgets {

/// What parts the whole from its decimals in all of these texts: a comma in some languages. A point at first.
void set_decimal_mark(QChar mark);
QChar decimal_mark();
/// A number as somebody typed it, as programs read it: with a point, and a plain minus.
QString with_decimal_point(QString typed);

/// With so many digits after the point; never "-0.00", "nan" or an exponent.
QString fixed_text(std::optional<double> value, int decimals);

/// To so many significant digits, as short as it gets: 0.24, 9.1, 12, 1.2e-4 (very small or large: times a power of
/// 10).
QString short_text(std::optional<double> value, int digits = 2);

/// A factor: 1, 2.5, 2000; no zeros that say nothing.
QString times_text(double factor);

/// "12.34 ± 0.05": sigma to two digits, the value to the same place; an exact value (no sigma) to at most four digits.
QString with_sigma_text(std::optional<double> value, std::optional<double> sigma);

/// A value with its unit in one word: "9.1 px", "-" where it is not known; under a thousandth of a millimetre in um, of
/// a pixel without a power of ten.
QString with_unit_text(std::optional<double> value, const QString& unit, int digits = 2);

/// "12.34 ± 0.05 mm", "0.57 ± 0.12 µm": both in a unit that a person reads.
QString with_sigma_unit_text(std::optional<double> value, std::optional<double> sigma, const QString& unit);

/// "9.1 px", "12 mm", "45 σ"; "-" where it has no value.
QString size_text(const ShownSize& size, int digits = 2);

/// The text so that no line ends between a number and its unit or its sigma.
QString unbroken(QString text);

/// "2 s", "1 min 20 s": time left of a job.
QString duration_text(double seconds);

}  // namespace handsight::widgets
