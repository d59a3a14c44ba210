#!/usr/bin/env python3
"""A camera that is killed and a camera that freezes: hover, reported, and an error after five seconds."""
import sys
import time
import unittest

import rosnode
import rospy
import rostest
from adit_ros1.msg import OpenSpace
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Twist, TwistStamped
from sensor_msgs.msg import Image
from std_msgs.msg import String

from listening import Listener, status_of


def is_hover(m):
    return m.linear.x == 0 and m.linear.y == 0 and m.linear.z == 0 and m.angular.z == 0


class Watchdog(unittest.TestCase):
    def wait_for_error(self, namespace, words):
        diagnostics = Listener("/diagnostics", DiagnosticArray)

        def is_error(m):
            status = status_of(m, namespace + "/controller: controller") or status_of(m, "controller: controller")
            return (status is not None and namespace in status.name and status.level == DiagnosticStatus.ERROR
                    and words in status.message)
        return diagnostics.wait(is_error, 20)

    def test_killed(self):
        commands = Listener("/killed/setpoint_velocity/cmd_vel", TwistStamped)
        images = Listener("/killed/camera/image_raw", Image)
        state = Listener("/killed/controller_state", String)
        self.assertIsNotNone(commands.wait(lambda m: m.twist.linear.x > 0), "it never flew")
        self.assertIsNotNone(images.wait(lambda m: True), "no image")
        rosnode.kill_nodes(["/killed/camera"])
        self.assertIsNotNone(state.wait(lambda m: m.data == "no image"))
        time.sleep(2.0)
        # By their stamps: when a message reaches this test is another matter.
        last_image = max(m.header.stamp for _, m in images.all())
        later = [((m.header.stamp - last_image).to_sec(), m.twist) for _, m in commands.all()
                 if m.header.stamp > last_image]
        # 0.5 s after the last image was taken, and what may come between looking at the clock and writing the stamp.
        after = [twist for age_s, twist in later if age_s > 0.6]
        self.assertGreater(len(after), 10, "hover is said again and again, for autopilots that want to hear it")
        self.assertTrue(all(is_hover(twist) for twist in after), "an old command was repeated")
        first_hover_s = min(age_s for age_s, twist in later if is_hover(twist))
        print("watchdog: hover %.2f s after the last image was taken" % first_hover_s)
        # A tick of 50 ms, and what a loaded machine adds.
        self.assertLess(first_hover_s, 1.5)
        self.assertIsNotNone(self.wait_for_error("killed", "no image"))

    def test_frozen(self):
        commands = Listener("/frozen/cmd_vel", Twist)
        images = Listener("/frozen/camera/image_raw", Image)
        answers = Listener("/frozen/open_space", OpenSpace)
        self.assertIsNotNone(answers.wait(lambda m: m.status == OpenSpace.FROZEN_FRAME, 30))
        self.assertIsNotNone(self.wait_for_error("frozen", "frozen"))
        images.clear()
        commands.clear()
        self.assertGreater(len(images.wait_count(10)), 9, "the driver goes on publishing")
        self.assertTrue(all(is_hover(m) for m in commands.wait_count(10)))


if __name__ == "__main__":
    rospy.init_node("watchdog_test")
    rostest.rosrun("adit_ros1", "watchdog", Watchdog, sys.argv)
