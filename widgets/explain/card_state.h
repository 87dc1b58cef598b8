// SPDX-License-Identifier: GPL-3.0-or-later
// What a card says of a cause that may be missing in the model, or why there is nothing to add.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "widgets/lists/model_parameter.h"

namespace handsight::widgets {

enum class CardKind { candidate, adequate, unexplained, ambiguous, too_few, repeatability, noise_unknown };

/// Error left beside today's and the noise, in `unit`.
struct ErrorLeft {
  std::optional<double> now, left, noise;
  bool is_predicted = false;  // not fitted in full: the bar is dashed
  QString unit = "px";
};

/// A check with the real robot as numbers: predicted, measured, and what that says.
struct CardCheck {
  QString prediction;  // "Hang 1 kg on the hand: it should sag 1.40 ± 0.20 mm further (pose 37)."
  QString unit;        // of what is typed
  QString measured;    // "1.30 ± 0.05"; empty: nothing yet
  QString answer;      // "Inside: 0.5 sigma from the prediction. That speaks for this cause."
  bool is_inside = false;
};

struct CardState {
  QString id;  // what signals say; unique in the list
  CardKind kind = CardKind::candidate;
  std::string effect;  // of the catalogue, for the drawing; empty: the unnamed curve
  QString title;       // "Joint elasticity"
  QString where;       // "arm_2, arm_4"
  QString words;       // what it is; of an honest card its sentence
  ErrorLeft error;
  QString evidence;                   // "Follows the gravity torque of arm_2; chance would show this once in 10,000."
  std::vector<ModelParameter> sizes;  // value with sigma against what is plausible
  QString indistinguishable_from;     // "payload, base tilt"; empty: nothing
  QString check;                      // a cheap check with the robot
  std::optional<CardCheck> check_number;
  QString caution;   // "The fit wants 4 kg; 1 kg is plausible."
  QString add_text;  // "Add joint elasticity": what the button below the cards says; empty: "Add"
  bool can_add = true;
  QString why_not;  // where it cannot be added: the button's tool tip, and shown
  bool can_what_if = true, can_show_poses = false;
  QString action, action_id;  // an honest card's button: text and what the signal says; empty: none
};

}  // namespace handsight::widgets
