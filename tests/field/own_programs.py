#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Recordings as people's own scripts and makers' programs write them, in the layouts of public repositories of hand-eye
calibration: lists of rotations and places, pairs within a log, a JSON a sample, arrays as Python prints them, cameras as
plain matrices. All of them are made here from a known scene by NumPy, OpenCV, PyYAML and as text.

own_programs.py HANDSIGHT_CLI [NAME ...]: a line for each, with what was said (-v: all of it); exit code 1 where one does not
come to its right value or to a sentence that says what to do; 77 where the writers are not installed."""
import json
import os
import pickle
import sys

try:
    import cv2
    import numpy as np
    import yaml
    from scipy.spatial.transform import Rotation
    cv2.aruco.CharucoBoard_create  # of the OpenCV of Debian 12
except (ImportError, AttributeError) as missing:
    print("not installed: %s" % missing)
    sys.exit(77)

sys.dont_write_bytecode = True  # nothing is written beside the sources
from field_runner import pose, run_cases
from field_scene import (ANGLES, CAMERA, CAMERAS, COUNT, FLANGES, FOCAL, HEIGHT, JOINTS, K, SEEN, TAG, TARGETS, WIDTH, chessboard,
                         joint_table, motion, photographed, quaternion, quaternions, rotation_vector, table, urdf, write)

SENSOR = pose("mount_from_", CAMERA)
HAND = pose("tcp_from_body", TAG)
CHARUCO = "charuco columns=7 rows=5 square=26mm marker=19mm dictionary=DICT_5X5_100"
CHESSBOARD = "chessboard columns=7 rows=5 square=20mm"


def floats(*rows):
    return [float(x) for row in rows for x in row]


def lists(matrix):
    return [floats(row) for row in matrix]


def millimetres(p):
    m = p.copy()
    m[:3, 3] *= 1000
    return m


def euler(p, sequence="xyz"):
    return Rotation.from_matrix(p[:3, :3]).as_euler(sequence, degrees=True)


def told(*words):
    """convert refuses with a sentence that has these words."""
    return lambda made: (made.returncode == 2 and all(w in made.stderr for w in words), made.stderr.strip().split("\n")[-1])


def charuco_images(name, cameras=tuple(CAMERAS), numbers=range(COUNT)):
    drawn = cv2.aruco.CharucoBoard_create(7, 5, 0.026, 0.019, cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_5X5_100)).draw((1400, 1000))
    for i in numbers:
        write(name % i, "")
        cv2.imwrite(name % i, photographed(drawn, 7 * 0.026, cameras[i]))


def chessboard_images(name):
    for i, c in enumerate(CAMERAS):
        write(name % i, "")
        cv2.imwrite(name % i, photographed(chessboard(7, 5), 0.2, c))


def camera_info():
    return write("camera.yaml", "image_width: %d\nimage_height: %d\ncamera_name: cam\ncamera_matrix: {rows: 3, cols: 3, data: [%g, 0, %g, "
                 "0, %g, %g, 0, 0, 1]}\ndistortion_model: plumb_bob\ndistortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}\n"
                 % (WIDTH, HEIGHT, K[0, 0], K[0, 2], K[1, 1], K[1, 2]))


# Poses.
def json_a_sample():
    """A folder a sample with joints, the flange column by column (libfranka) and solvePnP's vectors."""
    for i, (f, t) in enumerate(zip(FLANGES, TARGETS)):
        write("captured/pose_%02d/data.json" % i, json.dumps(
            {"joint_pose": [0.1 * i, 0.2, 0.3, -2.4, 0, 2.2, 0.7], "O_T_EE": floats(f.T.ravel()), "camera_intrinsics": lists(K),
             "dist_coeffs": [0.0] * 5, "charuco_detected": True, "T_cam_target_rvec": rotation_vector(t).reshape(3, 1).tolist(),
             "T_cam_target_tvec": t[:3, 3:].tolist()}, indent=4))
    return ["captured"], SENSOR


def rotations_and_places_in_yaml():
    for name, poses in (("robot_data.yaml", FLANGES), ("marker_data.yaml", TARGETS)):
        write(name, yaml.dump({"poses": [{"rotation": lists(p[:3, :3]), "translation": floats(p[:3, 3])} for p in poses]}))
    return ["robot_data.yaml", "marker_data.yaml"], SENSOR


def lists_for_calibrate_hand_eye():
    """The four arguments of OpenCV's calibrateHandEye, dumped."""
    write("data.json", json.dumps({"R_gripper2base": [lists(p[:3, :3]) for p in FLANGES], "t_gripper2base": [p[:3, 3:].tolist() for p in FLANGES],
                                   "R_target2cam": [lists(p[:3, :3]) for p in TARGETS], "t_target2cam": [p[:3, 3:].tolist() for p in TARGETS]}))
    return ["data.json"], SENSOR


