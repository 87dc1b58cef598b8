#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Recordings of strangers, twenty-two kinds, each in its format's own words, by writers that are not Handsight's where Debian has them
(rosbag and genpy of ROS, OpenCV, MuJoCo, NumPy, SciPy, PyYAML): how many become sessions without an edit, and give the
right answer (hand-eye pose, or TCP->Body, within 0.3 mm and 0.05 degrees).

strangers_recordings.py HANDSIGHT_CLI [NUMBER ...]: a line for each; exit code 1 where fewer than nine of ten open, or one that
opens is wrong; 77 where the writers are not installed."""
import csv
import ctypes
import json
import math
import os
import subprocess
import sys
import tempfile

try:
    import cv2
    import genpy
    import numpy as np
    import rosbag
    import yaml
    from geometry_msgs.msg import TransformStamped
    from scipy.spatial.transform import Rotation
    from sensor_msgs.msg import CameraInfo, JointState
    from std_msgs.msg import String
    from tf2_msgs.msg import TFMessage
    cv2.aruco.GridBoard_create  # of the OpenCV of Debian 12
except (ImportError, AttributeError) as missing:
    print("not installed: %s" % missing)
    sys.exit(77)

sys.dont_write_bytecode = True  # nothing is written beside the sources
from field_scene import (ANGLES, CAMERA, CAMERAS, COUNT, FLANGES, FOCAL, HEIGHT, JOINTS, K, SEEN, TAG, TARGETS, WIDTH, chessboard,
                         joint_table, motion, photographed, quaternion, quaternions, table, urdf, write)

CLI = os.path.abspath(sys.argv[1])


def makers(header, sequence=None, unit=1000.0):
    """A controller's table of the flange, its angles by SciPy, beside the detector's poses."""
    def turn(p):
        r = Rotation.from_matrix(p[:3, :3])
        if sequence == "q":
            return np.roll(r.as_quat(), 1)
        if sequence is None:
            return cv2.Rodrigues(p[:3, :3])[0][:, 0]
        return r.as_euler(sequence, degrees=True)
    flange = table("flange.csv", header, [[*map(float, (*(unit * p[:3, 3]), *turn(p)))] for p in FLANGES])
    return [flange, quaternions("target.csv", TARGETS)], CAMERA


def universal_robots():
    return makers(["x", "y", "z", "rx", "ry", "rz"], None, 1.0)


def kuka():
    return makers(["X", "Y", "Z", "A", "B", "C"], "ZYX")


def fanuc():
    return makers(["X", "Y", "Z", "W", "P", "R"], "xyz")


def staubli():
    return makers(["X", "Y", "Z", "RX", "RY", "RZ"], "XYZ")


def abb():
    return makers(["x", "y", "z", "q1", "q2", "q3", "q4"], "q")


def matrices_by_row():
    for name, poses in (("flange.txt", FLANGES), ("target.txt", TARGETS)):
        np.savetxt(name, [p.ravel() for p in poses])
    return ["flange.txt", "target.txt"], CAMERA


def matrices_by_file():
    for name, poses in (("flange", FLANGES), ("target", TARGETS)):
        os.mkdir(name)
        for i, p in enumerate(poses):
            np.savetxt("%s/pose_%02d.txt" % (name, i), p)
    return ["flange", "target"], CAMERA


def opencv_storage():
    for name, key, poses in (("flange.yml", "gripper2base", FLANGES), ("target.yml", "target2cam", TARGETS)):
        storage = cv2.FileStorage(name, cv2.FILE_STORAGE_WRITE)
        for i, p in enumerate(poses):
            storage.write("%s%02d" % (key, i), p)
        storage.release()
    return ["flange.yml", "target.yml"], CAMERA


def visp():
    os.mkdir("poses")
    for key, poses in (("fPe", FLANGES), ("cPo", TARGETS)):
        for i, p in enumerate(poses):
            numbers = (*p[:3, 3], *cv2.Rodrigues(p[:3, :3])[0][:, 0])
            write("poses/pose_%s_%d.yaml" % (key, i + 1),
                  "rows: 6\ncols: 1\ndata:\n" + "".join("  - [%.9g]\n" % x for x in numbers))
    return ["poses"], CAMERA


def easy_handeye():
    def transform(p):
        return {"translation": dict(zip("xyz", map(float, p[:3, 3]))), "rotation": dict(zip("xyzw", map(float, quaternion(p))))}
    samples = [{"robot": transform(f), "tracking": transform(t)} for f, t in zip(FLANGES, TARGETS)]
    write("my_calibration.samples", yaml.dump({"parameters": {"calibration_type": "eye_in_hand"}, "samples": samples}))
    return ["my_calibration.samples"], CAMERA


def moveit():
    write("samples.yaml", yaml.dump([{"effector_wrt_world": [float(x) for x in f.ravel()],
                                      "object_wrt_sensor": [float(x) for x in t.ravel()]} for f, t in zip(FLANGES, TARGETS)]))
    return ["samples.yaml"], CAMERA


def charuco_and_echo():
    board = cv2.aruco.CharucoBoard_create(7, 5, 0.026, 0.019, cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_5X5_100))
    drawn = board.draw((1400, 1000))
    os.mkdir("images")
    for i, c in enumerate(CAMERAS):
        cv2.imwrite("images/frame%04d.png" % i, photographed(drawn, 7 * 0.026, c))
    info = CameraInfo(width=WIDTH, height=HEIGHT, distortion_model="plumb_bob", D=[0.0] * 5, K=list(K.ravel()),
                      R=list(np.eye(3).ravel()), P=list(np.hstack([K, np.zeros((3, 1))]).ravel()))
    write("camera_info.txt", str(info) + "\n---\n")  # as `rostopic echo -n 1` prints it
    return ["images", "camera_info.txt", quaternions("flange.csv", FLANGES), "--target",
            "charuco columns=7 rows=5 square=0.026 marker=0.019 dictionary=DICT_5X5_100"], CAMERA


OST = """# oST version 5.0 parameters


