// SPDX-License-Identifier: Apache-2.0
// What is said of a session and its model, made once from what was found. Every place that speaks of the model (the
// window's badge, sentence, header, cards, blame, Inspect and report, the command line) shows this and nothing else, so
// that no two of them can contradict each other.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/message.h"
#include "diagnosis/verdict/diagnosis_result.h"
#include "diagnosis/verdict/stand_in.h"

namespace handsight {

/// What there is to say.
enum class StoryState {
  not_looked,            // there is no diagnosis (yet): only what the fit says
  too_few_observations,  // to tell causes apart
  noise_unknown,         // nobody can say whether what is left is much
  at_the_noise,
  unnamed_at_the_noise,  // down there with a curve that has no name
  repeatability,         // more than the noise, and it follows nothing
  missing,               // a cause leads
  ambiguous,             // likewise, and another one looks the same on these poses
  implausible,           // what would help is larger than robots are built
  unexplained,           // something real, and nothing in the catalogue explains (all of) it
  refused                // what would explain it does not lower the error on observations that the fit has not seen
};
/// "at_the_noise": for files and tests.
const char* story_state_text(StoryState state);

/// The error that counts and what noise alone makes of it. One figure, everywhere: the root mean square (rms), in px
/// over image coordinates, with a tracker or pose sensor in m over the lengths of three coordinates together.
struct StoryError {
  std::optional<double> error;  // held out where that is known, else fitted
  std::optional<double> noise;
  std::optional<double> elsewhere;  // held out region by region: where the robot has not been measured
  bool held_out = false;
  bool in_pixels = true;

  std::optional<double> ratio() const {
    return error && noise && *noise > 0 ? std::optional(*error / *noise) : std::nullopt;
  }
};

/// Times the noise: up to here an error agrees with it, where no scatter is known; never beyond.
inline constexpr double most_that_agrees = 1.5;
/// The same where joints or place are known to scatter.
inline constexpr double most_beside_repeatability = 1.25;
/// Times the noise: an observation beyond it is more than noise.
inline constexpr double beyond_noise = 3;
/// With fewer observations than this a fit agrees with them whatever is wrong: no error is reported.
inline constexpr int fewest_that_tell = 3;

StoryError story_error(const Fit& fit, const FitReport& report);

/// A cause that is offered.
struct StoryCause {
  std::size_t candidate = 0;       // index into Diagnosis::candidates
  std::string id;                  // of the effect or the curve (find_id)
  std::vector<std::string> where;  // joints, markers, "from observation 37 on"
  std::optional<double> left;      // the error that it would leave, as StoryError::error
  bool is_predicted = false;       // `left` was not fitted
  bool unnamed = false;            // a curve
  bool believable = true;          // of a size that robots have (is_believable)
  bool refused = false;
  std::vector<std::string> indistinguishable_from;  // effect ids
};

/// What to do next.
enum class StoryNext {
  wait,            // for the search
  measure_more,    // observations
  tell_apart,      // poses that would
  add,             // the first of the causes
  add_or_stop,     // likewise, but it may stand in for another cause
  tell_the_noise,  // declare sigma, or repeat poses
  give_masses,     // of the robot's links: without them nothing that bends could be tried
  look,            // at what is left, and at what it follows
  use_it           // export
};

struct Story {
  StoryState state = StoryState::not_looked;
  StoryError error;
  std::vector<StoryCause> causes;  // as they are offered (finding.h), none in a state without a search
  bool cause_leads = false;  // the first of the causes is the first word; else that it has no name, or nothing to add
  std::vector<StandIn> stands_in;  // in the model
  ErrorAttribution attribution;    // in the light of what leads
  int used = 0;                    // observations
  int beyond = 0;                  // of them beyond `beyond_noise`
  bool cannot_bend = false;        // something is left, and no link has a mass by which it could bend
  StoryNext next = StoryNext::wait;

  /// The cause that leads; null where none does.
  const StoryCause* lead() const { return cause_leads && !causes.empty() ? &causes.front() : nullptr; }
  /// Does more than noise show in so many observations that none of them is odd by itself: a tenth at least?
  bool many_beyond() const { return beyond > 0 && 10 * beyond >= used; }
};

/// What a story is made from. `diagnosis` is of the same model; null where there is none (yet).
struct StoryBasis {
  const Fit& fit;
  const FitReport& report;
  ErrorAttribution attribution;  // by residuals alone
  const Diagnosis* diagnosis = nullptr;
  std::set<std::string> refused = {};    // tried on this model and not taken, by find_id
  std::optional<double> elsewhere = {};  // px or m, where it was worked out beside the report
};
Story find_story(const StoryBasis& basis);

/// Of a diagnosis alone, as the command line has it (its blame is already told in the light of what was found).
/// `refused`: as in StoryBasis.
Story find_story(const Diagnosis& diagnosis, const std::set<std::string>& refused = {});

/// "3.4 px", "23 mm": an error as every place tells it, to two digits. From px or m.
Message story_size_text(double error, bool in_pixels);

/// The story in English for terminals and files: one to three sentences.
Message story_text(const Story& story, const Diagnosis& diagnosis);

}  // namespace handsight
