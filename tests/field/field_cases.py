#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Recordings as they come from the field, right ones in makers' own words and ones with a mistake in them. Each is made here
by other programs than Handsight (OpenCV, NumPy, SciPy, text), its right value with it: each must come to its right value, or
to a sentence that names the cause.

field_cases.py HANDSIGHT_CLI [NAME ...]: a line for each, with what was said (-v: all of it); exit code 1 where one is neither;
77 where the writers are not installed."""
import io
import json
import math
import os
import re
import struct
import sys
import zlib

try:
    import cv2
    import numpy as np
    import genpy
    from geometry_msgs.msg import TransformStamped
    from scipy.spatial.transform import Rotation
    from tf2_msgs.msg import TFMessage
    cv2.aruco.CharucoBoard_create  # of the OpenCV of Debian 12
except (ImportError, AttributeError) as missing:
    print("not installed: %s" % missing)
    sys.exit(77)

sys.dont_write_bytecode = True  # nothing is written beside the sources
from field_runner import pose, run, run_cases
from field_scene import (ANGLES, CAMERA, CAMERAS, COUNT, FLANGES, HEIGHT, JOINTS, K, SEEN, STAND, TAG, TARGETS, WIDTH,
                         chessboard, hand, joint_table, motion, photographed, quaternion, quaternions, rotation_vector, table,
                         urdf, write)

NOISE = np.random.default_rng(37)
DICTIONARY = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_5X5_100)
COLUMNS, ROWS, SQUARE = 7, 5, 0.02  # of the printed chessboard
CHESSBOARD = "chessboard columns=7 rows=5 square=0.02"


def shaken(pose, place=2e-4, turn=3e-4):
    """A sensor's pose with its noise (m, rad of a coordinate)."""
    return pose @ motion(NOISE.normal(0, turn, 3), NOISE.normal(0, place, 3))


def floats(*rows):
    return [float(x) for row in rows for x in row]


def euler(pose, sequence):
    return Rotation.from_matrix(pose[:3, :3]).as_euler(sequence, degrees=True)


# What is to come of a case.

def told(*words, commands=("check", "fit")):
    """convert, or one of these commands, says a sentence with these words."""
    def judge(made):
        said = ""
        for command in (None, *(commands if made.returncode == 0 else ())):
            done = run(command, "session") if command else made
            said += done.stdout + done.stderr
            for line in re.split(r"\n(?! {4})", done.stdout + done.stderr):
                if all(re.search(word, line) for word in words):
                    return True, line.strip()
        return False, said
    return judge


def both(*judges):
    def judge(made):
        answers = [one(made) for one in judges]
        return all(good for good, _ in answers), "; ".join(said for _, said in answers)
    return judge


SENSOR = pose("mount_from_", CAMERA)
FIRST = SENSOR
HAND = pose("tcp_from_body", TAG, 3e-4, 0.05)


# The flange as makers' own programs hold it, beside the poses of a target by a detector.
def kuka_points():
    """Points of a program in KRL (.dat)."""
    lines = ["&ACCESS RVP", "&REL 3", "DEFDAT HANDEYE", "EXT BAS (BAS_COMMAND :IN,REAL :IN )"]
    for i, p in enumerate(FLANGES):
        lines += ["DECL E6POS XP%d={X %.6f,Y %.6f,Z %.6f,A %.6f,B %.6f,C %.6f,S 2,T 35,E1 0.0,E2 0.0,E3 0.0,E4 0.0,E5 0.0,E6 0.0}"
                  % (i + 1, *(1000 * p[:3, 3]), *euler(p, "ZYX")), 'DECL FDAT FP%d={TOOL_NO 0,BASE_NO 0,IPO_FRAME #BASE}' % (i + 1)]
    return [write("handeye.dat", "\r\n".join(lines + ["ENDDAT", ""])), quaternions("target.csv", TARGETS)], SENSOR


def abb_module():
    """robtargets of a module in RAPID (.mod), quaternions with w first."""
    lines = ["MODULE HandEye"]
    for i, p in enumerate(FLANGES):
        lines.append("  CONST robtarget p%d:=[[%.4f,%.4f,%.4f],[%.9f,%.9f,%.9f,%.9f],[-1,0,0,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]];"
                     % (10 * (i + 1), *(1000 * p[:3, 3]), *np.roll(quaternion(p), 1)))
    lines += ["  PROC main()", "    MoveJ p10,v200,fine,tool0;", "  ENDPROC", "ENDMODULE", ""]
    return [write("HandEye.mod", "\n".join(lines)), quaternions("target.csv", TARGETS)], SENSOR


