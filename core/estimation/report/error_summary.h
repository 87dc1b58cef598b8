// SPDX-License-Identifier: Apache-2.0
// Errors of many observations together.
#pragma once

#include <cmath>
#include <optional>

namespace handsight {

/// Root mean square, mean and maximum. Pixel: over image coordinates. Metres: over the lengths of the markers' 3D
/// residuals in the sensor's frame, of markers seen as points. Of cameras, hand_m: root mean square of how far the hand
/// is from where it is predicted, the markers of an observation taken together (their middle), to first order.
struct ErrorSummary {
  std::optional<double> rms_pixel, rms_m, mean_m, max_m, hand_m;
};

/// What the noise of one coordinate makes of an rms error as it is reported: in px it is over coordinates, in metres
/// over the lengths of three coordinates together.
inline double as_reported(double noise, bool in_pixels) { return in_pixels ? noise : std::sqrt(3.0) * noise; }

/// The same where it is known what noise makes of lengths (FitReport::rms_of_noise_m): a touch reads one coordinate, a
/// tracker three.
inline std::optional<double> reported_noise(std::optional<double> noise, std::optional<double> rms_of_noise_m,
                                            bool in_pixels) {
  if (!noise || in_pixels) return noise;
  return rms_of_noise_m.value_or(as_reported(*noise, false));
}

}  // namespace handsight
