// SPDX-License-Identifier: Apache-2.0
/// @file
/// What can go wrong. Bad input (a file, an option, a number) throws handsight::InputError, one sentence that says
/// what is wrong, where, and what to do. handsight::BrokenPromise is an error of the library itself; please report it.
/// What cannot be computed from the measurements is no exception: it is a std::optional or a note in the result.
#pragma once

#include "base/error.h"
