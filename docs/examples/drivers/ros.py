#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A driver for ROS 1: control_msgs/FollowJointTrajectory moves, sensor_msgs/JointState tells where the robot stands,
sensor_msgs/Image is what a camera sees.

ros.py --action /arm/follow_joint_trajectory --joints a1 a2 ... --image left=/left/image_rect --out FOLDER [--states /joint_states]

Without control_msgs (Debian 12 has no package of it) --command TOPIC publishes the same path as a
trajectory_msgs/JointTrajectory, and the driver waits until the robot stands at its end."""
import argparse
import json
import os
import sys
import threading
import time

ANSWERS = os.fdopen(os.dup(1), "w")  # rospy prints to standard output now and then, where answers belong:
os.dup2(2, 1)  # what it prints goes to standard error

import rospy
from sensor_msgs.msg import Image, JointState
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

NEAR = 0.002  # rad: so near to the end the robot has arrived
SENT = 0.2  # s: so long a message is on its way before the node may end
STILL = 0.3  # s: so long it must stand before it is looked


class Robot:
    def __init__(self, options):
        self.options, self.joints = options, options.joints
        self.lock, self.state, self.images = threading.Lock(), None, {}
        rospy.init_node("handsight_driver", disable_signals=True, anonymous=True)
        rospy.Subscriber(options.states, JointState, self.took_state, queue_size=5)
        self.cameras = dict(pair.split("=", 1) for pair in options.image)
        for camera, topic in self.cameras.items():
            rospy.Subscriber(topic, Image, lambda image, camera=camera: self.took_image(camera, image), queue_size=1)
        self.client = self.publisher = None
        if options.command:
            self.publisher = rospy.Publisher(options.command, JointTrajectory, queue_size=1)
        else:
            import actionlib
            from control_msgs.msg import FollowJointTrajectoryAction
            self.client = actionlib.SimpleActionClient(options.action, FollowJointTrajectoryAction)
            if not self.client.wait_for_server(rospy.Duration(options.limit)):
                raise SystemExit(f"No action server at {options.action} for {options.limit:g} s.")

    def took_state(self, state):
        if all(name in state.name for name in self.joints):
            with self.lock:
                self.state = (time.monotonic(), state)

    def took_image(self, camera, image):
        with self.lock:
            self.images[camera] = (time.monotonic(), image)

    def fresh(self, what, since):
        """Waits for a message that came after `since`."""
        end = time.monotonic() + self.options.limit
        while time.monotonic() < end:
            with self.lock:
                got = self.state if what is None else self.images.get(what)
            if got and got[0] > since:
                return got[1]
            time.sleep(0.005)
        raise RuntimeError(f"nothing came on {self.options.states if what is None else self.cameras[what]} for "
                           f"{self.options.limit:g} s")

    def where(self):
        state = self.fresh(None, time.monotonic())
        values = dict(zip(state.name, state.position))
        efforts = dict(zip(state.name, state.effort))
        answer = {"position": [values[name] for name in self.joints], "time": state.header.stamp.to_sec()}
        if all(name in efforts for name in self.joints):
            answer["torque"] = [efforts[name] for name in self.joints]
        return answer

    def trajectory(self, path, speed):
        trajectory = JointTrajectory(joint_names=self.joints)
        before, seconds = self.where()["position"], 0.0
        for point in path:
            seconds += max(0.05, 1.5 * max(abs(a - b) for a, b in zip(point, before)) / speed)
            trajectory.points.append(JointTrajectoryPoint(positions=point, velocities=[0.0] * len(point),
                                                          time_from_start=rospy.Duration(seconds)))
            before = point
        return trajectory, seconds

    def move(self, path, speed):
        trajectory, seconds = self.trajectory(path, speed)
        if self.client:
            from control_msgs.msg import FollowJointTrajectoryGoal
            self.client.send_goal(FollowJointTrajectoryGoal(trajectory=trajectory))
            if not self.client.wait_for_result(rospy.Duration(3 * seconds + self.options.limit)):
                self.client.cancel_goal()
                raise RuntimeError("the trajectory has not ended in three times its time")
            if self.client.get_result().error_code != 0:
                raise RuntimeError(f"error code {self.client.get_result().error_code} of the trajectory")
        else:
            self.publisher.publish(trajectory)
            self.wait_for(path[-1], 3 * seconds + self.options.limit)
        time.sleep(STILL)
        return {"ok": True, **self.where()}

    def wait_for(self, goal, limit):
        end = time.monotonic() + limit
        while max(abs(a - b) for a, b in zip(self.where()["position"], goal)) > NEAR:
            if time.monotonic() > end:
                raise RuntimeError(f"the robot has not arrived in {limit:.0f} s")

    def stop(self):
        if self.client:
            self.client.cancel_all_goals()
        else:
            here = self.where()["position"]
            self.publisher.publish(self.trajectory([here], 1.0)[0])

    def look(self):
        since, files = time.monotonic(), {}
        for camera in self.cameras:
            files[camera] = self.written(camera, self.fresh(camera, since))
        return {"ok": True, "images": files}

    def written(self, camera, image):
        """As PGM, which needs no library: grey images, and the green channel of coloured ones."""
        channels = {"mono8": 1, "rgb8": 3, "bgr8": 3, "rgba8": 4, "bgra8": 4}.get(image.encoding)
        if not channels:
            raise RuntimeError(f"images of {camera} are {image.encoding}; expected mono8, rgb8, bgr8, rgba8 or bgra8")
        grey = bytearray()
        for row in range(image.height):
            line = image.data[row * image.step:row * image.step + image.width * channels]
            grey += line[(1 if channels > 1 else 0)::channels]
        file = os.path.join(self.options.out, f"{camera}_{time.time_ns()}.pgm")
        with open(file, "wb") as out:
            out.write(b"P5\n%d %d\n255\n" % (image.width, image.height) + bytes(grey))
        return file


def answer(robot, options, message):
    try:
        if message["do"] == "hello":
            said = {"joints": options.joints, "can": ["move", "look"], "name": "ROS", "position": robot.where()["position"]}
        elif message["do"] == "move":
            said = robot.move(message["path"], message["speed"])
        elif message["do"] == "look":
            said = robot.look()
        else:
            robot.stop()
            said = {"ok": True}
    except Exception as error:  # told, not raised: the experiment decides
        said = {"ok": False, "why": str(error) or type(error).__name__}
    print(json.dumps({"id": message["id"], **said}), file=ANSWERS, flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--action", default="/follow_joint_trajectory")
    parser.add_argument("--command", help="publish a JointTrajectory here in place of the action")
    parser.add_argument("--states", default="/joint_states")
    parser.add_argument("--joints", nargs="+", required=True)
    parser.add_argument("--image", nargs="*", default=[], metavar="CAMERA=TOPIC")
    parser.add_argument("--out", default=".", help="where images are written")
    parser.add_argument("--limit", type=float, default=20, help="s that anything is waited for")
    options = parser.parse_args()
    robot = Robot(options)
    for line in sys.stdin:  # in a thread: a stop may come while the robot moves
        threading.Thread(target=answer, args=(robot, options, json.loads(line)), daemon=True).start()
    robot.stop()  # nobody speaks any more: the program has ended, by itself or not, and nothing moves on
    time.sleep(SENT)


main()
