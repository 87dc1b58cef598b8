// SPDX-License-Identifier: Apache-2.0
/// @page cpp From C++
/// Where a robot's hand really is, and why. One include, one target:
/// @code{.cmake}
/// find_package(Handsight REQUIRED)
/// target_link_libraries(my_program PRIVATE Handsight::handsight)
/// @endcode
/// @code{.cpp}
/// #include <handsight/handsight.h>
///
/// const handsight::Session session = handsight::read_session("sample_sessions/hidden_1");
/// const handsight::Improvement found = handsight::improve(session, handsight::Model{});
/// const handsight::CalibratedRobot robot = handsight::calibrated_robot(session, found);
/// const handsight::Correction command = handsight::correct(robot, session.observations[0].position);
/// handsight::save_robot("calibrated.urdf", robot, "urdf");
/// @endcode
/// Everything is in the namespace `handsight`. Lengths are in m, angles in rad, image points in px, times in s; a
/// motion `a_from_b` carries points from frame b to frame a. Values are plain data; functions change nothing that is
/// given to them and may be called from several threads. What stands below `handsight/detail/` is there because the
/// headers need it, and may change from one version to the next.
///
/// @file
/// All public headers.
#pragma once

#include "handsight/compare.h"
#include "handsight/convert.h"
#include "handsight/correct.h"
#include "handsight/diagnose.h"
#include "handsight/error.h"
#include "handsight/export.h"
#include "handsight/fit.h"
#include "handsight/improve.h"
#include "handsight/model.h"
#include "handsight/predict.h"
#include "handsight/session.h"
#include "handsight/simulate.h"

namespace handsight {

/// The library's version, "1.0.0".
const char* version();

}  // namespace handsight
