"""What the test suites share: waiting for messages with an end, and reading diagnostics."""
import threading
import time

import rospy


class Listener:
    """Keeps what came on a topic, with the wall time of its coming."""

    def __init__(self, topic, message_type):
        self._lock = threading.Condition()
        self._kept = []
        self._subscriber = rospy.Subscriber(topic, message_type, self._take, queue_size=1000, tcp_nodelay=True)

    def _take(self, message):
        with self._lock:
            self._kept.append((time.monotonic(), message))
            self._lock.notify_all()

    def all(self):
        with self._lock:
            return list(self._kept)

    def clear(self):
        with self._lock:
            self._kept.clear()

    def wait(self, wanted, timeout_s=20.0):
        """The first kept message for which wanted(message) holds; None when none came in time."""
        end = time.monotonic() + timeout_s
        seen = 0
        with self._lock:
            while True:
                for _, message in self._kept[seen:]:
                    if wanted(message):
                        return message
                seen = len(self._kept)
                left = end - time.monotonic()
                if left <= 0:
                    return None
                self._lock.wait(left)

    def stop(self):
        """Nobody listens any more."""
        self._subscriber.unregister()

    def wait_count_of(self, wanted, count, timeout_s=20.0):
        """So many messages for which wanted(message) holds."""
        end = time.monotonic() + timeout_s
        with self._lock:
            while True:
                found = [message for _, message in self._kept if wanted(message)]
                if len(found) >= count or time.monotonic() >= end:
                    return found
                self._lock.wait(max(0.0, end - time.monotonic()))

    def wait_last(self, wanted, timeout_s=20.0):
        """The last kept message for which wanted(message) holds; None when none came in time."""
        self.wait(wanted, timeout_s)
        found = [message for _, message in self.all() if wanted(message)]
        return found[-1] if found else None

    def wait_count(self, count, timeout_s=20.0):
        """So many messages, or fewer when they did not come in time."""
        end = time.monotonic() + timeout_s
        with self._lock:
            while len(self._kept) < count and time.monotonic() < end:
                self._lock.wait(max(0.0, end - time.monotonic()))
            return [message for _, message in self._kept]


def status_of(array, name_part):
    """The status of a diagnostic array whose name contains name_part, or None."""
    for status in array.status:
        if name_part in status.name:
            return status
    return None


def value_of(status, key):
    for pair in status.values:
        if pair.key == key:
            return pair.value
    return None
