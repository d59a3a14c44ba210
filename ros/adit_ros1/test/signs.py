#!/usr/bin/env python3
"""Signs and frames of every command, from an image to the autopilot's setpoint: right in the image is a negative yaw rate."""
import math
import sys
import unittest

import rospy
import rostest
from adit_ros1.msg import OpenSpace
from geometry_msgs.msg import Twist, TwistStamped
from sensor_msgs.msg import CameraInfo, Image

from frames import camera_info, image_of, tunnel, wait_for_listeners
from listening import Listener

try:
    from mavros_msgs.msg import PositionTarget
except ImportError:
    PositionTarget = None  # adit was built without it


class Signs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.images = rospy.Publisher("image", Image, queue_size=10, tcp_nodelay=True)
        cls.infos = rospy.Publisher("camera_info", CameraInfo, queue_size=10, latch=True)
        cls.answers = Listener("open_space", OpenSpace)
        cls.headings = Listener("heading", TwistStamped)
        cls.setpoints = Listener("setpoint_velocity/cmd_vel", TwistStamped)
        cls.twists = Listener("cmd_vel", Twist)
        cls.targets = Listener("setpoint_raw/local", PositionTarget) if PositionTarget else None
        wait_for_listeners(cls.images, cls.infos)
        cls.infos.publish(camera_info(rospy.Time.now()))
        rospy.sleep(0.5)

    def look(self, middle_px):
        """The last answer, heading and commands of a second of frames with the opening there."""
        for i in range(30):
            stamp = rospy.Time.now()
            self.images.publish(image_of(tunnel(middle_px, i), stamp))
            answer = self.answers.wait(lambda m: m.header.stamp == stamp)
            heading = self.headings.wait(lambda m: m.header.stamp == stamp)
            self.assertIsNotNone(answer)
            self.assertIsNotNone(heading)
            self.assertEqual(answer.status, OpenSpace.FOUND, answer.status_text)
            rospy.sleep(0.01)
        return answer, heading

    def commanded(self, listener, rate_of, heading):
        """The command that carries the heading's rate."""
        wanted = heading.twist.angular.z
        return listener.wait(lambda m: abs(rate_of(m) - wanted) < 1e-6 and abs(wanted) > 0.02)

    def check(self, middle_px, right):
        answer, heading = self.look(middle_px)
        turn = -1.0 if right else 1.0
        self.assertGreater(-turn * answer.sx, 0.05)
        self.assertGreater(-turn * answer.azimuth, 0.05, "azimuth is positive to the right")
        self.assertGreater(turn * heading.twist.angular.z, 0.02, "REP 103: positive to the left")
        twist = self.commanded(self.twists, lambda m: m.angular.z, heading)
        self.assertIsNotNone(twist, "no such command")
        setpoint = self.commanded(self.setpoints, lambda m: m.twist.angular.z, heading)
        self.assertIsNotNone(setpoint, "no such setpoint")
        for linear in (twist.linear, setpoint.twist.linear):
            self.assertEqual((linear.x, linear.y, linear.z), (heading.twist.linear.x, 0.0, 0.0))
        self.assertEqual(setpoint.header.frame_id, "base_link")
        return heading

    def target_of(self, heading):
        if PositionTarget is None:
            self.skipTest("adit_ros1 was built without mavros_msgs")
        return self.commanded(self.targets, lambda m: m.yaw_rate, heading)

    def check_target(self, target):
        """Velocity and yaw rate of the body, and nothing else, is asked of the autopilot."""
        used = (PositionTarget.IGNORE_VX | PositionTarget.IGNORE_VY | PositionTarget.IGNORE_VZ | PositionTarget.IGNORE_YAW_RATE
                | PositionTarget.FORCE)
        unused = (PositionTarget.IGNORE_PX | PositionTarget.IGNORE_PY | PositionTarget.IGNORE_PZ | PositionTarget.IGNORE_AFX
                  | PositionTarget.IGNORE_AFY | PositionTarget.IGNORE_AFZ | PositionTarget.IGNORE_YAW)
        self.assertEqual(target.type_mask & used, 0)
        self.assertEqual(target.type_mask, unused)
        self.assertEqual(target.coordinate_frame, PositionTarget.FRAME_BODY_NED)
        self.assertEqual(target.header.frame_id, "base_link")
        self.assertEqual((target.velocity.y, target.velocity.z), (0.0, 0.0))
        for vector in (target.position, target.acceleration_or_force):
            self.assertEqual((vector.x, vector.y, vector.z), (0.0, 0.0, 0.0))

    def test_right_is_negative(self):
        self.check(250.0, True)

    def test_left_is_positive(self):
        self.check(70.0, False)

    def test_the_autopilot_is_told_the_same(self):
        for middle_px, right in ((250.0, True), (70.0, False)):
            heading = self.check(middle_px, right)
            target = self.target_of(heading)
            self.assertIsNotNone(target, "no such setpoint")
            self.check_target(target)
            self.assertEqual(target.velocity.x, heading.twist.linear.x)
            self.assertEqual(math.copysign(1.0, target.yaw_rate), -1.0 if right else 1.0)
            age_s = (rospy.Time.now() - target.header.stamp).to_sec()
            self.assertLess(abs(age_s), 20.0)

    def test_the_autopilot_is_told_to_hover(self):
        """Nothing comes any more: zero is an order, not a field to be ignored."""
        if PositionTarget is None:
            self.skipTest("adit_ros1 was built without mavros_msgs")
        self.look(160.0)
        rospy.sleep(1.0)
        self.targets.clear()
        for target in self.targets.wait_count(5)[:5]:
            self.check_target(target)
            self.assertEqual((target.velocity.x, target.yaw_rate), (0.0, 0.0))
        self.assertGreaterEqual(len(self.targets.all()), 5)

    def test_the_message_is_that_of_mavros(self):
        """MAVROS refuses to connect to a message of another checksum. This is the checksum of the public mavros_msgs."""
        if PositionTarget is None:
            self.skipTest("adit_ros1 was built without mavros_msgs")
        self.assertEqual(PositionTarget._md5sum, "dedb0081aaf8cb20209737746bb49117")


if __name__ == "__main__":
    rospy.init_node("signs_test")
    rostest.rosrun("adit_ros1", "signs", Signs, sys.argv)