def pairs_within_a_log():
    write("handeye_log.json", json.dumps(
        {"Title": "Handeye", "Camera Mount Type": "attached on robot", "Result in Matrix Format": lists(CAMERA), "Joint Dataset": [[0.1] * 6] * COUNT,
         "Transform Dataset": [[lists(f), lists(t)] for f, t in zip(FLANGES, TARGETS)]}, indent=4))
    return ["handeye_log.json"], SENSOR


def pairs_without_a_name():
    """T1_0, T2_0 ...: which is which nobody can say, but who made them."""
    storage = cv2.FileStorage("TransformPairs.yml", cv2.FILE_STORAGE_WRITE)
    storage.write("frameCount", COUNT)
    for i, (f, t) in enumerate(zip(FLANGES, TARGETS)):
        storage.write("T1_%d" % i, f)
        storage.write("T2_%d" % i, t)
    storage.release()
    return ["TransformPairs.yml"]


def pairs_without_a_name_are_asked_for():
    return pairs_without_a_name(), told("--target-frame")


def pairs_whose_target_is_named():
    return [*pairs_without_a_name(), "--target-frame", "T2"], SENSOR


def arrays_as_python_prints_them():
    chessboard_images("shots/%d_VidFramed.png")
    for i, f in enumerate(FLANGES):
        write("shots/%d_VidFramed.txt" % i, "np.array(%s)\n" % lists(millimetres(f)))
    return ["shots", camera_info(), "--target", CHESSBOARD], SENSOR


def zivid():
    chessboard_images("dataset/img%02d.png")
    for i, f in enumerate(FLANGES):
        write("dataset/pos%02d.yaml" % i, "__version__:\n  serializer: 1\n  data: 1\nFloatMatrix:\n  Data: [\n    [%s] ]\n"
              % "],\n    [".join(", ".join("%.9g" % x for x in row) for row in millimetres(f)))
    return ["dataset", camera_info(), "--target", CHESSBOARD], SENSOR


def halcon():
    for key, poses in (("tool_in_base", FLANGES), ("obj_in_cam", TARGETS)):
        for i, p in enumerate(poses):
            write("poses/%s_%02d.dat" % (key, i), "# 3D POSE PARAMETERS: rotation and translation\n\n# Used representation type:\nf 0\n\n"
                  "# Rotation angles [deg] or Rodriguez vector:\nr %.10g %.10g %.10g\n\n# Translation vector (x y z [m]):\nt %.10g %.10g %.10g\n"
                  % (*(euler(p, "XYZ") % 360), *p[:3, 3]))
    return ["poses"], SENSOR


def yaskawa():
    lines = ["/JOB", "//NAME HANDEYE", "//POS", "///NPOS %d,0,0,0,0,0" % COUNT, "///TOOL 0", "///POSTYPE ROBOT", "///RECTAN", "///RCONF 0,0,0,0,0,0"]
    lines += ["C%05d=%s" % (i, ",".join("%.5f" % x for x in floats(1000 * p[:3, 3], euler(p)))) for i, p in enumerate(FLANGES)]
    lines += ["//INST", "///DATE 2026/03/01 10:00", "NOP", *("MOVJ C%05d VJ=0.78" % i for i in range(COUNT)), "END", ""]
    return [write("HANDEYE.JBI", "\r\n".join(lines)), quaternions("target.csv", TARGETS)], SENSOR


def kawasaki():
    points = "".join("p%d %s\n" % (i + 1, " ".join("%.6f" % x for x in floats(1000 * p[:3, 3], euler(p, "ZYZ")))) for i, p in enumerate(FLANGES))
    return [write("handeye.as", ".PROGRAM handeye()\n JMOVE p1\n.END\n.TRANS\n" + points + ".END\n"), quaternions("target.csv", TARGETS)], SENSOR


# Recorders.
def echo_as_csv():
    """`ros2 topic echo --csv` of joint states and of a PoseStamped: no header."""
    write("robot.urdf", urdf(JOINTS))
    stamp = lambda i: "%d,%d," % (1700000000 + i, 5000000)
    write("joint_states.csv", "".join("%s,%s\n" % (stamp(i), ",".join([*JOINTS, *("%.9g" % x for x in q), *["0.0"] * 12])) for i, q in enumerate(ANGLES)))
    write("tag.csv", "".join("%scamera,%s\n" % (stamp(i), ",".join("%.9g" % x for x in floats(p[:3, 3], quaternion(p)))) for i, p in enumerate(SEEN)))
    return ["robot.urdf", "joint_states.csv", "tag.csv", "--tcp", "link_6"], HAND


