#!/usr/bin/env python3
"""The controller's watchdog by a clock of the test's own: five seconds pass in an instant, time jumps and runs backwards."""
import sys
import time
import unittest

import rospy
import rostest
from adit_ros1.msg import OpenSpace
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Twist, TwistStamped
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String

from frames import wait_for_listeners
from listening import Listener, status_of, value_of


def is_hover(m):
    return m.linear.x == 0 and m.angular.z == 0


class ClockTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock = rospy.Publisher("/clock", Clock, queue_size=10, tcp_nodelay=True)
        cls.news = rospy.Publisher("open_space", OpenSpace, queue_size=10, tcp_nodelay=True)
        cls.headings = rospy.Publisher("heading", TwistStamped, queue_size=10, tcp_nodelay=True)
        cls.commands = Listener("cmd_vel", Twist)
        cls.states = Listener("controller_state", String)
        cls.diagnostics = Listener("/diagnostics", DiagnosticArray)
        wait_for_listeners(cls.clock, cls.news, cls.headings)
        cls.now_s = 100.0
        cls.rate = 0.0

    def set_clock(self, now_s):
        type(self).now_s = now_s
        self.clock.publish(Clock(rospy.Time.from_sec(now_s)))
        time.sleep(0.15)  # three ticks of the controller's

    def frame(self, status=OpenSpace.FOUND, age_s=0.0, wait_s=1.0):
        """An image was taken and judged: the command that came of it, None when none did in time."""
        type(self).rate += 0.001  # no two commands are the same
        stamp = rospy.Time.from_sec(self.now_s - age_s)
        news = OpenSpace(status=status)
        heading = TwistStamped()
        news.header.stamp = heading.header.stamp = stamp
        heading.twist.linear.x, heading.twist.angular.z = 0.2, self.rate
        self.commands.clear()
        self.news.publish(news)
        time.sleep(0.02)  # two topics: nothing else says which comes first
        self.headings.publish(heading)
        return self.commands.wait(lambda m: abs(m.angular.z - self.rate) < 1e-9, wait_s)

    def fly(self, begin_s):
        """Images by this clock until one is followed."""
        for i in range(20):
            self.set_clock(begin_s + 0.05 * i)
            if self.frame() is not None:
                return
        self.fail("it does not follow")

    def report(self):
        """What the next diagnostics say, but one: the first may have been on its way."""
        self.diagnostics.clear()
        seen = 0
        end = time.monotonic() + 10
        while time.monotonic() < end:
            found = [m for _, m in self.diagnostics.all() if status_of(m, "controller")]
            seen = len(found)
            if seen >= 2:
                return status_of(found[-1], "controller")
            time.sleep(0.05)
        self.fail("no diagnostics")

    def test_half_a_second_is_hover_and_five_are_an_error(self):
        self.fly(200.0)
        begin_s = self.now_s
        self.assertEqual(self.report().level, DiagnosticStatus.OK)
        self.commands.clear()
        self.set_clock(begin_s + 0.45)
        self.assertEqual(self.commands.all(), [], "not yet, and nothing is repeated")
        self.set_clock(begin_s + 0.55)
        self.assertGreaterEqual(len(self.commands.wait_count(1)), 1)
        self.assertTrue(all(is_hover(m) for _, m in self.commands.all()))
        self.assertIsNotNone(self.states.wait(lambda m: m.data == "no image"))
        self.assertEqual(self.report().level, DiagnosticStatus.WARN)
        self.set_clock(begin_s + 4.9)
        self.assertEqual(self.report().level, DiagnosticStatus.WARN)
        self.set_clock(begin_s + 5.1)
        status = self.report()
        self.assertEqual(status.level, DiagnosticStatus.ERROR)
        self.assertIn("no image", status.message)
        self.assertTrue(all(is_hover(m) for _, m in self.commands.all()))
        self.fly(begin_s + 6.0)
        self.assertEqual(self.report().level, DiagnosticStatus.OK)

    def test_images_without_an_opening_are_hovered_on_just_so(self):
        self.fly(300.0)
        begin_s = self.now_s
        for i in range(1, 16):
            self.set_clock(begin_s + 0.05 * i)
            self.frame(status=OpenSpace.NO_OPENING, wait_s=0.02)
        self.assertTrue(is_hover(self.commands.wait_count(1)[-1]))
        self.assertIn("no opening", self.report().message)

    def test_a_clock_that_stands_still_repeats_nothing(self):
        self.fly(400.0)
        time.sleep(0.2)
        self.commands.clear()
        time.sleep(1.0)
        self.assertEqual(self.commands.all(), [])

    def test_a_clock_that_is_set_back_is_counted_and_followed(self):
        self.fly(500.0)
        before = int(value_of(self.report(), "clock set back"))
        self.set_clock(450.0)
        self.assertTrue(is_hover(self.commands.wait_count(1)[-1]), "nothing that was seen is fresh by this clock")
        self.assertEqual(int(value_of(self.report(), "clock set back")), before + 1)
        self.fly(450.1)

    def test_a_clock_that_is_set_forward_hovers_until_the_next_image(self):
        self.fly(600.0)
        self.commands.clear()
        self.set_clock(700.0)
        self.assertTrue(is_hover(self.commands.wait_count(1)[-1]))
        self.fly(700.1)

    def test_images_of_the_past_and_of_the_future_are_named_and_counted(self):
        self.fly(800.0)
        before = self.report()
        for age_s, words, key in ((3.0, "images are old", "images of the past"),
                                  (-3.0, "images are of the future", "images of the future")):
            for _ in range(12):
                self.set_clock(self.now_s + 0.06)
                self.assertIsNone(self.frame(age_s=age_s, wait_s=0.1))
            self.assertIsNotNone(self.states.wait(lambda m: m.data.startswith(words)), words)
            # Those of the past come out of order after the fresh one at first: not all of them count.
            self.assertGreater(int(value_of(self.report(), key)), int(value_of(before, key)))
        self.set_clock(self.now_s + 10.0)
        self.fly(self.now_s)


if __name__ == "__main__":
    rospy.init_node("clock_test")
    rostest.rosrun("adit_ros1", "clock", ClockTest, sys.argv)
