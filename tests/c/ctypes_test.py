"""The C interface from a language that knows nothing of C++: Python's ctypes. usage: ctypes_test.py LIBRARY"""
import ctypes as c
import math
import sys
import unittest

LIBRARY = c.CDLL(sys.argv.pop(1))
WIDTH, HEIGHT = 160, 120


class Image(c.Structure):
    _fields_ = [("struct_size", c.c_size_t), ("data", c.POINTER(c.c_uint8)), ("width", c.c_int32),
                ("height", c.c_int32), ("stride_bytes", c.c_ssize_t), ("format", c.c_int32)]


class OpenSpace(c.Structure):
    _fields_ = [("struct_size", c.c_size_t), ("status", c.c_int32), ("opening_count", c.c_int32),
                ("flags", c.c_uint32), ("darkest_level", c.c_int32)] + [
                    (name, c.c_double) for name in
                    ("confidence", "u_px", "v_px", "sx", "sy", "azimuth_rad", "elevation_rad", "area_fraction",
                     "atmospheric_light", "veil_fraction")] + [("total_ns", c.c_int64)]


for name in ("adit_version", "adit_last_error", "adit_status_name", "adit_config_field"):
    getattr(LIBRARY, name).restype = c.c_char_p
LIBRARY.adit_config_create.restype = c.c_void_p
LIBRARY.adit_config_destroy.argtypes = [c.c_void_p]
LIBRARY.adit_config_set.argtypes = [c.c_void_p, c.c_char_p, c.c_char_p]
LIBRARY.adit_config_field.argtypes = [c.c_void_p, c.c_size_t]
LIBRARY.adit_finder_create.argtypes = [c.c_void_p, c.c_void_p, c.POINTER(c.c_void_p)]
LIBRARY.adit_finder_destroy.argtypes = [c.c_void_p]
LIBRARY.adit_finder_find.argtypes = [c.c_void_p, c.POINTER(Image), c.POINTER(OpenSpace)]


class CInterface(unittest.TestCase):

    def setUp(self):
        self.config = LIBRARY.adit_config_create()
        self.addCleanup(LIBRARY.adit_config_destroy, self.config)

    def test_finds_an_opening(self):
        self.assertEqual(LIBRARY.adit_config_set(self.config, b"method", b"adit"), 0)
        finder = c.c_void_p()
        self.assertEqual(LIBRARY.adit_finder_create(self.config, None, c.byref(finder)), 0)
        self.addCleanup(LIBRARY.adit_finder_destroy, finder)
        u, v = 50, 60
        pixels = bytearray(
            12 if math.hypot(x - u, y - v) < 18 else 120 + (7 * x + 13 * y) % 5
            for y in range(HEIGHT) for x in range(WIDTH))
        image = Image(c.sizeof(Image), (c.c_uint8 * len(pixels)).from_buffer(pixels), WIDTH, HEIGHT, WIDTH, 0)
        seen = OpenSpace(c.sizeof(OpenSpace))
        self.assertEqual(LIBRARY.adit_finder_find(finder, c.byref(image), c.byref(seen)), 0)
        self.assertEqual(LIBRARY.adit_status_name(seen.status), b"found")
        self.assertAlmostEqual(seen.u_px, u, delta=8)
        self.assertAlmostEqual(seen.v_px, v, delta=8)
        self.assertLess(seen.azimuth_rad, 0)

    def test_says_what_is_wrong(self):
        self.assertEqual(LIBRARY.adit_config_set(self.config, b"omega", b"7"), 1)
        self.assertIn(b"omega: 7 is not in [0.01, 1]", LIBRARY.adit_last_error())

    def test_names_every_field(self):
        names, index = [], 0
        while (name := LIBRARY.adit_config_field(self.config, index)) is not None:
            names.append(name.decode())
            index += 1
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("steering.prefer", names)


unittest.main()
