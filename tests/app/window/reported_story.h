// SPDX-License-Identifier: Apache-2.0
// What the window's places say of the model, against the story that all of them tell.
#pragma once

#include <QRegularExpression>

#include "app/window/pages.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "widgets/base/number_text.h"
#include "widgets/lists/attribution_bar.h"
#include "widgets/lists/three_numbers.h"
#include "window/rail_button.h"

namespace handsight::test {

struct Told {
  Desk& desk;
  ExplainPage explain{desk};

  app::Workbench& workbench() { return desk.window.workbench(); }
  const Story& story() { return workbench().story(); }
  const widgets::ErrorNumbers& header() { return desk.find<widgets::ThreeNumbers>("three_numbers")->numbers(); }
  app::WorkStatus rail(const char* place) { return desk.find<app::RailButton>(place)->status(); }
  static bool says_that_it_agrees(const QString& text) {
    return text.contains("agrees with the measurements") || text.contains("nothing is missing", Qt::CaseInsensitive);
  }

  /// Badge, sentence, header, cards, the row of actions, blame, Inspect and the rail, while Explain is shown.
  void expect_one_story(const char* state) {
    SCOPED_TRACE(state);
    QTest::qWait(60);  // what follows in turns
    expect_badge_and_sentence();
    expect_header();
    expect_cards();
    expect_attribution();
    expect_rail();
  }

  void expect_badge_and_sentence() {
    using widgets::SessionState;
    const std::map<StoryState, std::set<SessionState>> badges = {
        {StoryState::not_looked, {SessionState::waiting, SessionState::looking, SessionState::noise_unknown}},
        {StoryState::too_few_observations, {SessionState::too_few}},
        {StoryState::noise_unknown, {SessionState::noise_unknown}},
        {StoryState::at_the_noise, {SessionState::adequate, SessionState::stand_in}},
        {StoryState::unnamed_at_the_noise, {SessionState::unnamed}},
        {StoryState::repeatability, {SessionState::repeatability}},
        {StoryState::missing, {SessionState::missing}},
        {StoryState::implausible, {SessionState::implausible}},
        {StoryState::ambiguous, {SessionState::ambiguous}},
        {StoryState::unexplained, {SessionState::unexplained}},
        {StoryState::refused, {SessionState::unexplained}}};
    const widgets::SessionVerdict& v = explain.verdict();
    EXPECT_TRUE(badges.at(story().state).contains(v.state)) << story_state_text(story().state);
    if (story().error.ratio().value_or(0) > most_that_agrees) {
      EXPECT_FALSE(says_that_it_agrees(v.sentence)) << v.sentence.toStdString();
      EXPECT_NE(v.state, SessionState::adequate);
    }
    const StoryCause* lead = story().lead();
    const auto diagnosis = workbench().diagnosing.diagnosis();
    if (lead && diagnosis) {
      const DiagnosisCandidate& c = diagnosis->candidates[lead->candidate];
      const Session& session = workbench().document.session();
      const bool is_sentence = c.unnamed && !c.terms.empty();
      const QString reported =
          is_sentence ? app::curve_sentence(c.terms.front(), session.robot) : app::display_name(c, session);
      EXPECT_TRUE(v.sentence.contains(reported, Qt::CaseInsensitive)) << v.sentence.toStdString();
    }
    EXPECT_FALSE(v.sentence.contains(QRegularExpression("\\d (mm|mrad|px|m|°)\\b")))
        << "a line may end between a figure and its unit: " << v.sentence.toStdString();
    if (!lead) EXPECT_FALSE(v.sentence.contains("Most likely missing")) << v.sentence.toStdString();
    for (const auto& figure : {header().now, header().noise}) {
      const QString text = widgets::with_unit_text(figure, header().unit);
      if (figure) EXPECT_FALSE(v.sentence.contains(text)) << "the header says " << text.toStdString();
    }
    for (const StandIn& one : story().stands_in)
      EXPECT_TRUE(v.sentence.contains(app::effect_text(one.id, one.where))) << v.sentence.toStdString();
  }

