#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over core, the command line and the rooms of the window that are clean, where something changed since it
last found nothing; findings are errors.

  cmake/tidy.py                looks at everything that it has not passed in this build folder
  cmake/tidy.py widgets/plots  looks at these folders, whatever the list of rooms says: before a room is added to it
  cmake/tidy.py --seconds 60   begins nothing more after that time: the test Sources.ClangTidy. What was changed last comes first

Needs clang-tidy 14 and a build folder, in which tidy.txt notes what it found nothing in: a digest of each source with its header
and those headers that it includes which have no source of their own, and of .clang-tidy. Nearly all of the time goes into the
headers of libraries, so sources are looked at joined, and each half for itself where something is found.
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
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

root = Path(__file__).resolve().parent.parent
most_joined = 16  # sources at a time
roots = [root / "core", root / "app" / "cli", root / "widgets", root / "app"]  # as the compiler finds headers
rooms = ["core", "app/cli"]  # what is looked at
# The same where the window is built; a room is added when nothing is found in it.
window_rooms = ["widgets/" + room for room in ("base", "drawings", "explain", "images", "lists", "plots", "scene")] + [
    "app/" + room for room in ("calibrate", "collection", "compare", "document", "experiment", "explain", "export", "findings",
                               "images", "inspect", "jobs", "label", "live", "merge", "start", "window", "wizard", "words",
                               "workbench")]
# Of the window alone: to the compiler "private slots:" is "private:" once more.
wrong_for_qt = "-readability-redundant-access-specifiers"


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


def now(folders, by):
    """The digest of each source in the folders; of the window's, of those that the build compiles."""
    sources = sorted(p for f in folders for p in (root / f).rglob("*.cpp"))
    in_rooms = tuple(str(root / r) + os.sep for r in rooms)
    return {str(s.relative_to(root)): digest(s) for s in sources if str(s).startswith(in_rooms) or str(s) in by}


def by_last_change(sources):
    """The sources that were changed last come first; where git cannot tell, as they are."""
    log = subprocess.run(["git", "-C", root, "log", "-n", "60", "--pretty=", "--name-only"], capture_output=True, text=True)
    place = {}
    for path in log.stdout.splitlines():
        place.setdefault(path, len(place))
    return sorted(sources, key=lambda path: place.get(path, len(place)))


def passed(record):
    if not record.exists():
        return {}
    return dict(reversed(line.split()) for line in record.read_text().splitlines() )


def write(entries, record):
    lines = [f"{entries[path]} {path}" for path in sorted(entries)]
    fresh = record.with_suffix(".new")
    fresh.write_text("\n".join(lines) + "\n")
    fresh.replace(record)


def compiled_by(file):
    """The sources that the build compiles as one (HANDSIGHT_JOINED); else the file itself."""
    if file.parent.name != "Unity":
        return [str(file)]
    return re.findall(r'^#include "([^"]+)"', file.read_text(), re.M)


def commands(build):
    """What compiles each source, as clang understands it, without precompiled headers: path -> (folder, command)."""
    strange = r"-Winvalid-pch|-Xclang \S+|-fpch-instantiate-templates|-include \S+|--param=\S+|-Wno-(restrict|stringop-overflow|use-after-free)|-o \S+|-M[DTF] ?\S*"
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        command = re.sub(strange, "", re.sub(r"^.*?ccache ", "", entry["command"])).replace(entry["file"], "") + " -Wshadow"
        for source in compiled_by(Path(entry["file"])):
            found[source] = (entry["directory"], command)
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


def is_of_window(path):
    return not path.startswith(tuple(r + "/" for r in rooms))


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
                              f"--config-file={root / '.clang-tidy'}", "--header-filter=core/|app/|widgets/",
                              f"--checks={wrong_for_qt if any(map(is_of_window, paths)) else ''}", str(file)], capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stdout + run.stderr


def told_apart(group):
    """(path, findings) of each source of a group; where there are findings, or two clash, each half for itself."""
    paths, how, _ = group
    found = findings(paths, how)
    if not found or len(paths) == 1:
        return [(path, found) for path in paths]
    middle = len(paths) // 2
    return told_apart((paths[:middle], how, None)) + told_apart((paths[middle:], how, None))


def look_at(sources, by, heed, seconds):
    """Calls heed(source, findings) one by one; several groups are looked at side by side (JOBS). Returns how many were
    looked at and how many have findings."""
    bad, done, ends = 0, 0, time.monotonic() + seconds
    with ThreadPoolExecutor(int(os.environ.get("JOBS", os.cpu_count()))) as pool:
        groups = [pool.submit(lambda g=group: told_apart(g) if time.monotonic() < ends else []) for group in joined(sources, by)]
        for group in as_completed(groups):
            for path, found in group.result():
                done += 1
                print(f"[{done}/{len(sources)}] {path}" + (f"\n{found}" if found else ""), flush=True)
                heed(path, found)
                bad += 1 if found else 0
    return done, bad


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folders", nargs="*", help="instead of the rooms that are looked at always")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="nothing more is begun after that time")
    parser.add_argument("--build", type=Path, default=root / "build", help="folder of compile_commands.json")
    asked = parser.parse_args()
    if not shutil.which("clang-tidy"):
        print("clang-tidy is not installed: nothing was looked at.")
        sys.exit(77)
    record = asked.build / "tidy.txt"
    by = commands(asked.build)
    current, known = now(asked.folders or rooms + window_rooms, by), passed(record)
    changed = by_last_change(path for path in current if known.get(path) != current[path])
    good = {path: value for path, value in known.items() if path in current or asked.folders}

    def heed(path, found):
        if not found:
            good[path] = current[path]
            write(good, record)

    done, bad = look_at(changed, by, heed, asked.seconds)
    print(f"{done} of {len(current)} sources looked at, {bad} with findings; {len(changed) - done} are left for the next time.")
    sys.exit(1 if bad else 0)


main()
