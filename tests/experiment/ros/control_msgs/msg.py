# SPDX-License-Identifier: Apache-2.0
"""The messages of FollowJointTrajectory as ROS 1 has them (control_msgs 1.5), which Debian 12 has no package of."""
import actionlib_msgs.msg
import genpy.dynamic
import std_msgs.msg
import trajectory_msgs.msg

RULE = "=" * 80
JOINT_TOLERANCE = "string name\nfloat64 position\nfloat64 velocity\nfloat64 acceleration\n"
GOAL = ("trajectory_msgs/JointTrajectory trajectory\nJointTolerance[] path_tolerance\nJointTolerance[] goal_tolerance\n"
        "duration goal_time_tolerance\n")
RESULT = ("int32 error_code\nint32 SUCCESSFUL = 0\nint32 INVALID_GOAL = -1\nint32 INVALID_JOINTS = -2\n"
          "int32 OLD_HEADER_TIMESTAMP = -3\nint32 PATH_TOLERANCE_VIOLATED = -4\nint32 GOAL_TOLERANCE_VIOLATED = -5\n"
          "string error_string\n")
FEEDBACK = ("Header header\nstring[] joint_names\ntrajectory_msgs/JointTrajectoryPoint desired\n"
            "trajectory_msgs/JointTrajectoryPoint actual\ntrajectory_msgs/JointTrajectoryPoint error\n")
NAME = "FollowJointTrajectory"
OWN = {
    NAME + "Action": f"{NAME}ActionGoal action_goal\n{NAME}ActionResult action_result\n{NAME}ActionFeedback action_feedback\n",
    NAME + "ActionGoal": f"Header header\nactionlib_msgs/GoalID goal_id\n{NAME}Goal goal\n",
    NAME + "ActionResult": f"Header header\nactionlib_msgs/GoalStatus status\n{NAME}Result result\n",
    NAME + "ActionFeedback": f"Header header\nactionlib_msgs/GoalStatus status\n{NAME}Feedback feedback\n",
    NAME + "Goal": GOAL,
    NAME + "Result": RESULT,
    NAME + "Feedback": FEEDBACK,
    "JointTolerance": JOINT_TOLERANCE,
}


def own_text(message):
    """A message's definition without those that it has parts of, which follow it in its full text."""
    return message._full_text.split(RULE)[0]


def definition():
    parts = {"control_msgs/" + name: text for name, text in OWN.items()}
    for message in (std_msgs.msg.Header, actionlib_msgs.msg.GoalID, actionlib_msgs.msg.GoalStatus,
                    trajectory_msgs.msg.JointTrajectory, trajectory_msgs.msg.JointTrajectoryPoint):
        parts[message._type] = own_text(message)
    whole = parts.pop("control_msgs/" + NAME + "Action")
    return whole + "".join(f"{RULE}\nMSG: {name}\n{text}\n" for name, text in parts.items())


generated = genpy.dynamic.generate_dynamic("control_msgs/" + NAME + "Action", definition())
for full_name, message in generated.items():
    if full_name.startswith("control_msgs/"):
        globals()[full_name.split("/")[1]] = message
