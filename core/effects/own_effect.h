// SPDX-License-Identifier: Apache-2.0
// Effects made from their definitions by formulas: a user's own, and unnamed curves that the program has found.
#pragma once

#include "effects/effect.h"
#include "session/effect_definition.h"

namespace handsight {

/// Sites by scope. joint: angle, compliance, bend_compliance, before_x ... before_rz, after_x ... after_rz; marker: x,
/// y, z; session: hand_x ... hand_rz, mount_x ... mount_rz, body_x ... body_rz, gravity_rx, gravity_ry, and
/// of each camera NAME_fx ... NAME_p2 (camera_numbers; the same in all observations: no variables).
/// Variables: q, tau, velocity, approach of the effect's own joint (scope joint); q_NAME, tau_NAME of any; tcp_x,
/// tcp_y, tcp_z, the TCP's place in the frame of the link that carries the sensor (m); time (0 to 1 over the session),
/// seconds, order. tau is the gravity torque (N m; N where prismatic). Torques and places are those of the nominal
/// robot. Throws InputError where a site or a formula is not understood, a name is taken, or a formula is not linear in
/// the parameters.
std::shared_ptr<const Effect> own_effect(const EffectDefinition& definition, const Robot& robot,
                                         const Rig& rig = make_rig(StereoRig{}));

/// Those of the session's cameras (rig_effects.h) and target (target_effects.h), then those by formula, found finite at
/// every observation. Throws InputError as above, and where an id is one of the catalogue.
OwnEffects list_own_effects(const Session& session, const Chain& chain);

/// A name as formulas write it: characters other than letters, digits and _ become _.
std::string formula_name(const std::string& name);

}  // namespace handsight