def euroc_truth_and_four_cameras():
    """cam0 ... cam3 and Kalibr's camchain, the flange as EuRoC's ground truth."""
    from_last = [np.eye(4)] + [motion((0.01 * i, 0.03, -0.02), (-0.05, 0.01, 0.002)) for i in range(1, 4)]
    camera = {"camera_model": "pinhole", "intrinsics": [FOCAL, FOCAL, float(K[0, 2]), float(K[1, 2])], "distortion_model": "radtan",
              "distortion_coeffs": [0.0] * 4, "resolution": [WIDTH, HEIGHT]}
    stamps, chain, from_first = [1700000000000000000 + 500000000 * i for i in range(COUNT)], {}, np.eye(4)
    for n in range(4):
        from_first = from_last[n] @ from_first
        charuco_images("dataset/cam%d/%%02d.png" % n, [c @ np.linalg.inv(from_first) for c in CAMERAS])
        for i, stamp in enumerate(stamps):
            os.rename("dataset/cam%d/%02d.png" % (n, i), "dataset/cam%d/%d.png" % (n, stamp))
        chain["cam%d" % n] = {**camera, "rostopic": "/cam%d/image_raw" % n, **({"T_cn_cnm1": lists(from_last[n])} if n else {})}
    write("log-camchain.yaml", yaml.dump(chain))
    flange = table("data.csv", ["#timestamp [ns]", "p_RS_R_x [m]", "p_RS_R_y [m]", "p_RS_R_z [m]", "q_RS_w []", "q_RS_x []", "q_RS_y []", "q_RS_z []"],
                   [[stamp, *floats(p[:3, 3], np.roll(quaternion(p), 1))] for stamp, p in zip(stamps, FLANGES)])
    return ["dataset", "log-camchain.yaml", flange, "--target", CHARUCO], SENSOR


def images_called_by_nanoseconds():
    """A log at 20 Hz beside images that are called by the time at which they were taken."""
    charuco_images("images/%d.png")
    for i in range(COUNT):
        os.rename("images/%d.png" % i, "images/%d.png" % (1700000000500000000 + 2000000000 * i))
    rows = [[1.7e9 + 2 * i + 0.05 * k, *floats([0.1] * 6, p[:3, 3], rotation_vector(p))] for i, p in enumerate(FLANGES) for k in range(20)]
    head = ["timestamp"] + ["actual_q_%d" % i for i in range(6)] + ["actual_TCP_pose_%d" % i for i in range(6)]
    write("robot_data.csv", "\n".join(" ".join(map(str, row)) for row in [head, *rows]) + "\n")
    return ["images", "robot_data.csv", camera_info(), "--target", CHARUCO], SENSOR


def motive_with_markers_and_a_lost_frame():
    """Markers of the body and others beside it, millimetres, and a frame in which nothing was seen: the joints have a row for it."""
    write("robot.urdf", urdf(JOINTS))
    body, markers = "gripper", [(0.05, 0, 0), (0, 0.05, 0), (0, 0, 0.06)]
    of_markers = ["%s:Marker%d" % (body, k + 1) for k in range(3)]
    head = [["Format Version", "1.23", "Take Name", "Take", "Rotation Type", "Quaternion", "Length Units", "Millimeters", "Coordinate Space", "Global"],
            [], ["", "Type"] + ["Rigid Body"] * 8 + ["Rigid Body Marker"] * 12 + ["Marker"] * 9,
            ["", "Name"] + [body] * 8 + [m for m in of_markers for _ in range(4)] + [m for m in of_markers for _ in range(3)], ["", "ID"] + ["5A"] * 29,
            ["", ""] + ["Rotation"] * 4 + ["Position"] * 3 + ["Mean Marker Error"] + (["Position"] * 3 + ["Marker Quality"]) * 3 + ["Position"] * 9,
            ["Frame", "Time (Seconds)"] + ["X", "Y", "Z", "W", "X", "Y", "Z", ""] + ["X", "Y", "Z", ""] * 3 + ["X", "Y", "Z"] * 3]
    rows = []
    for i, p in enumerate(SEEN):
        seen = [floats(1000 * (p @ np.array([*x, 1]))[:3]) for x in markers]
        rows.append([i, i / 120] + ([""] * 29 if i == 7 else [*floats(quaternion(p), 1000 * p[:3, 3]), 0.1, *(x for m in seen for x in (*m, 1.0)),
                                                               *floats(*seen)]))
    table("take.csv", None, head + rows)
    return ["robot.urdf", "take.csv", joint_table(), "--tcp", "link_6"], HAND


def rows_of_nan_beside_joints():
    write("robot.urdf", urdf(JOINTS))
    rows = [["nan"] * 7 if i in (3, 11) else floats(p[:3, 3], quaternion(p)) for i, p in enumerate(SEEN)]
    return ["robot.urdf", table("tag.csv", ["x", "y", "z", "qx", "qy", "qz", "qw"], rows), joint_table(), "--tcp", "link_6"], HAND


