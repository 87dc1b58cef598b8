// SPDX-License-Identifier: Apache-2.0
#include "export/python_engine.h"

namespace handsight {

const char* const python_correction = R"python(

def _vector_of(r):
    v = [(r[2][1] - r[1][2]) / 2, (r[0][2] - r[2][0]) / 2, (r[1][0] - r[0][1]) / 2]
    sine, cosine = math.sqrt(_dot(v, v)), (r[0][0] + r[1][1] + r[2][2] - 1) / 2
    return v if sine < 1e-12 else [x * math.atan2(sine, cosine) / sine for x in v]


_LENGTH_OF_RADIAN = 0.3  # m


def _difference(start, end):
    turn = [[_dot(end[i][:3], start[k][:3]) for k in range(3)] for i in range(3)]
    return [end[i][3] - start[i][3] for i in range(3)] + [_LENGTH_OF_RADIAN * x for x in _vector_of(turn)]


def _solved(a, b):
    for i in range(6):
        for k in range(i + 1, 6):
            factor = a[k][i] / a[i][i]
            a[k] = [x - factor * y for x, y in zip(a[k], a[i])]
            b[k] -= factor * b[i]
    for i in range(5, -1, -1):
        b[i] = (b[i] - sum(a[i][k] * b[k] for k in range(i + 1, 6))) / a[i][i]
    return b


def _limited_step(by_joint, position, left, damping):
    limits = {joint.input: (joint.lower, joint.upper) for joint in _JOINTS if joint.input >= 0}
    step, free = [0.0] * len(position), set(limits)
    while True:
        a = [[sum(by_joint[i][k] * by_joint[i][m] for i in free) for m in range(6)] for k in range(6)]
        trace = sum(a[k][k] for k in range(6))
        for k in range(6):
            a[k][k] += damping * trace + 1e-30
        b = _solved(a, list(left))
        for i in free:
            step[i] = sum(by_joint[i][k] * b[k] for k in range(6))
        stopped = [i for i in free if not limits[i][0] <= position[i] + step[i] <= limits[i][1]]
        if not stopped:
            return step
        for i in stopped:
            step[i] = (limits[i][0] if position[i] + step[i] < limits[i][0] else limits[i][1]) - position[i]
            left = [x - by_joint[i][k] * step[i] for k, x in enumerate(left)]
            free.discard(i)


def correct(position, target=None, **drive):
    """(what to command, whether it gets there): the joint angles with which the hand really arrives at `target` (4 x 4),
    as it is where the nominal model puts it for `position`, within the joints' limits."""
    if target is None:
        target = nominal_hand_pose(position)
    position, damping = list(position), 1e-10

    def way_left(there):
        hand = hand_pose(there, **drive)
        left = _difference(hand, target)
        return hand, left, math.sqrt(sum(x * x for x in left))

    def hand_by_joint(here, hand):
        moved = [here[:i] + [here[i] + 1e-6] + here[i + 1:] for i in range(len(here))]
        return [[x / 1e-6 for x in _difference(hand, hand_pose(m, **drive))] for m in moved]

    hand, left, way = way_left(position)
    by_joint = hand_by_joint(position, hand)
    for _ in range(200):
        step = _limited_step(by_joint, position, left, damping)
        size = max(abs(x) for x in step)
        if size < 1e-12 or damping >= 1e6:
            break
        moved = [q + x * min(1.0, 0.3 / size) for q, x in zip(position, step)]
        there, now, then = way_left(moved)
        if then > way:
            damping *= 100
            continue
        damping = max(1e-10, damping / 100)
        position, hand, left, way = moved, there, now, then
        by_joint = hand_by_joint(position, hand)
    reached = math.sqrt(_dot(left, left)) < 1e-6 and math.sqrt(_dot(left[3:], left[3:])) < 1e-6 * _LENGTH_OF_RADIAN
    return position, reached


if __name__ == "__main__":
    # Reads positions, a line each, and writes root_from_hand row by row; with "correct" what to command.
    for line in sys.stdin:
        numbers = [float(x) for x in line.split()]
        if not numbers:
            continue
        if sys.argv[1:] == ["correct"]:
            commanded, good = correct(numbers)
            print(*map(repr, commanded), "good" if good else "bad")
        else:
            print(*(repr(x) for row in hand_pose(numbers)[:3] for x in row), "good")
)python";

}  // namespace handsight
