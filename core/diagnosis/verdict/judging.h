// SPDX-License-Identifier: Apache-2.0
// The verdict of a diagnosis, and its reason in words.
#pragma once

#include <map>

#include "diagnosis/ranking/refitting.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// How well a robot repeats of which nothing is declared: rad of one joint, m of the hand's place.
inline constexpr Repeatability usual_repeatability{3e-4, 3e-4};

/// What a model leaves, over what the noise, the robot's declared repeatability (else usual_repeatability) and poses
/// that were measured again leave: 1 or less where it may be scatter from pose to pose. The noise must be known.
double beyond_usual_repeatability(const Session& session, const Fit& fit, const LinearModel& model,
                                  const NoiseKnowledge& noise);

/// ln of the Bayes factor of `best`, the repeatability that suits the model, against the likeliest that is no worse
/// than declared (else usual_repeatability) and a tenth more; 0 where it is, or poses measured again scatter as much.
double find_ln_against_usual_repeatability(const Session& session, const Fit& fit, const LinearModel& model,
                                           const NoiseKnowledge& noise, const Repeatability& best);

/// Does what is left follow something clearly? The first of the patterns decides.
bool follows_a_pattern(const Diagnosis& diagnosis);

/// Is more left than noise and the scatter that robots have? Not where the noise is not known.
bool repeats_too_badly(const Diagnosis& diagnosis);

inline constexpr double ln_20 = 2.995732273553991;  // odds beyond which a rival is out

/// Sets verdict and reason from the candidates, which are in order. `refits`: the full fits, by effect.
void judge(const Session& session, bool knows_noise, const std::map<std::string, Refit>& refits, Diagnosis& diagnosis);

/// The verdict where nothing that could be added helps: adequate, or unexplained.
void judge_what_is_left(bool knows_noise, Diagnosis& diagnosis);

}  // namespace handsight
