#!/usr/bin/env python3
"""The camera node on a device: frames as they come, with the time of their coming; and told when it is unplugged."""
import sys
import time
import unittest

import rospy
import rostest
from adit_ros1.msg import OpenSpace
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import Image

from listening import Listener


class Camera(unittest.TestCase):
    def test_device(self):
        images = Listener("/device/camera/image_raw", Image)
        answers = Listener("/device/open_space", OpenSpace)
        said = Listener("/rosout", Log)
        first = images.wait(lambda m: True)
        self.assertIsNotNone(first, "no image")
        self.assertEqual((first.width, first.height), (640, 480))
        # A device has no rate but its own: 30 Hz, and never twice the same frame.
        kept = images.wait_count(60)
        stamps = [m.header.stamp.to_sec() for m in kept]
        self.assertGreater(len(stamps), 20)
        self.assertTrue(all(b > a for a, b in zip(stamps, stamps[1:])), stamps)
        self.assertIsNotNone(answers.wait(lambda m: m.status == OpenSpace.FOUND), "the disc was not found")
        self.assertIsNotNone(said.wait(lambda m: m.level == Log.ERROR and "/dev/video0: the camera gave no more frames" in m.msg,
                                       60), "nobody said that it is gone")
        self.assertIsNotNone(said.wait(lambda m: m.level == Log.WARN and "/dev/video0: no such camera" in m.msg),
                             "nobody asked for it again")
        count = len(images.all())
        time.sleep(0.5)
        self.assertEqual(len(images.all()), count, "images of a camera that is gone")


if __name__ == "__main__":
    rospy.init_node("camera_test")
    rostest.rosrun("adit_ros1", "camera", Camera, sys.argv)