  void expect_header() {
    const double scale = story().error.in_pixels ? 1 : 1e3;
    if (workbench().units.unit() == widgets::SizeUnit::sigma) return;
    if (story().error.in_pixels && workbench().units.unit() != widgets::SizeUnit::pixel) return;
    ASSERT_EQ(header().now.has_value(), story().error.error.has_value());
    if (header().now) EXPECT_NEAR(*header().now, scale * *story().error.error, 1e-9);
    ASSERT_EQ(header().noise.has_value(), story().error.noise.has_value());
    if (header().noise) EXPECT_NEAR(*header().noise, scale * *story().error.noise, 1e-9);
    if (header().ratio && story().error.ratio()) EXPECT_NEAR(*header().ratio, *story().error.ratio(), 1e-9);
    if (story().error.elsewhere) {
      ASSERT_TRUE(header().elsewhere);
      EXPECT_NEAR(*header().elsewhere, scale * *story().error.elsewhere, 1e-9);
    }
    const widgets::SessionVerdict& v = explain.verdict();
    const auto reported = story().error.in_pixels ? v.error_px : v.error_mm;
    if (header().now && reported)
      EXPECT_NEAR(*reported, *header().now, 1e-9) << "the verdict line says what the header says";
  }

  void expect_cards() {
    std::vector<QString> ids;
    bool is_honest_first = false;
    QString first_to_add;
    for (int i = 0; i < explain.cards()->count(); ++i) {
      const widgets::CardState& card = explain.cards()->card(i)->state();
      if (card.kind != widgets::CardKind::candidate) {
        is_honest_first = is_honest_first || i == 0;
        if (story().error.ratio().value_or(0) > most_that_agrees)
          EXPECT_NE(card.kind, widgets::CardKind::adequate) << "a green tick: " << card.title.toStdString();
        continue;
      }
      ids.push_back(card.id);
      if (first_to_add.isEmpty() && card.can_add) first_to_add = card.add_text;
      const auto now = header().now;
      if (now && card.error.now && card.error.unit == header().unit)
        EXPECT_EQ(widgets::with_unit_text(card.error.now, card.error.unit),
                  widgets::with_unit_text(now, header().unit));
    }
    std::vector<QString> reported;
    for (const StoryCause& c : story().causes) reported.push_back(QString::fromStdString(c.id));
    EXPECT_EQ(ids, reported);
    if (story().state != StoryState::not_looked) EXPECT_EQ(is_honest_first, story().lead() == nullptr);
    QPushButton* add = explain.cards()->add_button();
    EXPECT_TRUE(add->isVisible()) << "it does not come and go";
    EXPECT_EQ(add->isEnabled(), !first_to_add.isEmpty());
    if (!first_to_add.isEmpty()) EXPECT_EQ(add->text(), first_to_add);
  }

  void expect_attribution() {
    const auto& shown = explain.verdict().attribution;
    ASSERT_EQ(shown.has_value(), story().attribution.cause != ErrorCause::none);
    if (!shown) return;
    EXPECT_NEAR(shown->cameras, story().attribution.cameras, 1e-9);
    EXPECT_NEAR(shown->body, story().attribution.body, 1e-9);
    EXPECT_NEAR(shown->robot, story().attribution.robot, 1e-9);
  }

  void expect_rail() {
    const app::WorkStatus inspect = rail("rail_inspect"), explained = rail("rail_explain");
    if (story().beyond > 0) EXPECT_NE(inspect.line, "nothing odd") << story().beyond << " of " << story().used;
    EXPECT_EQ(explained.line == "nothing is missing",
              story().state == StoryState::at_the_noise && story().stands_in.empty())
        << explained.line.toStdString();
  }
};

}  // namespace handsight::test
