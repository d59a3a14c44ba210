#!/usr/bin/env python3
"""Bag in = topic in = adit run: one recording, through the topics of a running node and through `adit run FILE.bag`.

For the published chain and for adit with its navigator, which remembers: order and stamps of the images count there.
"""
import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
import rostest
from adit_ros1.msg import OpenSpace
from geometry_msgs.msg import TwistStamped
from sensor_msgs.msg import CameraInfo, Image

from listening import Listener


class Bag(unittest.TestCase):
    def setUp(self):
        self.method = rospy.get_param("~method")
        self.folder = tempfile.TemporaryDirectory()
        self.bag = os.path.join(self.folder.name, "flight.bag")
        course = os.path.join(os.environ["ADIT_COURSES"], "s_bend.yaml")
        self.adit("fly", course, "--method", self.method, "--time", "3", "--set", "lens.width=320", "--set",
                  "lens.height=240", "--bag", self.bag, "--quiet")

    def tearDown(self):
        self.folder.cleanup()

    def adit(self, *arguments):
        done = subprocess.run([os.environ["ADIT_PROGRAM"], *arguments], capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_same_numbers(self):
        rows = list(csv.DictReader(
            self.adit("run", self.bag, "--method", self.method, "--csv", "-", "--quiet").splitlines()))
        self.assertGreater(len(rows), 50)
        answers = self.play()
        self.assertEqual(len(answers), len(rows))
        found, rates = 0, set()
        for (answer, heading), row in zip(answers, rows):
            self.assertEqual(answer.status_text, row["status"])
            if row["yaw_rate_rad_s"]:
                self.assertAlmostEqual(heading.twist.angular.z, float(row["yaw_rate_rad_s"]), places=4)
                rates.add(row["yaw_rate_rad_s"])
            if row["status"] != "found":
                continue
            found += 1
            self.assertEqual(answer.rule, row["rule"])
            self.assertAlmostEqual(answer.confidence, float(row["confidence"]), places=3)
            self.assertAlmostEqual(math.degrees(answer.elevation), float(row["elevation_deg"]), places=2)
            self.assertAlmostEqual(answer.sx, float(row["sx"]), places=4)
            self.assertAlmostEqual(answer.sy, float(row["sy"]), places=4)
            self.assertAlmostEqual(math.degrees(answer.azimuth), float(row["azimuth_deg"]), places=2)
        self.assertGreater(found, 30)
        self.assertGreater(len(rates), 10, "a command that stands still would prove little")
        print("same numbers: method %s, %d frames, %d of them found" % (self.method, len(rows), found))

    def play(self):
        """The bag's own messages, one after the other, each with its answer."""
        answers, headings = Listener("open_space", OpenSpace), Listener("heading", TwistStamped)
        images = rospy.Publisher("camera/image_raw", Image, queue_size=10)
        infos = rospy.Publisher("camera/camera_info", CameraInfo, queue_size=10, latch=True)
        while images.get_num_connections() == 0 or infos.get_num_connections() == 0:
            rospy.sleep(0.05)
        pairs = []
        with rosbag.Bag(self.bag) as bag:
            for topic, message, _ in bag.read_messages(topics=["/camera/image_raw", "/camera/camera_info"]):
                if topic.endswith("camera_info"):
                    if not pairs:
                        infos.publish(message)
                        rospy.sleep(0.3)  # the calibration is there before the first image
                    continue
                stamp = message.header.stamp
                if pairs and pairs[-1][0].header.stamp == stamp:
                    continue
                images.publish(message)
                answer = answers.wait(lambda m: m.header.stamp == stamp, 10)
                heading = headings.wait(lambda m: m.header.stamp == stamp, 10)
                self.assertIsNotNone(answer, "no answer")
                self.assertIsNotNone(heading, "no heading")
                pairs.append((answer, heading))
                if len(pairs) == 1:
                    infos.unregister()
        return pairs


if __name__ == "__main__":
    rospy.init_node("bag_test")
    rostest.rosrun("adit_ros1", "bag", Bag, sys.argv)
