#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A robot on ROS 1 for tests, with handsight-driver-simulated behind it: ros_robot.py CAMERA COMMAND LOG. It publishes
/joint_states and /CAMERA/image and follows what comes on /command, a line of LOG each time."""
import json
import queue
import subprocess
import sys

import cv2
import rospy
from sensor_msgs.msg import Image, JointState
from trajectory_msgs.msg import JointTrajectory

camera, command, log = sys.argv[1:4]
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


hello = ask("hello")
position, orders = hello["position"], queue.Queue()
rospy.init_node("robot", disable_signals=True)
states = rospy.Publisher("/joint_states", JointState, queue_size=1)
images = rospy.Publisher(f"/{camera}/image", Image, queue_size=1)
rospy.Subscriber("/command", JointTrajectory, orders.put)
image = seen()
while True:
    try:
        trajectory = orders.get(timeout=0.05)
        with open(log, "a") as file:
            file.write(f"{len(trajectory.points)} points\n")
        places = [trajectory.joint_names.index(name) for name in hello["joints"]]
        moved = ask("move", path=[[point.positions[i] for i in places] for point in trajectory.points], speed=1.0)
        image = seen()  # before anybody hears that the robot has arrived
        position = moved["position"]
    except queue.Empty:
        pass
    states.publish(JointState(name=hello["joints"], position=position, header=rospy.Header(stamp=rospy.Time.now())))
    images.publish(image)
