#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How soon `online --watch` finds what arrives, and what memory a day of arrivals at 5 a second takes.

trial_watch.py CLI SESSION latency [SECONDS]      arrivals at 5 a second of a tracker's session, each timed to its line
trial_watch.py CLI SESSION memory [ARRIVALS]      as fast as they are taken; resident memory at every tenth
"""

import json
import pathlib
import queue
import subprocess
import sys
import tempfile
import threading
import time
import xml.etree.ElementTree as xml


def measured(session):
    """Joint names, and of every observation its joints' and points' texts."""
    root = xml.parse(session / "session.xml").getroot()
    joints = root.find("joints").text.split()
    count = int(root.find("markers").get("count"))
    lines = []
    for observation in root.find("observations"):
        points = [["", "", ""] for _ in range(count)]
        for marker in observation.findall("marker"):
            points[int(marker.get("index"))] = marker.get("point").split()
        lines.append((observation.find("position").text.split(), sum(points, [])))
    return joints, count, lines


def begun(session, folder, kept=30):
    """The session's first observations, in a folder of its own."""
    tree = xml.parse(session / "session.xml")
    observations = tree.getroot().find("observations")
    for observation in list(observations)[kept:]:
        observations.remove(observation)
    robot = tree.getroot().find("robot").get("file")
    source = session / robot
    if not source.exists():
        source = next(above / "robots" / robot for above in session.parents if (above / "robots" / robot).exists())
    (folder / robot).write_bytes(source.read_bytes())
    tree.write(folder / "session.xml", encoding="utf-8", xml_declaration=True)


class Watch:
    def __init__(self, cli, folder, seconds):
        self.process = subprocess.Popen([cli, "online", "--watch", "--for", str(seconds), str(folder), "--json", "-"],
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.lines = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            self.lines.put((time.monotonic(), json.loads(line)))
        self.lines.put(None)

    def resident(self):
        text = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(text.split("VmRSS:")[1].split()[0]) / 1024

    def skip(self, count):
        for _ in range(count):
            self.lines.get(timeout=60)


def tables(folder, joints, count):
    header = ",".join(["number", "time", *joints])
    points = ",".join(["number", *(f"m{m}_{axis}" for m in range(count) for axis in "xyz")])
    opened = [open(folder / name, "a", encoding="utf-8") for name in ("points.csv", "joints.csv")]
    opened[0].write(points + "\n")
    opened[1].write(header + "\n")
    return opened


def write(opened, lines, number):
    position, points = lines[number % len(lines)]
    opened[0].write(",".join([str(number), *points]) + "\n")
    opened[1].write(",".join([str(number), repr(1e4 + 0.2 * number), *position]) + "\n")


def latency(cli, session, seconds):
    joints, count, lines = measured(session)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        begun(session, folder)
        watch = Watch(cli, folder, seconds + 5)
        watch.skip(30)
        opened, waits = tables(folder, joints, count), []
        for number in range(5 * seconds):
            write(opened, lines, number)
            for file in opened:
                file.flush()
            written = time.monotonic()
            waits.append(1e3 * (watch.lines.get(timeout=30)[0] - written))
            time.sleep(max(0, 0.2 - (time.monotonic() - written)))
        watch.process.terminate()
    waits.sort()
    print(f"{len(waits)} arrivals: median {waits[len(waits) // 2]:.1f} ms, 99 % {waits[int(0.99 * len(waits))]:.1f} ms, "
          f"at most {waits[-1]:.1f} ms; within 100 ms: {sum(w <= 100 for w in waits)}")


def memory(cli, session, arrivals):
    joints, count, lines = measured(session)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        begun(session, folder)
        watch = Watch(cli, folder, 86400)
        watch.skip(30)
        opened, start, number = tables(folder, joints, count), time.monotonic(), 0
        for part in range(11):
            print(f"{number:>7} arrivals, {time.monotonic() - start:6.0f} s: {watch.resident():.1f} MB", flush=True)
            for _ in range(arrivals // 10 if part < 10 else 0):
                write(opened, lines, number)
                number += 1
                if number % 50 == 0:
                    for file in opened:
                        file.flush()
                    watch.skip(50)
        watch.process.terminate()


def main():
    cli, session, what = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
    number = int(sys.argv[4]) if len(sys.argv) > 4 else None
    {"latency": lambda: latency(cli, session, number or 60), "memory": lambda: memory(cli, session, number or 432000)}[what]()


if __name__ == "__main__":
    main()