[image]

width
%d

height
%d

[narrow_stereo]

camera matrix
%s

distortion
0.000000 0.000000 0.000000 0.000000 0.000000

rectification
1.000000 0.000000 0.000000
0.000000 1.000000 0.000000
0.000000 0.000000 1.000000

projection
%s

"""


def sixteen_bits_and_ost():
    os.mkdir("images")
    drawn = chessboard(7, 5)
    for i, c in enumerate(CAMERAS):
        cv2.imwrite("images/img_%02d.png" % i, photographed(drawn, 10 * 0.02, c).astype(np.uint16) * 16)  # 12 bits are used
    lines = lambda m: "\n".join(" ".join("%.6f" % x for x in row) for row in m)
    write("ost.txt", OST % (WIDTH, HEIGHT, lines(K), lines(np.hstack([K, np.zeros((3, 1))]))))
    flange = table("flange.csv", ["image", "x", "y", "z", "qx", "qy", "qz", "qw"],
                   [["img_%02d.png" % i, *map(float, (*FLANGES[i][:3, 3], *quaternion(FLANGES[i])))]
                    for i in reversed(range(COUNT))])
    return ["images", "ost.txt", flange, "--target", "chessboard columns=7 rows=5 square=0.02"], CAMERA


def webp_and_realsense():
    board = cv2.aruco.GridBoard_create(5, 4, 0.03, 0.006, cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50))
    drawn = cv2.copyMakeBorder(board.draw((1740, 1380)), 100, 100, 100, 100, cv2.BORDER_CONSTANT, value=255)
    os.mkdir("images")
    for i, c in enumerate(CAMERAS):
        cv2.imwrite("images/%d.webp" % (i + 8), photographed(drawn, 0.194, c), [cv2.IMWRITE_WEBP_QUALITY, 101])
    write("intrinsics.json", json.dumps({"width": WIDTH, "height": HEIGHT, "fx": FOCAL, "fy": FOCAL, "ppx": K[0, 2],
                                         "ppy": K[1, 2], "model": "distortion.none", "coeffs": [0.0] * 5}))
    np.savetxt("flange_tum.txt", [[1.7e9 + i, *p[:3, 3], *quaternion(p)] for i, p in enumerate(FLANGES)], fmt="%.9f")
    return ["images", "intrinsics.json", "flange_tum.txt", "--target",
            "grid columns=5 rows=4 marker=0.03 separation=0.006 dictionary=DICT_4X4_50"], CAMERA


def kalibr_pair():
    second = motion((0.01, 0.03, -0.02), (-0.06, 0.001, 0.002))  # cam1_from_cam0
    drawn = chessboard(7, 5)
    for i, c in enumerate(CAMERAS):
        for name, pose in (("cam0", c), ("cam1", c @ np.linalg.inv(second))):
            os.makedirs(name + "/data", exist_ok=True)
            cv2.imwrite("%s/data/%d.png" % (name, 1700000000000000000 + 500000000 * i), photographed(drawn, 10 * 0.02, pose))
    camera = {"camera_model": "pinhole", "intrinsics": [FOCAL, FOCAL, float(K[0, 2]), float(K[1, 2])],
              "distortion_model": "radtan", "distortion_coeffs": [0.0] * 4, "resolution": [WIDTH, HEIGHT]}
    write("camchain.yaml", yaml.dump({"cam0": {**camera, "rostopic": "/cam0/image_raw"},
                                      "cam1": {**camera, "rostopic": "/cam1/image_raw", "T_cn_cnm1": second.tolist()}}))
    write("checkerboard_7x5.yaml", yaml.dump({"target_type": "checkerboard", "targetCols": 7, "targetRows": 5,
                                              "rowSpacingMeters": 0.02, "colSpacingMeters": 0.02}))
    return ["cam0/data", "cam1/data", "camchain.yaml", "checkerboard_7x5.yaml", quaternions("flange.csv", FLANGES)], CAMERA


def transform(time, parent, child, pose):
    tf = TransformStamped(child_frame_id=child)
    tf.header.stamp, tf.header.frame_id = time, parent
    tf.transform.translation.x, tf.transform.translation.y, tf.transform.translation.z = pose[:3, 3]
    r = tf.transform.rotation
    r.x, r.y, r.z, r.w = quaternion(pose)
    return tf


def bag_with_robot():
    with rosbag.Bag("recording.bag", "w", compression="lz4") as bag:
        bag.write("/robot_description", String(urdf(JOINTS)), genpy.Time(100))
        for i, (q, pose) in enumerate(zip(ANGLES, SEEN)):
            for k in range(60):  # stands for a second of three
                t = genpy.Time.from_sec(100 + 3 * i + 0.05 * k)
                share = max(0.0, (k - 20) / 40) if i + 1 < len(ANGLES) else 0.0
                joints = JointState(name=JOINTS, position=list(q + share * (ANGLES[min(i + 1, len(ANGLES) - 1)] - q)))
                joints.header.stamp = t
                bag.write("/joint_states", joints, t)
                if k == 10:
                    bag.write("/tf", TFMessage([transform(t, "camera_optical_frame", "tag_7", pose)]), t)
    return ["recording.bag", "--tcp", "link_6"], TAG


def bag_of_poses():
    with rosbag.Bag("hand_eye.bag", "w", compression="bz2") as bag:
        for i, (flange, target) in enumerate(zip(FLANGES, TARGETS)):
            for k in range(20):
                t = genpy.Time.from_sec(100 + 2 * i + 0.05 * k)
                bag.write("/tf", TFMessage([transform(t, "base_link", "tool0", flange)]), t)
                if k == 10:
                    bag.write("/tf", TFMessage([transform(t, "camera", "aruco_marker", target)]), t)
    return ["hand_eye.bag"], CAMERA


def mujoco_and_motive():
    write("robot.urdf", urdf(JOINTS))
    mujoco, error = ctypes.CDLL("libmujoco.so.2.2.2"), ctypes.create_string_buffer(1000)
    mujoco.mj_loadXML.restype = ctypes.c_void_p
    model = mujoco.mj_loadXML(b"robot.urdf", None, error, 1000)
    if not model or not mujoco.mj_saveLastXML(b"robot.xml", ctypes.c_void_p(model), error, 1000):
        raise RuntimeError(error.value.decode())
    os.remove("robot.urdf")
    body = ["gripper"] * 7
    head = [["Format Version", "1.23", "Take Name", "Take 2026-03-01", "Capture Frame Rate", "120.000000", "Rotation Type",
             "Quaternion", "Length Units", "Meters", "Coordinate Space", "Global"], [],
            ["", "Type"] + ["Rigid Body"] * 7, ["", "Name"] + body, ["", "ID"] + ["1"] * 7,
            ["", ""] + ["Rotation"] * 4 + ["Position"] * 3, ["Frame", "Time (Seconds)", "X", "Y", "Z", "W", "X", "Y", "Z"]]
    table("take.csv", None, head + [[i, i / 120, *map(float, (*quaternion(p), *p[:3, 3]))] for i, p in enumerate(SEEN)])
    return ["robot.xml", "take.csv", joint_table(), "--tcp", "link_6"], TAG


def vicon():
    write("robot.urdf", urdf(JOINTS))
    head = [["Objects"], ["100"], ["", "", "gripper:gripper"] + [""] * 5,
            ["Frame", "Sub Frame", "RX", "RY", "RZ", "TX", "TY", "TZ"], ["", ""] + ["rad"] * 3 + ["mm"] * 3]
    table("trial.csv", None, head + [[i + 1, 0, *map(float, (*cv2.Rodrigues(p[:3, :3])[0][:, 0], *(1000 * p[:3, 3])))]
                                     for i, p in enumerate(SEEN)])
    return ["robot.urdf", "trial.csv", joint_table(), "--tcp", "link_6"], TAG


def lerobot():
    names = ["shoulder_pan", "shoulder_lift", "elbow_flex", "wrist_flex", "wrist_roll", "hand_roll"]
    write("robot.urdf", urdf(names))
    servos = {n: {"id": i + 1, "drive_mode": 0, "homing_offset": 37 * i - 90, "range_min": 700 + 40 * i, "range_max": 3400 - 25 * i}
              for i, n in enumerate(names)}
    write("so101_follower.json", json.dumps(servos, indent=4))
    half = np.array([(s["range_max"] - s["range_min"]) / 2 for s in servos.values()])
    table("log.csv", [n + ".pos" for n in names], [[*map(float, 100 * q * 4096 / (2 * math.pi) / half)] for q in ANGLES])
    return ["robot.urdf", "so101_follower.json", "log.csv", quaternions("tag_poses.csv", SEEN), "--tcp", "link_6"], TAG


def rtde():
    """As record.py of UR's RTDE client writes it; the detector's poses as SciPy's angles with units."""
    rows = [[100 + 0.1 * i, *map(float, (*p[:3, 3], *cv2.Rodrigues(p[:3, :3])[0][:, 0])), 0.1] for i, p in enumerate(FLANGES)]
    table("robot_data.csv", ["timestamp"] + ["actual_TCP_pose_%d" % i for i in range(6)] + ["actual_main_voltage"], rows, " ")
    table("target.csv", ["x [mm]", "y [mm]", "z [mm]", "roll [deg]", "pitch [deg]", "yaw [deg]"],
          [[*map(float, (*(1000 * p[:3, 3]), *Rotation.from_matrix(p[:3, :3]).as_euler("xyz", degrees=True)))] for p in TARGETS])
    return ["robot_data.csv", "target.csv"], CAMERA


