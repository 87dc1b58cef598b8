# SPDX-License-Identifier: Apache-2.0
"""Sessions: read from a folder, or made of arrays."""

import os
import shutil
from xml.sax.saxutils import quoteattr

import numpy

from . import _core


class Session:
    """What was measured, with its robot. Read-only; make another one to change something."""

    def __init__(self, core, robot_file=None):
        self._core = core
        self._robot_file = robot_file

    title = property(lambda self: self._core.title)
    joints = property(lambda self: self._core.joints, doc="names, in the order of the columns of positions")
    cameras = property(lambda self: self._core.cameras, doc="names; none with a tracker")
    marker_count = property(lambda self: self._core.marker_count)
    notes = property(lambda self: self._core.notes, doc="sentences: what the reader ignored or warns of")
    ids = property(lambda self: numpy.array(self._core.ids, dtype=int), doc="of the observations, in order of time")
    positions = property(lambda self: self._core.positions, doc="observations x joints, rad (m)")

    def _measured(self, camera):
        return self._core.measured(camera).reshape(len(self.ids), self.marker_count, -1)

    @property
    def pixels(self):
        """By camera: observations x markers x 2 (u, v in px), nan where it was not seen."""
        return {name: self._measured(number) for number, name in enumerate(self.cameras)}

    @property
    def points(self):
        """Of a tracker: observations x markers x 3 (m, its frame), nan where it was not seen. None with cameras."""
        return None if self.cameras else self._measured(-1)

    def save(self, folder):
        """Writes a session made of arrays as a new folder that the program opens."""
        if self._robot_file is None:
            raise _core.InputError("This session was read from a folder; copy that. Only one made of arrays is saved.")
        folder = os.fspath(folder)
        if os.path.exists(os.path.join(folder, "session.xml")):
            raise _core.InputError(f"{folder}: there is a session.xml already; name another folder.")
        os.makedirs(folder, exist_ok=True)
        shutil.copyfile(self._robot_file, os.path.join(folder, "robot.urdf"))
        with open(os.path.join(folder, "session.xml"), "w", encoding="utf-8") as file:
            file.write(self._core.text())


def read(path):
    """The session in a folder, or of a session.xml."""
    return Session(_core.read_session(os.fspath(path)))


def motion(xyz, rpy):
    """The 4x4 matrix of a translation (m) and XYZ fixed angles (rad): R = Rz(yaw) Ry(pitch) Rx(roll)."""
    (sr, sp, sy), (cr, cp, cy) = numpy.sin(rpy), numpy.cos(rpy)
    matrix = numpy.eye(4)
    matrix[:3, :3] = [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                      [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr], [-sp, cp * sr, cp * cr]]
    matrix[:3, 3] = xyz
    return matrix


def session(robot, tcp, mount, positions, *, joints, pixels=None, points=None, cameras=None, mount_from_sensor=None,
            estimate_mount=None, times=None, velocities=None, torques=None, ids=None, sigma=None, gravity=None,
            title="From arrays"):
    """A session made of arrays.

    robot: URDF file. tcp: link of the hand; mount: link that carries the sensor (the root link for one on a stand).
    positions: observations x joints; joints: their names in that order.
    pixels: {camera: observations x markers x 2}, with cameras: a list of dicts with name, width, height, fx, fy, cx, cy
    and what the camera has of skew, model, k1 ... k6, p1, p2; every camera but the first has camera_from_first (4x4).
    points: instead, of a tracker: observations x markers x 3, m. nan: not seen.
    mount_from_sensor: 4x4 of the first camera or the tracker; None: not known, it is estimated. estimate_mount=True: it
    is only a guess. sigma: of one measured coordinate where it is known, px or m. times: s, ascending.
    """
    robot = os.fspath(robot)
    positions = _array("positions", positions, 2)
    if (pixels is None) == (points is None):
        raise _core.InputError("Give either pixels (with cameras) or points (of a tracker), not both.")
    if pixels is not None and cameras is None:
        raise _core.InputError("pixels need cameras: a list of dicts with name, width, height, fx, fy, cx, cy.")
    seen = {None: points} if pixels is None else pixels
    seen = {name: _array("points" if name is None else f"pixels of {name}", values, 3, nan=True)
            for name, values in seen.items()}
    count = {values.shape[1] for values in seen.values()}
    for name, values in seen.items():
        if len(values) != len(positions) or len(count) != 1 or values.shape[2] != (3 if name is None else 2):
            raise _core.InputError(
                f"{'points' if name is None else f'pixels of {name}'} have the shape {values.shape}; expected "
                f"{len(positions)} observations x markers x {3 if name is None else 2}, as many markers in all cameras.")
    device = (_tracker(mount, mount_from_sensor, estimate_mount, sigma) if pixels is None else
              _cameras(cameras, mount, mount_from_sensor, estimate_mount))
    noise = "" if sigma is None or pixels is None else f' sigma_pixel="{_number(sigma)}"'
    lines = ['<?xml version="1.0"?>', f"<handsight_session version=\"1\" title={quoteattr(title)}>",
             f'  <robot file="robot.urdf" tcp={quoteattr(tcp)}/>']
    if gravity is not None:
        lines.append(f'  <gravity xyz="{_numbers(gravity)}"/>')
    lines += [*device, f'  <markers count="{count.pop()}"{noise}/>', f"  <joints>{' '.join(joints)}</joints>",
              "  <observations>"]
    per_pose = {"velocity": velocities, "torque": torques}
    per_pose = {name: _array(name, values, 2) for name, values in per_pose.items() if values is not None}
    for i, position in enumerate(positions):
        number, time = i if ids is None else int(ids[i]), float(i) if times is None else times[i]
        lines.append(f'    <observation id="{number}" time="{_number(time)}">')
        lines.append(f"      <position>{_numbers(position)}</position>")
        lines += [f"      <{name}>{_numbers(values[i])}</{name}>" for name, values in per_pose.items()]
        lines += _markers(i, seen)
        lines.append("    </observation>")
    lines += ["  </observations>", "</handsight_session>", ""]
    return Session(_core.session_of("\n".join(lines), robot), robot)


