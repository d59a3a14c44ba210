"""How much of the machine others take: what a latency says depends on it."""
import os


def jiffies_of(pid):
    """Processor time of a process and its ended children; 0 when it is gone."""
    try:
        with open("/proc/%d/stat" % pid) as stat:
            fields = stat.read().rsplit(")", 1)[1].split()
    except OSError:
        return 0
    return sum(int(field) for field in fields[11:15])


def parents():
    """Process: its parent."""
    found = {}
    for name in os.listdir("/proc"):
        if not name.isdigit():
            continue
        try:
            with open("/proc/%s/stat" % name) as stat:
                found[int(name)] = int(stat.read().rsplit(")", 1)[1].split()[1])
        except OSError:
            pass
    return found


class Burden:
    """Shares of the machine, since the last look: what others had of it, and what the host of a virtual machine stole."""

    def __init__(self):
        # rostest has started this test, and all the nodes.
        self._root = os.getppid()
        self._last = self._look()

    def _look(self):
        with open("/proc/stat") as stat:
            total = [int(field) for field in stat.readline().split()[1:9]]
        of = parents()

        def is_ours(pid):
            while pid in of and pid > 1:
                if pid == self._root:
                    return True
                pid = of[pid]
            return False
        ours = sum(jiffies_of(pid) for pid in of if is_ours(pid))
        idle, stolen = total[3] + total[4], total[7]
        return sum(total), sum(total) - idle - stolen, stolen, ours

    def since(self):
        """(others, stolen), each 0 to 1 of all processors."""
        now = self._look()
        everything, busy, stolen, ours = (b - a for a, b in zip(self._last, now))
        self._last = now
        everything = max(1, everything)
        return max(0.0, (busy - ours) / everything), stolen / everything
