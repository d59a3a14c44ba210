#!/usr/bin/env python3
"""Topics, frames, stamps and signs of camera, perception and controller in one nodelet manager."""
import sys
import time
import unittest

import rospy
import rostest
from adit_ros1.msg import OpenSpace
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from sensor_msgs.msg import CameraInfo, Image
from std_msgs.msg import Float64

from listening import Listener, status_of, value_of


class Topics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.open_space = Listener("open_space", OpenSpace)
        cls.heading = Listener("heading", TwistStamped)
        cls.cmd_vel = Listener("cmd_vel", Twist)
        cls.open_space.wait_count(30)

    def test_open_space_is_of_the_image(self):
        images = Listener("camera/image_raw", Image)
        image = images.wait(lambda m: True)
        self.assertIsNotNone(image, "no image")
        stamps = {m.header.stamp.to_nsec() for m in images.wait_count(20)}
        answers = [m for m in self.open_space.wait_count(120) if m.header.stamp.to_nsec() in stamps]
        self.assertGreater(len(answers), 5)
        for answer in answers:
            self.assertEqual(answer.header.frame_id, "camera_optical")

    def test_found_comes_with_its_evidence(self):
        found = self.open_space.wait(lambda m: m.status == OpenSpace.FOUND)
        self.assertIsNotNone(found)
        self.assertEqual(found.status_text, "found")
        self.assertEqual(found.rule, "darkest_cluster")
        self.assertGreaterEqual(len(found.openings), 1)
        self.assertAlmostEqual(found.openings[0].azimuth, found.azimuth, places=5)
        self.assertGreater(found.find_ms, 0.0)

    def test_right_in_the_image_is_a_negative_yaw_rate(self):
        """Over the whole clip, the commands turn towards the openings."""
        azimuth = {m.header.stamp.to_nsec(): m.azimuth for m in self.open_space.wait_count(60)
                   if m.status == OpenSpace.FOUND and abs(m.azimuth) > 0.1}
        pairs = [(azimuth[m.header.stamp.to_nsec()], m.twist.angular.z) for m in self.heading.wait_count(60)
                 if m.header.stamp.to_nsec() in azimuth and abs(m.twist.angular.z) > 0.05]
        self.assertGreater(len(pairs), 5)
        against = sum(1 for a, rate in pairs if a * rate > 0)
        self.assertLess(against, 0.2 * len(pairs), "the rate's limit lets it lag; it does not let it turn away")

    def test_heading_is_of_the_body(self):
        heading = self.heading.wait(lambda m: m.twist.linear.x > 0)
        self.assertIsNotNone(heading)
        self.assertEqual(heading.header.frame_id, "base_link")
        self.assertEqual(heading.twist.linear.x, 1.0)
        self.assertEqual(heading.twist.linear.y, 0.0)
        self.assertEqual(heading.twist.angular.x, 0.0)

    def test_commands_are_headings(self):
        commands = [(m.linear.x, m.angular.z) for m in self.cmd_vel.wait_count(60)]
        time.sleep(0.5)  # a heading is on its way no longer than its command
        headings = {(m.twist.linear.x, m.twist.angular.z) for _, m in self.heading.all()}
        # The two topics were not connected at the same time.
        first = next((i for i, command in enumerate(commands) if command in headings), len(commands))
        known = commands[first:]
        self.assertGreater(len(known), 20)
        self.assertLessEqual(set(known), headings | {(0.0, 0.0)})

    def test_setpoint_velocity_is_stamped(self):
        setpoint = Listener("setpoint_velocity/cmd_vel", TwistStamped).wait(lambda m: True)
        self.assertIsNotNone(setpoint)
        self.assertEqual(setpoint.header.frame_id, "base_link")

    def test_latency_is_published(self):
        latency = Listener("latency", Float64).wait(lambda m: True)
        self.assertIsNotNone(latency)
        self.assertGreater(latency.data, 0.0)
        self.assertLess(latency.data, 0.5)

    def test_the_arrow_is_in_the_optical_frame(self):
        arrow = Listener("direction", PoseStamped).wait(lambda m: True)
        self.assertIsNotNone(arrow)
        self.assertEqual(arrow.header.frame_id, "camera_optical")
        q = arrow.pose.orientation
        self.assertAlmostEqual(q.x ** 2 + q.y ** 2 + q.z ** 2 + q.w ** 2, 1.0, places=6)
        forward = 2.0 * (q.x * q.z - q.w * q.y)  # z of the turned x axis
        self.assertGreater(forward, 0.5)

    def test_pictures_come_when_somebody_looks(self):
        info = Listener("camera/camera_info", CameraInfo).wait(lambda m: True)
        self.assertIsNotNone(info)
        for topic, encoding in (("overlay", "bgr8"), ("scattering_depth", "mono8")):
            picture = Listener(topic, Image).wait(lambda m: True)
            self.assertIsNotNone(picture, topic)
            self.assertEqual(picture.encoding, encoding)
            self.assertEqual((picture.width, picture.height), (info.width, info.height))
            self.assertEqual(len(picture.data), picture.step * picture.height)

    def test_nothing_is_made_for_nobody(self):
        """How many of each were made is told by the diagnostics: none while nobody listens, and again none afterwards."""
        diagnostics = Listener("/diagnostics", DiagnosticArray)

        def made():
            diagnostics.clear()
            status = status_of(diagnostics.wait_count_of(lambda m: status_of(m, "open space"), 2)[-1], "open space")
            return [int(value_of(status, key)) for key in ("overlays made", "scattering depths made", "arrows made")]
        for i, (topic, kind) in enumerate((("overlay", Image), ("scattering_depth", Image), ("direction", PoseStamped))):
            before = made()
            self.assertEqual(made(), before, "made while nobody listens")
            listener = Listener(topic, kind)
            self.assertEqual(len(listener.wait_count(5)[:5]), 5, topic)
            listener.stop()
            after = made()
            self.assertGreaterEqual(after[i] - before[i], 5, topic)
            self.assertEqual(made(), after, "nobody listens any more")
            others = [k for k in range(3) if k != i]
            self.assertEqual([after[k] for k in others], [before[k] for k in others], "and the others are not made with it")

    def test_diagnostics_name_what_is(self):
        diagnostics = Listener("/diagnostics", DiagnosticArray)
        message = diagnostics.wait(lambda m: status_of(m, "open space"))
        self.assertIsNotNone(message)
        status = status_of(message, "open space")
        for key in ("rate (Hz)", "latency p99 (ms)", "age (s)", "status", "dropped"):
            self.assertIsNotNone(value_of(status, key), key)
        self.assertIsNotNone(diagnostics.wait(lambda m: status_of(m, ": controller")))


if __name__ == "__main__":
    rospy.init_node("topics_test")
    rostest.rosrun("adit_ros1", "topics", Topics, sys.argv)
