#!/usr/bin/env python3
"""Latency from an image's stamp to the command at 640 x 480 and 30 Hz, frames dropped, and memory over the run.

The figures are printed always. They are judged only where ADIT_LATENCY_P99_MS is set (a machine that does nothing else);
what is judged everywhere is that commands come, and that memory stays flat.
"""
import os
import sys
import time
import unittest

import rosnode
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from std_msgs.msg import Float64

from listening import Listener, status_of, value_of

SAMPLES = 12  # of the memory, after the first


def resident_kb(pid):
    with open("/proc/%d/status" % pid) as status:
        for line in status:
            if line.startswith("VmRSS"):
                return int(line.split()[1])
    return 0


def pid_of(node):
    import xmlrpc.client
    uri = rosnode.get_api_uri(rospy.get_master(), node)
    uri = uri[2] if isinstance(uri, (list, tuple)) else uri
    return xmlrpc.client.ServerProxy(uri).getPid("/latency_test")[2]


class Latency(unittest.TestCase):
    def test_latency(self):
        seconds = float(rospy.get_param("~seconds", 20))
        limit_ms = float(rospy.get_param("~p99_ms", 0))
        namespace = rospy.get_param("~namespace")
        latency = Listener(namespace + "/latency", Float64)
        diagnostics = Listener("/diagnostics", DiagnosticArray)
        self.assertIsNotNone(latency.wait(lambda m: True), "no command")
        process = pid_of(namespace + "/open_space" if "processes" in namespace else namespace + "/manager")
        time.sleep(2.0)
        latency.clear()
        memory_kb = [resident_kb(process)]
        for _ in range(SAMPLES):
            time.sleep(seconds / SAMPLES)
            memory_kb.append(resident_kb(process))
        values = sorted(1e3 * m.data for _, m in latency.all())
        self.assertGreater(len(values), 5 * seconds, "commands at less than 5 Hz")

        def share(s):
            return values[min(len(values) - 1, int(s * len(values)))]
        diagnostics.clear()
        report = diagnostics.wait(lambda m: status_of(m, "open_space: open space"), 5)
        perception = status_of(report, "open_space: open space")
        dropped = value_of(perception, "dropped")
        print("latency over %s: p50 %.2f ms, p99 %.2f ms, max %.2f ms; %d commands in %.0f s; dropped %s; "
              "memory %d to %d kB" % (namespace, share(0.5), share(0.99), values[-1], len(values), seconds,
                                      dropped, memory_kb[0], memory_kb[-1]))
        # Where it goes: until the image is there, until its heading is sent off, until the command is.
        print("latency over %s, hops: image there p50 %s ms, p99 %s ms; heading sent p50 %s ms, p99 %s ms; load %.1f" % (
            namespace, *(value_of(perception, key) for key in ("arrival p50 (ms)", "arrival p99 (ms)", "latency p50 (ms)",
                                                               "latency p99 (ms)")), os.getloadavg()[0]))
        print("latency over %s, memory (kB), %d times in equal steps: %s" % (
            namespace, SAMPLES + 1, " ".join(str(kb) for kb in memory_kb)))
        self.assertLess(memory_kb[-1], memory_kb[0] + 4096, "memory grows")
        if limit_ms > 0:
            self.assertLessEqual(share(0.99), limit_ms)
            self.assertEqual(dropped, "0")


if __name__ == "__main__":
    rospy.init_node("latency_test")
    rostest.rosrun("adit_ros1", "latency", Latency, sys.argv)
