#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Robots as users have them, in the manner of well-known makers (their quirks, not their text), and calibration files of
each format: each must become a session that `check` accepts, or a sentence that a newcomer understands.

bring_what_you_have.py HANDSIGHT_CLI: prints a line for each; exit code 1 where one is neither."""
import math
import os
import random
import re
import subprocess
import sys
import tempfile

CLI = sys.argv[1]
FAILED = []


def link(name, mass=1.0, mesh=None, inertial=True):
    parts = '<inertial><origin xyz="0.01 0 0.05" rpy="0 0 0"/><mass value="%g"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" ' \
            'iyz="0" izz="1"/></inertial>' % mass if inertial else ""
    if mesh:
        parts += '<visual><geometry><mesh filename="%s"/></geometry></visual>' % mesh
    return '<link name="%s">%s</link>' % (name, parts)


def joint(name, parent, child, xyz="0 0 0.2", rpy="0 0 0", axis="0 0 1", kind="revolute", limit='lower="-2.8" upper="2.8"',
          more=""):
    limits = '<limit %s effort="87" velocity="2"/>' % limit if limit and kind in ("revolute", "prismatic") else ""
    moves = '<axis xyz="%s"/>' % axis if kind != "fixed" else ""
    return '<joint name="%s" type="%s"><parent link="%s"/><child link="%s"/><origin xyz="%s" rpy="%s"/>%s%s%s</joint>' % (
        name, kind, parent, child, xyz, rpy, moves, limits, more)


def arm(prefix="joint", links="link", count=6, mesh=None, masses=True, limit='lower="-2.8" upper="2.8"', root="base_link"):
    parts = [link(root, 4.0, mesh, masses)]
    before = root
    for i in range(1, count + 1):
        name = "%s_%d" % (links, i)
        parts.append(link(name, 3.0 / i, mesh, masses))
        parts.append(joint("%s_%d" % (prefix, i), before, name, xyz="0 %g 0.2" % (0.05 * (i % 2)),
                           rpy="%g 0 0" % (math.pi / 2 * (-1) ** i if i > 1 else 0), limit=limit))
        before = name
    return parts, before


def robot(parts, name="robot", attributes=""):
    return '<?xml version="1.0"?>\n<robot name="%s"%s>\n%s\n</robot>\n' % (name, attributes, "\n".join(parts))


def universal():
    """Names with the arm's letter, meshes by package://, safety and transmission blocks, a tool0 frame on fixed joints."""
    parts, last = arm("shoulder", "ur_link", 6, "package://maker_description/meshes/base.dae")
    parts += [link("flange", inertial=False), joint("wrist-flange", last, "flange", kind="fixed", xyz="0 0 0"),
              link("tool0", inertial=False), joint("flange-tool0", "flange", "tool0", kind="fixed", rpy="1.57 0 1.57"),
              '<transmission name="t1"><type>simple</type><joint name="shoulder_1"/></transmission>',
              '<gazebo reference="flange"><selfCollide>true</selfCollide></gazebo>']
    return robot(parts), "tool0", ["shoulder_%d" % i for i in range(1, 7)]


def panda():
    """Seven joints, fingers of which one mimics the other, safety controllers, no masses at all."""
    parts, last = arm("panda_joint", "panda_link", 7, "package://panda/meshes/link0.stl", masses=False)
    parts += [link("panda_hand", inertial=False), joint("hand_joint", last, "panda_hand", kind="fixed", rpy="0 0 -0.785"),
              link("left_finger", inertial=False), link("right_finger", inertial=False),
              joint("finger_1", "panda_hand", "left_finger", kind="prismatic", axis="0 1 0", limit='lower="0" upper="0.04"'),
              joint("finger_2", "panda_hand", "right_finger", kind="prismatic", axis="0 -1 0", limit='lower="0" upper="0.04"',
                    more='<mimic joint="finger_1"/>')]
    return robot(parts, "panda"), "panda_hand", ["panda_joint_%d" % i for i in range(1, 8)]


