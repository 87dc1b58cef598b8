// SPDX-License-Identifier: Apache-2.0
// The part of an exported Python file that is the same for every robot. Internal to python_file.cpp.
#pragma once

namespace handsight {

/// Stands before the tables.
extern const char* const python_types;

/// Stand after the tables and _add_effects().
extern const char* const python_engine;
extern const char* const python_correction;

}  // namespace handsight