def fanuc_program():
    """Positions of a TP program (.ls)."""
    text = "/PROG  HANDEYE\n/ATTR\nOWNER\t\t= MNEDITOR;\n/MN\n   1:J P[1] 20% FINE    ;\n/POS\n"
    for i, p in enumerate(FLANGES):
        text += ("P[%d]{\n   GP1:\n\tUF : 0, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 0',\n\tX = %9.4f  mm,\tY = %9.4f  mm,\tZ = %9.4f  mm,\n"
                 "\tW = %9.5f deg,\tP = %9.5f deg,\tR = %9.5f deg\n};\n" % (i + 1, *(1000 * p[:3, 3]), *euler(p, "xyz")))
    return [write("HANDEYE.LS", text + "/END\n"), quaternions("target.csv", TARGETS)], SENSOR


def fanuc_german_table():
    """Quoted, with semicolons and decimal commas, from a German spreadsheet."""
    comma = lambda x: ('"%.5f"' % x).replace(".", ",")
    rows = ['"Nr";"X";"Y";"Z";"W";"P";"R"']
    rows += ['"%d";' % (i + 1) + ";".join(comma(x) for x in (*(1000 * p[:3, 3]), *euler(p, "xyz"))) for i, p in enumerate(FLANGES)]
    with open("flansch.csv", "wb") as file:
        file.write(("\ufeff" + "\r\n".join(rows) + "\r\n").encode())
    return ["flansch.csv", quaternions("target.csv", TARGETS)], SENSOR


def staubli_latin():
    """Units in brackets with a degree sign in Latin-1."""
    rows = ["X (mm);Y (mm);Z (mm);RX (°);RY (°);RZ (°)"]
    rows += [";".join("%.5f" % x for x in (*(1000 * p[:3, 3]), *euler(p, "XYZ"))) for p in FLANGES]
    with open("points.csv", "wb") as file:
        file.write(("\n".join(rows) + "\n").encode("latin-1"))
    return ["points.csv", quaternions("target.csv", TARGETS)], SENSOR


def doosan():
    """posx of Doosan: mm and degrees about z, y, z."""
    flange = table("posx.csv", ["x", "y", "z", "a", "b", "c"], [floats(1000 * p[:3, 3], euler(p, "ZYZ")) for p in FLANGES])
    return [flange, quaternions("target.csv", TARGETS)], SENSOR


def techman():
    """Techman: mm and degrees, fixed axes; the camera tells rotation vectors of solvePnP."""
    flange = table("tm_points.csv", ["Name", "X", "Y", "Z", "RX", "RY", "RZ"],
                   [["P%d" % (i + 1), *floats(1000 * p[:3, 3], euler(p, "xyz"))] for i, p in enumerate(FLANGES)])
    target = table("solvepnp.csv", ["tvec_x", "tvec_y", "tvec_z", "rvec_x", "rvec_y", "rvec_z"],
                   [floats(p[:3, 3], rotation_vector(p)) for p in TARGETS])
    return [flange, target], SENSOR


def ur_script():
    """Poses as URScript writes them."""
    lines = ["p[%s]" % ", ".join("%.7f" % x for x in floats(p[:3, 3], rotation_vector(p))) for p in FLANGES]
    return [write("waypoints.txt", "\n".join(lines) + "\n"), quaternions("target.csv", TARGETS)], SENSOR


def mcap_record(code, *parts):
    content = b"".join(parts)
    return struct.pack("<BQ", code, len(content)) + content


def mcap_text(text):
    data = text if isinstance(text, bytes) else text.encode()
    return struct.pack("<I", len(data)) + data


