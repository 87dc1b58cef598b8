#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whole commands on files that are a little wrong: fuzz_commands.py HANDSIGHT_CLI [--seconds S | --runs N] [--seed K] [--keep FOLDER]

Sessions, robots, calibrations, own effects, tables, camera files and images that work are changed in one to four places, by what they mean
(a number becomes another one, an attribute or an element goes, comes twice or changes its name) or by bytes, and a command reads them.
A finding is an exit code other than 0, 1 and 2, more than 10 s or 1 GB, a number that is none in what is printed, a refusal without a
sentence, or a file of the input that was changed. Findings are kept with the command that shows them; exit code 1 if there are any."""
import argparse
import collections
import hashlib
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

MOST_SECONDS, MOST_BYTES = 10, 1 << 30
SENTENCE = range(20, 1200)  # characters: paths of temporary folders are long
NUMBER = re.compile(rb'[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?')
NOT_A_NUMBER = re.compile(r'(?<![\w./-])-?(nan|inf|infinity)(?![\w/-])', re.I)
NUMBERS = [b'0', b'-0', b'1', b'-1', b'2', b'3', b'1e-3', b'0.5', b'1e-9', b'1e-160', b'1e-308', b'1e6', b'1e9', b'1e12', b'1e154', b'1e300',
           b'1e308', b'1e309', b'-1e9', b'nan', b'inf', b'-inf', b'2147483647', b'2147483648', b'-2147483649', b'4294967296',
           b'18446744073709551616', b'0x10', b'1,5', b'--1', b'1e', b'.', b'', b'00012', b'3.14159265358979', b'57.29578', b'1000', b'64', b'65',
           b'1 2 3', b'\xd9\xa3']
TEXTS = [b'', b' ', b'a' * 5000, b'\x1b[31mred', b'%s%n', b'../../etc/passwd', b'/dev/zero', b'.', b'-', b'name with spaces', b'\xc3\xa4\xff', b'&#0;',
         b'&lt;', b'left', b'right', b'revolute', b'prismatic', b'fixed', b'true', b'charuco']
TAG = re.compile(rb'<[A-Za-z_!?/][^<>]*>')
ATTRIBUTE = re.compile(rb'\s[\w:.-]+\s*=\s*"[^"]*"')


def run(cli, arguments, folder, seconds):
    """Exit code, output, seconds and largest memory of one command."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_FSIZE, (200 << 20, 200 << 20))
    with tempfile.TemporaryFile() as output:
        begin = time.monotonic()
        process = subprocess.Popen([cli] + arguments, cwd=folder, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                   preexec_fn=limit, start_new_session=True)
        timer = begin + seconds
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > timer:
                os.killpg(process.pid, signal.SIGKILL)
                pid, status, usage = os.wait4(process.pid, 0)
                break
            time.sleep(0.002)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read(4 << 20).decode('utf-8', 'replace')
        return process.returncode, text, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def made(cli, root, *arguments):
    subprocess.run([cli, *arguments], cwd=root, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def seeds(cli, source, root):
    """Small folders that work, each with the files that may be changed and the commands that read them."""
    samples = os.path.join(source, 'sample_sessions')
    session_commands = [
        ['check', 'S'], ['fit', 'S', '--json', '-'], ['fit', 'S', '--effects', 'joint_offset'], ['fit', 'S', '--loss', 'huber'],
        ['fit', 'S', '--objective', 'camera'], ['fit', 'S', '--objective', 'angle-axis'], ['fit', 'S', '--effects', 'own_sag', '--export', 'N.xml'],
        ['diagnose', 'S', '--json', '-'], ['improve', 'S'], ['plan', 'S'], ['effects', '--session', 'S'], ['effective-mass', 'S'],
        ['online', 'S'], ['online', 'S', '--save'], ['predict', 'K.xml', '--positions', 'P.csv', '--robot', 'R.urdf', '--json', '-'],
        ['predict', 'S', '--positions', 'P.csv'], ['simulate', '--like', 'S', '--out', 'N', '--observations', '5', '--images', 'none'],
        ['export', 'K.xml', '--robot', 'R.urdf', '--as', 'urdf', '--out', '-'], ['export', 'S', '--as', 'cpp', '--out', '-'],
        ['export', 'S', '--as', 'yaml', '--out', '-'], ['correct', 'K.xml', '--robot', 'R.urdf', '--positions', 'P.csv', '--json', '-'],
        ['compare', 'S', 'S2'], ['compare', 'K.xml', 'S'], ['batch', 'S', 'S2']]
    folders = []
    for like in ('hidden_1', 'hidden_3', 'rigs/six_axis_stand', 'rigs/seven_axis_stand'):
        folder = os.path.join(root, like.replace('/', '_'))
        os.makedirs(folder)
        made(cli, folder, 'simulate', '--like', os.path.join(samples, like), '--out', 'S', '--observations', '14', '--noise', '0.2', '--seed', '3', '--images', 'none')
        for extra in ('truth.xml',):
            path = os.path.join(folder, 'S', extra)
            if os.path.exists(path):
                os.remove(path)
        shutil.copytree(os.path.join(folder, 'S'), os.path.join(folder, 'S2'))
        made(cli, folder, 'fit', 'S', '--effects', 'joint_offset', '--export', 'K.xml')
        with open(os.path.join(folder, 'S', 'session.xml'), 'rb') as file:
            session = file.read()
        names = re.search(rb'<joints[^>]*>([^<]*)<', session).group(1).split()
        robot = re.search(rb'<robot[^>]*file="([^"]*)"', session).group(1).decode()
        shutil.copy(os.path.join(folder, 'S', robot), os.path.join(folder, 'R.urdf'))
        with open(os.path.join(folder, 'P.csv'), 'wb') as file:
            file.write(b','.join(names) + b'\n' + b'\n'.join(b','.join(b'%.3f' % (0.1 * (i + j)) for j in range(len(names))) for i in range(4)) + b'\n')
        with open(os.path.join(folder, 'Q.csv'), 'wb') as file:
            file.write(b'm0_x,m0_y,m0_z,m1_x,m1_y,m1_z,m2_x,m2_y,m2_z\n' + b'\n'.join(
                b','.join(b'%.4f' % (0.3 + 0.05 * ((7 * i + 3 * j) % 11)) for j in range(9)) for i in range(4)) + b'\n')
        with open(os.path.join(folder, 'S', 'effects.xml'), 'wb') as file:
            file.write(b'<handsight_effects version="1">\n  <effect id="own_sag" title="Own sag" scope="joint">\n'
                       b'    <cause>A gear of its own.</cause>\n    <parameter name="size" unit="rad" sigma="1e-3"/>\n'
                       b'    <moves site="angle" by="size*sin(2.7*q+0.4)"/>\n  </effect>\n</handsight_effects>\n')
        tcp = re.search(rb'<robot[^>]*tcp="([^"]*)"', session).group(1).decode()
        folders.append((folder, session_commands + [['convert', 'R.urdf', 'P.csv', 'Q.csv', '--tcp', tcp, '--out', 'N']]))
    images = os.path.join(root, 'images')
    os.makedirs(images)
    shutil.copytree(os.path.join(samples, 'first_steps'), os.path.join(images, 'S'))
    pictures = sorted(os.listdir(os.path.join(images, 'S', 'images')))
    left = os.path.join('S', 'images', pictures[0])
    right = os.path.join('S', 'images', pictures[1])
    folders.append((images, [['check', 'S'], ['online', 'S'], ['detect', left, right, '--session', 'S'],
                             ['label', 'S', '--observation', '0', '--left', '421,338', '408,411', '473,378']]))
    board = os.path.join(root, 'board')
    os.makedirs(board)
    made(cli, board, 'simulate', '--like', os.path.join(samples, 'rigs', 'one_camera_board'), '--out', 'S', '--observations', '6', '--seed', '7',
         '--farthest', '1.1')
    os.remove(os.path.join(board, 'S', 'truth.xml'))
    folders.append((board, [['check', 'S'], ['online', 'S'], ['fit', 'S'], ['diagnose', 'S']]))
    return folders


def check_seeds(cli, folders, root):
    """A command that does not work on what is right proves nothing of what is wrong."""
    for template, commands in folders:
        for arguments in commands:
            work = os.path.join(root, 'work')
            shutil.rmtree(work, ignore_errors=True)
            shutil.copytree(template, work)
            code, text, _, _ = run(cli, arguments, work, 3 * MOST_SECONDS)
            if code not in (0, 1) and arguments[0] != 'effective-mass':  # which refuses more than one marker
                sys.exit('%s: handsight-cli %s: exit code %d: %s' % (template, ' '.join(arguments), code, text[-400:]))


def files_of(folder):
    return sorted(os.path.join(at, name) for at, _, names in os.walk(folder) for name in names)


def changed_by_meaning(data, random):
    kind = random.randrange(9)
    pick = lambda found: random.choice(found) if found else None
    if kind <= 2:
        place = pick(list(NUMBER.finditer(data)))
        return data if not place else data[:place.start()] + random.choice(NUMBERS) + data[place.end():]
    if kind == 3:
        place = pick(list(NUMBER.finditer(data)))
        if not place:
            return data
        try:
            value = float(place.group()) * random.choice([-1, 10, 0.1, 57.29578, 1000, 1e-3, 1.5])
        except ValueError:
            return data
        return data[:place.start()] + repr(value).encode() + data[place.end():]
    if kind == 4:
        place = pick(list(ATTRIBUTE.finditer(data)))
        return data if not place else data[:place.start()] + random.choice([b'', place.group() * 2]) + data[place.end():]
    if kind == 5:
        place = pick(list(re.finditer(rb'="([^"]*)"', data)))
        return data if not place else data[:place.start(1)] + random.choice(TEXTS) + data[place.end(1):]
    if kind == 6:
        place = pick(list(TAG.finditer(data)))
        return data if not place else data[:place.start()] + random.choice([b'', place.group() * random.choice([2, 300])]) + data[place.end():]
    lines = data.split(b'\n')
    at = random.randrange(len(lines))
    if kind == 7:
        lines[at:at + 1] = random.choice([[], [lines[at]] * random.choice([2, 500]), [random.choice(lines)]])
    else:
        other = random.randrange(len(lines))
        lines[at], lines[other] = lines[other], lines[at]
    return b'\n'.join(lines)


def changed_by_bytes(data, random):
    if not data:
        return b'\x00'
    at = random.randrange(min(len(data), random.choice([64, 400, len(data)])))
    kind = random.randrange(4)
    if kind == 0:
        return data[:at]
    if kind == 1:
        return data[:at] + bytes([random.randrange(256)]) + data[at + 1:]
    if kind == 2:
        return data[:at] + bytes(random.randrange(256) for _ in range(random.choice([1, 4, 4000]))) + data[at:]
    return data[:at] + data[at + random.choice([1, 8, 1000]):]


def changed(path, random):
    with open(path, 'rb') as file:
        data = file.read()
    is_text = b'\x00' not in data[:1000]
    for _ in range(random.choice([1, 1, 1, 2, 4])):
        data = changed_by_meaning(data, random) if is_text and random.random() < 0.85 else changed_by_bytes(data, random)
    with open(path, 'wb') as file:
        file.write(data)


def digest(folder):
    sums = {}
    for path in files_of(folder):
        with open(path, 'rb') as file:
            sums[os.path.relpath(path, folder)] = hashlib.sha256(file.read()).hexdigest()
    return sums


def fault_of(code, text, seconds, memory, before, after, arguments):
    if code not in (0, 1, 2):
        return 'exit code %d' % code
    if seconds > MOST_SECONDS:
        return '%.1f s' % seconds
    if memory > MOST_BYTES:
        return '%d MB' % (memory >> 20)
    if found := NOT_A_NUMBER.search(re.sub(r'"[^"\n]*"|\'[^\'\n]*\'', '""', text)):
        if code == 0:
            return 'prints ' + found.group()
    if code == 2 and not any(len(line) in SENTENCE for line in text.splitlines()):
        return 'no sentence'
    if '--save' not in arguments and arguments[0] != 'label':
        lost = [name for name, value in before.items() if after.get(name) != value]
        if lost:
            return 'changed ' + lost[0]
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('cli')
    parser.add_argument('--seconds', type=float)
    parser.add_argument('--runs', type=int, default=10 ** 9)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--keep', default='found_by_commands')
    options = parser.parse_args()
    cli, source = os.path.abspath(options.cli), os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
    chance = random.Random(options.seed)
    end = time.monotonic() + (options.seconds or 1e9)
    codes, findings, slowest, largest, runs = collections.Counter(), 0, 0, 0, 0
    with tempfile.TemporaryDirectory() as root:
        os.environ['HOME'] = os.environ['XDG_STATE_HOME'] = os.environ['XDG_CONFIG_HOME'] = root
        folders = seeds(cli, source, os.path.join(root))
        check_seeds(cli, folders, root)
        while runs < options.runs and time.monotonic() < end:
            template, commands = chance.choice(folders)
            work = os.path.join(root, 'work')
            shutil.rmtree(work, ignore_errors=True)
            shutil.copytree(template, work)
            changed(chance.choice(files_of(work)), chance)
            before = digest(work)
            arguments = chance.choice(commands)
            code, text, seconds, memory = run(cli, arguments, work, 3 * MOST_SECONDS)
            after = digest(work)
            fault = fault_of(code, text, seconds, memory, before, after, arguments)
            runs += 1
            codes[code] += 1
            slowest, largest = max(slowest, seconds), max(largest, memory)
            if fault:
                findings += 1
                place = os.path.join(options.keep, '%d_%d' % (options.seed, runs))
                shutil.rmtree(place, ignore_errors=True)
                shutil.copytree(work, place)
                print('%s: %s: handsight-cli %s\n    %s' % (place, fault, ' '.join(arguments), text.strip()[-300:]), flush=True)
    print('%d runs, exit codes %s, slowest %.1f s, largest %d MB, %d findings' %
          (runs, ' '.join('%d: %d' % item for item in sorted(codes.items())), slowest, largest >> 20, findings))
    return 1 if findings else 0


if __name__ == '__main__':
    sys.exit(main())
