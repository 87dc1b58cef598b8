#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Commands that write, killed at random moments, and two that write one session at once:
kill_and_race.py HANDSIGHT_CLI [--kills N] [--rounds N] [--seed K]

After each kill every file is as it was before or as the whole command leaves it, and nothing else is touched; the next run succeeds
and leaves nothing behind. Of two writers each one's change is in the session, or it said that it is not (exit code 2).
Exit code 1 where that fails."""
import argparse
import hashlib
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SOURCE = os.path.realpath(os.path.join(os.path.dirname(__file__), '..', '..'))
SAMPLES = os.path.join(SOURCE, 'sample_sessions')
MOMENT = re.compile(rb'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ|"milliseconds":[\d.e+-]+')
FIRST = ['--observation', '0', '--left', '421,338', '408,411', '473,378']


def run(arguments, folder, seconds=120):
    done = subprocess.run(arguments, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds)
    return done.returncode, done.stdout.decode('utf-8', 'replace')


def contents(folder):
    """Digest of each file below the folder, by its path; moments and times that they tell are left out."""
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            with open(path, 'rb') as file:
                found[os.path.relpath(path, folder)] = hashlib.sha256(MOMENT.sub(b'', file.read())).hexdigest()
    return found


def leftovers(files):
    return [f for f in files if '.handsight-' in f or '.part' in f]


class Desk:
    """A fresh folder with S (images, not labelled), L (labelled) and H (a session whose fit is quick)."""

    def __init__(self, cli, root):
        self.cli, self.root = cli, root
        self.original = os.path.join(root, 'original')
        os.makedirs(self.original)
        shutil.copytree(os.path.join(SAMPLES, 'first_steps'), os.path.join(self.original, 'S'))
        shutil.copytree(os.path.join(self.original, 'S'), os.path.join(self.original, 'L'))
        shutil.copytree(os.path.join(SAMPLES, 'hidden_1'), os.path.join(self.original, 'H'))
        code, text = run([cli, 'label', 'L'] + FIRST, self.original)
        if code != 0:
            raise SystemExit('label: ' + text)

    def fresh(self, name='work'):
        folder = os.path.join(self.root, name)
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.original, folder)
        return folder

    def commands(self):
        return {
            'label': ['label', 'S'] + FIRST,
            'online --save': ['online', 'L', '--save', '--json', 'online.json'],
            'fit --json --export': ['fit', 'H', '--json', 'fit.json', '--export', 'tcp.xml'],
            'diagnose --json': ['diagnose', 'H', '--json', 'diagnose.json'],
            'export --as python': ['export', 'H', '--as', 'python', '--out', 'hand.py'],
            'export --as urdf': ['export', 'H', '--as', 'urdf', '--out', 'calibrated.urdf'],
            'simulate --out': ['simulate', '--like', 'H', '--out', 'made', '--images', '2', '--observations', '40', '--seed', '3'],
            'convert --out': ['convert', 'H/' + self.robot(), 'joints.csv', 'points.csv', '--out', 'converted', '--tcp', 'hand',
                              '--mount', 'stand'],
        }

    def robot(self):
        with open(os.path.join(self.original, 'H', 'session.xml'), encoding='utf-8') as file:
            return re.search(r'<robot file="([^"]*)"', file.read()).group(1)

    def write_tables(self):
        """What `convert` reads: angles and points of twelve observations."""
        rng = random.Random(5)
        names = [f'axis_{i}' for i in range(1, 7)]
        with open(os.path.join(self.original, 'joints.csv'), 'w', encoding='utf-8') as file:
            file.write(','.join(['observation'] + names) + '\n')
            for k in range(12):
                file.write(','.join([str(k)] + [f'{rng.uniform(-0.4, 0.4):.4f}' for _ in names]) + '\n')
        with open(os.path.join(self.original, 'points.csv'), 'w', encoding='utf-8') as file:
            file.write('observation,marker,x,y,z\n')
            for k in range(12):
                for m in range(3):
                    file.write(f'{k},{m},' + ','.join(f'{rng.uniform(0.4, 0.9):.4f}' for _ in range(3)) + '\n')


def killed(desk, name, arguments, times, rng, problems):
    """Kills the command so often; the folder stays from one kill to the next until a change is whole."""
    folder = desk.fresh()
    before = contents(folder)
    began = time.monotonic()
    code, text = run([desk.cli] + arguments, folder)
    duration = time.monotonic() - began
    if code not in (0, 1):
        problems.append(f'{name}: undisturbed it ends with {code}: {text[-300:]}')
        return 0, 0
    after = contents(folder)
    folder = desk.fresh()
    whole = 0
    for _ in range(times):
        process = subprocess.Popen([desk.cli] + arguments, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        time.sleep(rng.uniform(0, 1.2 * duration))
        process.send_signal(signal.SIGKILL)
        process.wait()
        now = contents(folder)
        passing = set(leftovers(now))
        for file in sorted(set(now) | set(before)):
            if file in passing or file.endswith('.lock'):
                continue
            if now.get(file) not in (before.get(file), after.get(file)):
                problems.append(f'{name}: {file} is neither as before nor as it should become')
                return times, whole
        if any(now.get(f) != before.get(f) for f in after):
            whole += 1
            folder = desk.fresh()
    folder_state = contents(folder)
    for f in leftovers(folder_state):
        os.utime(os.path.join(folder, f), (1, 1)) if os.path.exists(os.path.join(folder, f)) else None
    code, text = run([desk.cli] + arguments, folder)
    if code not in (0, 1):
        problems.append(f'{name}: after the kills it ends with {code}: {text[-300:]}')
    left = leftovers(contents(folder))
    if left:
        problems.append(f'{name}: left behind: {", ".join(left)}')
    return times, whole


def labelled_points(desk):
    """Left image points of each observation, as `online --save` writes them."""
    folder = desk.fresh('labelled')
    run([desk.cli, 'online', 'L', '--save'], folder)
    with open(os.path.join(folder, 'L', 'session.xml'), encoding='utf-8') as file:
        text = file.read()
    found = {}
    for match in re.finditer(r'<observation id="(\d+)".*?</observation>', text, re.S):
        points = re.findall(r'<marker index="(\d+)"[^>]*left="([-\d.e+]+) ([-\d.e+]+)"', match.group(0))
        if len(points) == 3:
            found[int(match.group(1))] = [f'{u},{v}' for _, u, v in sorted(points)]
    return found


def has_labels(folder, observation):
    with open(os.path.join(folder, 'S', 'session.xml'), encoding='utf-8') as file:
        match = re.search(rf'<observation id="{observation}".*?</observation>', file.read(), re.S)
    return bool(match and '<marker' in match.group(0))


def race(desk, rounds, rng, problems):
    points = labelled_points(desk)
    ids = sorted(points)
    both = refused = 0
    for _ in range(rounds):
        folder = desk.fresh('race')
        a, b = rng.sample(ids, 2)
        writers = []
        for observation in (a, b):
            writers.append(subprocess.Popen([desk.cli, 'label', 'S', '--observation', str(observation), '--left'] + points[observation],
                                            cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT))
            time.sleep(rng.choice([0, 0, 0.01, 0.05, 0.2, 1]))
        codes, texts = [], []
        for w in writers:
            out, _ = w.communicate(timeout=120)
            codes.append(w.returncode)
            texts.append(out.decode('utf-8', 'replace'))
        for observation, code, text in zip((a, b), codes, texts):
            if code == 0 and not has_labels(folder, observation):
                problems.append(f'two writers: labels of {observation} were said to be saved and are gone')
            if code != 0 and (code != 2 or len(text.strip()) < 20):
                problems.append(f'two writers: exit code {code}: {text[-300:]}')
            if code != 0 and has_labels(folder, observation):
                problems.append(f'two writers: labels of {observation} were refused and are there')
        both += codes == [0, 0]
        refused += 2 in codes
        code, text = run([desk.cli, 'check', 'S'], folder)
        if code != 0:
            problems.append(f'two writers: the session cannot be read: {text[-300:]}')
    return both, refused


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('cli')
    parser.add_argument('--kills', type=int, default=400)
    parser.add_argument('--rounds', type=int, default=200)
    parser.add_argument('--seed', type=int, default=1)
    o = parser.parse_args()
    rng, problems = random.Random(o.seed), []
    with tempfile.TemporaryDirectory() as root:
        desk = Desk(os.path.realpath(o.cli), root)
        desk.write_tables()
        commands = desk.commands()
        kills = 0
        for name, arguments in commands.items():
            times, whole = killed(desk, name, arguments, max(1, o.kills // len(commands)), rng, problems)
            kills += times
            print(f'{name:<22} {times} kills, {whole} of them after the change', flush=True)
        both, refused = race(desk, o.rounds, rng, problems)
        print(f'two writers: {o.rounds} rounds, {both} with both changes, {refused} with one refused in words')
    for p in problems:
        print('FAILED:', p)
    print(f'{kills} kills, {o.rounds} rounds, {len(problems)} problems')
    return 1 if problems else 0


if __name__ == '__main__':
    sys.exit(main())
