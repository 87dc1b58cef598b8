// SPDX-License-Identifier: Apache-2.0
#include "export/python_engine.h"

namespace handsight {

const char* const python_types = R"python(
import collections
import math
import sys

_Joint = collections.namedtuple(
    "_Joint", "parent kind input parent_from_joint axis joint_from_child stiffness mass moment lower upper mimics")


class _JointChange:
    def __init__(self):
        self.angle = self.multiplier_error = self.share = self.compliance = self.bend = self.gap = 0.0
        self.before = [0.0] * 6
        self.after = [0.0] * 6


class _WholeChange:
    def __init__(self):
        self.hand = [0.0] * 6
        self.body = [0.0] * 6
        self.tilt = [0.0] * 2
        self.base = [0.0] * 3
        self.payload_mass = 0.0
        self.payload_moment = [0.0] * 3


def sign_of(x):
    return 1.0 if x > 0 else -1.0 if x < 0 else 0.0

)python";

const char* const python_engine = R"python(

# A motion b_from_a is (rotation, translation): x_in_b = rotation x_in_a + translation.
_NONE = ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0, 0.0, 0.0])


def _rotated(r, x):
    return [row[0] * x[0] + row[1] * x[1] + row[2] * x[2] for row in r]


def _rotated_back(r, x):
    return [r[0][i] * x[0] + r[1][i] * x[1] + r[2][i] * x[2] for i in range(3)]


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _multiplied(a, b):
    return [[row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k] for k in range(3)] for row in a]


def _chained(c_from_b, b_from_a):
    shift = _rotated(c_from_b[0], b_from_a[1])
    return (_multiplied(c_from_b[0], b_from_a[0]), [shift[i] + c_from_b[1][i] for i in range(3)])


def _turn_about(a, angle):
    sine, versine = math.sin(angle), 2 * math.sin(angle / 2) ** 2
    r = [[versine * a[i] * a[k] + (1 - versine if i == k else 0.0) for k in range(3)] for i in range(3)]
    for i, k, sign, axis in ((0, 1, -1, 2), (0, 2, 1, 1), (1, 0, 1, 2), (1, 2, -1, 0), (2, 0, -1, 1), (2, 1, 1, 0)):
        r[i][k] += sign * sine * a[axis]
    return r


def _turn_by_vector(v):
    angle = math.sqrt(_dot(v, v))
    if angle == 0:
        return _NONE[0]
    return _turn_about([x / angle for x in v], angle)


def _small_motion(v):
    return (_turn_by_vector(v[3:]), list(v[:3]))


class _Deflection:
    def __init__(self):
        self.angle = [0.0] * len(_JOINTS)
        self.lateral = [[0.0] * 3 for _ in _JOINTS]
        self.base = [0.0] * 3

    def numbers(self):
        return self.angle + [x for v in self.lateral for x in v] + self.base

    def set_numbers(self, numbers):
        joints = len(_JOINTS)
        self.angle, self.base = numbers[:joints], numbers[4 * joints:]
        self.lateral = [numbers[i:i + 3] for i in range(joints, 4 * joints, 3)]


def _lead_between(by, led, last_by, last_led):
    """Play may throw the passes to and fro: then the equilibrium is between where this one and the last one led."""
    if not sum(a * b for a, b in zip(by, last_by)) < 0:
        return led
    change = [a - b for a, b in zip(by, last_by)]
    share = sum(a * c for a, c in zip(by, change)) / sum(c * c for c in change)
    return [a - share * (a - b) for a, b in zip(led, last_led)]


