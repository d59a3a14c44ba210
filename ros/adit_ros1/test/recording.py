#!/usr/bin/env python3
"""bag.launch: a recording that plays again and again, with compressed or raw images, is flown by its own clock."""
import sys
import unittest

import rospy
import rostest
from adit_ros1.msg import OpenSpace
from geometry_msgs.msg import Twist
from rosgraph_msgs.msg import Clock

from listening import Listener


class Recording(unittest.TestCase):
    def test_it_is_judged_in_its_own_time(self):
        clock = Listener("/clock", Clock)
        answers = Listener("open_space", OpenSpace)
        commands = Listener("cmd_vel", Twist)
        found = answers.wait(lambda m: m.status == OpenSpace.FOUND)
        self.assertIsNotNone(found, "no opening was found")
        # The flight's own time, from 1 s on, and not the time of day.
        self.assertLess(found.header.stamp.to_sec(), 60.0)
        self.assertIsNotNone(clock.wait(lambda m: m.clock.to_sec() < 60.0))
        self.assertIsNotNone(commands.wait(lambda m: m.linear.x > 0), "images of that time are fresh by that clock")

    def test_it_goes_on_when_the_recording_begins_again(self):
        answers = Listener("open_space", OpenSpace)
        first = answers.wait(lambda m: True)
        self.assertIsNotNone(first)
        late = answers.wait(lambda m: m.header.stamp > first.header.stamp)
        again = answers.wait(lambda m: m.header.stamp < late.header.stamp and m is not first, 40)
        self.assertIsNotNone(again, "the recording did not begin again")
        answers.clear()
        self.assertIsNotNone(answers.wait(lambda m: m.status == OpenSpace.FOUND))


if __name__ == "__main__":
    rospy.init_node("recording_test")
    rostest.rosrun("adit_ros1", "recording", Recording, sys.argv)
