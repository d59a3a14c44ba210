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
from geometry_msgs.msg import Twist
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
        commands = Listener("/killed/cmd_vel", Twist)
        images = Listener("/killed/camera/image_raw", Image)
        state = Listener("/killed/controller_state", String)
        self.assertIsNotNone(commands.wait(lambda m: m.linear.x > 0), "it never flew")
        rosnode.kill_nodes(["/killed/camera"])
        self.assertIsNotNone(state.wait(lambda m: m.data == "no image"))
        last_image_s = images.all()[-1][0]
        end_s = time.monotonic() + 2.0
        while time.monotonic() < end_s:
            time.sleep(0.05)
        after = [(t - last_image_s, m) for t, m in commands.all() if t > last_image_s + 0.9]
        self.assertGreater(len(after), 10, "hover is said again and again, for autopilots that want to hear it")
        self.assertTrue(all(is_hover(m) for _, m in after), "an old command was repeated")
        hovers = [t - last_image_s for t, m in commands.all() if is_hover(m) and t > last_image_s]
        # 0.5 s after the last image was taken, a tick of 50 ms, and what a loaded machine adds.
        self.assertLess(hovers[0], 1.0)
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
