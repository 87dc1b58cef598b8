// SPDX-License-Identifier: Apache-2.0
// What a window paints against what its story knows: the story's figures are everywhere the same, nothing is said to
// agree that is more than 1.5 times the noise, and no number is none.
#pragma once

#include <QCoreApplication>
#include <QRegularExpression>

#include "app/window/painted_text.h"
#include "app/window/reported_story.h"
#include "widgets/base/number_text.h"

namespace handsight::test {

/// Figures of this unit in a text, with a point as decimal mark.
inline QStringList figures_in(QString text, const QString& unit) {
  static const QRegularExpression one(
      QString::fromUtf8("(?<!± )(?<![\\d.\\w−-])(\\d+(?:\\.\\d+)?)[ \u00A0](px|mm)(?![\\w/])"));
  if (widgets::decimal_mark() != '.') text.replace(QRegularExpression("(?<=\\d),(?=\\d)"), ".");
  QStringList figures;
  for (auto i = one.globalMatch(text); i.hasNext();) {
    const auto found = i.next();
    if (found.captured(2) == unit) figures << found.captured(1);
  }
  return figures;
}

/// Near one of the story's figures, and yet another one: 0.20 beside 0.21.
inline void expect_same_figures(const QStringList& lines, const std::vector<double>& figures, const QString& unit,
                                const std::string& where) {
  for (const QString& line : lines)
    for (const QString& shown : figures_in(line, unit)) {
      const double value = shown.toDouble();
      const auto decimals = shown.contains('.') ? static_cast<int>(shown.size() - shown.indexOf('.') - 1) : 0;
      const auto is_near = [&](double figure) { return std::abs(value - figure) <= 0.03 * figure; };
      const auto is_same = [&](double figure) { return shown == QString::number(figure, 'f', decimals); };
      if (std::none_of(figures.begin(), figures.end(), is_near)) continue;
      EXPECT_TRUE(std::any_of(figures.begin(), figures.end(), is_same))
          << where << ": " << shown.toStdString() << " in " << line.toStdString();
    }
}

/// In the language that is spoken.
inline bool is_said_to_agree(const QString& text) {
  const QString agrees =
      QCoreApplication::translate("", "The model agrees with the measurements down to the noise.").chopped(1);
  return text.contains(agrees) || text.contains(QCoreApplication::translate("", "Nothing is missing"));
}

inline void expect_painted_story(Desk& desk, const std::string& where) {
  if (!desk.document().is_open() || !desk.document().shown_model()) return;
  const QStringList lines = painted(desk.window);
  const QString all = lines.join('\n');
  EXPECT_FALSE(all.contains(QRegularExpression("\\b(nan|inf)\\b"))) << where;
  const Story& story = desk.window.workbench().story();
  const StoryError& error = story.error;
  if (error.ratio().value_or(0) > most_that_agrees) EXPECT_FALSE(is_said_to_agree(all)) << where;
  const auto of_error = error.in_pixels ? widgets::SizeUnit::pixel : widgets::SizeUnit::millimetre;
  if (!error.error || desk.window.workbench().units.unit() != of_error) return;
  if (!desk.window.workbench().blunders().empty()) return;  // no figure of it tells anything
  // Where single observations are listed one of theirs may well be near.
  if (desk.window.workspace() != app::Place::explain && desk.window.workspace() != app::Place::write_out) return;
  const double scale = error.in_pixels ? 1 : 1e3;
  std::vector<double> figures;
  for (const auto& figure : {error.error, error.noise, error.elsewhere})
    if (figure) figures.push_back(scale * *figure);
  for (const StoryCause& cause : story.causes)  // "0.30 -> 0.21 px" on a card
    if (cause.left) figures.push_back(scale * *cause.left);
  expect_same_figures(lines, figures, error.in_pixels ? "px" : "mm", where);
}

}  // namespace handsight::test
