// SPDX-License-Identifier: Apache-2.0
#include "export/cpp_engine.h"

namespace handsight {

const char* const cpp_types = R"cpp(
  /// A rigid motion b_from_a: x_in_b = turn * x_in_a + shift (m).
  struct Motion {
    double turn[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double shift[3] = {0, 0, 0};
  };

  /// How the robot comes to a pose, where effects depend on it. As it is: at rest, from nowhere, after the session.
  struct Drive {
    const double* velocity = nullptr;  // joint_count numbers, rad/s (m/s)
    const double* from = nullptr;      // joint_count numbers: the position before, for the direction of approach
    double share = 1;                  // 0 to 1 over the session that the calibration comes from
    double seconds = 1;                // since its first observation
    double order = 1073741824;         // how many observations there had been, less one
  };

  namespace detail {

  struct Joint {
    int parent;  // -1: the floor
    char kind;   // t turns, s slides, f does not move
    int input;   // place in a position; -1: none
    Motion parent_from_joint;
    double axis[3];
    Motion joint_from_child;
    double stiffness, mass, moment[3];  // 0 is rigid; kg; kg m in the child's frame
    double lower, upper;
    int first_mimic, mimics;
  };

  struct Mimic {
    int joint;
    double multiplier, offset;
  };

  struct JointChange {
    double angle = 0, multiplier_error = 0, share = 0, compliance = 0, bend = 0, gap = 0;
    double before[6] = {0, 0, 0, 0, 0, 0}, after[6] = {0, 0, 0, 0, 0, 0};
  };

  struct WholeChange {
    double hand[6] = {0, 0, 0, 0, 0, 0}, body[6] = {0, 0, 0, 0, 0, 0};
    double tilt[2] = {0, 0}, base[3] = {0, 0, 0}, payload_mass = 0, payload_moment[3] = {0, 0, 0};
  };

  inline double sign_of(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }
)cpp";

}  // namespace handsight