def kinova():
    """Continuous joints without limits; the root is called world."""
    parts, last = arm("Actuator", "Segment", 7, limit="", root="base")
    text = "\n".join(parts).replace('type="revolute"', 'type="continuous"')
    parts = ['<link name="world"/>', joint("world_joint", "world", "base", kind="fixed", xyz="0 0 0"), text]
    return robot(parts, "gen3"), last, ["Actuator_%d" % i for i in range(1, 8)]


def hobby():
    """SO-101: five joints and a gripper, meshes beside the file, masses of grams, joints called 1 to 6."""
    parts, last = arm("j", "part", 5, "assets/part.stl")
    text = "\n".join(parts).replace('name="j_', 'name="')
    parts = [text, link("moving_jaw", 0.02), joint("6", last, "moving_jaw", limit='lower="-0.17" upper="1.7"')]
    return robot(parts, "so101"), last, [str(i) for i in range(1, 6)]


def fetch():
    """Wheels, a lifting torso, head and arm in one tree; the camera is on the head."""
    parts, last = arm("arm", "arm_link", 7, root="torso_lift_link")
    parts = [link("base_link", 70), joint("torso_lift", "base_link", "torso_lift_link", kind="prismatic", axis="0 0 1",
                                          limit='lower="0" upper="0.38"')] + parts
    for side in "lr":
        parts += [link("%s_wheel" % side), joint("%s_wheel_joint" % side, "base_link", "%s_wheel" % side, kind="continuous")]
    parts += [link("head_pan_link"), joint("head_pan", "torso_lift_link", "head_pan_link"), link("head_tilt_link"),
              joint("head_tilt", "head_pan_link", "head_tilt_link", axis="0 1 0")]
    return robot(parts, "fetch"), last, ["torso_lift", "head_pan", "head_tilt"] + ["arm_%d" % i for i in range(1, 8)]


def tiago():
    """A planar base joint at the root, limits that are missing on one joint, file:// meshes."""
    parts, last = arm("arm", "arm_link", 7, "file:///opt/robots/mesh.obj", root="base_footprint")
    parts = ['<link name="odom"/>', joint("base_planar", "odom", "base_footprint", kind="planar", xyz="0 0 0")] + parts
    text = robot(parts, "tiago")
    return text.replace('<limit lower="-2.8" upper="2.8" effort="87" velocity="2"/>', "", 1), last, [
        "arm_%d" % i for i in range(1, 8)]


def nao():
    """A floating root, names in CamelCase, several chains, tiny masses, a mimic with an offset."""
    parts, last = arm("RArm", "RArmLink", 5, root="torso")
    parts = ['<link name="world"/>', joint("floating_base", "world", "torso", kind="floating", xyz="0 0 0.3")] + parts
    parts += [link("Head", 0.4), joint("HeadYaw", "torso", "Head", limit='lower="-2" upper="2"'),
              link("RHand", 0.1), joint("RHandJoint", last, "RHand", limit='lower="0" upper="1"'),
              link("RFinger", 0.01), joint("RFingerJoint", "RHand", "RFinger", limit="",
                                           more='<mimic joint="RHandJoint" multiplier="0.999" offset="0.05"/>')]
    return robot(parts, "nao"), "RHand", ["HeadYaw", "RHandJoint"] + ["RArm_%d" % i for i in range(1, 6)]


def old_exporter():
    """Written by a drawing program: Latin-1 umlauts, huge limits for none, zero axes of fixed joints, CRLF line ends."""
    parts, last = arm("Achse", "Glied", 6, limit='lower="-1e+16" upper="1e+16"')
    parts += ['<link name="Greifer"/>',
              '<joint name="fest" type="fixed"><parent link="%s"/><child link="Greifer"/><axis xyz="0 0 0"/></joint>' % last]
    return robot(parts, "Gerät").replace("\n", "\r\n"), "Greifer", ["Achse_%d" % i for i in range(1, 7)]