# Cameras.
def with_camera(*files, images="images/%d.png"):
    charuco_images(images)
    return ["images", *files, quaternions("flange.csv", FLANGES), "--target", CHARUCO], SENSOR


def matrix_of_savetxt():
    np.savetxt("K.txt", K)
    return with_camera("K.txt")


def matrix_and_lens_of_savetxt():
    np.savetxt("K.txt", K)
    np.savetxt("dist.txt", np.zeros((1, 5)))
    return with_camera("K.txt", "dist.txt")


def lists_of_a_tutorial():
    return with_camera(write("calibration_matrix.yaml", yaml.dump({"camera_matrix": lists(K), "dist_coeff": [[0.0] * 5]})))


def zed():
    return with_camera(write("zed.yaml", "# ZED SDK rectified LEFT intrinsics\nimage_width: %d\nimage_height: %d\nfx: %g\nfy: %g\ncx: %g\ncy: %g\n"
                             "distortion:\n%scamera_serial: 49953548\ncamera_model: ZED X\n" % (WIDTH, HEIGHT, FOCAL, FOCAL, K[0, 2], K[1, 2], "- 0.0\n" * 12)))


def orb_slam():
    return with_camera(write("TUM1.yaml", '%%YAML:1.0\n\nCamera.type: "PinHole"\nCamera.fx: %g\nCamera.fy: %g\nCamera.cx: %g\nCamera.cy: %g\n'
                             "Camera.k1: 0.0\nCamera.k2: 0.0\nCamera.p1: 0.0\nCamera.p2: 0.0\n\nCamera.width: %d\nCamera.height: %d\nCamera.fps: 30.0\n"
                             % (FOCAL, FOCAL, K[0, 2], K[1, 2], WIDTH, HEIGHT)))


def opencv_in_xml():
    storage = cv2.FileStorage("camera.xml", cv2.FILE_STORAGE_WRITE)
    for name, value in (("Camera_Matrix", K), ("Distortion_Coefficients", np.zeros((5, 1))), ("image_Width", WIDTH), ("image_Height", HEIGHT)):
        storage.write(name, value)
    storage.release()
    return with_camera("camera.xml")


# What is not read, or wrong.
def a_pickle():
    with open("dataset.pkl", "wb") as file:
        pickle.dump({"robot": FLANGES}, file)
    return ["dataset.pkl"], told("pickle", "CSV")


def a_json_of_something_else():
    """Beside what is read: left out and named, not taken for a calibration."""
    write("all/results.json", json.dumps({"experiment": 7, "operator": "me"}))
    quaternions(write("all/flange.csv", ""), FLANGES)
    quaternions(write("all/target.csv", ""), TARGETS)
    return ["all"], lambda made: (SENSOR(made)[0] and "results.json" in made.stderr, made.stderr.strip().split("\n")[0])


def square_without_a_unit():
    """22 for 22 mm beside rotation vectors: the unit is the cause, not the angles."""
    chessboard_images("images/%d.png")
    flange = table("poses.csv", ["x", "y", "z", "rx", "ry", "rz"], [floats(p[:3, 3], rotation_vector(p)) for p in FLANGES])
    return ["images", camera_info(), flange, "--target", "chessboard columns=7 rows=5 square=20"], told("square=20mm", "millimetres")


def angles_said_wrongly():
    """--angles that do not suit: the reading that does is named."""
    flange = table("flange.csv", ["x", "y", "z", "rx", "ry", "rz"], [floats(p[:3, 3], rotation_vector(p)) for p in FLANGES])
    return ([flange, quaternions("target.csv", TARGETS), "--angles", "rpy"],
            lambda made: (made.returncode == 0 and "As --angles has it" in made.stderr and "rotation vectors" in made.stderr, made.stderr))


def a_hand_that_the_robot_has_not():
    write("arm.urdf", urdf(JOINTS))
    return ["arm.urdf", joint_table(), quaternions("target.csv", SEEN), "--tcp", "flange"], told('--tcp "flange"', "link_6")


CASES = [json_a_sample, rotations_and_places_in_yaml, lists_for_calibrate_hand_eye, pairs_within_a_log,
         pairs_without_a_name_are_asked_for, pairs_whose_target_is_named, arrays_as_python_prints_them, zivid, halcon, yaskawa, kawasaki,
         echo_as_csv, euroc_truth_and_four_cameras, images_called_by_nanoseconds, motive_with_markers_and_a_lost_frame,
         rows_of_nan_beside_joints, matrix_of_savetxt, matrix_and_lens_of_savetxt, lists_of_a_tutorial, zed, orb_slam, opencv_in_xml, a_pickle,
         a_json_of_something_else, square_without_a_unit, angles_said_wrongly, a_hand_that_the_robot_has_not]

sys.exit(run_cases(CASES))
