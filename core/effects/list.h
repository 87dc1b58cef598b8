// SPDX-License-Identifier: Apache-2.0
// The catalogue's entries, each in the file of its name. A new effect is one file, one line here and one in
// catalogue.cpp.
#pragma once

#include "effects/effect.h"

namespace handsight {

Effect joint_offset();
Effect joint_scale();
Effect joint_coupling();
Effect joint_elasticity();
Effect link_elasticity();
Effect link_geometry();
Effect encoder_eccentricity();
Effect transmission_ripple();
Effect backlash();
Effect friction_hysteresis();
Effect payload();
Effect base_tilt();
Effect base_elasticity();
Effect mimic_error();
Effect mimic_linkage();
Effect camera_mount();
Effect stereo_rig();
Effect rig();
Effect camera_intrinsics();
Effect lens_distortion();
Effect time_lag();
Effect mount_drift();
Effect mount_slip();
Effect body_slip();
Effect marker_slip();
Effect target_scale();
Effect target_bend();
Effect tag_placement();

}  // namespace handsight
