// SPDX-License-Identifier: Apache-2.0
#include "widgets/explain_samples.h"

#include <array>
#include <cmath>
#include <random>

#include "effects/effect.h"

namespace handsight::test {

using namespace widgets;

SessionVerdict missing_verdict() {
  SessionVerdict v;
  v.state = SessionState::missing;
  v.sentence =
      "Most likely missing: joint arm_2 gives way under gravity. With it the error would fall from 9.1 to 0.24 px on "
      "observations that the fit has not seen.";
  v.error_px = 9.1;
  v.noise_px = 0.2;
  v.error_mm = 12;
  v.noise_mm = 0.3;
  v.attribution = ErrorAttribution{0.02, 0.04, 0.94};
  return v;
}

std::vector<PatternPlot> nine_patterns(int observations) {
  struct Kind {
    const char *what, *against, *x_unit, *shows;
    double strength;
  };
  const std::array<Kind, 9> kinds = {{{"z of the TCP", "gravity torque of arm_2", "N m", "joint elasticity", 0.93},
                                      {"angle of arm_2", "angle of arm_2", "rad", "eccentricity, scale", 0.71},
                                      {"angle of arm_3", "angle of arm_3", "rad", "ripple", 0.32},
                                      {"angle of arm_4", "approach of arm_4", "", "hysteresis", 0.12},
                                      {"x of the TCP", "time", "s", "mount drift, slips", 0.08},
                                      {"v in the image", "place across the image", "px", "intrinsics", 0.05},
                                      {"u in the image", "place down the image", "px", "lens distortion", 0.04},
                                      {"depth of the hand", "depth", "m", "stereo rig", 0.02},
                                      {"x of the TCP", "speed of the hand", "m/s", "time lag", 0.01}}};
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  std::vector<PatternPlot> plots;
  for (const Kind& kind : kinds) {
    PatternPlot plot;
    plot.id = QString("%1/%2").arg(kind.what, kind.against);
    plot.what = kind.what;
    plot.against = kind.against;
    plot.x_unit = kind.x_unit;
    plot.y_unit = "mm";
    plot.shows = kind.shows;
    plot.strength = kind.strength;
    plot.is_chance = kind.strength < 0.06;
    plot.noise = 0.3;
    const double size = 9 * kind.strength;
    const auto curve = [&](double x) { return size * (plots.size() == 1 ? std::sin(3 * x) : x); };
    for (int i = 0; i < observations; ++i) {
      const double x = 2.0 * i / observations - 1, y = curve(x) + 0.3 * noise(random);
      plot.points.push_back({i, x * 30, y, std::abs(y) / 0.3, 12});
    }
    for (int i = 0; i <= 40; ++i) {
      const double x = i / 20.0 - 1;
      plot.trend.push_back({x * 30, curve(x), curve(x) - 0.4, curve(x) + 0.4});
      if (kind.strength > 0.3) plot.candidate.push_back({x * 30, 0.92 * curve(x), 0, 0});
    }
    plots.push_back(plot);
  }
  return plots;
}

std::vector<CloudPoint> cloud(int observations, double size) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.2);
  std::vector<CloudPoint> points;
  for (int i = 0; i < observations; ++i) {
    const double down = size * std::sin(2.4 * i), across = 0.3 * size * std::cos(1.7 * i);
    for (int marker = 0; marker < 3; ++marker)
      for (const int camera : {0, 1})
        points.push_back({i, marker, camera, across + noise(random), down + noise(random)});
  }
  return points;
}

CardState elasticity_card() {
  CardState card;
  card.id = "joint_elasticity/arm_2+arm_4";
  card.effect = "joint_elasticity";
  card.title = "Joint elasticity";
  card.where = "arm_2, arm_4";
  card.words =
      "The joint is a spring: its gear, its torque sensor or its controller gives way to the moment of gravity about "
      "its axis.";
  card.error = {9.1, 0.24, 0.2, false, "px"};
  card.evidence = "z of the TCP follows the gravity torque of arm_2; chance would show this less than once in 10,000.";
  card.sizes = {{"arm_2", "compliance", 1.18e-4, 3e-6, "rad/(N m)", 1e-4},
                {"arm_4", "compliance", 2.4e-5, 8e-6, "rad/(N m)", 1e-4}};
  card.check = "Hang 1 kg on the hand, arm stretched: it should drop 1.4 ± 0.2 mm more.";
  return card;
}

CardState predicted_card() {
  CardState card;
  card.id = "payload";
  card.effect = "payload";
  card.title = "Payload";
  card.words = "The hand carries a mass that the model does not know.";
  card.error = {9.1, 3.4, 0.2, true, "px"};
  card.sizes = {{"", "mass", 4.1, 0.6, "kg", 1}};
  card.caution = "The fit wants 4.1 kg; 1 kg is plausible. Probably another cause.";
  card.indistinguishable_from = "base tilt";
  card.check = "Weigh the hand with everything on it.";
  card.can_show_poses = true;
  return card;
}

