// SPDX-License-Identifier: Apache-2.0
// The window's words are those of an engineer, in the places where they belong; German without the ones that are none.
#include <gtest/gtest.h>

#include <QPushButton>

#include "app/window/explain_fixture.h"
#include "app/window/painted_text.h"
#include "app/window/reported_story.h"
#include "app/window/said_forms.h"
#include "findings/explain_texts.h"
#include "widgets/lists/observation_strip.h"
#include "window/language.h"

namespace handsight::test {
namespace {

class Words : public Explain {
 protected:
  Told reported{desk};
};

TEST_F(Words, OfTheCardsCheckAreWhatToDoAndWhatToExpect) {
  open("hidden_3");
  static const QRegularExpression sag(
      QString::fromUtf8("Hang 1.kg on the hand: it should sag [0-9.]+.±.[0-9.]+.mm further \\(pose [0-9]+\\)"));
  ASSERT_TRUE(explain.first().check_number);
  const QString predicted = explain.first().check_number->prediction;
  EXPECT_TRUE(predicted.contains(sag)) << predicted.toStdString();
  EXPECT_EQ(desk.find<QPushButton>("add_first")->text(), "Add joint elasticity");
  EXPECT_EQ(desk.find<QPushButton>("until_it_stops")->text(), "Add until it stops");
  EXPECT_EQ(reported.rail("rail_label").line, "labels included");
}

TEST_F(Words, OfACurveSayWhatItDoes) {
  open("hidden_8");
  static const QRegularExpression repeats(
      QString::fromUtf8("axis_3 has an error that repeats three times a turn \\(±.1.5.mrad\\)"));
  EXPECT_TRUE(explain.verdict().sentence.contains(repeats)) << explain.verdict().sentence.toStdString();
}

TEST_F(Words, OfTouchesSayThatThereIsNothingToPlay) {
  desk.window.resize(1440, 900);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(make_copy("probe_and_plate").string())));
  ASSERT_TRUE(desk.settle());
  EXPECT_EQ(reported.rail("rail_calibrate").line, "nothing to play");
}

TEST_F(Words, OfTheStripsColoursStandOnALineOfTheirOwn) {
  open("hidden_3");
  auto* strip = desk.find<widgets::ObservationStrip>("strip");
  QStringList line;
  double top = 0, lowest_number = 0;
  for (const PaintedText& text : texts_of(*strip)) {
    bool is_of_cells = false;
    text.text.toInt(&is_of_cells);
    if (is_of_cells) lowest_number = std::max(lowest_number, text.place.bottom());
    if (is_of_cells) continue;
    line << text.text.trimmed();
    top = text.place.top();
  }
  EXPECT_EQ(line.join(' ').simplified(), QString::fromUtf8("× noise: < 1.5 < 3 < 5 < 10 ≥ 10"));
  EXPECT_GT(top, lowest_number);
}

TEST(WordsOf, OneMarkerAndOfMarkersThatAreNoneAreWhatAPersonSays) {
  EXPECT_EQ(app::cannot_be_split_text(), "Cannot be split with one marker");
  const auto said = said_by_the_core();
  EXPECT_TRUE(std::any_of(said.begin(), said.end(),
                          [](const auto& one) { return one.first.startsWith("none of the %1 markers"); }));
}

TEST(WordsOf, GermanHasNoneThatAreNoGerman) {
  const app::Translation german("de");
  for (const char* context : {"core", "errors", "effects", "handsight"})
    for (const QString& source : german.sources(context)) {
      const QString translated = german.translate("", source.toUtf8(), nullptr, -1);
      for (const char* word : {"Rauschgrenze", "ausreichend"})
        EXPECT_FALSE(translated.contains(word, Qt::CaseInsensitive)) << translated.toStdString();
    }
}

TEST(StartPage, SaysWhatTheProgramIsForAndHasTheTourFirstAndTheHiddenOnesInOrder) {
  Desk desk;
  QStringList titles;
  for (const QAbstractButton* button : desk.find<QWidget>("start_page")->findChildren<QAbstractButton*>())
    if (button->objectName().startsWith("sample_")) titles << button->text();
  ASSERT_GT(titles.size(), 8);
  EXPECT_TRUE(titles.front().startsWith("Tour: "));
  const QStringList hidden = titles.filter(QRegularExpression("^Hidden "));
  QStringList sorted = hidden;
  sorted.sort();
  EXPECT_EQ(hidden, sorted);
  EXPECT_TRUE(painted(desk.window).join(' ').contains("Finds out where a robot's hand really is"));
}

}  // namespace
}  // namespace handsight::test
