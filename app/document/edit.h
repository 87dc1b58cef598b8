// SPDX-License-Identifier: GPL-3.0-or-later
// One action of the user as data: what it changed, from what to what. Undo, redo and the journal need no more.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "document/robot_reading.h"
#include "estimation/fit/fit.h"
#include "session/edit.h"

namespace handsight::app {

/// How the model is fitted: what the user chose.
struct ModelSettings {
  Objective objective = Objective::image;
  bool fix_markers = false;
  std::vector<EffectTerm> estimated;  // effects of the model, from these values on; single numbers may be held
  std::vector<EffectTerm> held;       // at these values
  int by_hand = 0;                    // of `estimated`, from the front: ticked by the user, so Explain leaves them in

  bool has_effects() const { return !estimated.empty() || !held.empty(); }
  bool operator==(const ModelSettings& other) const;
};

struct SettingsEdit {
  ModelSettings before, after;
};

/// What was measured for one cause; absent: nothing.
struct ReadingEdit {
  std::string effect;
  std::optional<RobotReading> before, after;
};

/// One marker of labels that are not finished yet: where it was pointed at, and the partner where the user took one.
struct DraftMarker {
  int marker = 0;
  Vector2 left{0, 0};
  bool left_is_free = false;     // on no corner
  std::optional<Vector2> right;  // absent: the program finds it

  bool operator==(const DraftMarker& other) const = default;
};
using LabelDraft = std::vector<DraftMarker>;

/// Unfinished labels of one observation; absent: none, the observation's own labels stand.
struct DraftEdit {
  std::int64_t observation = 0;
  std::optional<LabelDraft> before, after;
};

/// What a collection's sessions share, and which they are: the text of its file (session/collection.h).
struct CollectionEdit {
  std::string before, after;
};

/// One action. `sentence` says what was done in the past tense without a subject: "excluded observation 7".
struct Edit {
  QString sentence;
  std::vector<ObservationEdit> observations;
  std::optional<SettingsEdit> settings;
  std::optional<ReadingEdit> reading;
  std::optional<DraftEdit> draft;
  std::optional<CollectionEdit> collection;
  /// Actions with the same number, pushed one after the other, are one action to undo: a drag, a play. 0: alone.
  std::int64_t joins = 0;
  /// New observations for the end of the session, as they came; what is known of them is in `observations`.
  std::vector<Observation> added;

  bool is_empty() const {
    return added.empty() && observations.empty() && !settings && !reading && !draft && !collection;
  }
  /// Does it leave the model as it is?
  bool leaves_model() const {
    return added.empty() && observations.empty() && !settings && !collection && (reading || draft);
  }
};

/// `later` follows `earlier`: both as one, with the later sentence.
Edit joined(Edit earlier, const Edit& later);

/// The edit as one line of JSON, numbers bit for bit, and back. Effects by formula carry their definition along. Throws
/// InputError where the text is no edit.
std::string edit_text(const Edit& edit);
/// `session`: whose edit it is; without it an edit with an effect by formula is refused.
Edit parse_edit(const std::string& text, const Session* session = nullptr);

}  // namespace handsight::app
