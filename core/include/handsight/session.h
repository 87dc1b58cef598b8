// SPDX-License-Identifier: Apache-2.0
/// @file
/// A session: a robot, what watches it (cameras, a tracker, a sensor of poses), and the observations. Plain data;
/// lengths in m, angles in rad, image points in px (u to the right, v down, the middle of the first pixel at 0, 0).
/// Motions are named a_from_b: a point in b times the motion is the point in a (docs/conventions.md).
///
/// handsight::read_session reads a folder (docs/formats.md), handsight::save_session writes it,
/// handsight::check_session says what is in it and what would not work.
#pragma once

#include "estimation/report/session_check.h"
#include "session/session.h"
#include "session/session_xml.h"
