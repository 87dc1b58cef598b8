# SPDX-License-Identifier: Apache-2.0
"""A known scene for recordings of strangers: a camera on a flange over a board, a robot of six joints before a sensor, and
their files in other programs' words. Nothing of Handsight is used: turns by SciPy and OpenCV, images by OpenCV."""
import csv
import math
import os

import cv2
import numpy as np
from scipy.spatial.transform import Rotation

COUNT = 18
WIDTH, HEIGHT, FOCAL = 800, 600, 620.0
K = np.array([[FOCAL, 0, 402.0], [0, FOCAL, 297.0], [0, 0, 1]])
RANDOM = np.random.default_rng(11)


def motion(turn, place):
    m = np.eye(4)
    m[:3, :3] = Rotation.from_euler("xyz", turn).as_matrix()
    m[:3, 3] = place
    return m


CAMERA = motion((0.02, -0.05, 1.5), (0.06, -0.03, 0.05))  # flange_from_camera
BOARD = motion((0.03, 0.02, 0.5), (0.55, 0.08, 0.01))  # base_from_board
STAND = motion((2.2, 0.1, -0.6), (1.2, 0.5, 0.9))  # base_from_sensor of recordings with a robot
TAG = motion((0.3, -0.2, 0.9), (0.02, 0.05, 0.1))  # tcp_from_target of them


def looking(i):
    """base_from_camera above the board's middle, tilted."""
    far = 0.34 + 0.06 * (i % 3)
    tilt = motion((0.45 * math.sin(2.4 * i), 0.45 * math.cos(1.7 * i), 0.9 * math.sin(1.1 * i)), (0, 0, 0))
    back = np.eye(4)
    back[2, 3] = -far
    middle = np.eye(4)
    middle[:3, 3] = (0.09, 0.06, 0)
    return BOARD @ middle @ motion((math.pi, 0, 0), (0, 0, 0)) @ tilt @ back


CAMERAS = [looking(i) for i in range(COUNT)]
FLANGES = [c @ np.linalg.inv(CAMERA) for c in CAMERAS]
TARGETS = [np.linalg.inv(c) @ BOARD for c in CAMERAS]

# A robot of six joints.
ORIGINS = [((0, 0, 0), (0, 0, 0.3)), ((-math.pi / 2, 0, 0), (0.05, 0, 0.1)), ((0, 0, 0), (0, -0.4, 0)),
           ((math.pi / 2, 0, 0), (0, -0.35, 0.02)), ((-math.pi / 2, 0, 0), (0, 0, 0.1)), ((math.pi / 2, 0, 0), (0, 0.08, 0))]
MIDDLE = np.array([0.0, 0.3, -0.5, 0.1, 0.4, 0.0])
ANGLES = [MIDDLE + RANDOM.uniform(-0.9, 0.9, 6) for _ in range(40)]
JOINTS = ["joint_%d" % i for i in range(1, 7)]


def urdf(names):
    links = "".join('<link name="%s"><inertial><origin xyz="0 0 0.05"/><mass value="%g"/><inertia ixx="0.01" ixy="0" ixz="0" '
                    'iyy="0.01" iyz="0" izz="0.01"/></inertial></link>\n' % (n, 4 - 0.5 * i)
                    for i, n in enumerate(["base_link"] + ["link_%d" % i for i in range(1, 7)]))
    joints = "".join('<joint name="%s" type="revolute"><parent link="%s"/><child link="link_%d"/><origin rpy="%.17g %.17g %.17g" '
                     'xyz="%g %g %g"/><axis xyz="0 0 1"/><limit lower="-3.1" upper="3.1" effort="50" velocity="2"/></joint>\n'
                     % (n, "link_%d" % i if i else "base_link", i + 1, *ORIGINS[i][0], *ORIGINS[i][1])
                     for i, n in enumerate(names))
    return '<robot name="stranger">\n%s%s</robot>\n' % (links, joints)


def hand(q):
    m = np.eye(4)
    for (turn, place), angle in zip(ORIGINS, q):
        m = m @ motion(turn, place) @ motion((0, 0, angle), (0, 0, 0))
    return m


SEEN = [np.linalg.inv(STAND) @ hand(q) @ TAG for q in ANGLES]


def quaternion(m):
    return Rotation.from_matrix(m[:3, :3]).as_quat()  # x y z w


def rotation_vector(m):
    return cv2.Rodrigues(m[:3, :3])[0][:, 0]


def write(name, text):
    os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
    with open(name, "w", newline="") as file:
        file.write(text)
    return name


def table(name, header, rows, delimiter=","):
    with open(name, "w", newline="") as file:
        out = csv.writer(file, delimiter=delimiter)
        if header:
            out.writerow(header)
        out.writerows([["%.9g" % x if isinstance(x, float) else x for x in row] for row in rows])
    return name


def quaternions(name, poses):
    return table(name, ["x", "y", "z", "qx", "qy", "qz", "qw"], [[*map(float, (*p[:3, 3], *quaternion(p)))] for p in poses])


def joint_table(name="joints.csv"):
    return table(name, JOINTS, [[*map(float, q)] for q in ANGLES])


def photographed(board, metres, base_from_camera, focal=K, base_from_board=BOARD):
    """The printed board (an image, so many metres wide) as a camera sees it; three samples a pixel each way."""
    fine = 3
    to_fine = np.array([[fine, 0, (fine - 1) / 2], [0, fine, (fine - 1) / 2], [0, 0, 1]])
    scale = metres / board.shape[1]
    camera_from_board = np.linalg.inv(base_from_camera) @ base_from_board
    to_metres = np.array([[scale, 0, scale / 2], [0, -scale, (board.shape[0] - 0.5) * scale], [0, 0, 1]])  # y is up
    plane = camera_from_board[:3, [0, 1, 3]]
    large = cv2.warpPerspective(board, to_fine @ focal @ plane @ to_metres, (fine * WIDTH, fine * HEIGHT), flags=cv2.INTER_AREA,
                                borderMode=cv2.BORDER_CONSTANT, borderValue=190)
    return cv2.GaussianBlur(cv2.resize(large, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA), (0, 0), 0.6)


def chessboard(columns, rows, square=60):
    tiles = (np.add.outer(np.arange(rows + 1), np.arange(columns + 1)) % 2) * 255
    return cv2.copyMakeBorder(np.kron(tiles, np.ones((square, square))).astype(np.uint8), square, square, square, square,
                              cv2.BORDER_CONSTANT, value=255)
