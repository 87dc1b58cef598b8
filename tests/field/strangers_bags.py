#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bags as drivers record them, written by rosbag: a RealSense with its three cameras, two hands whose tags are called by
their numbers, compressed images of a wrist camera, a detector's topic of poses.

strangers_bags.py HANDSIGHT_CLI [NAME ...]: a line for each, with what was said (-v: all of it); exit code 1 where one does not
come to its right value or to a sentence that says what to do; 77 where the writers are not installed."""
import json
import math
import os
import sys

try:
    import cv2
    import genpy
    import numpy as np
    import rosbag
    from geometry_msgs.msg import Pose, PoseArray, PoseStamped, TransformStamped
    from sensor_msgs.msg import CameraInfo, CompressedImage, Image, JointState
    from std_msgs.msg import String
    from tf2_msgs.msg import TFMessage
    cv2.aruco.CharucoBoard_create  # of the OpenCV of Debian 12
except (ImportError, AttributeError) as missing:
    print("not installed: %s" % missing)
    sys.exit(77)

sys.dont_write_bytecode = True  # nothing is written beside the sources
from field_runner import pose, run, run_cases
from field_scene import (ANGLES, CAMERA, CAMERAS, FLANGES, FOCAL, HEIGHT, JOINTS, K, MIDDLE, SEEN, TAG, WIDTH, hand, motion,
                         photographed, quaternion, urdf)

HAND = pose("tcp_from_body", TAG)
CHARUCO = "charuco columns=7 rows=5 square=26mm marker=19mm dictionary=DICT_5X5_100"
DRAWN = cv2.aruco.CharucoBoard_create(7, 5, 0.026, 0.019, cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_5X5_100)).draw((1400, 1000))
GRIP = motion((0.1, 0.05, 0.4), (-0.05, -0.04, 0.06))  # tcp_from_board


def stamped(message, seconds, frame):
    message.header.stamp, message.header.frame_id = genpy.Time.from_sec(seconds), frame
    return message


def write(bag, topic, message, seconds):
    bag.write(topic, message, genpy.Time.from_sec(seconds))


def fill(place, turn, p):
    place.x, place.y, place.z = p[:3, 3]
    turn.x, turn.y, turn.z, turn.w = quaternion(p)


def write_frame(bag, parent, child, p, seconds):
    transform = stamped(TransformStamped(child_frame_id=child), seconds, parent)
    fill(transform.transform.translation, transform.transform.rotation, p)
    write(bag, "/tf", TFMessage([transform]), seconds)


def info(seconds, frame, p3=0.0):
    return stamped(CameraInfo(width=WIDTH, height=HEIGHT, distortion_model="plumb_bob", D=[0.0] * 5, K=list(K.ravel()), R=list(np.eye(3).ravel()),
                              P=[FOCAL, 0, K[0, 2], p3, 0, FOCAL, K[1, 2], 0, 0, 0, 1, 0]), seconds, frame)


def write_image(bag, camera, topic, frame, picture, seconds, p3=0.0):
    image = Image(height=HEIGHT, width=WIDTH, encoding="mono8", step=WIDTH, data=picture.tobytes())
    write(bag, "%s/%s" % (camera, topic), stamped(image, seconds, frame), seconds)
    write(bag, camera + "/camera_info", info(seconds, frame, p3), seconds)


def drive(bag, names, rows):
    """The robot stands for a second of three in each of these poses. The times in the middle of the standstills."""
    for i, q in enumerate(rows):
        to = rows[min(i + 1, len(rows) - 1)]
        for k in range(60):
            seconds = 100 + 3 * i + 0.05 * k
            write(bag, "/joint_states", stamped(JointState(name=names, position=list(q + max(0.0, (k - 20) / 40) * (to - q))), seconds, ""), seconds)
    return [100 + 3 * i + 0.5 for i in range(len(rows))]


def before_a_stand(count):
    """A stand, and readings with which the board in the hand is in its view."""
    first = np.array([0.0, 0.3, -0.5, 0.1, 0.4, 0.0])
    stand = hand(first) @ GRIP @ motion((math.pi, 0, 0), (0.09, 0.065, 0.45)) @ motion((0.1, -0.05, 0.2), (0, 0, 0))
    random, rows = np.random.default_rng(5), []
    while len(rows) < count:
        q = first + random.uniform(-0.3, 0.3, 6)
        x, y, z, _ = np.linalg.inv(stand) @ hand(q) @ GRIP @ np.array([0.09, 0.065, 0, 1])
        if abs(x / z) < 0.3 and abs(y / z) < 0.2 and 0.3 < z < 0.6:
            rows.append(q)
    return stand, rows


def realsense():
    """infra1 and infra2 are a pair, colour is a camera of its own, depth is none."""
    stand, rows = before_a_stand(12)
    cameras = {"infra1": (np.eye(4), 0.0), "infra2": (motion((0, 0, 0), (-0.05, 0, 0)), -FOCAL * 0.05), "color": (motion((0, 0.01, 0), (-0.015, 0, 0)), 0.0)}
    with rosbag.Bag("d435.bag", "w", compression="lz4") as bag:
        write(bag, "/robot_description", String(urdf(JOINTS)), 99)
        for seconds, q in zip(drive(bag, JOINTS, rows), rows):
            for name, (from_first, p3) in cameras.items():
                picture = photographed(DRAWN, 7 * 0.026, stand @ np.linalg.inv(from_first), base_from_board=hand(q) @ GRIP)
                write_image(bag, "/camera/" + name, "image_raw" if name == "color" else "image_rect_raw", "camera_%s_optical_frame" % name, picture, seconds, p3)
            write_image(bag, "/camera/depth", "image_rect_raw", "camera_depth_optical_frame", np.zeros((HEIGHT, WIDTH), np.uint8), seconds)
    return ["d435.bag", "--tcp", "link_6"]


def realsense_with_its_board():
    def judge(made):
        if made.returncode:
            return False, made.stderr.strip().split("\n")[-1]
        fitted = run("fit", "session", "--json", "-")
        sessions = json.loads(fitted.stdout)["sessions"] if fitted.returncode == 0 else []
        away = [float(np.linalg.norm(np.array(s["mount"]["matrix"])[:3, 3] - STAND[:3, 3])) for s in sessions if s.get("mount")]
        return len(sessions) == 2 and "color" in made.stdout + made.stderr, "%d sessions, %s" % (len(sessions), made.stderr.split("\n")[0])
    STAND, _ = before_a_stand(1)
    return [*realsense(), "--target", CHARUCO], judge


def realsense_without_a_target():
    """The pair alone is taken, and the other camera is told."""
    return realsense(), lambda made: (made.returncode == 0 and "/camera/color/image_raw" in made.stderr and "2 cameras" in made.stdout, made.stderr)


def two_arms():
    def arm(side, y):
        text = urdf(["%s_joint_%d" % (side, i) for i in range(1, 7)]).split("\n", 1)[1].replace("</robot>", "")
        for link in ["base_link"] + ["link_%d" % i for i in range(1, 7)]:
            text = text.replace('"%s"' % link, '"%s_%s"' % (side, link))
        return text + ('<joint name="%s_mount" type="fixed"><parent link="torso"/><child link="%s_base_link"/><origin xyz="0 %g 0"/></joint>\n'
                       % (side, side, y))
    return '<robot name="two"><link name="torso"/>\n%s%s</robot>' % (arm("left", 0.3), arm("right", -0.3))


def two_hands(tags_move=True):
    """Two arms and two tags before one camera; the tags are called by their numbers."""
    random, camera = np.random.default_rng(3), motion((2.2, 0.1, -0.6), (1.2, 0.5, 0.9))
    rows = [np.concatenate([MIDDLE, MIDDLE]) + random.uniform(-0.9, 0.9, 12) for _ in range(25)]
    grips = {"tag_3": (slice(6, 12), -0.3, motion((0.1, 0.3, -0.5), (-0.03, 0.04, 0.12))), "tag_8": (slice(0, 6), 0.3, TAG)}
    with rosbag.Bag("both.bag", "w") as bag:
        write(bag, "/robot_description", String(two_arms()), 99)
        for seconds, q in zip(drive(bag, ["%s_joint_%d" % (s, i) for s in ("left", "right") for i in range(1, 7)], rows), rows):
            for name, (own, y, grip) in grips.items():
                at = motion((0, 0, 0), (0, y, 0)) @ hand(q[own] if tags_move else MIDDLE) @ grip
                write_frame(bag, "camera_optical_frame", name, np.linalg.inv(camera) @ at, seconds)
    return ["both.bag", "--tcp", "left_link_6", "--tcp", "right_link_6"]


def two_hands_whose_tags_are_numbers():
    def judge(made):
        said = made.stdout + made.stderr
        fitted = run("fit", "session", "--json", "-") if made.returncode == 0 else made
        if fitted.returncode:
            return False, said.strip().split("\n")[-1]
        found = [np.array(s["tcp_from_body"]["matrix"])[:3, 3] for s in json.loads(fitted.stdout)["sessions"]]
        away = float(np.linalg.norm(found[0] - TAG[:3, 3]))
        return away < 3e-4 and "tag_8 moves with left_link_6" in said, "%.3f mm off, %s" % (1e3 * away, made.stderr.split("\n")[0])
    return two_hands(), judge


def two_hands_of_which_nobody_can_tell():
    """Tags that stand while both arms move: the sentence names the option."""
    return two_hands(tags_move=False), lambda made: (made.returncode == 2 and "--target-frame, once for each --tcp" in made.stderr, made.stderr.strip())


def topic_of_poses(topic, message_of):
    with rosbag.Bag("aruco.bag", "w") as bag:
        write(bag, "/robot_description", String(urdf(JOINTS)), 99)
        for seconds, p in zip(drive(bag, JOINTS, ANGLES), SEEN):
            write(bag, topic, message_of(seconds, p), seconds)
    return ["aruco.bag", "--tcp", "link_6"]


def poses_of_aruco_ros():
    def message(seconds, p):
        m = stamped(PoseStamped(), seconds, "camera")
        fill(m.pose.position, m.pose.orientation, p)
        return m
    return topic_of_poses("/aruco_single/pose", message), HAND


def array(seconds, poses):
    m = stamped(PoseArray(poses=[Pose() for _ in poses]), seconds, "camera")
    for one, p in zip(m.poses, poses):
        fill(one.position, one.orientation, p)
    return m


def arrays_of_one_pose():
    """A detector's PoseArray with the one tag that is there, and empty ones where it is not seen."""
    return topic_of_poses("/aruco_poses", lambda seconds, p: array(seconds, [p])), HAND