def rostopic_as_csv():
    """`rostopic echo -p` of joint_states and of a detector's PoseStamped."""
    write("robot.urdf", urdf(JOINTS))
    head = ["%time", "field.header.seq", "field.header.stamp", "field.header.frame_id"]
    stamp = lambda i: 1700000000000000000 + i * 10**9
    table("joints.csv", head + ["field.name%d" % i for i in range(6)] + ["field.position%d" % i for i in range(6)],
          [[stamp(i), i, stamp(i), "", *JOINTS, *map(float, q)] for i, q in enumerate(ANGLES)])
    table("tag.csv", head + ["field.pose.position." + a for a in "xyz"] + ["field.pose.orientation." + a for a in "xyzw"],
          [[stamp(i), i, stamp(i), "camera", *map(float, (*p[:3, 3], *quaternion(p)))] for i, p in enumerate(SEEN)])
    return ["robot.urdf", "joints.csv", "tag.csv", "--tcp", "link_6"], TAG


RECORDINGS = [(universal_robots, "UR's rotation vectors", "OpenCV's Rodrigues"), (kuka, "KUKA's X Y Z A B C, mm and degrees", "SciPy"),
              (fanuc, "Fanuc's X Y Z W P R", "SciPy"), (staubli, "Staubli's X Y Z RX RY RZ", "SciPy"),
              (abb, "ABB's quaternions, w first, mm", "SciPy"), (matrices_by_row, "4x4 matrices, one a row", "NumPy"),
              (matrices_by_file, "4x4 matrices, a file each", "NumPy"),
              (opencv_storage, "gripper2base, target2cam in a FileStorage", "OpenCV"),
              (visp, "pose_fPe_N.yaml, pose_cPo_N.yaml of ViSP", "by hand"),
              (easy_handeye, "samples of easy_handeye", "PyYAML"), (moveit, "samples of MoveIt", "PyYAML"),
              (charuco_and_echo, "ChArUco in PNG, `rostopic echo` of camera_info", "OpenCV, genpy"),
              (sixteen_bits_and_ost, "12 bits in 16-bit PNG, ost.txt, table with image names", "OpenCV; ost.txt by hand"),
              (webp_and_realsense, "ArUco grid in WebP, RealSense's intrinsics, TUM lines", "OpenCV, NumPy, JSON"),
              (kalibr_pair, "cam0/data, cam1/data, camchain and target of Kalibr", "OpenCV, PyYAML"),
              (bag_with_robot, "bag of ROS 1 (lz4) with robot, joints and a tag", "rosbag"),
              (bag_of_poses, "bag of ROS 1 (bz2) of /tf alone", "rosbag"),
              (mujoco_and_motive, "robot of MuJoCo, take of Motive, joint table", "MuJoCo; take by hand"),
              (vicon, "trial of Vicon, joint table, URDF", "by hand"),
              (lerobot, "LeRobot's calibration and log in per cent", "JSON, csv"),
              (rtde, "recording of UR's RTDE client", "OpenCV, SciPy"),
              (rostopic_as_csv, "`rostopic echo -p` of joints and poses", "csv by hand")]


