// SPDX-License-Identifier: Apache-2.0
#include "export/cpp_engine.h"

namespace handsight {

const char* const cpp_correction = R"cpp(
  /// The rotation vector of a rotation.
  inline void vector_of(const double r[3][3], double v[3]) {
    v[0] = (r[2][1] - r[1][2]) / 2;
    v[1] = (r[0][2] - r[2][0]) / 2;
    v[2] = (r[1][0] - r[0][1]) / 2;
    const double sine = std::sqrt(dot(v, v)), cosine = (r[0][0] + r[1][1] + r[2][2] - 1) / 2;
    if (sine < 1e-12) return;
    const double factor = std::atan2(sine, cosine) / sine;
    for (int i = 0; i < 3; ++i) v[i] *= factor;
  }

  /// What is left from one pose to another: m, then rad, in the root's axes.
  inline void difference(const Motion& from, const Motion& to, double out[6]) {
    double turn[3][3];
    for (int i = 0; i < 3; ++i) {
      out[i] = to.shift[i] - from.shift[i];
      for (int k = 0; k < 3; ++k) turn[i][k] = dot(to.turn[i], from.turn[k]);
    }
    vector_of(turn, out + 3);
  }

  /// Gauss without pivots; the matrix is symmetric and positive.
  inline void solve_six(double a[6][6], double b[6]) {
    for (int i = 0; i < 6; ++i)
      for (int k = i + 1; k < 6; ++k) {
        const double factor = a[k][i] / a[i][i];
        for (int l = i; l < 6; ++l) a[k][l] -= factor * a[i][l];
        b[k] -= factor * b[i];
      }
    for (int i = 5; i >= 0; --i) {
      for (int k = i + 1; k < 6; ++k) b[i] -= a[i][k] * b[k];
      b[i] /= a[i][i];
    }
  }

  /// The shortest step of the free joints that closes `left`; joints that would leave their limits stop there.
  inline void limited_step(const double by_joint[joint_count][6], const double* position, double left[6],
                           double damping, double* step) {
    bool is_free[joint_count];
    double lower[joint_count], upper[joint_count];
    for (int i = 0; i < joint_count; ++i) is_free[i] = false;
    for (int j = 0; j < count; ++j)
      if (joints[j].input >= 0) {
        is_free[joints[j].input] = true;
        lower[joints[j].input] = joints[j].lower;
        upper[joints[j].input] = joints[j].upper;
      }
    for (int i = 0; i < joint_count; ++i) step[i] = 0;
    for (bool has_new = true; has_new;) {
      double a[6][6] = {}, b[6], trace = 0;
      for (int k = 0; k < 6; ++k) b[k] = left[k];
      for (int i = 0; i < joint_count; ++i)
        if (is_free[i])
          for (int k = 0; k < 6; ++k)
            for (int l = 0; l < 6; ++l) a[k][l] += by_joint[i][k] * by_joint[i][l];
      for (int k = 0; k < 6; ++k) trace += a[k][k];
      for (int k = 0; k < 6; ++k) a[k][k] += damping * trace + 1e-30;
      solve_six(a, b);
      has_new = false;
      for (int i = 0; i < joint_count; ++i) {
        if (!is_free[i]) continue;
        step[i] = 0;
        for (int k = 0; k < 6; ++k) step[i] += by_joint[i][k] * b[k];
      }
      for (int i = 0; i < joint_count; ++i) {
        if (!is_free[i] || (position[i] + step[i] >= lower[i] && position[i] + step[i] <= upper[i])) continue;
        step[i] = (position[i] + step[i] < lower[i] ? lower[i] : upper[i]) - position[i];
        for (int k = 0; k < 6; ++k) left[k] -= by_joint[i][k] * step[i];
        is_free[i] = false;
        has_new = true;
      }
    }
  }

  constexpr double length_of_radian = 0.3;  // m: what a turn counts as beside a shift, where not all can be had

  /// What is left to the target, turns as lengths.
  inline double way_left(const double* position, const Drive& drive, const Motion& target, Motion& hand, double left[6]) {
    Motion body;
    predict(position, drive, hand, body);
    difference(hand, target, left);
    for (int k = 3; k < 6; ++k) left[k] *= length_of_radian;
    return std::sqrt(dot(left, left) + dot(left + 3, left + 3));
  }

