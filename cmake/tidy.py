#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over core and the command line, where something changed since it last found nothing; findings are errors.

  cmake/tidy.py            looks at what changed and at what it has never passed, prints findings, writes cmake/tidy.txt
  cmake/tidy.py --passed   looks at what it has passed once and has changed since, writes nothing: the test Sources.ClangTidy

Needs clang-tidy 14 and a build folder. A source is taken with its header and those headers that it includes
which have no source of their own; cmake/tidy.txt holds a digest of each, with that of .clang-tidy. Nearly all of the
time goes into the headers of libraries, so sources are looked at joined, and each half for itself where something is found.
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
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

root = Path(__file__).resolve().parent.parent
record = root / "cmake" / "tidy.txt"
most_joined = 16  # sources at a time
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


def commands(build):
    """What compiles each source, as clang understands it, without precompiled headers: path -> (folder, command)."""
    strange = r"-Winvalid-pch|-include \S+|--param=\S+|-Wno-(restrict|stringop-overflow|use-after-free)|-o \S+|-M[DTF] ?\S*"
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        command = re.sub(strange, "", re.sub(r"^.*?ccache ", "", entry["command"])).replace(entry["file"], "")
        found |= {path: (entry["directory"], command) for path in compiled(entry)}
    return found


def names(source):
    """What a source's unnamed namespace defines: two sources that define the same cannot be joined."""
    inside = "\n".join(re.findall(r"^namespace \{$(.*?)^\}", source.read_text(), re.M | re.S))
    return set(re.findall(r"^(?:\w[^\n(={;]*[\s&*])?(\w+)\s*(?:\(|=|\{|;|:)", inside, re.M))


def joined(sources, by):
    """Groups of sources that one command compiles and that do not clash."""
    groups = []
    for path in sources:
        mine = names(root / path)
        for group in groups:
            if len(group[0]) < most_joined and group[1] == by.get(str(root / path)) and not group[2] & mine:
                group[0].append(path)
                group[2].update(mine)
                break
        else:
            groups.append(([path], by.get(str(root / path)), set(mine)))
    return groups


def findings(paths, how):
    """What clang-tidy says of these sources, compiled as one."""
    if not how:
        return "No target compiles it.\n"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "joined.cpp"
        # NOLINT: a source that is included is what is meant here.
        file.write_text("".join(f'#include "{root / path}"  // NOLINT\n' for path in paths))
        entry = {"directory": how[0], "command": f"{how[1]} {file}", "file": str(file)}
        (Path(folder) / "compile_commands.json").write_text(json.dumps([entry]))
        run = subprocess.run(["clang-tidy", "-p", folder, "--quiet", "--warnings-as-errors=*",
                              f"--config-file={root / '.clang-tidy'}", str(file)], capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stdout + run.stderr


def told_apart(group):
    """(path, findings) of each source of a group; where there are findings, or two clash, each half for itself."""
    paths, how, _ = group
    found = findings(paths, how)
    if not found or len(paths) == 1:
        return [(path, found) for path in paths]
    middle = len(paths) // 2
    return told_apart((paths[:middle], how, None)) + told_apart((paths[middle:], how, None))


def look_at(sources, build, heed):
    """Calls heed(source, findings) one by one; several groups are looked at side by side (JOBS)."""
    bad, done = 0, 0
    with ThreadPoolExecutor(int(os.environ.get("JOBS", os.cpu_count()))) as pool:
        groups = [pool.submit(told_apart, group) for group in joined(sources, commands(build))]
        for group in as_completed(groups):
            for path, found in group.result():
                done += 1
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
