#!/usr/bin/env python3
"""The closed loop through topics flies the S-bend without contact: simulator, perception node, controller node. And what
the simulated robot says of itself."""
import re
import sys
import unittest

import rospy
import rostest
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, Image, Imu, LaserScan
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from listening import Listener


def turned(q, v):
    """The vector v turned by the quaternion q."""
    x, y, z = (2 * (q.y * v[2] - q.z * v[1]), 2 * (q.z * v[0] - q.x * v[2]), 2 * (q.x * v[1] - q.y * v[0]))
    return (v[0] + q.w * x + q.y * z - q.z * y, v[1] + q.w * y + q.z * x - q.x * z, v[2] + q.w * z + q.x * y - q.y * x)


class SBend(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.outcome = Listener("outcome", String)
        cls.odometry = Listener("odom", Odometry)
        cls.scans = Listener("scan", LaserScan)
        cls.imu = Listener("imu", Imu)
        cls.transforms = Listener("/tf", TFMessage)
        cls.static_transforms = Listener("/tf_static", TFMessage)
        cls.images = Listener("camera/image_raw", Image)
        cls.infos = Listener("camera/camera_info", CameraInfo)
        cls.clock = Listener("/clock", Clock)

    def test_it_reaches_the_goal(self):
        end = self.outcome.wait(lambda m: True, 380)
        self.assertIsNotNone(end, "the flight did not end in time")
        print("flight through topics: " + end.data)
        self.assertTrue(end.data.startswith("goal "), end.data)
        clearance_m = float(re.search(r"clearance_min_m=([0-9.]+)", end.data).group(1))
        self.assertGreater(clearance_m, 0.25, "the body's radius")

    def test_a_body_is_where_it_is_said_to_be(self):
        odometry = self.odometry.wait(lambda m: m.header.frame_id == "odom" and m.child_frame_id == "base_link")
        self.assertIsNotNone(odometry)
        placed = self.transforms.wait(lambda m: any(t.header.stamp == odometry.header.stamp for t in m.transforms))
        self.assertIsNotNone(placed)
        transform = placed.transforms[0]
        self.assertEqual((transform.header.frame_id, transform.child_frame_id), ("odom", "base_link"))
        place, said = transform.transform.translation, odometry.pose.pose.position
        self.assertEqual((place.x, place.y, place.z), (said.x, said.y, said.z))
        self.assertIsNotNone(self.odometry.wait(lambda m: m.twist.twist.linear.x > 0.3), "x is forward in the body's frame")

    def test_a_sweep_and_the_gravity(self):
        self.assertIsNotNone(self.scans.wait(lambda m: m.header.frame_id == "base_link" and len(m.ranges) > 100))
        self.assertIsNotNone(self.imu.wait(
            lambda m: m.header.frame_id == "base_link" and abs(m.linear_acceleration.z - 9.8) < 3), "z is up")

    def test_the_clock_goes_forward(self):
        times = [m.clock for m in self.clock.wait_count(30)]
        self.assertGreaterEqual(times[0].to_sec(), 1.0)
        self.assertEqual(times, sorted(times))
        self.assertGreater(times[-1], times[0])

    def test_the_camera_is_described(self):
        image = self.images.wait(lambda m: True)
        self.assertIsNotNone(image)
        info = self.infos.wait(lambda m: m.header.stamp >= image.header.stamp)
        self.assertIsNotNone(info)
        image = self.images.wait(lambda m: m.header.stamp == info.header.stamp)
        self.assertIsNotNone(image, "each has an image of its stamp")
        self.assertEqual((image.header.frame_id, info.header.frame_id), ("camera_optical", "camera_optical"))
        self.assertEqual((info.width, info.height), (image.width, image.height))
        self.assertEqual((image.width, image.height, image.encoding), (320, 240, "bgr8"))
        self.assertEqual(info.distortion_model, "plumb_bob")
        self.assertEqual(len(info.D), 5)
        focal_px, middle_px = info.K[0], info.K[2]
        self.assertGreater(focal_px, 100.0)
        self.assertAlmostEqual(middle_px, (image.width - 1) / 2, delta=1.0)
        self.assertEqual(tuple(info.K), (focal_px, 0, middle_px, 0, info.K[4], info.K[5], 0, 0, 1))
        self.assertEqual(tuple(info.R), (1, 0, 0, 0, 1, 0, 0, 0, 1))
        self.assertEqual(tuple(info.P), (focal_px, 0, middle_px, 0, 0, info.K[4], info.K[5], 0, 0, 0, 1, 0))

    def test_the_lens_sits_in_the_body(self):
        """REP 103: the optical frame's z looks along the body's x, its x to the right, its y down."""
        static = self.static_transforms.wait(lambda m: True)
        self.assertIsNotNone(static, "it is latched: whoever comes late hears it, too")
        lens = [t for t in static.transforms if t.child_frame_id == "camera_optical"]
        self.assertEqual(len(lens), 1)
        self.assertEqual(lens[0].header.frame_id, "base_link")
        for axis, wanted in (((0, 0, 1), (1, 0, 0)), ((1, 0, 0), (0, -1, 0)), ((0, 1, 0), (0, 0, -1))):
            for got, want in zip(turned(lens[0].transform.rotation, axis), wanted):
                self.assertAlmostEqual(got, want, delta=0.3)  # the camera may look up or down a little
        self.assertGreaterEqual(lens[0].transform.translation.x, 0.0)


if __name__ == "__main__":
    rospy.init_node("s_bend_test")
    rostest.rosrun("adit_ros1", "s_bend", SBend, sys.argv)
