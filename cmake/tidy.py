#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over core and the command line, where something changed since it last found nothing; findings are errors.

  cmake/tidy.py            looks at what changed and at what it has never passed, prints findings, writes cmake/tidy.txt
  cmake/tidy.py --passed   looks at what it has passed once and has changed since, writes nothing: the test Sources.ClangTidy

Needs clang-tidy 14 and a build folder. A source is taken with its header and those headers that it includes
which have no source of their own; cmake/tidy.txt holds a digest of each, with that of .clang-tidy.
"""
import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

root = Path(__file__).resolve().parent.parent
record = root / "cmake" / "tidy.txt"
roots = [root / "core", root / "app" / "cli"]  # as the compiler finds headers


def header(name, beside):
    return next((p for p in [beside / name] + [r / name for r in roots] if p.is_file()), None)


def unit(source):
    """The files whose findings show where `source` is compiled."""
    files = [source]
    for name in re.findall(r'^#include "([^"]+)"', source.read_text(), re.M):
        found = header(name, source.parent)
        if found and (found.with_suffix(".cpp") == source or not found.with_suffix(".cpp").exists()):
            files.append(found)
    return sorted(set(files))


def digest(source):
    sha = hashlib.sha256((root / ".clang-tidy").read_bytes())
    for path in unit(source):
        sha.update(str(path.relative_to(root)).encode() + b"\0" + path.read_bytes())
    return sha.hexdigest()[:24]


def now():
    sources = sorted(p for r in roots for p in r.rglob("*.cpp"))
    return {str(s.relative_to(root)): digest(s) for s in sources}


def passed():
    if not record.exists():
        return {}
    return dict(reversed(line.split()) for line in record.read_text().splitlines() if not line.startswith("#"))


def write(entries):
    lines = ["# Made by cmake/tidy.py: what clang-tidy found nothing in."]
    lines += [f"{entries[path]} {path}" for path in sorted(entries)]
    fresh = record.with_suffix(".new")
    fresh.write_text("\n".join(lines) + "\n")
    fresh.replace(record)


def compiled(entry):
    """The sources of an entry of compile_commands.json: one, or those that are compiled together (HANDSIGHT_UNITY)."""
    joined = Path(entry["file"])
    if joined.parent.name != "Unity" or not joined.is_file():
        return [entry["file"]]
    return re.findall(r'^#include "([^"]+)"', joined.read_text(), re.M)


def commands(build, folder):
    """The compiler's commands as clang understands them, without precompiled headers."""
    strange = r"-Winvalid-pch|-include \S+|--param=\S+|-Wno-(restrict|stringop-overflow|use-after-free)"
    base = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        entry["command"] = re.sub(strange, "", re.sub(r"^.*?ccache ", "", entry["command"]))
        base += [entry | {"file": path, "command": entry["command"].replace(entry["file"], path)} for path in compiled(entry)]
    (Path(folder) / "compile_commands.json").write_text(json.dumps(base))


def findings(source, folder):
    run = subprocess.run(["clang-tidy", "-p", folder, "--quiet", "--warnings-as-errors=*", str(root / source)],
                         capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stdout + run.stderr


def look_at(sources, build, heed):
    """Calls heed(source, findings) one by one; several are looked at side by side (JOBS)."""
    bad = 0
    jobs = int(os.environ.get("JOBS", os.cpu_count()))
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
        commands(build, folder)
        for done, (path, found) in enumerate(zip(sources, pool.map(lambda p: findings(p, folder), sources)), 1):
            print(f"[{done}/{len(sources)}] {path}" + (f"\n{found}" if found else ""), flush=True)
            heed(path, found)
            bad += 1 if found else 0
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--passed", action="store_true", help="only what has been passed once and has changed since")
    parser.add_argument("--build", type=Path, default=root / "build", help="folder of compile_commands.json")
    asked = parser.parse_args()
    if not shutil.which("clang-tidy"):
        print("clang-tidy is not installed: nothing was looked at.")
        sys.exit(77)
    current, known = now(), passed()
    changed = [path for path in current if known.get(path) != current[path]]
    never = [path for path in changed if path not in known]
    good = {path: value for path, value in known.items() if path in current}

    def heed(path, found):
        if not found and not asked.passed:
            good[path] = current[path]
            write(good)

    looked_at = [path for path in changed if path in known] if asked.passed else changed
    bad = look_at(looked_at, asked.build, heed)
    rest = f" {len(never)} have never been passed." if asked.passed else ""
    print(f"{len(looked_at)} of {len(current)} sources looked at, {bad} with findings.{rest}")
    sys.exit(1 if bad else 0)


main()
