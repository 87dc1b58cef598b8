// SPDX-License-Identifier: Apache-2.0
// The part of an exported C++ file that is the same for every robot. Internal to cpp_file.cpp.
#pragma once

namespace handsight {

/// Motions, and what the tables are made of: stands before the tables.
extern const char* const cpp_types;

/// Posture, prediction and correction: stands after the tables and add_effects().
extern const char* const cpp_engine;
extern const char* const cpp_correction;

/// What the file offers, and a main() behind HANDSIGHT_HAND_MAIN.
extern const char* const cpp_interface;

}  // namespace handsight
