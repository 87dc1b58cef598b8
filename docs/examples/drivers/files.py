#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A driver for robots whose program cannot be spoken to but reads and writes files.

files.py FOLDER JOINT ... : for the N-th order it writes FOLDER/order_N.json ({"do": "move", "path": ..., "speed": ...} or
{"do": "look"}) and waits for FOLDER/answer_N.json, which the robot's program writes beside it under another name and then
renames: {"ok": true, "position": [...]} or {"ok": true, "images": {...}}. FOLDER/stop is there once everything is to stand
still, and when nobody orders any more. FOLDER/where.json, a list of numbers, says where the robot stands before the first
order. Orders, answers and a stop of an earlier time are taken away at the start."""
import glob
import json
import os
import sys
import threading
import time

folder, joints = sys.argv[1], sys.argv[2:]
LIMIT = float(os.environ.get("HANDSIGHT_FILES_LIMIT", "600"))  # s: longer than any move of the robot


def write(name, content):
    part = os.path.join(folder, "." + name)
    with open(part, "w") as file:
        json.dump(content, file)
    os.replace(part, os.path.join(folder, name))


def read(name):
    with open(os.path.join(folder, name)) as file:
        return json.load(file)


def ordered(number, order):
    write(f"order_{number}.json", order)
    end = time.monotonic() + LIMIT
    while not os.path.exists(os.path.join(folder, f"answer_{number}.json")):
        if time.monotonic() > end:
            return {"ok": False, "why": f"no answer_{number}.json after {LIMIT:g} s"}
        time.sleep(0.02)
    return read(f"answer_{number}.json")


for name in ["stop"] + [os.path.basename(file) for kind in ("order", "answer")
                        for file in glob.glob(os.path.join(glob.escape(folder), kind + "_*.json"))]:
    if os.path.exists(os.path.join(folder, name)):
        os.remove(os.path.join(folder, name))
number = 0


def answer(message):
    global number
    if message["do"] == "hello":
        said = {"joints": joints, "can": ["move", "look"], "name": "files in " + folder}
        if os.path.exists(os.path.join(folder, "where.json")):
            said["position"] = read("where.json")
    elif message["do"] == "stop":
        write("stop", True)
        said = {"ok": True}
    else:
        number += 1
        said = ordered(number, {key: message[key] for key in message if key != "id"})
    print(json.dumps({"id": message["id"], **said}), flush=True)


for line in sys.stdin:  # in a thread: a stop may come while an order waits
    threading.Thread(target=answer, args=(json.loads(line),), daemon=True).start()
write("stop", True)
