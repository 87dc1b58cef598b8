// SPDX-License-Identifier: Apache-2.0
/// @file
/// A session from files that other programs wrote: tables of joint angles and poses, bags of ROS, folders of images,
/// calibrations, robots (docs/formats.md): handsight::convert with handsight::ConvertOptions.
#pragma once

#include "convert/convert.h"
#include "handsight/session.h"