  inline void hand_by_joint(const double* position, const Drive& drive, const Motion& hand, double by_joint[][6]) {
    for (int i = 0; i < joint_count; ++i) {
      double moved[joint_count];
      Motion there, body;
      std::copy(position, position + joint_count, moved);
      moved[i] += 1e-6;
      predict(moved, drive, there, body);
      difference(hand, there, by_joint[i]);
      for (int k = 0; k < 6; ++k) by_joint[i][k] *= (k < 3 ? 1 : length_of_radian) / 1e-6;
    }
  }

  inline bool correct(const Motion& target, const Drive& drive, double* position) {
    constexpr double least_damping = 1e-10, most_damping = 1e6, widest = 0.3;  // of the derivatives' squares; rad (m)
    double left[6], by_joint[joint_count][6], damping = least_damping;
    Motion hand;
    double way = way_left(position, drive, target, hand, left);
    hand_by_joint(position, drive, hand, by_joint);
    for (int pass = 0; pass < 200 && damping < most_damping; ++pass) {
      double closing[6], step[joint_count], moved[joint_count], size = 0, now[6];
      std::copy(left, left + 6, closing);
      limited_step(by_joint, position, closing, damping, step);
      for (int i = 0; i < joint_count; ++i) size = std::max(size, std::abs(step[i]));
      if (size < 1e-12) break;
      for (int i = 0; i < joint_count; ++i) moved[i] = position[i] + step[i] * std::min(1.0, widest / size);
      Motion there;
      const double then = way_left(moved, drive, target, there, now);
      if (then > way) {
        damping *= 100;
        continue;
      }
      damping = std::max(least_damping, damping / 100);
      std::copy(moved, moved + joint_count, position);
      std::copy(now, now + 6, left);
      way = then;
      hand = there;
      hand_by_joint(position, drive, hand, by_joint);
    }
    return std::sqrt(dot(left, left)) < 1e-6 && std::sqrt(dot(left + 3, left + 3)) < 1e-6 * length_of_radian;
  }
)cpp";

const char* const cpp_interface = R"cpp(
  }  // namespace detail

  /// root_from_hand where the hand really is, for the joint readings `position` (rad, m; the order of joint_names).
  /// False where the springs are too soft for the load: the pose is then not to be used.
  inline bool hand_pose(const double* position, Motion& root_from_hand, const Drive& drive = Drive{}) {
    Motion body;
    return detail::predict(position, drive, root_from_hand, body);
  }

  /// The same for the marker body.
  inline bool body_pose(const double* position, Motion& root_from_body, const Drive& drive = Drive{}) {
    Motion hand;
    return detail::predict(position, drive, hand, root_from_body);
  }

  /// Where the nominal model puts the hand.
  inline Motion nominal_hand_pose(const double* position) {
    double reading[detail::count];
    detail::all_readings(position, reading, true);
    detail::Posture posture;
    detail::solve(reading, detail::Change{}, detail::nominal_is_elastic, false, posture);
    return detail::hand_of(posture, detail::WholeChange{});
  }

  /// The joint angles to command so that the hand really arrives at `target`, from those near it, within the joints'
  /// limits. False where it cannot: `position` then brings it as near as possible.
  inline bool correct(const Motion& target, double* position, const Drive& drive = Drive{}) {
    return detail::correct(target, drive, position);
  }

  /// ... so that it arrives where the nominal model puts it for `position`.
  inline bool correct(double* position, const Drive& drive = Drive{}) {
    return detail::correct(nominal_hand_pose(position), drive, position);
  }

  }  // namespace handsight_hand

#ifdef HANDSIGHT_HAND_MAIN
  // Reads positions, a line each, and writes root_from_hand row by row; with the argument "correct" what to command.
#include <cstdio>
#include <cstring>

  int main(int argc, char** argv) {
    const bool corrects = argc > 1 && std::strcmp(argv[1], "correct") == 0;
    double position[handsight_hand::joint_count];
    while (true) {
      for (double& q : position)
        if (std::scanf("%lf", &q) != 1) return 0;
      bool is_good;
      if (corrects) {
        is_good = handsight_hand::correct(position);
        for (const double q : position) std::printf("%.17g ", q);
      } else {
        handsight_hand::Motion hand;
        is_good = handsight_hand::hand_pose(position, hand);
        for (int i = 0; i < 3; ++i)
          std::printf("%.17g %.17g %.17g %.17g ", hand.turn[i][0], hand.turn[i][1], hand.turn[i][2], hand.shift[i]);
      }
      std::printf("%s\n", is_good ? "good" : "bad");
    }
  }
#endif
)cpp";

}  // namespace handsight
