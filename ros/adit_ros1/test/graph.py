#!/usr/bin/env python3
"""The README's tables of topics against a master: what each running node takes, sends and serves, and nothing else."""
import os
import sys
import time
import unittest

import rosgraph
import rospy
import rostest
import yaml
from dynamic_reconfigure.srv import Reconfigure
from sensor_msgs.srv import SetCameraInfo

# What roscpp itself brings to each node.
EVERYWHERE = {("out", "/rosout"), ("service", "~get_loggers"), ("service", "~set_logger_level")}
SERVICES = {"dynamic_reconfigure/Reconfigure": Reconfigure, "sensor_msgs/SetCameraInfo": SetCameraInfo}
# Node of graph.test: node of the tables, and what holds for it.
NODES = {
    "/open_space": ("open_space", {"image_transport: raw"}),
    "/open_space_compressed": ("open_space", {"image_transport: compressed"}),
    "/controller": ("controller", set()),
    "/camera": ("camera", set()),
    "/sim": ("sim", set()),
}


def was_built_with_mavros():
    """Where these messages are in the workspace, the controller was built with them."""
    try:
        from mavros_msgs.msg import PositionTarget  # noqa: F401
    except ImportError:
        return False
    return True


def read_tables(path):
    """Node: rows of (way, name, type, where)."""
    tables, node = {}, None
    with open(path) as page:
        text = page.read()
    text = text.split("<!-- topics: made from the code -->")[1].split("<!-- end of the topics -->")[0]
    for line in text.splitlines():
        if line.startswith("### Node `"):
            node = line.split("`")[1]
            tables[node] = []
        elif line.startswith("| ") and node and line.split("|")[1].strip():
            way, name, message_type, where, _ = (cell.strip() for cell in line.strip("|").split("|"))
            tables[node].append((way, name.strip("`"), message_type, where))
    return tables


def resolved(name, node):
    if name.startswith("~"):
        return node + "/" + name[1:]
    return name if name.startswith("/") else "/" + name


def is_of_a_transport(node, way, name):
    """image_transport's plugins say more beside a camera's images: as many as are installed."""
    return node == "/camera" and way != "in" and name.startswith("/camera/image_raw/")


class Graph(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tables = read_tables(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "README.md"))
        cls.master = rosgraph.Master("/graph_test")

    def wanted(self, node):
        table, holds = NODES[node]
        holds = holds | {"always"} | ({"built with mavros_msgs"} if was_built_with_mavros() else set())
        known = {"always", "image_transport: raw", "image_transport: compressed", "built with mavros_msgs"}
        rows = set()
        for way, name, message_type, where in self.tables[table]:
            self.assertIn(where, known, "a condition that this test does not know")
            if where in holds:
                rows.add((way, resolved(name, node), message_type))
        return rows

    def present(self, node):
        types = dict(self.master.getTopicTypes())
        publishers, subscribers, services = self.master.getSystemState()
        ignored = {(way, resolved(name, node)) for way, name in EVERYWHERE}
        rows = set()
        for way, listed in (("out", publishers), ("in", subscribers), ("service", services)):
            for name, nodes in listed:
                if node not in nodes or (way, name) in ignored or is_of_a_transport(node, way, name):
                    continue
                rows.add((way, name, types.get(name, "?") if way != "service" else None))
        return rows

    def check(self, node):
        wanted = self.wanted(node)
        self.assertGreater(len(wanted), 2)
        nameless = {(way, name, None if way == "service" else message_type) for way, name, message_type in wanted}
        end = time.monotonic() + 30
        while self.present(node) != nameless and time.monotonic() < end:
            time.sleep(0.2)
        self.assertEqual(sorted(map(str, self.present(node))), sorted(map(str, nameless)))
        for way, name, message_type in wanted:
            if way == "service":  # the master knows no types of services: a call of another type is refused
                self.assertIn(message_type, SERVICES)
                proxy = rospy.ServiceProxy(name, SERVICES[message_type])
                self.assertIsNotNone(proxy.call(SERVICES[message_type]._request_class()))

    def test_open_space(self):
        self.check("/open_space")

    def test_open_space_with_compressed_images(self):
        self.check("/open_space_compressed")

    def test_controller(self):
        self.check("/controller")

    def test_camera(self):
        self.check("/camera")

    def test_sim(self):
        self.check("/sim")

    def test_rviz_looks_at_topics_that_are_there(self):
        """All that the configurations of RViz listen to is sent by some node, by its own name."""
        sent = {resolved(name, "/node") for rows in self.tables.values() for way, name, _, _ in rows if way == "out"}
        folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "rviz")
        for name in os.listdir(folder):
            with open(os.path.join(folder, name)) as file:
                displays = yaml.safe_load(file)["Visualization Manager"]["Displays"]
            topics = {display[key] for display in displays for key in ("Topic", "Image Topic") if key in display}
            self.assertIn("/overlay", topics, name)
            self.assertIn("/direction", topics, name)
            self.assertEqual(topics - sent, set(), name)

    def test_each_table_is_of_a_node_that_runs_here(self):
        self.assertEqual(set(self.tables), {table for table, _ in NODES.values()})


if __name__ == "__main__":
    rospy.init_node("graph_test")
    rostest.rosrun("adit_ros1", "graph", Graph, sys.argv)
