// SPDX-License-Identifier: GPL-3.0-or-later
// What a comparison says, in the window's words.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "compare/comparison.h"
#include "compare/several_comparison.h"

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

/// Of several: by how much each change moves the hand.
QStringList hand_sentences(const SeveralComparison& comparison);

/// A row of what has changed between several sessions, or has not.
struct SeveralLine {
  QString name;               // "joint offset of arm_2: march, april | may"; "or the load: march | april, may"
  QString likely;             // "98 %"
  bool is_change = false;     // it was found
  std::string before, after;  // titles of two sessions that it lies between; empty: it did not change
};
std::vector<SeveralLine> several_lines(const SeveralComparison& comparison);

/// The numbers of what has changed, each with how much more the later ones have.
std::vector<NumberLine> number_lines(const SeveralComparison& comparison);

}  // namespace handsight::app
