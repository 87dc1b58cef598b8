#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A driver for handsight-cli experiment: fill in the four functions. JSON, a line a message, on standard input and output;
whatever is for people goes to standard error."""
import json
import os
import sys
import threading

ANSWERS = os.fdopen(os.dup(1), "w")  # for answers alone:
os.dup2(2, 1)  # what libraries print goes to standard error
JOINTS = ["a1", "a2", "a3", "a4", "a5", "a6"]  # names as in the URDF; the order of every list below


def where():  # rad (m), from the robot's sensors
    raise NotImplementedError


def drive(path, speed):  # through all its points, straight in the joints; speed of the fastest joint, rad/s
    raise NotImplementedError


def see():  # {"images": {"left": "/path/left.png", "right": "/path/right.png"}}, or {"points": ...}, {"target_pose": ...}
    raise NotImplementedError


def halt():  # at once
    raise NotImplementedError


def answer(message):
    try:
        if message["do"] == "hello":
            said = {"joints": JOINTS, "can": ["move", "look"], "name": "my robot", "position": where()}
        elif message["do"] == "move":
            drive(message["path"], message["speed"])
            said = {"ok": True, "position": where()}
        else:
            said = {"ok": True, **(see() if message["do"] == "look" else halt() or {})}
    except Exception as error:  # a pose that cannot be reached, a camera that did not answer
        said = {"ok": False, "why": str(error) or type(error).__name__}
    print(json.dumps({"id": message["id"], **said}), file=ANSWERS, flush=True)


for line in sys.stdin:  # in a thread: a stop may come while the robot moves
    threading.Thread(target=answer, args=(json.loads(line),)).start()
halt()  # nobody speaks any more: the program has ended, by itself or not, and nothing moves on