class _Posture:
    """Where everything is at static equilibrium."""

    def __init__(self, reading, joint_changes, whole, elastic, with_loads):
        self.changes, self.whole, self.reading = joint_changes, whole, reading
        self.deflection = _Deflection()
        self.converged = True
        self.rest = [_chained(j.parent_from_joint, _small_motion(c.before)) for j, c in zip(_JOINTS, joint_changes)]
        self.after = [_chained(_small_motion(c.after), j.joint_from_child) for j, c in zip(_JOINTS, joint_changes)]
        gravity = _rotated(_turn_by_vector(whole.tilt + [0.0]), _GRAVITY)
        last_by, last_led = [], []
        for _ in range(501):
            self._set_values()
            self._set_frames()
            if not elastic and not with_loads:
                return
            root_turning = self._set_loads(gravity)
            if not elastic:
                return
            following = self._deflection(root_turning)
            led = following.numbers()
            by = [a - b for a, b in zip(led, self.deflection.numbers())]
            step = max(abs(x) for x in by)
            if step < 1e-11:
                return
            if not step < 10:
                break
            following.set_numbers(_lead_between(by, led, last_by, last_led))
            self.deflection, last_by, last_led = following, by, led
        self.converged = False

    def _set_values(self):
        corrected = [0.0] * len(_JOINTS)
        self.value = [0.0] * len(_JOINTS)
        for j in _VALUE_ORDER:
            joint, change = _JOINTS[j], self.changes[j]
            corrected[j] = change.angle + (0.0 if joint.mimics else self.reading[j])
            for followed, multiplier, offset in joint.mimics:
                corrected[j] += (multiplier + change.multiplier_error) * (
                    corrected[followed] + change.share * self.deflection.angle[followed]) + offset
            self.value[j] = corrected[j] + self.deflection.angle[j]

    def _set_frames(self):
        self.frame, self.origin, self.turned = [], [], []
        root_from_base = (_turn_by_vector(self.deflection.base), [0.0] * 3)
        for j, joint in enumerate(_JOINTS):
            parent = root_from_base if joint.parent < 0 else self.frame[joint.parent]
            turn, shift = _chained(parent, self.rest[j])
            self.origin.append(shift)
            if joint.kind == "t":
                turn = _multiplied(turn, _turn_about(joint.axis, self.value[j]))
            elif joint.kind == "s":
                way = _rotated(turn, joint.axis)
                shift = [shift[i] + way[i] * self.value[j] for i in range(3)]
            self.turned.append(turn)
            turn = _multiplied(turn, _turn_by_vector(self.deflection.lateral[j]))
            self.frame.append(_chained((turn, shift), self.after[j]))

    def _set_loads(self, gravity):
        count = len(_JOINTS)
        mass, moment = [0.0] * count, [None] * count
        of_root = list(_ROOT_MOMENT)
        for j, joint in enumerate(_JOINTS):
            mass[j], in_child = joint.mass, list(joint.moment)
            if j == _TCP_JOINT:
                w = self.whole
                in_tcp = [_CENTER_IN_TCP[i] * w.payload_mass + w.payload_moment[i] for i in range(3)]
                turned = _rotated(_CHILD_FROM_TCP[0], in_tcp)
                in_child = [in_child[i] + turned[i] + _CHILD_FROM_TCP[1][i] * w.payload_mass for i in range(3)]
                mass[j] += w.payload_mass
            turned = _rotated(self.frame[j][0], in_child)
            moment[j] = [turned[i] + self.frame[j][1][i] * mass[j] for i in range(3)]
        self.torque, self.moment = [0.0] * count, [None] * count
        for j in range(count - 1, -1, -1):
            joint = _JOINTS[j]
            arm = [moment[j][i] - self.origin[j][i] * mass[j] for i in range(3)]
            above = of_root if joint.parent < 0 else moment[joint.parent]
            for i in range(3):
                above[i] += moment[j][i]
            if joint.parent >= 0:
                mass[joint.parent] += mass[j]
            self.moment[j] = _cross(arm, gravity)
            axis = _rotated(self.turned[j], joint.axis)
            self.torque[j] = _dot(axis, gravity) * mass[j] if joint.kind == "s" else _dot(axis, self.moment[j])
        return _cross(of_root, gravity)

    def _deflection(self, root_turning):
        carried = list(self.torque)
        for j, joint in enumerate(_JOINTS):
            for followed, multiplier, _ in joint.mimics:
                carried[followed] += (
                    self.changes[j].share * (multiplier + self.changes[j].multiplier_error) * self.torque[j])
        following = _Deflection()
        for j, joint in enumerate(_JOINTS):
            if joint.kind == "f":
                continue
            change = self.changes[j]
            compliance = change.compliance + (1 / joint.stiffness if joint.stiffness > 0 else 0.0)
            following.angle[j] = compliance * carried[j] + change.gap * math.tanh(carried[j] / 0.3)
            if change.bend == 0:
                continue
            moment = _rotated_back(self.turned[j], self.moment[j])
            along = _dot(joint.axis, moment)
            following.lateral[j] = [(moment[i] - joint.axis[i] * along) * change.bend for i in range(3)]
        base = self.whole.base
        following.base[0] = base[0] * root_turning[0] + base[1] * root_turning[1]
        following.base[1] = base[1] * root_turning[0] + base[2] * root_turning[1]
        return following

    def hand(self):
        hand = _NONE if _TCP_JOINT < 0 else _chained(self.frame[_TCP_JOINT], _CHILD_FROM_TCP)
        return _chained(hand, _small_motion(self.whole.hand))