def mcap_of_poses():
    """/tf alone in an MCAP, by its specification: a schema, a channel, messages of ROS 1 in two chunks."""
    def message(number, seconds, parent, child, pose):
        tf = TransformStamped(child_frame_id=child)
        tf.header.stamp, tf.header.frame_id = genpy.Time.from_sec(seconds), parent
        tf.transform.translation.x, tf.transform.translation.y, tf.transform.translation.z = pose[:3, 3]
        r = tf.transform.rotation
        r.x, r.y, r.z, r.w = quaternion(pose)
        data = io.BytesIO()
        TFMessage([tf]).serialize(data)
        time_ns = int(round(seconds * 1e9))
        return mcap_record(5, struct.pack("<HIQQ", 1, number, time_ns, time_ns), data.getvalue())

    schema = mcap_record(3, struct.pack("<H", 1), mcap_text("tf2_msgs/TFMessage"), mcap_text("ros1msg"), mcap_text(TFMessage._full_text))
    channel = mcap_record(4, struct.pack("<HH", 1, 1), mcap_text("/tf"), mcap_text("ros1"), struct.pack("<I", 0))
    messages = []
    for i, (flange, target) in enumerate(zip(FLANGES, TARGETS)):
        for k in range(20):
            messages.append(message(len(messages), 100 + 2 * i + 0.05 * k, "base_link", "tool0", flange))
            if k == 10:
                messages.append(message(len(messages), 100 + 2 * i + 0.05 * k, "camera", "aruco_marker", target))
    magic = b"\x89MCAP0\r\n"
    chunks = b""
    for half in (messages[:200], messages[200:]):
        records = (schema + channel if not chunks else b"") + b"".join(half)
        chunks += mcap_record(6, struct.pack("<QQQI", 0, 2**63, len(records), zlib.crc32(records)), mcap_text(""),
                              struct.pack("<Q", len(records)), records)
    with open("hand_eye.mcap", "wb") as file:
        file.write(magic + mcap_record(1, mcap_text("ros1"), mcap_text("field")) + chunks + mcap_record(15, struct.pack("<I", 0))
                   + mcap_record(2, struct.pack("<QQI", 0, 0, 0)) + magic)
    return ["hand_eye.mcap"], SENSOR


# Images.
CAMERA_YAML = """image_width: %d
image_height: %d
camera_name: cam
camera_matrix: {rows: 3, cols: 3, data: [%g, 0, %g, 0, %g, %g, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
"""


def camera_file(width=WIDTH, height=HEIGHT, k=K):
    return write("camera.yaml", CAMERA_YAML % (width, height, k[0, 0], k[0, 2], k[1, 1], k[1, 2]))


def photographs(drawn, metres, numbers=range(COUNT), name="images/img_%02d.png", change=None):
    os.makedirs(os.path.dirname(name), exist_ok=True)
    for i in numbers:
        picture = photographed(drawn, metres, CAMERAS[i])
        cv2.imwrite(name % i, change(picture) if change else picture)
    return os.path.dirname(name)


def chessboard_images(**more):
    return photographs(chessboard(COLUMNS, ROWS), 10 * SQUARE, **more)


def ur_images():
    """Rotation vectors as UR's pendant tells them, in mm, and a chessboard."""
    flange = table("poses.csv", ["X", "Y", "Z", "RX", "RY", "RZ"], [floats(1000 * p[:3, 3], rotation_vector(p)) for p in FLANGES])
    return [chessboard_images(), camera_file(), flange, "--target", CHESSBOARD], FIRST


def square_in_millimetres():
    return ([chessboard_images(numbers=range(8)), camera_file(), quaternions("flange.csv", FLANGES[:8]), "--target",
             "chessboard columns=7 rows=5 square=20"], told("millimet"))


def rows_for_columns():
    """ChArUco of 5 x 7 squares for one of 7 x 5."""
    drawn = cv2.aruco.CharucoBoard_create(7, 5, 0.026, 0.019, DICTIONARY).draw((1400, 1000))
    return ([photographs(drawn, 7 * 0.026, numbers=range(8)), camera_file(), quaternions("flange.csv", FLANGES[:8]), "--target",
             "charuco columns=5 rows=7 square=0.026 marker=0.019 dictionary=DICT_5X5_100"], told("columns", "7"))


def chessboard_transposed():
    """A chessboard of 5 x 7 corners for one of 7 x 5, which begins with another colour."""
    return ([chessboard_images(), camera_file(), quaternions("flange.csv", FLANGES), "--target",
             "chessboard columns=5 rows=7 square=0.02"], told("columns", "7", "rows", "5"))


