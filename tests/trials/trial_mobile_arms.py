#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A mobile robot with two arms, in the manner of TIAGo Pro: wheels, casters, lift, head, fingers; 31 joints of which ten
are measured, and a camera in the head that gives the whole pose of a target on the right hand.

trial_mobile_arms.py CLI FOLDER [SEED ...]   makes and improves sessions of 48 poses, says what was found and how long it took
"""
import json
import resource
import subprocess
import sys
from pathlib import Path

hidden = ["joint_offset:arm_right_2.offset=0.03", "joint_offset:torso_lift.offset=0.004",
          "joint_elasticity:arm_right_4.compliance=6e-4", "link_geometry:arm_right_3.tu=0.003",
          "link_geometry:arm_right_3.ru=0.006", "friction_hysteresis:arm_right_2.gap=0.003"]
curve = "arm_right_1: 0.008*sin(3q)"


def link(name, mass):
    return (f'<link name="{name}"><inertial><origin xyz="0.01 0 0.05"/><mass value="{mass:g}"/>'
            '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>')


def joint(name, parent, child, xyz="0 0 0", axis="0 0 1", kind="revolute", limits=(-2.2, 2.2), rpy="0 0 0"):
    limit = f'<limit lower="{limits[0]}" upper="{limits[1]}" effort="87" velocity="2"/>' if kind in ("revolute", "prismatic") else ""
    moves = f'<axis xyz="{axis}"/>' if kind != "fixed" else ""
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{xyz}" rpy="{rpy}"/>{moves}{limit}</joint>')


def base():
    parts = [link("base_link", 60)]
    for i in range(4):
        parts += [link(f"caster_{i}", 0.3), joint(f"caster_{i}_joint", "base_link", f"caster_{i}", kind="continuous"),
                  link(f"caster_{i}_wheel", 0.2),
                  joint(f"caster_{i}_wheel_joint", f"caster_{i}", f"caster_{i}_wheel", kind="continuous", axis="0 1 0")]
    for i in range(2):
        parts += [link(f"wheel_{i}", 1), joint(f"wheel_{i}_joint", "base_link", f"wheel_{i}", kind="continuous", axis="0 1 0")]
    return parts + [link("torso", 20), joint("torso_lift", "base_link", "torso", "0 0 0.6", kind="prismatic", limits=(0, 0.35))]


def arm(side, y):
    places = [f"0.1 {y} 0.2", "0.05 0 0.05", "0 0 0.15", "0.03 0 0.15", "-0.03 0 0.15", "0 0 0.15", "0 0 0.08"]
    parts, before = [], "torso"
    for i, place in enumerate(places, 1):
        name = f"arm_{side}_{i}_link"
        parts += [link(name, 3 / i), joint(f"arm_{side}_{i}", before, name, place, axis="0 1 0" if i % 2 == 0 else "0 0 1")]
        before = name
    hand = f"gripper_{side}"
    parts += [link(hand, 0.5), joint(f"{hand}_joint", before, hand, "0 0 0.05", kind="fixed")]
    for f in range(2):
        parts += [link(f"finger_{side}_{f}", 0.05), joint(f"finger_{side}_{f}_joint", hand, f"finger_{side}_{f}", axis="0 1 0",
                                                          kind="prismatic", limits=(0, 0.04))]
    return parts


def head():
    return [link("head_1", 1), joint("head_pan", "torso", "head_1", "0.1 0 0.3", limits=(-1.2, 1.2)), link("head_2", 1.5),
            joint("head_tilt", "head_1", "head_2", "0.05 0 0.05", axis="0 1 0", limits=(-1, 0.8)), '<link name="camera"/>',
            joint("camera_joint", "head_2", "camera", "0.05 0 0.08", kind="fixed", rpy="-1.5708 0 -1.5708")]


def write_like(folder):
    parts = base() + arm("left", 0.2) + arm("right", -0.2) + head()
    (folder / "robot.urdf").write_text('<robot name="mobile">\n' + "\n".join(parts) + "\n</robot>\n")
    joints = ["torso_lift", "head_pan", "head_tilt"] + [f"arm_right_{i}" for i in range(1, 8)]
    (folder / "session.xml").write_text(
        '<handsight_session version="1" title="A mobile robot with two arms">\n'
        '<robot file="robot.urdf" tcp="gripper_right"/>\n<target kind="pose"/>\n'
        '<pose_sensor mount="camera" sigma="0.0005" sigma_angle="0.001">'
        '<mount_from_sensor xyz="0.01 0.005 0" rpy="0.01 0.02 0" estimate="yes"/></pose_sensor>\n'
        f'<joints>{" ".join(joints)}</joints>\n'
        f'<observations><observation id="0" time="0"><position>{" ".join("0" for _ in joints)}</position></observation>'
        '</observations>\n</handsight_session>\n')


def seconds_of_children():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def main(cli, folder, seeds):
    folder.mkdir(parents=True)
    write_like(folder)
    for seed in seeds:
        session = folder / f"seed_{seed}"
        subprocess.run([cli, "simulate", "--like", folder, "--out", session, "--observations", "48", "--seed", str(seed),
                        "--nearest", "0.2", "--farthest", "2", "--curve", curve, "--effect", *hidden],
                       check=True, stdout=subprocess.DEVNULL)
        before = seconds_of_children()
        told = subprocess.run([cli, "--threads", "1", "improve", session, "--json", "-"], capture_output=True, text=True).stdout
        result = json.loads(told)
        steps = result["steps"]
        print(f"seed {seed}: {seconds_of_children() - before:.1f} s, held out {1e3 * steps[0]['held_out_mean_m']:.2f} -> "
              f"{1e3 * steps[-1]['held_out_mean_m']:.3f} mm: {', '.join(e['id'] for e in result['effects'])}; {result['verdict']}")


if len(sys.argv) < 3:
    sys.exit(__doc__)
main(sys.argv[1], Path(sys.argv[2]), [int(s) for s in sys.argv[3:]] or [5, 6, 7])
