// SPDX-License-Identifier: Apache-2.0
// A rotation that was read from three numbers by the wrong convention, read by another one.
#pragma once

#include <string>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

/// What three numbers may be. The first is what they were read as where the name does not say otherwise.
///   rotation_vector  rotation vectors, read as roll pitch yaw
///   rpy              roll pitch yaw (fixed axes x y z), read as rotation vectors
///   moving_xyz       turns about the moving axes x y z, read as roll pitch yaw
///   zyx              turns about z first, then y, x (A B C of some makers), read as roll pitch yaw
///   zyz              turns about z y z (O A T of some makers), read as roll pitch yaw
const std::vector<std::string>& rotation_conventions();

/// The rotations that it can be, the likeliest first: the numbers themselves are gone, and several triples of them
/// give the same wrong rotation.
std::vector<Matrix3> read_again(const Matrix3& wrong, const std::string& convention);

}  // namespace handsight
