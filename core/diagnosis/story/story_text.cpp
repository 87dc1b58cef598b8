// SPDX-License-Identifier: Apache-2.0
// The story in English, for terminals and files.
#include <fmt/format.h>

#include "diagnosis/evidence/repeatability_levels.h"
#include "diagnosis/story/story.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis/verdict/finding.h"

namespace handsight {
namespace {

Message size_or_unknown(std::optional<double> size, bool in_pixels) {
  return size ? story_size_text(*size, in_pixels) : Message("unknown");
}

Message named(const std::string& id, const std::vector<std::string>& where) {
  const Effect* effect = find_effect(id);
  const Message title = effect ? looked_up(effect->title) : verbatim(id);
  return where.empty() ? title : message("{} ({})", title, listed(where));
}

Message both(const Story& s) {
  return message("{}{} where the noise is {}", size_or_unknown(s.error.error, s.error.in_pixels),
                 s.error.held_out ? " held out" : "", size_or_unknown(s.error.noise, s.error.in_pixels));
}

Message of_disbelief(const DiagnosisCandidate& c) {
  switch (find_disbelief(c)) {
    case Disbelief::pushes_back:
      return " It pushes back where springs give way: it probably stands in for another cause.";
    case Disbelief::too_large:
      return " It is larger than robots are built: it probably stands in for another cause.";
    case Disbelief::leaves_much:
      return " It is more than three times what is usual, and it leaves much: it may stand in for another cause.";
    case Disbelief::none:
      break;
  }
  return "";
}

Message of_lead(const Story& s, const Diagnosis& d) {
  const DiagnosisCandidate& c = d.candidates[s.causes.front().candidate];
  if (c.unnamed) return d.reason;
  const Message text = missing_text(c, s.state == StoryState::ambiguous, d);
  return s.state == StoryState::implausible ? text + of_disbelief(c) : text;
}

Message of_repeatability(const Story& s, const Diagnosis& d) {
  const Message size = repeatability_text(d.repeatability, d.model.session.joints);
  return message(
      "What is left, {}, differs from pose to pose and follows nothing that was measured{}: no effect "
      "can remove it.",
      both(s), size.empty() ? Message() : message(", as of {}", size));
}

Message of_part(const Story& s) {
  return message(
      "Something real is left, {}: {} explains a part of it, and nothing in the catalogue explains the "
      "rest.",
      both(s), named(s.causes.front().id, s.causes.front().where));
}

Message of_stand_ins(const Story& s) {
  std::vector<Message> names;
  for (const StandIn& one : s.stands_in) names.push_back(named(one.id, one.where));
  if (names.empty()) return "";
  return message(" {} in the model {} in for another cause: no robot is built so.", joined(names, ", ", " and "),
                 names.size() == 1 ? "stands" : "stand");
}

Message of_state(const Story& s, const Diagnosis& d) {
  switch (s.state) {
    case StoryState::missing:
    case StoryState::ambiguous:
    case StoryState::implausible:
      return of_lead(s, d);
    case StoryState::repeatability:
      return of_repeatability(s, d);
    case StoryState::unexplained:
      return s.lead() && !s.lead()->unnamed ? of_part(s) : d.reason;
    case StoryState::refused:
      return message(
          "Something is left, {}, and what would explain it does not lower the error on observations "
          "that the fit has not seen.",
          both(s));
    default:
      return d.reason;
  }
}

Message of_masses(const Story& s) {
  if (!s.cannot_bend) return "";
  return " No link of the robot has a mass, so that nothing that bends could be tried: give the masses in the robot's "
         "file.";
}

}  // namespace

Message story_size_text(double error, bool in_pixels) { return reported_size(error, in_pixels); }

Message story_text(const Story& s, const Diagnosis& d) { return of_state(s, d) + of_masses(s) + of_stand_ins(s); }

}  // namespace handsight