CardState unnamed_card() {
  CardState card;
  card.id = "unnamed/arm_3";
  card.title = "A curve without a name";
  card.where = "arm_3";
  card.words = "Something follows the angle of arm_3, three times a turn.";
  card.error = {3.1, 0.9, 0.2, true, "px"};
  card.can_add = card.can_what_if = false;
  card.why_not = "It has no name in the catalogue: it can be looked at, not added.";
  return card;
}

std::vector<CardState> honest_cards() {
  const auto card = [](CardKind kind, const char* id, const char* title, const char* words, const char* action) {
    CardState state;
    state.kind = kind;
    state.id = id;
    state.title = title;
    state.words = words;
    state.action = action;
    state.action_id = *action ? id : "";
    return state;
  };
  return {card(CardKind::adequate, "export", "Nothing is missing",
               "The model agrees with the measurements down to the cameras' noise (0.21 against 0.20 px). These poses "
               "could not show: base tilt, time lag.",
               "Export"),
          card(CardKind::ambiguous, "poses", "Two that look the same",
               "Joint offset of arm_6 or camera mount: on these poses they look the same. 6 more poses would tell.",
               "Show the poses"),
          card(CardKind::unexplained, "curve", "Not in the catalogue",
               "Something real is left (3.1 px), and nothing in the catalogue explains it. It follows the angle of "
               "arm_3, three times a turn.",
               "Show the curve"),
          card(CardKind::too_few, "plan", "Too few observations",
               "12 observations cannot tell causes apart; with this model it takes about 25.", "Plan poses"),
          card(CardKind::repeatability, "scatter", "The robot does not repeat better",
               "What is left (0.6 px) differs from pose to pose without a pattern: the joints do not repeat better. No "
               "effect can remove it.",
               ""),
          card(CardKind::noise_unknown, "noise", "The noise is unknown",
               "Without three markers or repeated poses the noise is unknown, so the program cannot say when to stop.",
               "Plan poses")};
}

StaircaseState four_versions() {
  StaircaseState state;
  state.noise = 0.2;
  state.versions = {{"TCP→Body", 8.8, 9.1, false, {}},
                    {"+ joint elasticity of arm_2", 1.1, 1.4, false, {}},
                    {"+ payload", 1.0, 1.5, true, "on unseen observations the error would rise from 1.4 to 1.5 px"},
                    {"+ joint offset of arm_4", 0.21, 0.24, false, {}}};
  return state;
}

std::vector<VersionEntry> version_entries() {
  return {{"TCP→Body", "", 9.1, 8.8, {}, {}, false},
          {"+ joint elasticity of arm_2", "", 1.4, 1.1, -7.7, 0.3, false},
          {"+ payload", "the error would rise from 1.4 to 1.5 px", 1.5, 1.0, {}, {}, true},
          {"+ joint offset of arm_4", "2 excluded", 0.24, 0.21, -1.16, 0.08, false}};
}

std::vector<EffectRow> effect_rows() {
  std::vector<EffectRow> rows;
  for (const Effect& effect : catalogue()) {
    EffectRow row{
        QString::fromStdString(effect.id), QString::fromStdString(effect.title), "", EffectVerdict::no_sign, "",
        "The error would stay at 9.1 px."};
    if (effect.id == "joint_elasticity") {
      row.where = "arm_2, arm_4";
      row.verdict = EffectVerdict::would_help;
      row.reason = "The error would fall from 9.1 to 0.24 px.";
    } else if (effect.id == "payload") {
      row.verdict = EffectVerdict::worse;
      row.reason = "It fits, but leaves 3.4 px and wants 4.1 kg.";
    } else if (effect.id == "camera_mount") {
      row.verdict = EffectVerdict::in_model;
      row.reason = "Estimated with TCP→Body.";
    } else if (effect.id == "base_tilt" || effect.id == "time_lag") {
      row.verdict = EffectVerdict::cannot_be_seen;
      row.reason = QString::fromStdString(effect.visibility);
    } else if (effect.id == "joint_scale") {
      row.verdict = EffectVerdict::same_as;
      row.same_as = "joint offset";
      row.reason = "arm_2 turns by 20 deg only: 6 more poses would tell.";
    }
    rows.push_back(row);
  }
  return rows;
}

WhatIfState eccentricity() {
  WhatIfState state;
  state.id = "encoder_eccentricity";
  state.title = "Encoder eccentricity";
  state.places = {"arm_1", "arm_2", "arm_3"};
  state.place = 2;
  state.parameters = {{"sine", "mrad", 2, 1.3, 0.2, 1.0}, {"cosine", "mrad", 2, -0.4, 0.2, 0.0}};
  state.answer = "With this the error would be 3.1 px instead of 9.1 px.";
  return state;
}

std::vector<TruthRow> truth_rows() {
  return {
      {"joint elasticity of arm_2", "compliance", "rad/(N m)", 1.2e-4, 1.18e-4, 3e-6, TruthVerdict::right, "0.7 σ off"},
      {"joint offset of arm_4", "offset", "mrad", 4.0, 5.1, 0.2, TruthVerdict::off, "5.5 σ off"},
      {"time lag", "lag", "ms", 15.0, {}, {}, TruthVerdict::missed, ""},
      {"payload", "mass", "kg", {}, 0.4, 0.1, TruthVerdict::too_much, ""}};
}

}  // namespace handsight::test