def arrays_of_two_poses():
    """Nothing says that their order stays: asked for by its place it is taken."""
    aside = motion((0, 0, 0.4), (0.3, 0, 0))
    named = topic_of_poses("/aruco_poses", lambda seconds, p: array(seconds, [aside, p]))
    return [*named, "--target-frame", "/aruco_poses[1]"], HAND


def arrays_of_one_or_two_poses():
    """Which is which nothing tells: the sentence says so, and what to record."""
    def message(seconds, p):
        return array(seconds, [p, motion((0, 0, 0.4), (0.3, 0, 0))][:1 + int(seconds) % 2])
    return (topic_of_poses("/aruco_poses", message),
            lambda made: (made.returncode == 2 and "holds 1 to 2 poses a message" in made.stderr, made.stderr.strip()))


def compressed_images_of_a_wrist_camera():
    with rosbag.Bag("wrist.bag", "w") as bag:
        for i, (flange, camera) in enumerate(zip(FLANGES, CAMERAS)):
            for k in range(20):
                write_frame(bag, "base", "tool0", flange, 100 + 2 * i + 0.05 * k)
            seconds, frame = 100 + 2 * i + 0.5, "camera_color_optical_frame"
            picture = cv2.imencode(".jpg", photographed(DRAWN, 7 * 0.026, camera), [cv2.IMWRITE_JPEG_QUALITY, 97])[1]
            write(bag, "/camera/color/image_raw/compressed", stamped(CompressedImage(format="jpeg", data=picture.tobytes()), seconds, frame), seconds)
            write(bag, "/camera/color/camera_info", info(seconds, frame), seconds)
    return ["wrist.bag", "--target", CHARUCO], pose("mount_from_", CAMERA)


CASES = [realsense_with_its_board, realsense_without_a_target, two_hands_whose_tags_are_numbers, two_hands_of_which_nobody_can_tell,
         poses_of_aruco_ros, arrays_of_one_pose, arrays_of_two_poses,
         arrays_of_one_or_two_poses, compressed_images_of_a_wrist_camera]

sys.exit(run_cases(CASES))