def xacro():
    parts, last = arm()
    return robot(parts + ['<xacro:include filename="$(find maker)/tool.xacro"/>'], "x",
                 ' xmlns:xacro="http://www.ros.org/wiki/xacro"'), last, []


def xacro_arguments():
    parts, last = arm()
    return robot(parts).replace('name="joint_1"', 'name="${prefix}joint_1"'), last, []


def two_roots():
    parts, last = arm()
    return robot(parts + [link("table")]), last, ["joint_%d" % i for i in range(1, 7)]


def simulator():
    return "<sdf version='1.7'><model name='arm'/></sdf>", "hand", []


def write(folder, name, text, encoding="utf-8"):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(text.encode(encoding))
    return path


def run(*arguments):
    return subprocess.run([CLI] + list(arguments), capture_output=True, text=True)


def judge(name, converted, out, refusal=None):
    """A session that check accepts, or one sentence; where `refusal` is given, one with these words."""
    sentence = converted.stderr.strip().split("\n")[-1] if converted.returncode else ""
    if converted.returncode == 0:
        checked = run("check", out)
        good = checked.returncode == 0 and refusal is None
        said = "a session that check accepts" if checked.returncode == 0 else "check: " + checked.stderr.strip()
    else:
        good = converted.returncode == 2 and 20 <= len(sentence) <= 600 and refusal is not None and \
            all(re.search(word, sentence) for word in refusal)
        said = "refused: " + sentence
    print("%-4s %-28s %s" % ("ok" if good else "FAIL", name, said))
    if not good:
        FAILED.append(name)
        print(converted.stdout + converted.stderr)


def tables(folder, joints):
    random.seed(1)
    rows, points = [",".join(joints)], ["x,y,z"]
    for _ in range(12):
        rows.append(",".join("%.4f" % random.uniform(0.0, 0.3) for _ in joints))
        points.append("%.4f,%.4f,%.4f" % (1 + random.random(), random.random(), random.random()))
    return write(folder, "joints.csv", "\n".join(rows) + "\n"), write(folder, "points.csv", "\n".join(points) + "\n")


def robots(folder):
    for make, refusal in ((universal, None), (panda, None), (kinova, None), (hobby, None), (fetch, None), (tiago, None),
                          (nao, None), (old_exporter, None), (xacro, ["xacro", "robot.urdf"]),
                          (xacro_arguments, ["xacro"]), (two_roots, ["root links", "table"]), (simulator, ["SDF", "URDF"])):
        place = os.path.join(folder, make.__name__)
        text, tcp, joints = make()
        urdf = write(place, "robot.urdf", text, "latin-1" if make is old_exporter else "utf-8")
        joint_table, point_table = tables(place, joints or ["joint_1", "joint_2"])
        out = os.path.join(place, "session")
        judge(make.__name__, run("convert", urdf, joint_table, point_table, "--tcp", tcp, "--out", out), out, refusal)


OPENCV = """%YAML:1.0
---
image_width: 8
image_height: 6
M1: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 10., 0., 4., 0., 10., 3., 0., 0., 1. ]
M2: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 10., 0., 4., 0., 10., 3., 0., 0., 1. ]
R: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]
T: !!opencv-matrix
   rows: 3
   cols: 1
   dt: d
   data: [ -0.12, 0., 0. ]
"""
INFO = """image_width: 8
image_height: 6
camera_name: %s
camera_matrix: {rows: 3, cols: 3, data: [10, 0, 4, 0, 10, 3, 0, 0, 1]}
distortion_model: %s
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [10, 0, 4, %s, 0, 10, 3, 0, 0, 0, 1, 0]}
"""
KALIBR = """cam0:
  camera_model: %s
  intrinsics: [10, 10, 4, 3]
  distortion_model: radtan
  distortion_coeffs: [0, 0, 0, 0]
  resolution: [8, 6]
cam1:
  camera_model: %s
  intrinsics: [10, 10, 4, 3]
  distortion_model: radtan
  distortion_coeffs: [0, 0, 0, 0]
  resolution: [8, 6]
  T_cn_cnm1: [[1, 0, 0, -0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
"""


