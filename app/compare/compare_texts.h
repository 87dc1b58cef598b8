// SPDX-License-Identifier: GPL-3.0-or-later
// What a comparison says, in the window's words.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "compare/comparison.h"

namespace handsight::app {

/// What has changed, by evidence: the core's sentence with titles in place of ids.
QString comparison_sentence(const Comparison& comparison);

/// "The hand is 1.2 mm from where it was in the mean over these poses, at most 2.3 mm."; empty where it is not known.
QString hand_sentence(const Comparison& comparison);

/// "Joint offset of arm_2": one of the things that may have changed.
QString change_title(const Change& change);
/// Its numbers with their sigmas, a line each.
QStringList change_numbers(const Change& change);

/// A row of the table of numbers.
struct NumberLine {
  QString name;    // "TCP→Body x"
  QString change;  // "1.24 ± 0.05"
  QString unit;    // "mm"
  double sigmas = 0;
  QString before_after;  // "12.1 → 13.3 mm"
};
/// Those that moved farthest in units of their sigmas first.
std::vector<NumberLine> number_lines(const Comparison& comparison);

}  // namespace handsight::app
