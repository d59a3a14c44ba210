#!/usr/bin/env python3
"""What perception takes besides raw images: compressed ones, the same numbers as `adit run`; and a gyroscope's yaw rate."""
import csv
import os
import subprocess
import sys
import unittest

import rospy
import rostest
from adit_ros1.msg import OpenSpace
from diagnostic_msgs.msg import DiagnosticArray
from sensor_msgs.msg import CompressedImage, Imu

from listening import Listener, status_of, value_of


class Inputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(os.environ["ADIT_PICTURE"], "rb") as file:
            cls.jpeg = file.read()
        cls.answers = Listener("open_space", OpenSpace)
        cls.diagnostics = Listener("/diagnostics", DiagnosticArray)
        cls.pictures = rospy.Publisher("camera/image_raw/compressed", CompressedImage, queue_size=10, tcp_nodelay=True)
        cls.rates = rospy.Publisher("imu", Imu, queue_size=10, tcp_nodelay=True)
        while cls.pictures.get_num_connections() == 0 or cls.rates.get_num_connections() == 0:
            rospy.sleep(0.05)

    def send(self, pixels, seconds=20.0):
        """The answer to one picture; None when none came in time."""
        message = CompressedImage(format="jpeg", data=pixels)
        message.header.stamp = rospy.Time.now()
        message.header.frame_id = "camera_optical"
        self.pictures.publish(message)
        return self.answers.wait(lambda m: m.header.stamp == message.header.stamp, seconds)

    def told(self, key):
        """What the next diagnostics say under this key."""
        self.diagnostics.clear()
        message = self.diagnostics.wait(lambda m: status_of(m, "open space"))
        self.assertIsNotNone(message, "no diagnostics")
        return value_of(status_of(message, "open space"), key)

    def test_a_compressed_picture_is_judged_as_adit_run_judges_it(self):
        done = subprocess.run([os.environ["ADIT_PROGRAM"], "run", os.environ["ADIT_PICTURE"], "--method", "paper", "--csv",
                               "-", "--quiet"], capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        row = next(csv.DictReader(done.stdout.splitlines()))
        answer = self.send(self.jpeg)
        self.assertIsNotNone(answer, "no answer")
        self.assertEqual(answer.header.frame_id, "camera_optical")
        self.assertEqual(answer.status_text, row["status"])
        self.assertEqual(row["status"], "found")
        self.assertAlmostEqual(answer.sx, float(row["sx"]), places=4)
        self.assertAlmostEqual(answer.sy, float(row["sy"]), places=4)

    def test_bytes_that_are_no_picture_are_survived(self):
        self.assertIsNone(self.send(b"no picture", 0.5))
        self.assertIsNone(self.send(self.jpeg[:40], 0.5))
        self.assertIsNone(self.send(b"", 0.5))
        self.assertIsNotNone(self.send(self.jpeg))

    def test_a_yaw_rate_is_used_where_it_is_of_the_image(self):
        before = int(self.told("yaw rates"))
        used = int(self.told("images with a yaw rate"))
        for _ in range(5):
            rate = Imu()
            rate.header.stamp = rospy.Time.now()
            rate.angular_velocity.z = 0.3
            self.rates.publish(rate)
        while int(self.told("yaw rates")) < before + 5:
            pass  # the suite's time limit ends it
        late = Imu()
        late.header.stamp = rospy.Time.now()
        late.angular_velocity.z = 0.3
        self.rates.publish(late)
        while int(self.told("yaw rates")) < before + 6:
            pass
        rospy.sleep(0.3)
        self.assertIsNotNone(self.send(self.jpeg))
        self.assertEqual(int(self.told("images with a yaw rate")), used, "that rate was of another motion")


if __name__ == "__main__":
    rospy.init_node("inputs_test")
    rostest.rosrun("adit_ros1", "inputs", Inputs, sys.argv)
