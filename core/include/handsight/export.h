// SPDX-License-Identifier: Apache-2.0
/// @file
/// The calibrated robot for other programs: URDF, MuJoCo, SDFormat, DH tables, offsets, or C++ and Python that compute
/// the corrected hand pose.
#pragma once

#include <filesystem>
#include <string>

#include "export/exported.h"
#include "handsight/predict.h"

namespace handsight {

/// The robot as the text of another kind of file: one of handsight::export_kinds ("urdf", "mjcf", "dh", "cpp" ...; what
/// each holds is in docs/formats.md). ExportedFile::left is how far the file's hand is from the calibration's over the
/// session's poses (m, rms), ExportedFile::notes what the file cannot say. ExportOptions::file is where the text will
/// be written: meshes are named from its folder.
/// Throws InputError where the kind is not known, or this robot cannot be written so.
ExportedFile export_robot(const CalibratedRobot& robot, const std::string& kind, const ExportOptions& options = {});

/// Writes (or replaces) such a file, whole or not at all, and returns what was written.
/// Throws InputError as export_robot(), and where the file cannot be written.
ExportedFile save_robot(const std::filesystem::path& file, const CalibratedRobot& robot, const std::string& kind);

}  // namespace handsight
