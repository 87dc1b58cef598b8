#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sessions by chance, far from what is usual: `improve` must end in each, never as `missing_effect`, without a held-out
error that rises, within a minute. Only without any noise, where everything that is left means something, may it take many
steps.

chance_sessions.py HANDSIGHT_CLI FIRST_SEED COUNT: prints a line for each that is odd and a sum; exit code 1 where one is."""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import time

CLI, FIRST, COUNT = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
RIGS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "sample_sessions", "rigs")
MOST_STEPS, MOST_SECONDS = 16, 60
RISES = 1.0021  # other names may raise the held-out error by two thousandths


def run(*arguments):
    return subprocess.run([CLI, *arguments], capture_output=True, text=True)


def joints_of(rig):
    with open(os.path.join(rig, "session.xml"), encoding="utf-8") as file:
        return re.search(r"<joints>([^<]*)</joints>", file.read()).group(1).split()


def effect_arguments(chance, catalogue, joints):
    told = []
    for effect in chance.sample(catalogue, chance.randint(0, 3)):
        size = 10 ** chance.uniform(-0.5, 1.7)
        places = [""] if effect["scope"] in ("session", "camera") else chance.sample(joints, chance.randint(1, 3))
        if effect["scope"] not in ("session", "joint"):
            continue
        for place in places:
            for p in effect["parameters"]:
                if p.get("sigma"):
                    told.append("%s:%s%s=%.6g" % (effect["id"], place + "." if place else "", p["name"],
                                                  chance.gauss(0, size * p["sigma"])))
    return ["--effect", *told] if told else []


def arguments_of(seed, catalogue):
    chance = random.Random(seed)
    rig = os.path.join(RIGS, chance.choice(sorted(os.listdir(RIGS))))
    joints = joints_of(rig)
    arguments = ["--like", rig, "--seed", str(seed), "--images", "none",
                 "--observations", str(chance.choice([6, 8, 12, 20, 40, 80, 120])),
                 "--noise", str(chance.choice([0, 0.01, 0.1, 0.2, 0.3, 1])),
                 "--joint-range", str(chance.choice([0.1, 0.3, 0.6, 1])),
                 *effect_arguments(chance, catalogue, joints)]
    if chance.random() < 0.4:
        arguments += ["--curve", "%s: %.4g*%s(%dq)" % (chance.choice(joints), 10 ** chance.uniform(-4, -1),
                                                        chance.choice(["sin", "cos"]), chance.randint(1, 4))]
    if chance.random() < 0.3:
        arguments += ["--wrong-corners", "%.2f" % chance.uniform(0, 0.3)]
    if chance.random() < 0.3:
        arguments += ["--unseen", "%.2f" % chance.uniform(0, 0.5)]
    if chance.random() < 0.3:
        arguments += ["--undeclared"]
    return arguments


def oddities(result, seconds, noise):
    odd = ["%.0f s" % seconds] if seconds > MOST_SECONDS else []
    steps = result["steps"]
    if len(steps) - 1 > MOST_STEPS and noise > 0:
        odd.append("%d steps" % (len(steps) - 1))
    if result["verdict"] == "missing_effect":
        odd.append("ends as missing_effect")
    errors = [s["held_out_rms_pixel"] if s["held_out_rms_pixel"] is not None else s["held_out_rms_m"] for s in steps]
    for before, after in zip(errors, errors[1:]):
        if before and after and after > RISES * before:
            odd.append("the held-out error rises from %.6g to %.6g" % (before, after))
    return odd


def main():
    catalogue = json.loads(run("effects", "--json", "-").stdout)
    simulated, odd_ones, slowest = 0, 0, 0.0
    for seed in range(FIRST, FIRST + COUNT):
        with tempfile.TemporaryDirectory() as folder:
            session = os.path.join(folder, "session")
            arguments = arguments_of(seed, catalogue)
            if run("simulate", *arguments, "--out", session).returncode != 0:
                continue
            simulated += 1
            begin = time.time()
            done = run("--threads", "1", "improve", session, "--json", "-")
            seconds = time.time() - begin
            slowest = max(slowest, seconds)
            if done.returncode in (0, 1) and done.stdout:
                odd = oddities(json.loads(done.stdout), seconds, float(arguments[arguments.index("--noise") + 1]))
            else:
                odd = [] if done.returncode == 2 and done.stderr.count("\n") == 1 else ["exit code %d: %s" % (
                    done.returncode, done.stderr[:300])]
        if odd:
            odd_ones += 1
            print("%d: %s (simulate %s)" % (seed, "; ".join(odd), " ".join(arguments)), flush=True)
    print("%d of %d seeds could be simulated, %d odd; slowest %.1f s" % (simulated, COUNT, odd_ones, slowest))
    return 1 if odd_ones else 0


sys.exit(main())