def run(*arguments):
    return subprocess.run([CLI, *arguments], capture_output=True, text=True)


def last(text):
    lines = text.strip().split("\n")
    return lines[-1] if lines else ""


def judge(make):
    """Does it open, is it right, what is said."""
    arguments, truth = make()
    made = run("convert", *arguments, "--out", "session")
    if made.returncode:
        return False, False, "refused: " + last(made.stderr)
    fitted = run("fit", "session", "--json", "-")
    if fitted.returncode == 2:
        return True, False, "fit: " + last(fitted.stderr)
    result = json.loads(fitted.stdout)
    found = np.array(result["mount_from_sensor"] if truth is CAMERA else result["tcp_from_body"]["matrix"])
    away = np.linalg.inv(truth) @ found
    turn = Rotation.from_matrix(away[:3, :3]).magnitude()
    length = float(np.linalg.norm(away[:3, 3]))
    return True, length < 3e-4 and turn < math.radians(0.05), "%.3f mm and %.4f degrees off" % (1e3 * length, math.degrees(turn))


def main():
    wanted = {int(n) for n in sys.argv[2:]} or set(range(1, len(RECORDINGS) + 1))
    opened = wrong = 0
    for number, (make, what, writer) in enumerate(RECORDINGS, 1):
        if number not in wanted:
            continue
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            opens, right, said = judge(make)
            os.chdir("/")
        opened += opens
        wrong += opens and not right
        print("%2d %-7s %-58s (%s) %s" % (number, "right" if right else "OPENS" if opens else "REFUSED", what, writer, said), flush=True)
    print("%d of %d open, %d of them wrong" % (opened, len(wanted), wrong))
    return 1 if wrong or opened < 0.9 * len(wanted) else 0


sys.exit(main())
