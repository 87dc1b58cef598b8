# SPDX-License-Identifier: Apache-2.0
"""check, fit, diagnose, improve, compare, predict, correct, export."""

import os

import numpy

from . import _core
from ._results import result


def _replace(path, text):
    """Writes a file whole or not at all."""
    beside = os.fspath(path) + ".new"
    with open(beside, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(beside, path)


class Calibration:
    """A robot with what was found out about it: what predict and correct take."""

    def __init__(self, core):
        self._core = core

    joints = property(lambda self: self._core.joints, doc="names, in the order of a position")
    text = property(lambda self: self._core.text(), doc="the calibration XML")

    def save(self, path):
        """Writes the calibration XML, which handsight-cli and the window read."""
        _replace(path, self.text)


def read_calibration(path, robot):
    """A calibration XML with the robot's URDF."""
    return Calibration(_core.read_calibration(os.fspath(path), os.fspath(robot)))


def check(session):
    """What is there and what would not work: contents, warnings, problems, notes (sentences)."""
    return result(_core.check(session._core))


def _fitted(pair):
    found = result(pair[0])
    found["calibration"] = Calibration(pair[1])
    return found


def fit(session, effects=(), *, objective="image", loss="none", fix_markers=False, without_wrong_points=False):
    """TCP->Body and the parameters of the effects, as `handsight-cli fit --json` tells them, and `calibration`.

    effects: "joint_offset" or "joint_offset:a2+a3" to estimate, "joint_offset:a2.offset=0.004" to hold.
    """
    return _fitted(_core.fit(session._core, list(effects), objective, loss, fix_markers, without_wrong_points))


def diagnose(session, effects=()):
    """verdict, reason, candidates, patterns, invisible ...: what the model (with these effects) lacks."""
    return result(_core.diagnose(session._core, list(effects)))


def improve(session, effects=(), *, names_only=False):
    """Diagnose, add, refit, again: steps, verdict, all that fit tells of the last model, and `calibration`."""
    return _fitted(_core.improve(session._core, list(effects), names_only))


def compare(before, after, effects=()):
    """What has changed: verdict, reason, changes (best first), numbers, hand_mean_m ... of `handsight-cli compare`.

    before: a session, or a calibration (what fit, improve or read_calibration returned) against which a few poses are
    enough. after: a later session. effects: in the model of both sessions, estimated.
    """
    if hasattr(before, "_core") and not isinstance(before, Calibration):
        return result(_core.compare(before._core, after._core, list(effects)))
    if effects:
        raise _core.InputError("effects are for two sessions; a calibration has its own.")
    return result(_core.compare_since(_calibration(before), after._core))


def export(calibration, kind, path=None):
    """The robot as another kind of file ("urdf", "mjcf", "dh", "cpp" ...; docs/formats.md), written to path if one is
    given: text, left_mm (rms distance of the file's hand from the calibration's), nominal_mm, notes."""
    told, text = _core.export_robot(_calibration(calibration), kind, "" if path is None else os.fspath(path))
    found = result(told)
    found["text"] = text
    if path is not None:
        _replace(path, text)
    return found


def _poses(positions):
    positions = numpy.asarray(positions, dtype=float)
    return numpy.atleast_2d(positions), positions.ndim == 1


def _calibration(source):
    return (source if isinstance(source, Calibration) else source.calibration)._core


def _answer(text, single):
    """One result for one pose; for many a result of arrays, a row a pose."""
    rows = result(text)
    if single:
        return rows[0]
    names = rows[0] if rows else ()
    return type(rows[0])((name, _column([row[name] for row in rows])) for name in names) if rows else rows


def _column(values):
    return None if all(value is None for value in values) else numpy.array(values)


def predict(calibration, positions):
    """Where the TCP really is: root_from_tcp (commanded), root_from_tcp_est (4x4), sigma (x y z rx ry rz; m, rad).

    calibration: what fit, improve or read_calibration returned. positions: one pose, or many as poses x joints: every
    answer then has a row a pose.
    """
    poses, single = _poses(positions)
    return _answer(_core.predict(_calibration(calibration), poses), single)


def correct(calibration, positions, target=None):
    """The joint angles to command so that the hand arrives: corrected, error_before_m, error_after_m, sigma_m, reached.

    Meant is where the nominal model puts the hand for these positions, or target (4x4, root_from_tcp).
    """
    poses, single = _poses(positions)
    return _answer(_core.correct(_calibration(calibration), poses, None if target is None else numpy.asarray(target)),
                   single)
