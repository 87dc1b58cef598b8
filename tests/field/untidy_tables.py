#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tables as hands, spreadsheets and terminals leave them: other names of columns, words between numbers, dates, inches, lists in
cells, what `ros2 topic echo` and NumPy print, touches in a workshop's words. Each is made here without Handsight, its right value
with it: each must come to its right value, or to a sentence that names the cause.

untidy_tables.py HANDSIGHT_CLI [NAME ...]: a line for each, with what was said; exit code 1 where one is neither; 77 where the
writers are not installed."""
import functools
import json
import math
import os
import re
import sys

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only wait for each other
try:
    import cv2  # noqa: of field_scene
    import numpy as np
    import yaml
    from scipy.spatial.transform import Rotation
except ImportError as missing:
    print("not installed: %s" % missing)
    sys.exit(77)

sys.dont_write_bytecode = True  # nothing is written beside the sources
from field_runner import pose, run, run_cases
from field_scene import (ANGLES, CAMERA, FLANGES, JOINTS, MIDDLE, ORIGINS, SEEN, STAND, TAG, TARGETS, hand, motion, quaternion,
                         quaternions, rotation_vector, table, urdf, write)

NOISE = np.random.default_rng(3740)
QUATERNION = ["x", "y", "z", "qx", "qy", "qz", "qw"]


def shaken(pose, place=2e-4, turn=3e-4):
    """A sensor's pose with its noise (m, rad of a coordinate)."""
    return pose @ motion(NOISE.normal(0, turn, 3), NOISE.normal(0, place, 3))


TARGETS = [shaken(p) for p in TARGETS]
SEEN = [shaken(p) for p in SEEN]


def numbers(p):
    return [float(x) for x in (*p[:3, 3], *quaternion(p))]


def degrees(p, sequence):
    return [float(x) for x in Rotation.from_matrix(p[:3, :3]).as_euler(sequence, degrees=True)]


def with_commas(rows):
    """As a German spreadsheet saves them: BOM, semicolons, decimal commas, CRLF."""
    text = "".join(";".join(c if isinstance(c, str) else ("%.6f" % c).replace(".", ",") for c in r) + "\r\n" for r in rows)
    return b"\xef\xbb\xbf" + text.encode()


def save(name, data):
    with open(name, "wb") as file:
        file.write(data)
    return name


# What is to come of a case, beside a pose: a sentence of convert, or of another command.
def told(*words, by=None):
    def judge(made):
        done = run(by, "session") if by else made
        said = done.stdout + done.stderr
        return all(re.search(w, said) for w in words), said.strip().split("\n")[-1]
    return judge


MOUNT, HAND = pose("mount_from_", CAMERA, 4e-4), pose("tcp_from_body", TAG, 4e-4)


def beside_target(flange):
    return [flange, quaternions("target.csv", TARGETS)], MOUNT


def german():
    rows = [["Nr.", "X [mm]", "Y [mm]", "Z [mm]", "A [°]", "B [°]", "C [°]"]]
    rows += [[str(i + 1), *(1000 * p[:3, 3]), *degrees(p, "ZYX")] for i, p in enumerate(FLANGES)]
    return beside_target(save("Roboter Posen.csv", with_commas(rows)))


def unicode_text():
    """Excel's "Unicode text": UTF-16 with tabs."""
    lines = ["X\tY\tZ\tRx\tRy\tRz"] + ["\t".join("%.6f" % v for v in (*(1000 * p[:3, 3]), *degrees(p, "xyz"))) for p in FLANGES]
    return beside_target(save("flange.txt", ("\r\n".join(lines) + "\r\n").encode("utf-16")))


def words_for_nothing():
    """What stands in cells in which nothing was measured."""
    rows = [numbers(p) for p in TARGETS]
    for i, word in enumerate(["nan", "NaN", "None", "", "null", "#N/A", "-", "inf"]):
        rows[2 * i + 1] = [word] * 7
    return [quaternions("flange.csv", FLANGES), table("target.csv", QUATERNION, rows)], MOUNT


