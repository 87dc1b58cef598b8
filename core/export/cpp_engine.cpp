// SPDX-License-Identifier: Apache-2.0
#include "export/cpp_engine.h"

namespace handsight {

const char* const cpp_engine = R"cpp(
  inline void rotate(const double r[3][3], const double x[3], double out[3]) {
    for (int i = 0; i < 3; ++i) out[i] = r[i][0] * x[0] + r[i][1] * x[1] + r[i][2] * x[2];
  }

  inline void rotate_back(const double r[3][3], const double x[3], double out[3]) {
    for (int i = 0; i < 3; ++i) out[i] = r[0][i] * x[0] + r[1][i] * x[1] + r[2][i] * x[2];
  }

  inline double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  inline void cross(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
  }

  inline void multiply(const double a[3][3], const double b[3][3], double out[3][3]) {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) out[i][k] = a[i][0] * b[0][k] + a[i][1] * b[1][k] + a[i][2] * b[2][k];
  }

  inline Motion chained(const Motion& c_from_b, const Motion& b_from_a) {
    Motion m;
    multiply(c_from_b.turn, b_from_a.turn, m.turn);
    rotate(c_from_b.turn, b_from_a.shift, m.shift);
    for (int i = 0; i < 3; ++i) m.shift[i] += c_from_b.shift[i];
    return m;
  }

  /// Rotation by sine and versine (1 - cosine) about a unit axis.
  inline void turn_about(const double a[3], double sine, double versine, double out[3][3]) {
    const double c = 1 - versine;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) out[i][k] = versine * a[i] * a[k] + (i == k ? c : 0.0);
    out[0][1] -= sine * a[2];
    out[0][2] += sine * a[1];
    out[1][0] += sine * a[2];
    out[1][2] -= sine * a[0];
    out[2][0] -= sine * a[1];
    out[2][1] += sine * a[0];
  }

  inline void turn_by_vector(const double v[3], double out[3][3]) {
    const double angle = std::sqrt(dot(v, v));
    if (angle == 0) {
      const double none[3] = {1, 0, 0};
      turn_about(none, 0, 0, out);
      return;
    }
    const double half = std::sin(angle / 2), axis[3] = {v[0] / angle, v[1] / angle, v[2] / angle};
    turn_about(axis, std::sin(angle), 2 * half * half, out);
  }

  /// Translation as it is, rotation the exponential of the last three.
  inline Motion small_motion(const double v[6]) {
    Motion m;
    turn_by_vector(v + 3, m.turn);
    for (int i = 0; i < 3; ++i) m.shift[i] = v[i];
    return m;
  }

  inline bool is_zero(const double* v, int count) {
    for (int i = 0; i < count; ++i)
      if (v[i] != 0) return false;
    return true;
  }

  struct Change {
    JointChange joint[count];
    WholeChange whole;
  };

  struct Deflection {
    double angle[count] = {}, lateral[count][3] = {}, base[3] = {0, 0, 0};
  };

  struct Posture {
    Motion frame[count];  // of what the joint carries
    double turned[count][3][3], origin[count][3], value[count] = {}, torque[count] = {}, moment[count][3] = {};
    Deflection deflection;
    bool converged = true;
  };

  /// Readings of all joints from those of a position; followers at the sum of what they follow.
  inline void all_readings(const double* position, double* reading, bool with_offsets) {
    for (int i = 0; i < count; ++i) {
      const int j = value_order[i];
      reading[j] = joints[j].input >= 0 ? position[joints[j].input] : 0.0;
      if (joints[j].mimics > 0) reading[j] = 0;
      for (int m = joints[j].first_mimic; m < joints[j].first_mimic + joints[j].mimics; ++m)
        reading[j] += mimics[m].multiplier * reading[mimics[m].joint] + (with_offsets ? mimics[m].offset : 0.0);
    }
  }

  inline void set_values(const double* reading, const Change& change, Posture& p) {
    double corrected[count];
    for (int i = 0; i < count; ++i) {
      const int j = value_order[i];
      const JointChange& c = change.joint[j];
      corrected[j] = c.angle + (joints[j].mimics > 0 ? 0.0 : reading[j]);
      for (int m = joints[j].first_mimic; m < joints[j].first_mimic + joints[j].mimics; ++m)
        corrected[j] += (mimics[m].multiplier + c.multiplier_error) *
                            (corrected[mimics[m].joint] + c.share * p.deflection.angle[mimics[m].joint]) +
                        mimics[m].offset;
      p.value[j] = corrected[j] + p.deflection.angle[j];
    }
  }

  /// Where joints rest and what follows their motion, with the small motions of the effects; the same in every pass.
  struct Rest {
    Motion before[count], after[count];
  };

  inline void set_rest(const Change& change, Rest& rest) {
    for (int j = 0; j < count; ++j) {
      const JointChange& c = change.joint[j];
      rest.before[j] = is_zero(c.before, 6) ? joints[j].parent_from_joint
                                            : chained(joints[j].parent_from_joint, small_motion(c.before));
      rest.after[j] =
          is_zero(c.after, 6) ? joints[j].joint_from_child : chained(small_motion(c.after), joints[j].joint_from_child);
    }
  }

  inline void set_frames(const Rest& rest, Posture& p) {
    Motion root_from_base;
    turn_by_vector(p.deflection.base, root_from_base.turn);
    for (int j = 0; j < count; ++j) {
      const Joint& joint = joints[j];
      const Motion& parent = joint.parent < 0 ? root_from_base : p.frame[joint.parent];
      Motion frame = chained(parent, rest.before[j]);
      for (int i = 0; i < 3; ++i) p.origin[j][i] = frame.shift[i];
      if (joint.kind == 't') {
        const double half = std::sin(p.value[j] / 2);
        double by_angle[3][3], turned[3][3];
        turn_about(joint.axis, std::sin(p.value[j]), 2 * half * half, by_angle);
        multiply(frame.turn, by_angle, turned);
        std::copy(&turned[0][0], &turned[0][0] + 9, &frame.turn[0][0]);
      } else if (joint.kind == 's') {
        double way[3];
        rotate(frame.turn, joint.axis, way);
        for (int i = 0; i < 3; ++i) frame.shift[i] += way[i] * p.value[j];
      }
      std::copy(&frame.turn[0][0], &frame.turn[0][0] + 9, &p.turned[j][0][0]);
      if (!is_zero(p.deflection.lateral[j], 3)) {
        double by_load[3][3], turned[3][3];
        turn_by_vector(p.deflection.lateral[j], by_load);
        multiply(frame.turn, by_load, turned);
        std::copy(&turned[0][0], &turned[0][0] + 9, &frame.turn[0][0]);
      }
      p.frame[j] = chained(frame, rest.after[j]);
    }
  }

  /// Moments of gravity at every joint, and of the whole robot about the root's origin.
  inline void set_loads(const double gravity_here[3], const WholeChange& whole, Posture& p, double root_turning[3]) {
    double mass[count], moment[count][3], of_root[3];
    for (int i = 0; i < 3; ++i) of_root[i] = root_moment[i];
    for (int j = 0; j < count; ++j) {
      double in_child[3];
      mass[j] = joints[j].mass;
      for (int i = 0; i < 3; ++i) in_child[i] = joints[j].moment[i];
      if (j == tcp_joint) {
        double in_tcp[3], turned[3];
        for (int i = 0; i < 3; ++i) in_tcp[i] = center_in_tcp[i] * whole.payload_mass + whole.payload_moment[i];
        rotate(child_from_tcp.turn, in_tcp, turned);
        for (int i = 0; i < 3; ++i) in_child[i] += turned[i] + child_from_tcp.shift[i] * whole.payload_mass;
        mass[j] += whole.payload_mass;
      }
      rotate(p.frame[j].turn, in_child, moment[j]);
      for (int i = 0; i < 3; ++i) moment[j][i] += p.frame[j].shift[i] * mass[j];
    }
    for (int j = count - 1; j >= 0; --j) {
      double arm[3], axis[3];
      for (int i = 0; i < 3; ++i) {
        arm[i] = moment[j][i] - p.origin[j][i] * mass[j];
        (joints[j].parent < 0 ? of_root[i] : moment[joints[j].parent][i]) += moment[j][i];
      }
      if (joints[j].parent >= 0) mass[joints[j].parent] += mass[j];
      cross(arm, gravity_here, p.moment[j]);
      rotate(p.turned[j], joints[j].axis, axis);  // a turn about the axis leaves it where it is
      p.torque[j] = joints[j].kind == 's' ? dot(axis, gravity_here) * mass[j] : dot(axis, p.moment[j]);
    }
    cross(of_root, gravity_here, root_turning);
  }

  inline void set_deflection(const Change& change, const Posture& p, const double root_turning[3], Deflection& next) {
    double carried[count];
    for (int j = 0; j < count; ++j) carried[j] = p.torque[j];
    for (int j = 0; j < count; ++j)
      for (int m = joints[j].first_mimic; m < joints[j].first_mimic + joints[j].mimics; ++m)
        carried[mimics[m].joint] +=
            change.joint[j].share * (mimics[m].multiplier + change.joint[j].multiplier_error) * p.torque[j];
    for (int j = 0; j < count; ++j) {
      const JointChange& c = change.joint[j];
      for (int i = 0; i < 3; ++i) next.lateral[j][i] = 0;
      next.angle[j] = 0;
      if (joints[j].kind == 'f') continue;
      next.angle[j] = (c.compliance + (joints[j].stiffness > 0 ? 1 / joints[j].stiffness : 0.0)) * carried[j];
      if (c.gap != 0) next.angle[j] += c.gap * std::tanh(carried[j] / 0.3);
      if (c.bend == 0) continue;
      double moment[3];
      rotate_back(p.turned[j], p.moment[j], moment);
      const double along = dot(joints[j].axis, moment);
      for (int i = 0; i < 3; ++i) next.lateral[j][i] = (moment[i] - joints[j].axis[i] * along) * c.bend;
    }
    const double* const b = change.whole.base;
    next.base[0] = b[0] * root_turning[0] + b[1] * root_turning[1];
    next.base[1] = b[1] * root_turning[0] + b[2] * root_turning[1];
    next.base[2] = 0;
  }

  inline double largest_difference(const Deflection& a, const Deflection& b) {
    double largest = 0;
    for (int j = 0; j < count; ++j) {
      largest = std::max(largest, std::abs(a.angle[j] - b.angle[j]));
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(a.lateral[j][i] - b.lateral[j][i]));
    }
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(a.base[i] - b.base[i]));
    return largest;
  }

  inline double& number(Deflection& d, int i) {
    if (i < count) return d.angle[i];
    return i < 4 * count ? d.lateral[(i - count) / 3][(i - count) % 3] : d.base[i - 4 * count];
  }

  /// Play may throw the passes to and fro: then the equilibrium is between where this one and the last one led.
  inline void lead_between(Deflection& now, Deflection& next, Deflection& last_next, Deflection& last_by) {
    double alike = 0, along = 0, differ = 0;
    for (int i = 0; i < 4 * count + 3; ++i) {
      const double by = number(next, i) - number(now, i), change = by - number(last_by, i);
      alike += by * number(last_by, i);
      along += by * change;
      differ += change * change;
    }
    const double share = alike < 0 ? along / differ : 0;
    for (int i = 0; i < 4 * count + 3; ++i) {
      const double led = number(next, i);
      number(last_by, i) = led - number(now, i);
      number(next, i) = led - share * (led - number(last_next, i));
      number(last_next, i) = led;
    }
  }

  /// Static equilibrium: springs give way to loads, which change with them, until nothing moves by 1e-11 any more.
  inline void solve(const double* reading, const Change& change, bool elastic, bool with_loads, Posture& p) {
    double tilt[3] = {change.whole.tilt[0], change.whole.tilt[1], 0}, turn[3][3], gravity_here[3], root_turning[3];
    turn_by_vector(tilt, turn);
    rotate(turn, gravity, gravity_here);
    Rest rest;
    set_rest(change, rest);
    Deflection next, last_next, last_by;
    for (int pass = 0; pass <= 500; ++pass) {
      set_values(reading, change, p);
      set_frames(rest, p);
      if (!elastic && !with_loads) return;
      set_loads(gravity_here, change.whole, p, root_turning);
      if (!elastic) return;
      set_deflection(change, p, root_turning, next);
      const double step = largest_difference(next, p.deflection);
      if (step < 1e-11) return;
      if (!(step < 10)) break;
      lead_between(p.deflection, next, last_next, last_by);
      p.deflection = next;
    }
    p.converged = false;
  }

  inline Motion hand_of(const Posture& p, const WholeChange& whole) {
    Motion hand;
    if (tcp_joint >= 0) hand = chained(p.frame[tcp_joint], child_from_tcp);
    return is_zero(whole.hand, 6) ? hand : chained(hand, small_motion(whole.hand));
  }

  /// In the frame of the link that carries the sensor.
  inline void place_of_tcp(const Posture& p, double tcp[3]) {
    const Motion hand = hand_of(p, WholeChange{});
    const Motion mount = mount_joint >= 0 ? chained(p.frame[mount_joint], child_from_mount) : child_from_mount;
    double way[3];
    for (int i = 0; i < 3; ++i) way[i] = hand.shift[i] - mount.shift[i];
    rotate_back(mount.turn, way, tcp);
  }

  inline bool predict(const double* position, const Drive& drive, Motion& hand, Motion& body) {
    double reading[count], before[count], velocity[count] = {}, approach[count] = {}, torque[count] = {};
    all_readings(position, reading, true);
    if (drive.velocity) all_readings(drive.velocity, velocity, false);
    if (drive.from) all_readings(drive.from, before, true);
    for (int j = 0; j < count; ++j)
      approach[j] = velocity[j] != 0 ? sign_of(velocity[j]) : drive.from ? sign_of(reading[j] - before[j]) : 0.0;
    double tcp[3] = {};
    if (reads_torque || reads_place) {
      Posture nominal;
      solve(reading, Change{}, nominal_is_elastic, reads_torque, nominal);
      std::copy(nominal.torque, nominal.torque + count, torque);
      if (reads_place) place_of_tcp(nominal, tcp);
    }
    Change change;
    add_effects(reading, torque, tcp, velocity, approach, drive.share, drive.seconds, drive.order, change.joint,
                change.whole);
    Posture posture;
    solve(reading, change, is_elastic, false, posture);
    hand = hand_of(posture, change.whole);
    body = chained(hand, tcp_from_body);
    if (!is_zero(change.whole.body, 6)) body = chained(body, small_motion(change.whole.body));
    return posture.converged;
  }
)cpp";

}  // namespace handsight
