#!/usr/bin/env python3
"""What cameras and their drivers do wrong, through topics: each named, counted and survived by perception."""
import sys
import time
import unittest

import rospy
import rostest
from adit_ros1.msg import OpenSpace
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from sensor_msgs.msg import CameraInfo, Image

from frames import camera_info, image_of, tunnel, wait_for_listeners
from listening import Listener, status_of, value_of


class Camera:
    """A camera of the test's own, and what the node behind it says."""

    def __init__(self, namespace):
        self.images = rospy.Publisher(namespace + "/image", Image, queue_size=10, tcp_nodelay=True)
        self.infos = rospy.Publisher(namespace + "/camera_info", CameraInfo, queue_size=10)
        self.answers = Listener(namespace + "/open_space", OpenSpace)
        self.diagnostics = Listener("/diagnostics", DiagnosticArray)
        self.name = (namespace + "/open_space").strip("/") + ": open space"
        self.seed = 0
        wait_for_listeners(self.images, self.infos)

    def frame(self, stamp=None, **size):
        self.seed += 1
        return image_of(tunnel(seed=self.seed, **size), stamp or rospy.Time.now())

    def send(self, image, seconds=10.0):
        """The answer to it; None when none came in time."""
        seen = len(self.answers.all())
        self.images.publish(image)
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for _, answer in self.answers.all()[seen:]:
                if answer.header.stamp == image.header.stamp or image.header.stamp.is_zero():
                    return answer
            time.sleep(0.01)
        return None

    def status(self, wanted=lambda status: True, seconds=20.0):
        """What the next diagnostics say of which this holds; None when they did not come in time."""
        self.diagnostics.clear()
        found = self.diagnostics.wait(
            lambda m: (status_of(m, self.name) is not None) and wanted(status_of(m, self.name)), seconds)
        return status_of(found, self.name) if found else None

    def told(self, message, words, level):
        """Sends it again and again until the diagnostics name it."""
        self.diagnostics.clear()
        end = time.monotonic() + 20
        while time.monotonic() < end:
            message()
            status = self.diagnostics.wait(lambda m: status_of(m, self.name) is not None
                                           and words in status_of(m, self.name).message, 0.05)
            if status is not None:
                return status_of(status, self.name).level == level
        return False


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.camera = Camera("/calibrated")
        cls.bare = Camera("/bare")
        cls.camera.infos.publish(camera_info(rospy.Time.now()))
        time.sleep(0.5)

    def setUp(self):
        # Each test begins with a stream that is as it should be.
        for _ in range(3):
            self.assertIsNotNone(self.camera.send(self.camera.frame()))
        self.before = self.camera.status()
        self.assertIsNotNone(self.before, "no diagnostics")

    def count(self, key):
        """By so much a counter has grown in this test, and the stream goes on."""
        answer = self.camera.send(self.camera.frame())
        self.assertIsNotNone(answer, "it did not go on")
        self.assertEqual(answer.status, OpenSpace.FOUND, answer.status_text)
        return int(value_of(self.camera.status(), key)) - int(value_of(self.before, key))

    def test_an_encoding_that_nobody_knows(self):
        image = self.camera.frame()
        image.encoding = "colours_of_mars"
        self.assertIsNone(self.camera.send(image, 0.3))
        self.assertEqual(self.count("encodings unknown"), 1)
        self.assertTrue(self.camera.told(lambda: self.camera.images.publish(image), "colours_of_mars", DiagnosticStatus.WARN))

    def test_an_image_that_is_shorter_than_it_says(self):
        image = self.camera.frame()
        image.data = image.data[:1000]
        self.assertIsNone(self.camera.send(image, 0.3))
        self.assertEqual(self.count("images unusable"), 1)
        self.assertTrue(self.camera.told(lambda: self.camera.images.publish(image), "the message is damaged", DiagnosticStatus.WARN))

    def test_a_stamp_that_comes_twice(self):
        image = self.camera.frame()
        self.assertIsNotNone(self.camera.send(image))
        self.assertIsNone(self.camera.send(image, 0.3))
        self.assertEqual(self.count("stamps duplicate"), 1)
        last = self.camera.frame()
        self.camera.send(last)
        self.assertTrue(self.camera.told(lambda: self.camera.images.publish(last), "duplicate", DiagnosticStatus.WARN))

    def test_a_stamp_that_is_out_of_order(self):
        late, early = self.camera.frame(), self.camera.frame()
        late.header.stamp = rospy.Time.now()
        early.header.stamp = late.header.stamp - rospy.Duration(0.1)
        self.assertIsNotNone(self.camera.send(late))
        self.assertIsNone(self.camera.send(early, 0.3))
        self.assertEqual(self.count("stamps reordered"), 1)

    def test_time_that_goes_backwards_and_comes_back(self):
        """A bag that starts again, a clock that is set: the next images count from there."""
        past = rospy.Time.now() - rospy.Duration(1000)
        self.assertIsNotNone(self.camera.send(self.camera.frame(past)))
        self.assertIsNotNone(self.camera.send(self.camera.frame(past + rospy.Duration(0.03))))
        self.assertEqual(self.count("stamps restarted"), 1)
        self.assertGreaterEqual(self.count("stamps gap"), 1)

    def test_a_driver_that_does_not_stamp(self):
        answer = self.camera.send(self.camera.frame(rospy.Time(0, 1)))  # of 1970, but a stamp
        self.assertIsNotNone(answer)
        image = self.camera.frame()
        image.header.stamp = rospy.Time()
        answer = self.camera.send(image)
        self.assertIsNotNone(answer)
        self.assertLess(abs((rospy.Time.now() - answer.header.stamp).to_sec()), 10.0, "the time of its coming")
        self.assertEqual(self.count("stamps missing"), 1)

    def test_a_resolution_that_the_calibration_is_not_of(self):
        answer = self.camera.send(self.camera.frame(width=160, height=120))
        self.assertIsNotNone(answer)
        self.assertEqual(answer.status_text, "wrong_size")
        self.assertEqual(self.count("images not of the camera's size"), 1)
        self.assertTrue(self.camera.told(lambda: self.camera.send(self.camera.frame(width=160, height=120)),
                                         "it is of 320 x 240 px, the image of 160 x 120 px", DiagnosticStatus.ERROR))

    def test_a_camera_info_that_is_none(self):
        broken = camera_info(rospy.Time.now(), focal_px=-1.0)
        self.camera.infos.publish(broken)
        self.assertTrue(self.camera.told(lambda: self.camera.send(self.camera.frame()), "camera_info", DiagnosticStatus.WARN))
        self.camera.infos.publish(camera_info(rospy.Time.now()))
        self.assertEqual(self.count("camera_infos unusable"), 1)

    def test_no_camera_info_at_all(self):
        answer = self.bare.send(self.bare.frame())
        self.assertIsNotNone(answer)
        self.assertEqual(answer.status, OpenSpace.FOUND, answer.status_text)
        self.assertTrue(self.bare.told(lambda: self.bare.send(self.bare.frame()), "no camera_info has come",
                                       DiagnosticStatus.WARN))

    def test_a_resolution_that_changes_in_flight(self):
        self.assertIsNotNone(self.bare.send(self.bare.frame()))
        before = int(value_of(self.bare.status(), "sizes changed"))
        for size in ((160, 120), (640, 480), (320, 240)):
            answer = self.bare.send(self.bare.frame(width=size[0], height=size[1]))
            self.assertIsNotNone(answer)
            self.assertEqual(answer.status, OpenSpace.FOUND, answer.status_text)
        self.assertEqual(int(value_of(self.bare.status(), "sizes changed")), before + 3)


if __name__ == "__main__":
    rospy.init_node("faults_test")
    rostest.rosrun("adit_ros1", "faults", Faults, sys.argv)
