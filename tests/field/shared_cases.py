#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Inputs of the field that no other test runs: each comes to the right value of its README, or to the sentence that it asks for.

shared_cases.py HANDSIGHT_CLI FIELD: a line for each; exit code 1 where one is neither; 77 where the inputs are not there."""
import json
import os
import subprocess
import sys
import tempfile

CLI, FIELD = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
CHARUCO = "charuco columns=8 rows=6 square=35mm marker=24mm dictionary=DICT_4X4_50"


def run(*arguments):
    done = subprocess.run([CLI, *arguments], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def cameras(target, *folders):
    code, said = run("cameras", *("%s/cameras/%s" % (FIELD, f) for f in folders), "--target", target, "--json", "cameras.json")
    if code:
        return None, said
    with open("cameras.json") as file:
        return json.load(file), said


def focal_length(camera):
    return next(p["value"] for p in camera["parameters"] if p["name"] == "fx")


def converted(case, *options, files=("flange.csv", "target.csv")):
    return run("convert", *("%s/robots/%s/%s" % (FIELD, case, f) for f in files), *options, "--out", "session")


def aruco_gridboard():
    result, said = cameras("grid columns=4 rows=5 marker=35mm separation=15mm dictionary=DICT_6X6_250", "aruco_gridboard/images")
    return result and result["cameras"][0]["points"] == 6 * 80 and abs(focal_length(result["cameras"][0]) - 620) < 0.5, said


def euroc_folders():
    result, said = cameras(CHARUCO, "euroc_folders/different_times/cam0/data", "euroc_folders/different_times/cam1/data")
    lengths = [focal_length(c) for c in result["cameras"]] if result else []
    apart = abs(result["cameras"][1]["from_first"][0][3]) if len(lengths) == 2 else 0
    return (len(lengths) == 2 and abs(lengths[0] - 620) < 0.3 and abs(lengths[1] - 610) < 0.3 and abs(apart - 0.12) < 2e-4
            and "other times" in said), said


def sixteen_bit():
    result, said = cameras(CHARUCO, "sixteen_bit/images")
    return result and [i["points"] for i in result["images"]] == [35] * 4, said


def marker_size_wrong():
    converted("marker_size_wrong")
    _, said = run("fit", "session")
    return "The target is 4.0 % smaller than its description says" in said, said


def tag_flips():
    converted("tag_flips")
    _, said = run("fit", "session")
    return "Observations 3, 9, 14: the flat target's pose flipped" in said and "stray_poses" not in said, said


def normalised_joints():
    code, said = converted("normalised_joints", "--tcp", "tool", files=("joints.csv", "target.csv", "arm.urdf"))
    return code == 2 and "per cent of its range" in said and "LeRobot" in said, said


def plan_out_of_sight():
    """Each pose that is planned has the tag before the camera, its face within 70 degrees of the camera's axis, by what
    `predict` says of it."""
    converted("plan_out_of_sight", "--degrees", "--tcp", "link_eef", files=("joints.csv", "target.csv", "arm.urdf"))
    code, said = run("plan", "session", "--count", "4", "--json", "plan.json")
    _, fitted = run("fit", "session", "--json", "fit.json")
    if code:
        return False, said
    with open("plan.json") as plan, open("fit.json") as fit:
        poses, mount = json.load(plan)["poses"], json.load(fit)
    inside = []
    for p in poses:
        _, told = run("predict", "session", "--position", " ".join(map(str, p["position"])), "--json", "-")
        body = json.loads(told[told.index("["):])[0]["root_from_body_est"]
        camera = mount["mount_from_sensor"]
        away = [body[i][3] - camera[i][3] for i in range(3)]
        depth = sum(camera[i][2] * away[i] for i in range(3))
        facing = sum(camera[i][2] * body[i][2] for i in range(3))
        inside.append(0.5 < depth < 1.2 and facing < -0.3)  # as measured: -0.98
    return len(inside) == 4 and all(inside), "%s\n%s" % (inside, said)


CASES = [aruco_gridboard, euroc_folders, sixteen_bit, marker_size_wrong, tag_flips, normalised_joints, plan_out_of_sight]

if not os.path.isdir(FIELD):
    print("not there: %s" % FIELD)
    sys.exit(77)
failed = 0
for case in CASES:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        good, said = case()
        os.chdir("/")
    failed += not good
    print("ok   %s" % case.__name__ if good else "FAIL %s\n%s" % (case.__name__, said), flush=True)
print("%d of %d failed" % (failed, len(CASES)))
sys.exit(1 if failed else 0)
