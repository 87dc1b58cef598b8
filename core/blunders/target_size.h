// SPDX-License-Identifier: Apache-2.0
// A target that is described much too large or too small: told beside a fit that it ruins, at once.
#pragma once

#include <optional>
#include <string>

#include "base/message.h"
#include "estimation/fit/fit.h"

namespace handsight {

/// Is a target's size that of its squares? Else it is that of its tags.
bool has_squares(const Target& target);

/// The length that tells how large a target is described (m): of a square, or of a tag.
double described_length(const Target& target);

struct TargetSize {
  double scale = 0, sigma = 0;  // the target is so much larger than its description says: 0.09 is 9 %
  bool in_pixels = true;
  double rms_before = 0, rms_after = 0;      // px or m, of one coordinate: with the size described, and with this one
  double error_before = 0, error_after = 0;  // the same as a fit's report says it (reported_error)
  Message text;                              // one sentence: how large it is, by its squares, tags or distances
  Message fix;                               // one sentence: what to do
};

/// The size that makes the fit of a session right, where it leaves many times the noise and one size of the target
/// takes away most of that. Nothing where the target has no size that is known, where its size is in the model already,
/// or where the noise is all that is left. `options` are those of the fit.
std::optional<TargetSize> other_target_size(const Session& session, const Fit& fit, const FitOptions& options);

}  // namespace handsight
