#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A robot on ROS 1 for tests, with handsight-driver-simulated behind it: robot.py CAMERA COMMAND LOG [SECONDS]. It publishes
/joint_states and /CAMERA/image, follows what comes on /command and, where actionlib is installed, serves
/follow_joint_trajectory; each move takes so many seconds. A line of LOG for each move, and for each that was cancelled."""
import json
import queue
import subprocess
import sys
import threading
import time

import cv2
import rospy
from sensor_msgs.msg import Image, JointState
from trajectory_msgs.msg import JointTrajectory

camera, command, log = sys.argv[1:4]
seconds = float(sys.argv[4]) if len(sys.argv) > 4 else 0
process = subprocess.Popen(command, shell=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
count = 0


def ask(what, **more):
    global count
    count += 1
    process.stdin.write(json.dumps({"do": what, "id": count, **more}) + "\n")
    process.stdin.flush()
    return json.loads(process.stdout.readline())


def seen():
    grey = cv2.imread(ask("look")["images"][camera], cv2.IMREAD_GRAYSCALE)
    return Image(height=grey.shape[0], width=grey.shape[1], encoding="mono8", step=grey.shape[1], data=grey.tobytes())


def noted(line):
    with open(log, "a") as file:
        file.write(line + "\n")


def serve():
    import actionlib
    from control_msgs.msg import FollowJointTrajectoryAction, FollowJointTrajectoryResult

    def follow(goal):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if server.is_preempt_requested():
                noted("cancelled")
                return server.set_preempted()
            time.sleep(0.02)
        arrived = threading.Event()
        orders.put((goal.trajectory, arrived))
        arrived.wait()
        server.set_succeeded(FollowJointTrajectoryResult(error_code=0))

    server = actionlib.SimpleActionServer("/follow_joint_trajectory", FollowJointTrajectoryAction, follow, False)
    server.start()


hello = ask("hello")
position, orders = hello["position"], queue.Queue()
rospy.init_node("robot", disable_signals=True)
states = rospy.Publisher("/joint_states", JointState, queue_size=1)
images = rospy.Publisher(f"/{camera}/image", Image, queue_size=1)
rospy.Subscriber("/command", JointTrajectory, lambda trajectory: orders.put((trajectory, None)))
try:
    serve()
except ImportError:
    pass
image = seen()
while True:
    arrived = None
    try:
        trajectory, arrived = orders.get(timeout=0.05)
        noted(f"{len(trajectory.points)} points")
        places = [trajectory.joint_names.index(name) for name in hello["joints"]]
        moved = ask("move", path=[[point.positions[i] for i in places] for point in trajectory.points], speed=1.0)
        image = seen()  # before anybody hears that the robot has arrived
        position = moved["position"]
    except queue.Empty:
        pass
    states.publish(JointState(name=hello["joints"], position=position, header=rospy.Header(stamp=rospy.Time.now())))
    images.publish(image)
    if arrived:
        arrived.set()
