// SPDX-License-Identifier: Apache-2.0
// How large what differs from pose to pose and follows nothing is, from what a model leaves.
#pragma once

#include <optional>

#include "diagnosis/evidence/evidence.h"

namespace handsight {

/// The scatter under which what the model leaves is likeliest, all joints alike, sought from `start` on by Fisher's
/// scoring over the variances (Searle, Casella and McCulloch, Variance Components, 1992, ch. 8); no more than 30 mrad
/// and 10 mm, 0 below 1 urad and 1 um. The place may share where the noise is known: a tracker's own noise would be the
/// same otherwise.
Repeatability likely_repeatability(const LinearModel& model, const Repeatability& start, const NoiseKnowledge& noise,
                                   bool with_place);

/// Joints that repeat differently, and by how much (ln) that must be likelier than joints that are alike.
struct UnevenRepeatability {
  Repeatability repeatability;
  double ln_price = 0;
};

/// The same with a variance for each joint, sought from joints that are alike (`even`) on; the noise is known. What the
/// measurements do not tell of a joint is as of the others: the logarithms of the variances are normal about their
/// mean. Nothing where joints do not scatter, or there is just one.
std::optional<UnevenRepeatability> likely_of_each_joint(const LinearModel& model, const Repeatability& even);

}  // namespace handsight
