# SPDX-License-Identifier: Apache-2.0
"""Handsight: where a robot's hand really is, and why it is not where the model says.

Sessions are read from their folder (`read`) or made of arrays (`session`). `check`, `fit`, `diagnose` and `improve`
tell what `handsight-cli ... --json` tells, under the same names; lists of numbers are NumPy arrays. `predict` and
`correct` take what `fit` and `improve` return, or a calibration file.

Units are SI and pixels: m, rad, s, kg, N m, px. A motion `b_from_a` is a 4x4 matrix: x_in_b = b_from_a @ x_in_a.
"""

from ._core import InputError, version as __version__
from ._results import Result
from ._session import Session, motion, read, session
from ._work import Calibration, check, compare, correct, diagnose, export, fit, improve, predict, read_calibration

__all__ = [
    "Calibration", "InputError", "Result", "Session", "check", "compare", "correct", "diagnose", "export", "fit",
    "improve", "motion", "predict", "read", "read_calibration", "session",
]
