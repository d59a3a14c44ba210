#!/usr/bin/env python3
"""Latency from an image's stamp to the command at 640 x 480 and 30 Hz, frames dropped, and memory over the run.

The figures are printed always, and a loose limit is asked of them always. The limits of the README are asked of the
seconds in which the machine was idle: others had at most IDLE_OTHERS of it, and its host took no more than IDLE_STOLEN. Where
there were too few such seconds, that is printed, and nothing is asked (ADIT_LATENCY_IDLE=1: it fails instead).
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

from burden import Burden
from listening import Listener, status_of, value_of

IDLE_OTHERS = 0.05  # of all processors: the system's own small jobs
IDLE_STOLEN = 0.005
IDLE_COMMANDS = 300  # ten seconds' worth: of fewer, the 99th percentile says little
LOOSE_P50_MS = 20.0  # ten times what it takes: a machine under load is late now and then, not always
MEMORY_SAMPLES = 12  # after the first
MEMORY_GROWTH_KB = 4096


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


def share(values, s):
    return values[min(len(values) - 1, int(s * len(values)))]


class Latency(unittest.TestCase):
    def setUp(self):
        self.namespace = rospy.get_param("~namespace")
        self.latency = Listener(self.namespace + "/latency", Float64)
        self.diagnostics = Listener("/diagnostics", DiagnosticArray)
        self.assertIsNotNone(self.latency.wait(lambda m: True), "no command")

    def perception(self):
        """What the last diagnostics say of perception."""
        found = self.diagnostics.wait_last(lambda m: status_of(m, "open_space: open space"), 5)
        self.assertIsNotNone(found, "no diagnostics")
        return status_of(found, "open_space: open space")

    def run_for(self, seconds):
        """Second by second: begin, end, is it idle, frames dropped so far. And the memory in equal steps."""
        process = pid_of(self.namespace + ("/open_space" if "processes" in self.namespace else "/manager"))
        time.sleep(2.0)
        self.latency.clear()
        rows, memory_kb, burden = [], [resident_kb(process)], Burden()
        begin = time.monotonic()
        while time.monotonic() < begin + seconds:
            from_s = time.monotonic()
            time.sleep(1.0)
            others, stolen = burden.since()
            rows.append((from_s, time.monotonic(), others, stolen, int(value_of(self.perception(), "dropped"))))
            if len(rows) >= len(memory_kb) * seconds / MEMORY_SAMPLES:
                memory_kb.append(resident_kb(process))
        return rows, memory_kb

    def test_latency(self):
        seconds = float(rospy.get_param("~seconds", 20))
        rows, memory_kb = self.run_for(seconds)
        kept = self.latency.all()
        values = sorted(1e3 * m.data for _, m in kept)
        self.assertGreater(len(values), 5 * seconds, "commands at less than 5 Hz")
        perception = self.perception()
        print("latency over %s: p50 %.2f ms, p99 %.2f ms, max %.2f ms; %d commands in %.0f s; dropped %s; "
              "memory %d to %d kB" % (self.namespace, share(values, 0.5), share(values, 0.99), values[-1], len(values),
                                      seconds, value_of(perception, "dropped"), memory_kb[0], memory_kb[-1]))
        # Where it goes: until the image is there, until its heading is sent off, until the command is.
        print("latency over %s, hops: image there p50 %s ms, p99 %s ms; heading sent p50 %s ms, p99 %s ms; load %.1f" % (
            self.namespace, *(value_of(perception, key) for key in (
                "arrival p50 (ms)", "arrival p99 (ms)", "latency p50 (ms)", "latency p99 (ms)")), os.getloadavg()[0]))
        print("latency over %s, memory (kB), %d times in equal steps: %s" % (
            self.namespace, len(memory_kb), " ".join(str(kb) for kb in memory_kb)))
        self.assertLess(memory_kb[-1], memory_kb[0] + MEMORY_GROWTH_KB, "memory grows")
        self.assertLess(share(values, 0.5), LOOSE_P50_MS)
        limit_ms = float(rospy.get_param("~p99_ms", 0))
        if limit_ms > 0:
            self.check_idle(rows, kept, limit_ms)

    def check_idle(self, rows, kept, limit_ms):
        values, dropped, was_idle, before = [], 0, False, None
        for begin, end, others, stolen, dropped_so_far in rows:
            is_idle = others <= IDLE_OTHERS and stolen <= IDLE_STOLEN
            if is_idle:
                values += [1e3 * m.data for came, m in kept if begin <= came < end]
            # The diagnostics come once a second: what they tell may be of the second before.
            if is_idle and was_idle and before is not None:
                dropped += dropped_so_far - before
            was_idle, before = is_idle, dropped_so_far
        values.sort()
        if len(values) < IDLE_COMMANDS:
            print("latency over %s: p99 <= %.0f ms and no frame dropped were NOT ASKED: of %d seconds, too few were idle (others "
                  "had %.0f %% of the machine, its host %.1f %%)" % (
                      self.namespace, limit_ms, len(rows), 100 * sum(r[2] for r in rows) / len(rows),
                      100 * sum(r[3] for r in rows) / len(rows)))
            self.assertFalse(os.environ.get("ADIT_LATENCY_IDLE"), "the machine was to be idle, and was not")
            return
        print("latency over %s, asked of %d commands in idle seconds: p99 %.2f ms (limit %.0f ms), dropped %d (limit 0)" % (
            self.namespace, len(values), share(values, 0.99), limit_ms, dropped))
        self.assertLessEqual(share(values, 0.99), limit_ms)
        self.assertEqual(dropped, 0)


if __name__ == "__main__":
    rospy.init_node("latency_test")
    rostest.rosrun("adit_ros1", "latency", Latency, sys.argv)