def calibrations(folder):
    parts, tcp = arm()
    urdf = write(folder, "robot.urdf", robot(parts))
    joints = ["joint_%d" % i for i in range(1, 7)]
    table = write(folder, "joints.csv", ",".join(joints) + "\n" + "\n".join(
        ",".join("%.3f" % (0.1 * (i + j) % 1.3) for j in range(6)) for i in range(3)) + "\n")
    for side in ("left", "right"):
        for i in range(3):
            write(folder, "%s/frame_%04d.pgm" % (side, i), "P5\n8 6\n255\n" + "x" * 48)
    images = [os.path.join(folder, side) for side in ("left", "right")]
    one = lambda name, text: write(folder, name, text)
    for name, files, refusal in (
            ("opencv yaml", [one("stereo.yml", OPENCV)], None),
            ("opencv in mm", [one("mm.yml", OPENCV.replace("-0.12", "-120."))], None),
            ("opencv without R", [one("half.yml", OPENCV.replace("\nR:", "\nE:"))], ["R and T of camera 2"]),
            ("ros camera_info pair", [one("l.yaml", INFO % ("left", "plumb_bob", "0")),
                                      one("r.yaml", INFO % ("right", "plumb_bob", "-1.2"))], None),
            ("ros fisheye", [one("lf.yaml", INFO % ("left", "equidistant", "0")), one("rf.yaml", INFO % ("right", "plumb_bob", "-1"))],
             None),
            ("ros thin prism", [one("lp.yaml", INFO % ("left", "thin_prism", "0")), one("rp.yaml", INFO % ("right", "plumb_bob", "-1"))],
             ["thin_prism", "plumb_bob"]),
            ("one camera", [one("only.yaml", INFO % ("left", "plumb_bob", "0"))], ["1 camera", "--target"]),
            ("kalibr camchain", [one("camchain.yaml", KALIBR % ("pinhole", "pinhole"))], None),
            ("kalibr omni", [one("omni.yaml", KALIBR % ("omni", "pinhole"))], ["omni"]),
            ("no calibration", [], ["no calibration"]),
            ("broken yaml", [one("broken.yaml", "cam0: [1, 2\nfoo: {")], ["no YAML"])):
        out = os.path.join(folder, "session_" + name.replace(" ", "_"))
        judge(name, run("convert", *images, table, *files, "--robot", urdf, "--tcp", tcp, "--out", out), out, refusal)


def samples(folder):
    def pose(t, q):
        return "    translation: {x: %g, y: %g, z: %g}\n    rotation: {x: %g, y: %g, z: %g, w: %g}\n" % (*t, *q)
    random.seed(2)
    text = "parameters:\n  calibration_type: eye_in_hand\nsamples:\n"
    for i in range(8):
        a = [random.gauss(0, 1) for _ in range(4)]
        n = math.sqrt(sum(x * x for x in a))
        q = [x / n for x in a]
        text += "- robot:\n" + pose((0.3 + 0.05 * i, 0.1, 0.4), q) + "  tracking:\n" + pose((0.1, 0.05 * i, 0.6), q)
    out = os.path.join(folder, "hand_eye")
    judge("easy_handeye samples", run("convert", write(folder, "a.samples", text), "--out", out), out)
    bad = text.replace("w: ", "w: 5", 1)
    judge("a broken quaternion", run("convert", write(folder, "b.samples", bad), "--out", out + "2"), out + "2", ["unit quaternion"])


with tempfile.TemporaryDirectory() as place:
    robots(os.path.join(place, "robots"))
    calibrations(os.path.join(place, "calibrations"))
    samples(os.path.join(place, "samples"))
print("%d failed" % len(FAILED))
sys.exit(1 if FAILED else 0)