def images_that_are_missing():
    """Eighteen rows with the names of their images, of which five were deleted."""
    numbers = [i for i in range(COUNT) if i not in (2, 3, 9, 10, 16)]
    flange = table("flange.csv", ["image", "x", "y", "z", "qx", "qy", "qz", "qw"],
                   [["img_%02d.png" % i, *floats(p[:3, 3], quaternion(p))] for i, p in enumerate(FLANGES)])
    return ([chessboard_images(numbers=numbers), camera_file(), flange, "--target", CHESSBOARD],
            both(FIRST, told("5 ", "image")))


def circles_transposed():
    """A grid of 4 x 9 circles described as 9 x 4."""
    arguments = circles("asymmetric", 4, 9, 0.018, 0.014)
    arguments[-1] = arguments[-1].replace("columns=4 rows=9", "columns=9 rows=4")
    return arguments, told("columns", "4", "rows", "9")


def images_that_are_missing_unnamed():
    """The same without names: nobody knows which row is whose."""
    numbers = [i for i in range(COUNT) if i not in (2, 3, 9, 10, 16)]
    return ([chessboard_images(numbers=numbers), camera_file(), quaternions("flange.csv", FLANGES), "--target", CHESSBOARD],
            lambda made: FIRST(made) if made.returncode == 0 else told("18", "13")(made))


def old_charuco():
    """As OpenCV before 4.6 drew it: of an even number of rows the first square is white."""
    columns, rows, cell, edge = 7, 6, 200, 25
    drawn = np.full((rows * cell, columns * cell), 255, np.uint8)
    number = 0
    for row in range(rows):
        for column in range(columns):
            square = drawn[row * cell:(row + 1) * cell, column * cell:(column + 1) * cell]
            if (row + column) % 2:
                square[:] = 0
                continue
            square[edge:-edge, edge:-edge] = cv2.aruco.drawMarker(DICTIONARY, number, cell - 2 * edge)
            number += 1
    return ([photographs(drawn, columns * 0.024, numbers=range(8)), camera_file(), quaternions("flange.csv", FLANGES[:8]), "--target",
             "charuco columns=7 rows=6 square=0.024 marker=0.018 dictionary=DICT_5X5_100"], told("layout", "old"))


def single_tags(size):
    """Two tags of 60 mm beside each other, described as of `size`."""
    drawn = np.full((1000, 1800), 255, np.uint8)
    for i in range(2):
        marker = cv2.aruco.drawMarker(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11), i, 600)
        drawn[200:800, 150 + 900 * i:750 + 900 * i] = marker
    return [photographs(drawn, 0.18), camera_file(), quaternions("flange.csv", FLANGES), "--target",
            "tags dictionary=tag36h11 size=%g ids=0,1" % size]


def tags():
    return single_tags(0.06), FIRST


def tags_larger_than_said():
    return single_tags(0.05), told("target|tags", "2[0-9](\\.[0-9]+)? ?%|60", "larger")


def circles(layout, columns, rows, spacing, diameter):
    per_metre, edge = 10000, 0.02
    wide = (columns - 1) * spacing * (1 if layout == "symmetric" else 2) + (0 if layout == "symmetric" else spacing)
    drawn = np.full((int(per_metre * ((rows - 1) * spacing + 2 * edge)), int(per_metre * (wide + 2 * edge))), 255, np.uint8)
    for row in range(rows):
        for column in range(columns):
            x = column * spacing if layout == "symmetric" else (2 * column + row % 2) * spacing
            cv2.circle(drawn, (round(per_metre * (x + edge)), round(per_metre * (row * spacing + edge))), round(per_metre * diameter / 2),
                       0, -1, cv2.LINE_AA)
    words = "circles columns=%d rows=%d spacing=%g diameter=%g layout=%s" % (columns, rows, spacing, diameter, layout)
    return [photographs(drawn, drawn.shape[1] / per_metre), camera_file(), quaternions("flange.csv", FLANGES), "--target", words]


def circles_asymmetric():
    return circles("asymmetric", 4, 9, 0.018, 0.014), FIRST


def circles_symmetric():
    return circles("symmetric", 7, 5, 0.022, 0.014), FIRST


def portrait():
    """Images that stand upright, of a camera that was calibrated lying."""
    return ([chessboard_images(numbers=range(8), change=lambda p: cv2.rotate(p, cv2.ROTATE_90_CLOCKWISE)), camera_file(),
             quaternions("flange.csv", FLANGES[:8]), "--target", CHESSBOARD], told("600", "800"))


