// SPDX-License-Identifier: Apache-2.0
// The verdict of a diagnosis, and its reason in words.
#pragma once

#include <map>

#include "diagnosis/ranking/refitting.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

inline constexpr double ln_20 = 2.995732273553991;  // odds beyond which a rival is out

/// Sets verdict and reason from the candidates, which are in order. `refits`: the full fits, by effect.
void judge(const Session& session, bool knows_noise, const std::map<std::string, Refit>& refits, Diagnosis& diagnosis);

/// The verdict where nothing that could be added helps: adequate, or unexplained.
void judge_what_is_left(bool knows_noise, Diagnosis& diagnosis);

}  // namespace handsight
