# SPDX-License-Identifier: Apache-2.0
"""The Python module from its wheel, against the command line. HANDSIGHT_SOURCE and HANDSIGHT_CLI say where they are."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import numpy

import handsight

SOURCE = pathlib.Path(os.environ["HANDSIGHT_SOURCE"])
CLI = os.environ["HANDSIGHT_CLI"]
SAMPLES = SOURCE / "sample_sessions"


def told(*arguments):
    """What the command line tells as JSON."""
    done = subprocess.run([CLI, *map(str, arguments), "--json", "-"], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    return json.loads(done.stdout)


def six_axis(**changes):
    """hidden_1 made of arrays."""
    read = handsight.read(SAMPLES / "hidden_1")
    given = dict(
        robot=SAMPLES / "robots" / "six_axis.urdf", tcp="hand", mount="stand", joints=read.joints,
        positions=read.positions, pixels=read.pixels, sigma=0.2,
        cameras=[dict(name="left", width=1024, height=768, fx=880.4, fy=881, cx=516.3, cy=381.2, k1=-0.09, k2=0.04,
                      p1=3e-4, p2=2e-4),
                 dict(name="right", width=1024, height=768, fx=878.5, fy=879.3, cx=508.4, cy=389.1, k1=-0.085, k2=0.035,
                      p1=-1e-4, p2=4e-4, camera_from_first=handsight.motion((-0.2, 7e-4, -4e-4), (-0.002, 0.14, 0.003)))],
        mount_from_sensor=handsight.motion((1.35, -0.75, 0.95), (-1.86502292781, 0, 0.91971960535)))
    return handsight.session(**{**given, **changes})


class Answers(unittest.TestCase):
    """The same as the command line's, as arrays."""

    @classmethod
    def setUpClass(cls):
        cls.session = handsight.read(SAMPLES / "hidden_1")
        cls.fit = handsight.fit(cls.session)

    def test_fit(self):
        expected = told("fit", SAMPLES / "hidden_1")
        self.assertEqual(self.fit.rms_pixel, expected["rms_pixel"])
        self.assertEqual(self.fit.tcp_from_body.matrix.tolist(), expected["tcp_from_body"]["matrix"])
        self.assertEqual(self.fit.tcp_from_body.covariance.shape, (6, 6))
        self.assertIsInstance(self.fit.markers, numpy.ndarray)
        self.assertEqual([o["id"] for o in expected["per_observation"]], [o.id for o in self.fit.per_observation])

    def test_check(self):
        expected = told("check", SAMPLES / "hidden_1")
        self.assertEqual(dict(handsight.check(self.session)), expected)
        self.assertEqual(expected["blunders"], [])

    def test_diagnose(self):
        found, expected = handsight.diagnose(self.session), told("diagnose", SAMPLES / "hidden_1")
        self.assertEqual(found.verdict, expected["verdict"])
        self.assertEqual([c.id for c in found.candidates], [c["id"] for c in expected["candidates"]])

    def test_improve_predict_and_correct(self):
        better = handsight.improve(self.session)
        self.assertLess(better.held_out_rms_pixel, self.fit.held_out_rms_pixel)
        poses = self.session.positions[:7]
        there = handsight.predict(better, poses)
        self.assertEqual(there.root_from_tcp_est.shape, (7, 4, 4))
        self.assertEqual(there.sigma.shape, (7, 6))
        command = handsight.correct(better, poses)
        self.assertTrue(command.reached.all())
        # Commanding the corrected angles brings the hand where the nominal model puts it for the others.
        arrived = handsight.predict(better, command.corrected)
        reached = numpy.linalg.norm((arrived.root_from_tcp_est - there.root_from_tcp)[:, :3, 3], axis=1)
        numpy.testing.assert_allclose(reached, 0, atol=1e-6)
        one = handsight.correct(better, poses[0], target=there.root_from_tcp[0])
        numpy.testing.assert_allclose(one.corrected, command.corrected[0], atol=1e-9)

    def test_a_calibration_file_predicts_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "calibration.xml"
            self.fit.calibration.save(file)
            robot = SAMPLES / "robots" / "six_axis.urdf"
            read = handsight.read_calibration(file, robot)
            pose = self.session.positions[3]
            expected = told("predict", file, "--robot", robot, "--position", " ".join(map(repr, pose.tolist())))[0]
            there = handsight.predict(read, pose)
            self.assertEqual(there.root_from_tcp_est.tolist(), expected["root_from_tcp_est"])
            numpy.testing.assert_allclose(handsight.predict(self.fit, pose).root_from_tcp_est, there.root_from_tcp_est,
                                          atol=1e-12)

    def test_export(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "calibrated.urdf"
            made = handsight.export(self.fit, "urdf", file)
            self.assertEqual(file.read_text(encoding="utf-8"), made.text)
            self.assertIn("<robot", made.text)
            self.assertLessEqual(made.left_mm, made.nominal_mm)
        self.assertIn("def hand_pose", handsight.export(self.fit, "python").text)
        with self.assertRaisesRegex(handsight.InputError, "stone"):
            handsight.export(self.fit, "stone tablet")

    def test_compare(self):
        expected = told("compare", SAMPLES / "hidden_1", SAMPLES / "hidden_1")
        found = handsight.compare(self.session, self.session)
        self.assertEqual(found.verdict, expected["verdict"])
        self.assertEqual(found.reason, expected["reason"])
        positions = self.session.positions.copy()
        positions[:, 2] += 0.004  # the joint's zero is another
        since = handsight.compare(self.fit, six_axis(positions=positions))
        self.assertNotEqual(since.verdict, "unchanged")
        self.assertTrue(since.changes)
        with self.assertRaises(handsight.InputError):
            handsight.compare(self.fit, self.session, effects=["joint_offset"])


class Arrays(unittest.TestCase):
    def test_a_session_of_arrays_is_the_one_on_disk(self):
        read, made = handsight.read(SAMPLES / "hidden_1"), six_axis()
        self.assertEqual(made.positions.tolist(), read.positions.tolist())
        numpy.testing.assert_array_equal(made.pixels["right"], read.pixels["right"])
        numpy.testing.assert_allclose(handsight.fit(made).tcp_from_body.matrix,
                                      handsight.fit(read).tcp_from_body.matrix, atol=1e-9)

    def test_a_marker_that_is_nan_was_not_seen(self):
        pixels = {name: values.copy() for name, values in handsight.read(SAMPLES / "hidden_1").pixels.items()}
        pixels["left"][4, 1] = numpy.nan
        made = six_axis(pixels=pixels)
        self.assertTrue(numpy.isnan(made.pixels["left"][4, 1]).all())
        self.assertFalse(numpy.isnan(made.pixels["right"][4, 1]).any())

    def test_a_tracker(self):
        read = handsight.read(SAMPLES / "hidden_1")
        markers = numpy.array([[0, 0, 0.1], [0.06, 0, 0.1], [0, 0.04, 0.1]])
        truth = handsight.predict(handsight.fit(read), read.positions).root_from_tcp
        root_from_tracker = handsight.motion((2, 0.3, 0.5), (0.1, -0.2, 3))
        in_root = numpy.einsum("nij,mj->nmi", truth[:, :3, :3], markers) + truth[:, None, :3, 3]
        points = (in_root - root_from_tracker[:3, 3]) @ root_from_tracker[:3, :3]
        points += numpy.random.default_rng(5).normal(0, 1e-4, points.shape)
        made = handsight.session(robot=SAMPLES / "robots" / "six_axis.urdf", tcp="hand", mount="stand",
                                 joints=read.joints, positions=read.positions, points=points, sigma=1e-4)
        self.assertEqual(made.points.shape, points.shape)
        found = handsight.fit(made)
        # 1e-4 m of noise in 3 markers of so many observations.
        numpy.testing.assert_allclose(found.tcp_from_body.matrix[:3, 3], markers.mean(axis=0), atol=2e-4)

    def test_a_saved_session_opens(self):
        with tempfile.TemporaryDirectory() as folder:
            six_axis().save(folder)
            self.assertEqual(handsight.read(folder).positions.shape, six_axis().positions.shape)
            with self.assertRaises(handsight.InputError):
                six_axis().save(folder)

    def test_bad_input_is_a_sentence(self):
        read = handsight.read(SAMPLES / "hidden_1")
        for call in (lambda: six_axis(positions=read.positions[:, :5]), lambda: six_axis(positions=read.positions[:9]),
                     lambda: six_axis(positions=read.positions * numpy.nan), lambda: six_axis(tcp="no_such_link"),
                     lambda: six_axis(mount_from_sensor=numpy.ones((4, 4))), lambda: handsight.read("/nowhere"),
                     lambda: handsight.fit(read, ["no_such_effect"]), lambda: handsight.fit(read, objective="x"),
                     lambda: handsight.predict(handsight.fit(read), [0.0, 1.0]),
                     lambda: handsight.correct(handsight.fit(read), read.positions[0], target=numpy.zeros((4, 4)))):
            with self.assertRaises(handsight.InputError) as raised:
                call()
            self.assertTrue(20 <= len(str(raised.exception)) <= 600, str(raised.exception))


class Guide(unittest.TestCase):
    def test_the_example_runs(self):
        text = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
        self.assertEqual(len(blocks), 2)
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(SAMPLES, pathlib.Path(folder) / "sample_sessions")
            os.chdir(folder)
            try:
                exec("\n".join(blocks), {})  # pylint: disable=exec-used
                self.assertTrue(os.path.exists("calibration.xml") and os.path.exists("my_session/session.xml"))
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main()
