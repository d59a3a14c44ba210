#!/usr/bin/env python3
"""Parameters from YAML at the start, and live by dynamic_reconfigure."""
import sys
import unittest

import rospy
import rostest
from adit_ros1.msg import OpenSpace
from dynamic_reconfigure.client import Client

from listening import Listener


class Parameters(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client("open_space", timeout=20)

    def test_yaml_is_in_force(self):
        present = self.client.get_configuration(timeout=10)
        self.assertEqual(present["method"], "paper")
        self.assertAlmostEqual(present["omega"], 0.9)
        self.assertAlmostEqual(present["speed_m_s"], 1.0)

    def test_each_parameter_is_described(self):
        described = {p["name"]: p for p in self.client.get_parameter_descriptions()}
        for name in ("omega", "cluster_count", "method", "pilot", "yaw_rate_max_rad_s", "frozen_frames"):
            self.assertIn(name, described)
        self.assertEqual(described["omega"]["min"], 0.01)
        self.assertEqual(described["omega"]["max"], 1.0)
        self.assertEqual(described["cluster_count"]["type"], "int")
        self.assertIn("adit", described["method"]["edit_method"])

    def test_a_method_is_changed_in_flight(self):
        answers = Listener("open_space", OpenSpace)
        self.assertIsNotNone(answers.wait(lambda m: m.rule == "darkest_cluster"))
        self.assertEqual(self.client.update_configuration({"method": "adit"})["method"], "adit")
        self.assertIsNotNone(answers.wait(lambda m: m.rule in ("enclosed", "open_sided", "veil")))
        self.client.update_configuration({"method": "paper"})
        answers.clear()
        self.assertIsNotNone(answers.wait(lambda m: m.rule == "darkest_cluster"))

    def test_what_is_refused_changes_nothing(self):
        before = self.client.get_configuration(timeout=10)["patch_size_px"]
        after = self.client.update_configuration({"patch_size_px": 4})  # even: no middle pixel
        self.assertEqual(after["patch_size_px"], before)
        self.assertEqual(self.client.update_configuration({"method": "magic"})["method"], "paper")

    def test_the_parameter_server_follows(self):
        self.client.update_configuration({"cluster_count": 5})
        self.assertEqual(rospy.get_param("open_space/cluster_count"), 5)
        self.client.update_configuration({"cluster_count": 10})

    def test_the_controller_has_its_own(self):
        controller = Client("controller", timeout=20)
        self.assertAlmostEqual(controller.get_configuration(timeout=10)["hover_after_s"], 0.5)
        self.assertAlmostEqual(controller.update_configuration({"error_after_s": 0.1})["error_after_s"], 5.0)


if __name__ == "__main__":
    rospy.init_node("parameters_test")
    rostest.rosrun("adit_ros1", "parameters", Parameters, sys.argv)