def zeros_for_nothing():
    rows = [numbers(p) for p in TARGETS]
    rows[3], rows[7], rows[11] = [0.0] * 7, [0.0] * 6 + [1.0], [0.0] * 6 + [1.0]
    return [quaternions("flange.csv", FLANGES), table("target.csv", QUATERNION, rows)], MOUNT


def dates():
    flange = [["2024-07-23T16:%02d:%02d.120Z" % (i // 6, 10 * (i % 6)), *numbers(p)] for i, p in enumerate(FLANGES)]
    target = [["23.07.2024 16:%02d:%02d.150" % (i // 6, 10 * (i % 6)), *numbers(p)] for i, p in enumerate(TARGETS)]
    return [table("flange.csv", ["time", *QUATERNION], flange), table("target.csv", ["time", *QUATERNION], target[1:])], MOUNT


def matlab_remarks():
    text = "% x y z qx qy qz qw\n" + "".join(" ".join("%.9f" % v for v in numbers(p)) + "  # pose\n" for p in FLANGES)
    return beside_target(write("flange.txt", text))


def numpy_prints():
    return [write("flange.txt", "\n".join(repr(p) for p in FLANGES)), write("target.txt", "\n".join(str(p) for p in TARGETS))], MOUNT


def python_prints():
    return [write("flange.txt", "".join("%s\n" % numbers(p) for p in FLANGES)),
            write("target.txt", "".join("pose: %s\n" % numbers(p) for p in TARGETS))], MOUNT


def lists_in_cells():
    """As pandas saves a column of lists."""
    return beside_target(write("flange.csv", "number,pose\n" + "".join('%d,"%s"\n' % (i, numbers(p)) for i, p in enumerate(FLANGES))))


def json_a_line():
    lines = [json.dumps({"t": i, "position": numbers(p)[:3], "orientation": numbers(p)[3:]}) for i, p in enumerate(FLANGES)]
    target = [{"tvec": numbers(p)[:3], "rvec": [float(x) for x in rotation_vector(p)]} for p in TARGETS]
    return [write("flange.jsonl", "\n".join(lines) + "\n"), write("target.json", json.dumps(target))], MOUNT


def echo_of_pose(name, poses):
    def text(i, p):
        place = dict(zip("xyz", numbers(p)[:3]))
        return yaml.dump({"header": {"stamp": {"sec": 100 + i, "nanosec": 0}, "frame_id": "base"},
                          "pose": {"position": place, "orientation": dict(zip("xyzw", numbers(p)[3:]))}}, sort_keys=False)
    return write(name, "---\n".join(text(i, p) for i, p in enumerate(poses)) + "---\n")


def topic_echo_of_poses():
    return beside_target(echo_of_pose("flange.yaml", FLANGES))


def tf2_echo():
    def text(i, p):
        return ("At time %d.5\n- Translation: [%.6f, %.6f, %.6f]\n- Rotation: in Quaternion (xyzw) [%.6f, %.6f, %.6f, %.6f]\n"
                "- Rotation: in RPY (degree) [%.3f, %.3f, %.3f]\n" % (100 + i, *numbers(p), *degrees(p, "xyz")))
    return beside_target(write("flange.txt", "".join(text(i, p) for i, p in enumerate(FLANGES))))


# A robot before a sensor.
def before_sensor(joints):
    return ["robot.urdf", joints, quaternions("target.csv", SEEN), "--tcp", "link_6"], HAND


def joints_named(header, rows=None):
    write("robot.urdf", urdf(JOINTS))
    return before_sensor(table("joints.csv", header, rows or [[float(x) for x in q] for q in ANGLES]))


def j1_to_j6():
    return joints_named(["J%d" % i for i in range(1, 7)])


def position_0_to_5():
    return joints_named(["position[%d]" % i for i in range(6)])


def capitals():
    return joints_named([n.upper() for n in JOINTS])


def plotjuggler():
    return joints_named(["__time"] + ["/joint_states/%s/position" % n for n in JOINTS],
                        [[100.0 + i, *map(float, q)] for i, q in enumerate(ANGLES)])


def states_between():
    return joints_named(["n", *JOINTS, "state"], [[i, *map(float, q), "ok"] for i, q in enumerate(ANGLES)])


def other_names():
    return ([*joints_named(["pan", "lift", "elbow", "w1", "w2", "w3"])[0]], told("pan lift elbow w1 w2 w3", "joint_1 joint_2"))


def all_in_one_table():
    write("robot.urdf", urdf(JOINTS))
    rows = [[*map(float, q), *numbers(p)] for q, p in zip(ANGLES, SEEN)]
    return ["robot.urdf", table("all.csv", JOINTS + QUATERNION, rows), "--tcp", "link_6"], HAND


def controllers_own_pose():
    """The hand where the controller believes it to be is no measurement."""
    write("robot.urdf", urdf(JOINTS))
    rows = [[*map(float, q), *numbers(hand(q))] for q in ANGLES]
    return (["robot.urdf", table("all.csv", JOINTS + ["tcp_" + n for n in QUATERNION], rows), "--tcp", "link_6"],
            told("nothing that a sensor measured"))


def all_in_json():
    write("robot.urdf", urdf(JOINTS))
    samples = [{"joints": dict(zip(JOINTS, map(float, q))), "pose": {"position": dict(zip("xyz", numbers(p)[:3])),
                                                                    "orientation": dict(zip("xyzw", numbers(p)[3:]))}}
               for q, p in zip(ANGLES, SEEN)]
    return ["robot.urdf", write("samples.json", json.dumps({"samples": samples})), "--tcp", "link_6"], HAND


def topic_echo_of_joints():
    write("robot.urdf", urdf(JOINTS))
    def text(i, q):
        return yaml.dump({"header": {"stamp": {"sec": 100 + i, "nanosec": 0}, "frame_id": ""}, "name": JOINTS,
                          "position": [float(x) for x in q], "velocity": [], "effort": []}, sort_keys=False)
    joints = write("joints.yaml", "---\n".join(text(i, q) for i, q in enumerate(ANGLES)) + "---\n")
    return ["robot.urdf", joints, echo_of_pose("tag.yaml", SEEN), "--tcp", "link_6"], HAND


BALL = np.array([0.02, 0.05, 0.1])


def tracked(scale=1.0):
    points = [(np.linalg.inv(STAND) @ hand(q) @ np.append(BALL, 1))[:3] + NOISE.normal(0, 2e-5, 3) for q in ANGLES]
    return [[float(scale * x) for x in p] for p in points]


PLACE = pose("tcp_from_body", motion((0, 0, 0), BALL), 2e-4, None)


def tracker_with_names_of_points():
    """As a laser tracker's program lists them: a name, and millimetres without a header."""
    write("robot.urdf", urdf(JOINTS))
    text = "".join("P%d\t%.4f\t%.4f\t%.4f\r\n" % (i + 1, *p) for i, p in enumerate(tracked(1000)))
    return ["robot.urdf", table("joints.csv", JOINTS, [[*map(float, q)] for q in ANGLES]), write("FARO.txt", text), "--tcp", "link_6"], PLACE


def tracker_in_inches():
    write("robot.urdf", urdf(JOINTS))
    points = table("tracker.csv", ["x [in]", "y [in]", "z [in]"], tracked(1 / 0.0254))
    return ["robot.urdf", table("joints.csv", JOINTS, [[*map(float, q)] for q in ANGLES]), points, "--tcp", "link_6"], PLACE


# Touches.
TIP = np.array([0.01, -0.02, 0.15])
TOUCHED = pose("tcp_from_body", motion((0, 0, 0), TIP), 4e-4, None)
PLANES = {"plate": (np.array([0, 0, 1.0]), 0.25), "wall": (np.array([1.0, 0, 0]), 0.55), "side": (np.array([0, 1.0, 0]), 0.2)}
SOCKETS = {"socket 1": np.array([0.45, 0.1, 0.3]), "socket 2": np.array([0.45, -0.1, 0.3])}
BAR = np.array([0.3, 0.05, 0.1])


ORIGIN = [motion(turn, place) for turn, place in ORIGINS]


def reached(base, q, point):
    """Where a point of the hand is; as field_scene.hand, a hundred times as fast."""
    m = base
    for origin, angle in zip(ORIGIN, q):
        c, s = math.cos(angle), math.sin(angle)
        m = m @ origin @ np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    return (m @ np.append(point, 1))[:3]


def tip(q):
    return reached(np.eye(4), q, TIP)


def solved(misses, q):
    """Joint angles near q at which `misses` is 0, by Newton's method; None where it does not come there."""
    for _ in range(15):
        off = misses(q)
        if np.abs(off).max() < 1e-10:
            return q if np.abs(q).max() < 3 else None
        slope = np.array([(misses(q + 1e-6 * e) - off) / 1e-6 for e in np.eye(len(q))]).T
        step = np.linalg.pinv(slope) @ off
        q = q - step * min(1, 0.5 / np.abs(step).max())
    return None


def touching(misses, count):
    """Joint angles at which `misses` of the tip is 0, read to 20 urad."""
    found = []
    while len(found) < count:
        q = solved(lambda at: misses(tip(at)), MIDDLE + NOISE.uniform(-0.8, 0.8, 6))
        if q is not None:
            found.append(q + NOISE.normal(0, 2e-5, 6))
    return found


@functools.lru_cache(None)
def planes(count=25):
    return [(name, q) for name, (normal, far) in PLANES.items() for q in touching(lambda p: np.array([normal @ p - far]), count)]


def touches(name, header, rows, *options):
    write("robot.urdf", urdf(JOINTS))
    return ["robot.urdf", table(name, header, rows), "--tcp", "link_6", *options]


def touched_surfaces_in_degrees():
    rows = [[n, *map(float, np.degrees(q))] for n, q in planes()]
    return touches("contacts.csv", ["Surface", *["A%d [deg]" % i for i in range(1, 7)]], rows, "--fixture", "plane side"), TOUCHED


def touched_in_german():
    write("robot.urdf", urdf(JOINTS))
    rows = [["Ebene", *["%s [°]" % j for j in JOINTS]]] + [[n, *np.degrees(q)] for n, q in planes()]
    return ["robot.urdf", save("Antastung.csv", with_commas(rows)), "--tcp", "link_6", "--fixture", "plane side"], TOUCHED


def sockets(*options, names=tuple(SOCKETS)):
    rows = [[called, *map(float, q)] for called, at in zip(names, SOCKETS.values()) for q in touching(lambda p: p - at, 20)]
    return touches("touch.csv", ["fixture", *JOINTS], rows, *options)


def names_with_blanks():
    return sockets("--apart", "socket_1 socket_2 by=0.2 sigma=1e-5"), TOUCHED


def apart_in_millimetres():
    return sockets("--apart", "socket_1 socket_2 by=200 sigma=0.01"), told("by=0.2")


def apart_typed_wrongly():
    return sockets("--apart", "socket_1 socket_2 by=0.21 sigma=1e-5"), told("210.000 mm", r"200\.0\d\d mm", by="check")


def one_fixture_in_capitals():
    return sockets(names=("socket_a", "Socket_A")), told("socket_a", "Socket_A", "one way")


def missing_angles():
    rows = [[n, *map(float, q)] for n, q in planes()]
    rows[3][2], rows[40][5] = "nan", ""
    return touches("touch.csv", ["fixture", *JOINTS], rows, "--fixture", "plane side"), TOUCHED


def dial_in_hundredths():
    rows = []
    for _ in range(60):
        off = NOISE.uniform(-0.005, 0.005)
        q = touching(lambda p, at=off: np.array([p[2] - 0.3 - at]), 1)[0]
        rows.append(["dial", *map(float, q), float(1e5 * off)])
    return touches("dial.csv", ["feature", *JOINTS, "dial [1/100 mm]"], rows, "--fixture",
                   "gauge dial xyz=0.45,0,0.3 axis=0,0,1"), pose("tcp_from_body", motion((0, 0, 0), TIP), 1e-3, None)


def ball_bar(header, reading):
    rows = []
    for _ in range(60):
        off = NOISE.uniform(-3e-3, 3e-3)
        q = touching(lambda p, at=off: np.array([np.linalg.norm(p - BAR) - 0.3 - at]), 1)[0]
        rows.append(["bar", *map(float, q), float(reading(0.3 + off))])
    return rows, ["fixture", *JOINTS, header]


def bar_by_deviations():
    """A ball bar tells what is off from its length."""
    rows, header = ball_bar("deviation [um]", lambda m: 1e6 * (m - 0.3))
    return touches("bar.csv", header, rows, "--fixture", "length bar to=0.3,0.05,0.1 value=0.3"), pose(
        "tcp_from_body", motion((0, 0, 0), TIP), 1e-3, None)


def bar_by_deviations_from_nothing():
    rows, header = ball_bar("deviation [um]", lambda m: 1e6 * (m - 0.3))
    return touches("bar.csv", header, rows, "--fixture", "length bar to=0.3,0.05,0.1"), told("from which length")


def bar_in_inches():
    rows, header = ball_bar("reading [in]", lambda m: m / 0.0254)
    return touches("bar.csv", header, rows, "--fixture", "length bar to=0.3,0.05,0.1"), pose(
        "tcp_from_body", motion((0, 0, 0), TIP), 1e-3, None)


def touches_without_joints():
    rows = [[n, *[float(x) for x in 1000 * hand(q)[:3, 3]], *degrees(hand(q), "ZYX")] for n, q in planes(5)]
    return touches("touch.csv", ["fixture", "X", "Y", "Z", "A", "B", "C"], rows), told("column for each joint")


def hand_to_hand():
    """Two arms: the ball in one hand, a cup for it in the other."""
    text = urdf(JOINTS)
    other = re.sub(r"(link_|joint_)(\d)", r"left_\1\2", text)
    links = [x for x in re.findall(r"<link.*?</link>", other, re.S) if "base_link" not in x]
    joints = re.findall(r"<joint.*?</joint>", other, re.S)
    joints[0] = joints[0].replace('xyz="0 0 0.3"', 'xyz="0 0.5 0.3"')
    write("robot.urdf", text.replace("</robot>", "\n".join(links + joints) + "</robot>"))
    cup, base = np.array([0.0, 0.03, 0.12]), motion((0, 0, 0), (0, 0.5, 0))
    rows = []
    while len(rows) < 60:
        begin = np.concatenate([MIDDLE, MIDDLE]) + NOISE.uniform(-0.7, 0.7, 12)
        q = solved(lambda at: tip(at[:6]) - reached(base, at[6:], cup), begin)
        if q is not None:
            rows.append(["cup", *map(float, q + NOISE.normal(0, 2e-5, 12))])
    return ["robot.urdf", table("self_touch.csv", ["fixture", *JOINTS, *["left_" + j for j in JOINTS]], rows), "--tcp", "link_6",
            "--fixture", "point cup mount=left_link_6"], TOUCHED


CASES = [german, unicode_text, words_for_nothing, zeros_for_nothing, dates, matlab_remarks, numpy_prints, python_prints, lists_in_cells,
         json_a_line, topic_echo_of_poses, tf2_echo, j1_to_j6, position_0_to_5, capitals, plotjuggler, states_between, other_names,
         all_in_one_table, controllers_own_pose, all_in_json, topic_echo_of_joints, tracker_with_names_of_points, tracker_in_inches,
         touched_surfaces_in_degrees, touched_in_german, names_with_blanks, apart_in_millimetres,
         apart_typed_wrongly, one_fixture_in_capitals, missing_angles,
         dial_in_hundredths, bar_by_deviations, bar_by_deviations_from_nothing, bar_in_inches, touches_without_joints, hand_to_hand]


sys.exit(run_cases(CASES))
