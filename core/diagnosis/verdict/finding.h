// SPDX-License-Identifier: Apache-2.0
// What a diagnosis goes by, and whose fault the error is in its light.
#pragma once

#include <set>
#include <string>

#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// What a session's model calls the candidate: the effect's id, of a curve the id of its term; empty where it is a
/// curve that could not be written down.
std::string find_id(const DiagnosisCandidate& candidate);

/// Can the model take it in: a name, or a curve that was fitted?
bool can_be_added(const DiagnosisCandidate& candidate);

/// Does a spring of these terms push back by more than two of its sigmas (negative compliance)? No robot is built so.
/// `sigmas` may be empty: none is known.
bool pushes_back(const std::vector<EffectTerm>& terms, const std::vector<std::vector<double>>& sigmas);

/// Why a candidate's numbers are not believed to be what they say.
enum class Disbelief {
  none,
  pushes_back,  // a spring with a negative compliance: no robot is built so
  too_large,    // DiagnosisCandidate::too_large: nor so
  leaves_much   // more than usual, as robots have it now and then, but then it would explain more
};

/// What is more than usual is believed where it explains nearly all that is missing, or where small deviations at each
/// joint explain the rest.
Disbelief find_disbelief(const DiagnosisCandidate& candidate);
inline bool is_believable(const DiagnosisCandidate& c) { return find_disbelief(c) == Disbelief::none; }

/// Could the one with the most evidence stand in for this candidate: a curve, or twice as many numbers that no robot
/// has?
bool may_stand_in(const DiagnosisCandidate& best, const DiagnosisCandidate& candidate);

/// Do small deviations at each joint beside either make `candidate` as likely as the best one? These are in every
/// robot, and the best one may be likelier alone only since it takes them in.
bool is_likelier_beside_small(const DiagnosisCandidate& best, const DiagnosisCandidate& candidate);

/// Does a candidate come before the one with the most evidence? What the target is comes before what the robot is,
/// where it explains about as much: a wrong size bends every link a little. And few numbers come before many that no
/// robot has, where they explain nearly as much or are likelier beside small deviations at each joint: what is left
/// then is the next step's.
bool comes_before(const DiagnosisCandidate& candidate, const DiagnosisCandidate& best);

/// The candidates that pass the threshold, as they are offered: what comes before the best, what is believable and has
/// half as much evidence, then what no robot is built like, then those that were refused (by find_id); each by its
/// evidence. Indices into Diagnosis::candidates.
std::vector<std::size_t> offered(const Diagnosis& diagnosis, const std::set<std::string>& refused = {});

/// The candidate that a diagnosis goes by: the first that is offered. Null: none passes that was not refused.
const DiagnosisCandidate* finding_of(const Diagnosis& diagnosis, const std::set<std::string>& refused = {});

/// Of the effects that the poses could not show (Diagnosis::invisible), those that this robot and session have a place
/// for at all, and that are not in the model.
std::vector<std::string> unseen_effects(const Diagnosis& diagnosis);

/// Whose fault an error is, as far as residuals alone say, corrected by what was found: the share of the excess that
/// the finding explains belongs to what it moves (cameras and their mount, the marker body, the robot); the rest is
/// parted as before. A lens can look like the robot's error, for both images of a marker may still fit together.
ErrorAttribution attribution_by_finding(const ErrorAttribution& attribution, const Diagnosis& diagnosis,
                                        const std::set<std::string>& refused = {});

}  // namespace handsight