def _array(name, values, dimensions, nan=False):
    values = numpy.asarray(values, dtype=float)
    if values.ndim != dimensions:
        raise _core.InputError(f"{name} have {values.ndim} dimensions; expected {dimensions}.")
    if numpy.isinf(values).any() or (not nan and numpy.isnan(values).any()):
        raise _core.InputError(f"{name} hold a number that is not finite; expected numbers"
                               f"{', nan where a marker was not seen' if nan else ''}.")
    return values


def _number(value):
    return repr(float(value))


def _numbers(values):
    return " ".join(_number(value) for value in values)


def _rigid(name, matrix):
    """xyz and rpy of a 4x4 matrix, as attributes. XYZ fixed angles: R = Rz(yaw) Ry(pitch) Rx(roll)."""
    matrix = numpy.asarray(matrix, dtype=float)
    turn = matrix[:3, :3] if matrix.shape == (4, 4) else numpy.zeros((3, 3))
    if not (numpy.allclose(turn @ turn.T, numpy.eye(3), atol=1e-6) and numpy.linalg.det(turn) > 0):
        raise _core.InputError(f"{name} is no motion; expected a 4x4 matrix with a rotation and 0 0 0 1 below.")
    across = numpy.hypot(turn[0, 0], turn[1, 0])
    pitch = numpy.arctan2(-turn[2, 0], across)
    if across > 1e-9:
        roll, yaw = numpy.arctan2(turn[2, 1], turn[2, 2]), numpy.arctan2(turn[1, 0], turn[0, 0])
    else:  # roll and yaw turn about one axis
        roll, yaw = numpy.arctan2(-turn[1, 2], turn[1, 1]), 0.0
    return f'xyz="{_numbers(matrix[:3, 3])}" rpy="{_numbers((roll, pitch, yaw))}"'


def _mount(tag, mount_from_sensor, estimate):
    if mount_from_sensor is None:
        return f'    <{tag} estimate="yes"/>'
    return f'    <{tag} {_rigid("mount_from_sensor", mount_from_sensor)} estimate="{"yes" if estimate else "no"}"/>'


def _tracker(mount, mount_from_sensor, estimate, sigma):
    known = "" if sigma is None else f' sigma="{_number(sigma)}"'
    return [f"  <tracker mount={quoteattr(mount)}{known}>", _mount("mount_from_tracker", mount_from_sensor, estimate),
            "  </tracker>"]


def _cameras(cameras, mount, mount_from_sensor, estimate):
    lines = [f"  <cameras mount={quoteattr(mount)}>", _mount("mount_from_first", mount_from_sensor, estimate)]
    for number, camera in enumerate(cameras):
        values = dict(camera)
        placed = values.pop("camera_from_first", None)
        if (placed is None) != (number == 0):
            raise _core.InputError(f"Camera {camera.get('name')}: every camera but the first has camera_from_first (4x4), "
                                   "the first has none.")
        texts = {name: value if isinstance(value, str) else str(int(value)) if name in ("width", "height") else
                 _number(value) for name, value in values.items()}
        attributes = " ".join(f"{name}={quoteattr(text)}" for name, text in texts.items())
        if placed is None:
            lines.append(f"    <camera {attributes}/>")
        else:
            lines.append(f'    <camera {attributes}><from_first {_rigid("camera_from_first", placed)}/></camera>')
    return [*lines, "  </cameras>"]


def _markers(observation, seen):
    """A <marker> each that was seen by anything in this observation."""
    lines = []
    for marker in range(next(iter(seen.values())).shape[1]):
        attributes = [f'{name or "point"}="{_numbers(values[observation, marker])}"' for name, values in seen.items()
                      if not numpy.isnan(values[observation, marker]).any()]
        if attributes:
            lines.append(f'      <marker index="{marker}" {" ".join(attributes)}/>')
    return lines
