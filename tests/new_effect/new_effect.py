#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""One effect more, as docs/add_an_effect.md says: its file and its line, taken from that page, go into a copy of the
list; the command line and the tests of catalogue and exporters are linked with them and run.

  new_effect.py SOURCE BUILD FOLDER    BUILD: a folder that ninja has built; FOLDER is made anew
"""
import json
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

source, build, folder = (Path(a).resolve() for a in sys.argv[1:4])
core = folder / "core"
hidden = {"sine": 1.5e-3, "cosine": -1e-3}  # rad, of axis_3
joint = "axis_3"
poses = [[0.2, 0.5, -0.4, 0.3, 0.6, -0.2], [-0.7, 0.1, 0.9, -0.5, 0.4, 1.0], [1.1, -0.3, 0.2, 0.8, -0.9, 0.1]]


def fail(what):
    print("FAILED: " + what)
    sys.exit(1)


def run(*command, text=None, **more):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, input=text, **more)
    if done.returncode:
        fail(shlex.join(str(c) for c in command) + "\n" + done.stdout[-3000:] + done.stderr[-3000:])
    return done.stdout


def add_as_the_page_says():
    """Returns the id of the effect and the new sources, the list among them."""
    page = (source / "docs" / "add_an_effect.md").read_text()
    path = re.search(r"`(core/effects/\w+/\w+\.cpp)`:\n\n```cpp\n(.*?)```", page, re.S)
    line = re.search(r"`core/effects/list\.inc`:\n\n```\n(HANDSIGHT_EFFECT\((\w+)\))\n```", page)
    if not path or not line:
        fail("docs/add_an_effect.md does not say which file and which line")
    for name in ("list.h", "list.inc", "list.cpp"):
        (core / "effects").mkdir(parents=True, exist_ok=True)
        shutil.copy(source / "core" / "effects" / name, core / "effects" / name)
    with open(core / "effects" / "list.inc", "a") as listed:
        listed.write(line[1] + "\n")
    file = folder / path[1]
    file.parent.mkdir(parents=True)
    file.write_text(path[2])
    return line[2], [core / "effects" / "list.cpp", file]


def compile_like_the_list(files):
    """Objects of these files, compiled as the build compiles core/effects/list.cpp; the copy is found before the source."""
    like = source / "core" / "effects" / "list.cpp"
    entry = next(e for e in json.loads((build / "compile_commands.json").read_text()) if e["file"] == str(like))
    objects = []
    for file in files:
        words = shlex.split(entry["command"])
        words[words.index("-o") + 1] = str(file.with_suffix(".o"))
        words[words.index(str(like))] = str(file)
        words.insert(next(i for i, word in enumerate(words) if word.startswith("-I")), f"-I{core}")
        run(*words, cwd=entry["directory"])
        objects.append(file.with_suffix(".o"))
    return objects


def link(target, objects):
    """The program `target` of the build with these objects before its libraries."""
    commands = run("ninja", "-C", build, "-t", "commands", target).splitlines()
    words = shlex.split(next(part for part in commands[-1].split(" && ") if f"-o {target}" in part))
    program = folder / Path(target).name
    at = words.index("-o")
    words[at + 1] = str(program)
    words[at:at] = [str(o) for o in objects]
    run(*words, cwd=build)
    return program


def find(effects, name):
    return next((e for e in effects if e["id"] == name), None) or fail(f"no {name} among {[e['id'] for e in effects]}")


def values(effect):
    return {p["name"]: p for p in effect["parameters"] if p["of"] == joint}


def expect_found(effect, what):
    for name, number in values(effect).items():
        if not abs(number["value"] - hidden[name]) < 4 * number["sigma"] < 5e-4:
            fail(f"{what}: {name} is {number['value']} +- {number['sigma']}, hidden was {hidden[name]}")


def expect_same_hands(cli, calibration, robot):
    """The exported C++ and Python have the hand where predict has it, and not where it is without the effect."""
    asked = ["--position=" + " ".join(map(str, p)) for p in poses]
    predicted = json.loads(run(cli, "predict", calibration, "--robot", robot, *asked, "--json", "-"))
    text = "".join(" ".join(map(str, p)) + "\n" for p in poses)
    for kind, name in (("cpp", "hand.cpp"), ("python", "hand.py")):
        run(cli, "export", calibration, "--robot", robot, "--as", kind, "--out", folder / name)
    run("c++", "-std=c++17", "-O2", "-Wall", "-Wextra", "-Werror", "-DHANDSIGHT_HAND_MAIN", "-o", folder / "hand",
        folder / "hand.cpp")
    for command in ([folder / "hand"], [sys.executable, "-I", folder / "hand.py"]):
        lines = run(*command, text=text).splitlines()
        for line, pose in zip(lines, predicted, strict=True):
            found = [float(w) for w in line.split()[:12]]
            wanted = [n for row in pose["root_from_tcp_est"][:3] for n in row]
            if max(abs(a - b) for a, b in zip(found, wanted)) > 1e-9:
                fail(f"{command[-1].name} has the hand elsewhere than predict")
    return predicted


def main():
    shutil.rmtree(folder, ignore_errors=True)
    effect, files = add_as_the_page_says()
    objects = compile_like_the_list(files)
    cli = link("app/cli/handsight-cli", objects)
    for target, tests in (("tests/test_effects", "Catalogue.*"), ("tests/test_export", "Programs.HoldEachEffectAlone")):
        said = run(link(target, objects), f"--gtest_filter={tests}")
        if "[  PASSED  ]" not in said:
            fail(f"{target} ran nothing of {tests}")

    if effect not in run(cli, "effects"):
        fail("effects does not list it")
    session = folder / "session"
    run(cli, "simulate", "--like", source / "sample_sessions" / "hidden_8", "--out", session, "--seed", 5,
        "--observations", 80, "--images", "none", "--effect", *(f"{effect}:{joint}.{n}={v}" for n, v in hidden.items()))
    fit = json.loads(run(cli, "fit", session, "--effects", f"{effect}:{joint}", "--json", "-"))
    expect_found(find(fit["effects"], effect), "fit")
    diagnosis = json.loads(run(cli, "diagnose", session, "--json", "-"))
    if diagnosis["verdict"] != "missing_effect" or diagnosis["candidates"][0]["id"] != effect:
        fail(f"diagnose: {diagnosis['verdict']}, {diagnosis['candidates'][0]['id']}")
    improved = json.loads(run(cli, "improve", session, "--json", "-", "--export", folder / "calibration.xml"))
    expect_found(find(improved["effects"], effect), "improve")
    expect_same_hands(cli, folder / "calibration.xml", session / "six_axis.urdf")
    print(f"{effect}: listed, tested, simulated, fitted, diagnosed, exported, predicted.")


main()