def camera_upside_down():
    """A camera that hangs upside down and was calibrated so: no mistake."""
    turned = K.copy()
    turned[0, 2], turned[1, 2] = WIDTH - 1 - K[0, 2], HEIGHT - 1 - K[1, 2]
    return ([chessboard_images(change=lambda p: cv2.rotate(p, cv2.ROTATE_180)), camera_file(k=turned),
             quaternions("flange.csv", FLANGES), "--target", CHESSBOARD],
            pose("mount_from_", CAMERA @ motion((0, 0, math.pi), (0, 0, 0))))


# Tables with a mistake in them.
def inverse_flange_on_a_stand():
    """A camera on a stand sees the target on the flange; the table has the base in the flange's frame."""
    stand, grip = motion((2.2, 0.1, -0.6), (1.2, 0.5, 0.9)), TAG
    flanges = [hand(q) for q in ANGLES[:20]]
    target = quaternions("target.csv", [shaken(np.linalg.inv(stand) @ f @ grip) for f in flanges])
    flange = quaternions("flange.csv", [np.linalg.inv(f) for f in flanges])
    return ["--eye-on-base", flange, target], told("flange|Flange", "inverted|eye-on-base")


def clocks_apart():
    """Joints in seconds since the robot started, the target in seconds since 1970."""
    write("robot.urdf", urdf(JOINTS))
    joints = table("joints.csv", ["time", *JOINTS], [[float(i), *floats(q)] for i, q in enumerate(ANGLES)])
    target = table("target.csv", ["time", "x", "y", "z", "qx", "qy", "qz", "qw"],
                   [["%.3f" % (1.7e9 + i), *floats(p[:3, 3], quaternion(p))] for i, p in enumerate(SEEN)])
    return ["robot.urdf", joints, target, "--tcp", "link_6"], lambda made: HAND(made) if made.returncode == 0 else told("time|clock")(made)


def poses_twice():
    """A recorder wrote every third row twice."""
    rows = [i for i in range(COUNT) for _ in range(1 + (i % 3 == 0))]
    return ([quaternions("flange.csv", [FLANGES[i] for i in rows]), quaternions("target.csv", [TARGETS[i] for i in rows])],
            both(SENSOR, told("6 ", "row|line|twice|same")))


def tracker_points(turn):
    """One reflector per row of a tracker; the coordinates as `turn` has them."""
    write("robot.urdf", urdf(JOINTS))
    marker = np.array([0.03, -0.02, 0.09, 1])
    rows = [floats(turn @ ((np.linalg.inv(STAND) @ hand(q) @ marker)[:3] + NOISE.normal(0, 5e-5, 3))) for q in ANGLES]
    return ["robot.urdf", joint_table(), table("points.csv", ["x", "y", "z"], rows), "--tcp", "link_6", "--sigma", "5e-5"]


def place(truth):
    def judge(made):
        fitted = run("fit", "session", "--json", "-") if made.returncode == 0 else made
        if fitted.returncode == 2:
            return False, fitted.stderr.strip().split("\n")[-1]
        found = np.array(json.loads(fitted.stdout)["tcp_from_body"]["matrix"])[:3, 3]
        off = float(np.linalg.norm(found - truth))
        return off < 3e-4, "%.3f mm off" % (1e3 * off)
    return judge


def tracker_with_y_up():
    return tracker_points(Rotation.from_euler("x", -90, degrees=True).as_matrix()), place([0.03, -0.02, 0.09])


def tracker_axes_exchanged():
    """Columns y and z exchanged: a left-handed frame."""
    return tracker_points(np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])), told("mirror|left-handed|exchanged", "y|z|axis|axes")


def robot_before_a_sensor(change, names=JOINTS, header=JOINTS, **more):
    write("robot.urdf", urdf(names))
    joints = table("joints.csv", header, [floats(change(q)) for q in ANGLES], **more)
    return ["robot.urdf", joints, quaternions("target.csv", [shaken(p) for p in SEEN]), "--tcp", "link_6", "--sigma", "2e-4",
            "--sigma-angle", "3e-4"]


def degrees_without_header():
    return robot_before_a_sensor(np.degrees, header=None), told("degrees", "--degrees")


def four_degrees_off():
    return (robot_before_a_sensor(lambda q: q - np.radians([0, 0, 4, 0, 0, 0])),
            told("joint_3", "offset|zero|Zero", "4\\.0|3\\.9|0\\.069|0\\.07|69\\.|70\\.", commands=("check", "fit", "diagnose")))


