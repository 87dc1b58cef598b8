# SPDX-License-Identifier: Apache-2.0
"""How cases of the field are run: a function makes files in an empty folder and answers with the arguments of `convert` and with a
judge of what came of it, which says (good, sentence)."""
import json
import math
import os
import subprocess
import sys
import tempfile
import time

import numpy as np
from scipy.spatial.transform import Rotation

CLI = os.path.abspath(sys.argv[1])


def run(*arguments):
    return subprocess.run([CLI, *arguments], capture_output=True, text=True)


def pose(name, truth, away=3e-4, turn=0.05):
    """`fit` gives this pose, within m and degrees (turn None: the turn does not count)."""
    def judge(made):
        if made.returncode:
            return False, made.stderr.strip().split("\n")[-1]
        fitted = run("fit", "session", "--json", "-")
        if fitted.returncode == 2:
            return False, "fit: " + fitted.stderr.strip().split("\n")[-1]
        result = json.loads(fitted.stdout)
        found = next(result[k] for k in result if k.startswith(name))
        off = np.linalg.inv(truth) @ np.array(found["matrix"] if isinstance(found, dict) else found)
        length = float(np.linalg.norm(off[:3, 3]))
        angle = 0 if turn is None else math.degrees(Rotation.from_matrix(off[:3, :3]).magnitude())
        return length < away and (turn is None or angle < turn), "%.3f mm and %.4f degrees off" % (1e3 * length, angle)
    return judge


def run_cases(cases):
    """Those that the command line names, else all; -v: everything that `convert` said. The exit code."""
    wanted = [a for a in sys.argv[2:] if a != "-v"]
    looked_at = [make for make in cases if not wanted or make.__name__ in wanted]
    failed, begin = 0, time.monotonic()
    for make in looked_at:
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            before = time.monotonic()
            arguments, judge = make()
            made = run("convert", *arguments, "--out", "session")
            good, said = judge(made)
            if "-v" in sys.argv:
                print(made.stdout + made.stderr)
            os.chdir("/")
        failed += not good
        print("%-4s %-32s %4.1f s  %s" % ("ok" if good else "FAIL", make.__name__, time.monotonic() - before, said), flush=True)
    print("%d of %d failed, %.0f s" % (failed, len(looked_at), time.monotonic() - begin))
    return 1 if failed else 0
