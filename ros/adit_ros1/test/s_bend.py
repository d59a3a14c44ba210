#!/usr/bin/env python3
"""The closed loop through topics flies the S-bend without contact: simulator, perception node, controller node."""
import re
import sys
import unittest

import rospy
import rostest
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu, LaserScan
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from listening import Listener


class SBend(unittest.TestCase):
    def test_it_reaches_the_goal(self):
        outcome = Listener("outcome", String)
        odometry = Listener("odom", Odometry)
        scans = Listener("scan", LaserScan)
        imu = Listener("imu", Imu)
        transforms = Listener("/tf", TFMessage)
        self.assertIsNotNone(odometry.wait(lambda m: m.header.frame_id == "odom" and m.child_frame_id == "base_link"))
        self.assertIsNotNone(scans.wait(lambda m: m.header.frame_id == "base_link" and len(m.ranges) > 100))
        self.assertIsNotNone(imu.wait(lambda m: abs(m.linear_acceleration.z - 9.8) < 3))
        self.assertIsNotNone(transforms.wait(lambda m: m.transforms[0].child_frame_id == "base_link"))
        end = outcome.wait(lambda m: True, 380)
        self.assertIsNotNone(end, "the flight did not end in time")
        print("flight through topics: " + end.data)
        self.assertTrue(end.data.startswith("goal "), end.data)
        clearance_m = float(re.search(r"clearance_min_m=([0-9.]+)", end.data).group(1))
        self.assertGreater(clearance_m, 0.25, "the body's radius")


if __name__ == "__main__":
    rospy.init_node("s_bend_test")
    rostest.rosrun("adit_ros1", "s_bend", SBend, sys.argv)