def one_counts_backwards():
    return robot_before_a_sensor(lambda q: q * [1, 1, 1, -1, 1, 1]), told("joint_4", "other way")


def two_exchanged():
    return robot_before_a_sensor(lambda q: q[[0, 1, 2, 4, 3, 5]]), told("joint_4", "joint_5", "exchanged")


def two_hands_in_one_table():
    """A table with the poses of two targets, the left and the right hand's."""
    write("robot.urdf", urdf(JOINTS))
    header = ["%s_%s" % (side, n) for side in ("left", "right") for n in ("x", "y", "z", "qx", "qy", "qz", "qw")]
    other = motion((0.1, 0.2, 0.3), (0.3, 0.1, 0.2))
    rows = [floats(other[:3, 3], quaternion(other), p[:3, 3], quaternion(p)) for p in SEEN]
    return (["robot.urdf", joint_table(), table("targets.csv", header, rows), "--tcp", "link_6"], told("left", "right", "target-frame"))


def two_hands_chosen():
    arguments, _ = two_hands_in_one_table()
    return [*arguments, "--target-frame", "right"], HAND


def sides_exchanged():
    """A stereo pair on a stand before a board in the hand: the folders have each other's images."""
    write("robot.urdf", urdf(JOINTS))
    drawn = cv2.aruco.CharucoBoard_create(7, 5, 0.026, 0.019, DICTIONARY).draw((1400, 1000))
    second = motion((0, 0, 0), (-0.08, 0, 0))  # right_from_left
    grip = motion((0.1, 0.05, 0.4), (-0.05, -0.04, 0.06))
    middle = grip @ np.array([0.09, 0.065, 0, 1])
    kept = []
    at = hand(np.array([0.0, 0.3, -0.5, 0.1, 0.4, 0.0])) @ grip
    stand = at @ motion((math.pi, 0, 0), (0.09, 0.065, 0.45)) @ motion((0.1, -0.05, 0.2), (0, 0, 0))
    random = np.random.default_rng(5)
    for side in ("left", "right"):
        os.makedirs(side, exist_ok=True)
    while len(kept) < 12:
        q = np.array([0.0, 0.3, -0.5, 0.1, 0.4, 0.0]) + random.uniform(-0.3, 0.3, 6)
        board = hand(q) @ grip
        seen = np.linalg.inv(stand) @ hand(q) @ middle
        if abs(seen[0] / seen[2]) > 0.3 or abs(seen[1] / seen[2]) > 0.2 or not 0.3 < seen[2] < 0.6:
            continue
        for side, pose in (("right", stand), ("left", stand @ np.linalg.inv(second))):  # exchanged
            cv2.imwrite("%s/%03d.png" % (side, len(kept)), photographed(drawn, 7 * 0.026, pose, base_from_board=board))
        kept.append(q)
    storage = cv2.FileStorage("stereo.yml", cv2.FILE_STORAGE_WRITE)
    for name, value in (("K1", K), ("D1", np.zeros((1, 5))), ("K2", K), ("D2", np.zeros((1, 5))), ("R", second[:3, :3]),
                        ("T", second[:3, 3:])):
        storage.write(name, value)
    storage.release()
    return (["left", "right", "stereo.yml", "robot.urdf", table("joints.csv", JOINTS, [floats(q) for q in kept]), "--tcp", "link_6",
             "--target", "charuco columns=7 rows=5 square=0.026 marker=0.019 dictionary=DICT_5X5_100"], told("exchanged", "left|sides|cameras"))


CASES = [kuka_points, abb_module, fanuc_program, fanuc_german_table, staubli_latin, doosan, techman, ur_script, mcap_of_poses, ur_images,
         square_in_millimetres, rows_for_columns, chessboard_transposed, images_that_are_missing, images_that_are_missing_unnamed,
         old_charuco, tags, tags_larger_than_said, circles_asymmetric, circles_symmetric, circles_transposed, portrait, camera_upside_down,
         inverse_flange_on_a_stand, clocks_apart, poses_twice, tracker_with_y_up, tracker_axes_exchanged, degrees_without_header,
         four_degrees_off, one_counts_backwards, two_exchanged, two_hands_in_one_table, two_hands_chosen, sides_exchanged]


sys.exit(run_cases(CASES))
