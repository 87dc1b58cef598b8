// SPDX-License-Identifier: Apache-2.0
// Calibrations in and out, with numbers that read back bit for bit.
#pragma once

#include <filesystem>
#include <string>

#include "session/calibration.h"

namespace handsight {

/// The order of <model_covariance>: TCP->Body's xi, then the parameters of <effects> as they stand in the file.
inline constexpr char model_order[] = "x y z rx ry rz effects";
/// The order of <doubt>'s <covariance>: the same, then the parameters of <doubt>.
inline constexpr char warn_of_order[] = "x y z rx ry rz effects doubt";

/// The calibration as XML. A number that is absent is written by leaving its attribute out. Rotations are
/// those of the 16 numbers of <matrix>; rpy beside it is for people. Every number is finite: see
/// require_finite. What goes to a file is made by readable_text.
std::string calibration_text(const Calibration& calibration);

/// InputError that names what is not finite: a fit of measurements that say nothing may end so.
void require_finite(const Calibration& calibration);

/// The same text, checked: InputError where a number is not finite, BrokenPromise with the reader's sentence where
/// parse_calibration would refuse it.
std::string readable_text(const Calibration& calibration);

/// Replaces (or makes) a file by readable_text, whole or not at all: where that throws, the old file stays. InputError
/// where it cannot be written.
void write_calibration(const std::filesystem::path& path, const Calibration& calibration);

/// Reads a text; `file` is what sentences call it. InputError where it is wrong. <matrix> may be missing,
/// then xyz and rpy count; where both stand they must agree to 1e-6.
Calibration parse_calibration(const std::string& text, const std::string& file);
Calibration read_calibration(const std::filesystem::path& path);

}  // namespace handsight