def _readings(position, with_offsets=True):
    if len(position) != len(JOINT_NAMES):
        raise ValueError("%d numbers, expected one for each of: %s" % (len(position), " ".join(JOINT_NAMES)))
    reading = [0.0] * len(_JOINTS)
    for j in _VALUE_ORDER:
        joint = _JOINTS[j]
        if joint.input >= 0:
            reading[j] = position[joint.input]
        if joint.mimics:
            reading[j] = sum(m * reading[f] + (o if with_offsets else 0.0) for f, m, o in joint.mimics)
    return reading


def _unchanged():
    return [_JointChange() for _ in _JOINTS], _WholeChange()


def _place_of_tcp(posture):
    """In the frame of the link that carries the sensor."""
    hand = posture.hand()
    mount = _CHILD_FROM_MOUNT if _MOUNT_JOINT < 0 else _chained(posture.frame[_MOUNT_JOINT], _CHILD_FROM_MOUNT)
    return _rotated_back(mount[0], [hand[1][i] - mount[1][i] for i in range(3)])


def _predicted(position, drive):
    reading = _readings(position)
    count = len(_JOINTS)
    velocity, approach, torque = [0.0] * count, [0.0] * count, [0.0] * count
    if drive.get("velocity") is not None:
        velocity = _readings(drive["velocity"], False)
    before = _readings(drive["before"]) if drive.get("before") is not None else reading
    approach = [sign_of(v) if v != 0 else sign_of(q - b) for v, q, b in zip(velocity, reading, before)]
    tcp = None
    if _READS_TORQUE or _READS_PLACE:
        nominal = _Posture(reading, *_unchanged(), _NOMINAL_IS_ELASTIC, _READS_TORQUE)
        torque = nominal.torque if _READS_TORQUE else torque
        tcp = _place_of_tcp(nominal) if _READS_PLACE else None
    joint, whole = _unchanged()
    _add_effects(reading, torque, tcp, velocity, approach, drive.get("share", 1.0), drive.get("seconds", 1.0),
                 drive.get("order", 1073741824), joint, whole)
    posture = _Posture(reading, joint, whole, _IS_ELASTIC, False)
    if not posture.converged:
        raise ArithmeticError("the springs are too soft for the load")
    return posture.hand(), whole


def _matrix(motion):
    return [motion[0][i] + [motion[1][i]] for i in range(3)] + [[0.0, 0.0, 0.0, 1.0]]


def hand_pose(position, **drive):
    """root_from_hand (4 x 4) where the hand really is, for joint readings in the order of JOINT_NAMES (rad, m).

    How the robot comes there, where effects depend on it: velocity (a list), before (the position before, a list),
    share (0 to 1 over the session that the calibration comes from), seconds and order (observations) in it. As it is:
    at rest, from nowhere, after the session."""
    return _matrix(_predicted(position, drive)[0])


def body_pose(position, **drive):
    """root_from_body (4 x 4) of the marker body."""
    hand, whole = _predicted(position, drive)
    return _matrix(_chained(_chained(hand, _TCP_FROM_BODY), _small_motion(whole.body)))


def nominal_hand_pose(position):
    """Where the nominal model puts the hand (4 x 4)."""
    return _matrix(_Posture(_readings(position), *_unchanged(), _NOMINAL_IS_ELASTIC, False).hand())
)python";

}  // namespace handsight
