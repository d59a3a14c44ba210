"""Frames for tests that are a camera themselves: a tunnel with its dark end where it is wanted."""
import numpy
import rospy
from sensor_msgs.msg import CameraInfo, Image

WIDTH, HEIGHT = 320, 240


def tunnel(middle_px=160.0, seed=0, width=WIDTH, height=HEIGHT):
    """Bright rock about a dark end, with a camera's noise: no two frames are the same."""
    v, u = numpy.mgrid[0:height, 0:width]
    away = numpy.minimum(1.0, 1.4 * numpy.hypot((u - middle_px * width / WIDTH) / width, (v - height / 2) / height) * 2.0)
    noise = numpy.random.RandomState(seed).normal(0.0, 2.0, (height, width))
    return numpy.clip(8.0 + 180.0 * away * away + noise, 0, 255).astype(numpy.uint8)


def image_of(pixels, stamp, encoding="mono8"):
    image = Image(height=pixels.shape[0], width=pixels.shape[1], encoding=encoding, step=pixels.shape[1],
                  data=pixels.tobytes())
    image.header.stamp = stamp
    image.header.frame_id = "camera_optical"
    return image


def camera_info(stamp, width=WIDTH, height=HEIGHT, focal_px=250.0):
    info = CameraInfo(width=width, height=height, distortion_model="plumb_bob", D=[0.0] * 5,
                      K=[focal_px, 0, width / 2, 0, focal_px, height / 2, 0, 0, 1])
    info.header.stamp = stamp
    info.header.frame_id = "camera_optical"
    return info


def wait_for_listeners(*publishers):
    while not rospy.is_shutdown() and any(p.get_num_connections() == 0 for p in publishers):
        rospy.rostime.wallsleep(0.02)
