#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The small recording of recordings.h, written by ROS's own rosbag: write_with_rosbag.py FOLDER. Exit code 77 where Debian's
python3-rosbag, python3-sensor-msgs and python3-tf2-msgs are not installed."""
import math
import sys

try:
    import genpy
    import rosbag
    from geometry_msgs.msg import PoseStamped, TransformStamped
    from sensor_msgs.msg import CameraInfo, Image, JointState
    from std_msgs.msg import Int8, String
    from tf2_msgs.msg import TFMessage
except ImportError:
    sys.exit(77)


def quaternion(roll, pitch, yaw):
    """x, y, z, w of Rz(yaw) Ry(pitch) Rx(roll)."""
    cr, sr, cp, sp, cy, sy = (f(a / 2) for a in (roll, pitch, yaw) for f in (math.cos, math.sin))
    return (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)


def set_place(place, turn, i):
    place.x, place.y, place.z = 0.1, 0.01 * i, 0.5
    turn.x, turn.y, turn.z, turn.w = quaternion(0.1 * i, 0.2, -0.05 * i)


def write(bag):
    bag.write('/robot_description', String('<robot/>'), genpy.Time(999))
    for i in range(40):
        t = genpy.Time(1000 + i // 10, 100000000 * (i % 10))
        joints = JointState(name=['a', 'bb'], position=[0.01 * i, -0.5], effort=[1, 2])
        joints.header.stamp = t
        bag.write('/joint_states', joints, t)
        tf = TransformStamped(child_frame_id='tag_7')
        tf.header.stamp, tf.header.frame_id = t, 'camera'
        set_place(tf.transform.translation, tf.transform.rotation, i)
        bag.write('/tf', TFMessage([tf]), t)
        board = PoseStamped()
        board.header = tf.header
        set_place(board.pose.position, board.pose.orientation, 40 - i)
        bag.write('/board', board, t)
        bag.write('/chatter', Int8(3), t)
        if i % 10:
            continue
        info = CameraInfo(height=6, width=8, distortion_model='plumb_bob', D=[-0.1, 0.01, 0, 0, 0], K=[10, 0, 4, 0, 11, 3, 0, 0, 1],
                          R=[1, 0, 0, 0, 1, 0, 0, 0, 1], P=[10, 0, 4, 0, 0, 11, 3, 0, 0, 0, 1, 0])
        info.header = tf.header
        bag.write('/camera/camera_info', info, t)
        image = Image(height=6, width=8, encoding='mono8', step=8, data=bytes([ord('a') + i // 10]) * 48)
        image.header = tf.header
        bag.write('/camera/image_raw', image, t)


for compression in ('none', 'bz2', 'lz4'):
    with rosbag.Bag('%s/%s.bag' % (sys.argv[1], compression), 'w', compression=compression, chunk_threshold=2000) as recording:
        write(recording)
