/* The binary interface as it was promised: sizes, offsets and numbers of adit.h on 64-bit machines, all of which lay
 * them out alike. This file does not compile when one of them moves. What was added at the end of a struct is added
 * here too; what moved by design needs another ADIT_ABI_VERSION and SONAME, and a new list. */
#include <stddef.h>

#include "adit.h"

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
/* C99 has no static_assert; an array of -1 is an error everywhere. */
#define HOLDS(condition) typedef char JOIN(holds_, __LINE__)[(condition) ? 1 : -1]
#define OFFSET(type, member, bytes) HOLDS(offsetof(type, member) == (bytes))
#define SIZE(type, bytes) HOLDS(sizeof(type) == (bytes))
#define NUMBER(name, value) HOLDS((name) == (value))

NUMBER(ADIT_ABI_VERSION, 0);

NUMBER(ADIT_OK, 0);
NUMBER(ADIT_INVALID_ARGUMENT, 1);
NUMBER(ADIT_OUT_OF_MEMORY, 2);
NUMBER(ADIT_INTERNAL, 3);
NUMBER(ADIT_FOUND, 0);
NUMBER(ADIT_TOO_DARK, 1);
NUMBER(ADIT_TOO_BRIGHT, 2);
NUMBER(ADIT_NO_CONTRAST, 3);
NUMBER(ADIT_NO_REGION, 4);
NUMBER(ADIT_BAD_FRAME, 5);
NUMBER(ADIT_WRONG_SIZE, 6);
NUMBER(ADIT_NO_OPENING, 7);
NUMBER(ADIT_BLOCKED_LENS, 8);
NUMBER(ADIT_DUST, 9);
NUMBER(ADIT_FROZEN_FRAME, 10);
NUMBER(ADIT_TORN_FRAME, 11);
NUMBER(ADIT_GREY8, 0);
NUMBER(ADIT_BGR8, 1);
NUMBER(ADIT_RGB8, 2);
NUMBER(ADIT_BGRA8, 3);
NUMBER(ADIT_RGBA8, 4);
NUMBER(ADIT_GREY16, 5);
NUMBER(ADIT_STEER, 0);
NUMBER(ADIT_COAST, 1);
NUMBER(ADIT_HOLD, 2);
NUMBER(ADIT_WAIT, 0);
NUMBER(ADIT_FOLLOW, 1);
NUMBER(ADIT_TURN, 2);
NUMBER(ADIT_GIVE_UP, 3);
NUMBER(ADIT_NO_DISTORTION, 0);
NUMBER(ADIT_PLUMB_BOB, 1);
NUMBER(ADIT_RATIONAL_POLYNOMIAL, 2);
NUMBER(ADIT_EQUIDISTANT, 3);
NUMBER(ADIT_IMAGE_DARK_CHANNEL, 0);
NUMBER(ADIT_IMAGE_SCATTERING_DEPTH, 1);
NUMBER(ADIT_IMAGE_CLOSING, 2);
NUMBER(ADIT_IMAGE_CLUSTER, 3);
NUMBER(ADIT_IMAGE_BINARY, 4);
NUMBER(ADIT_IMAGE_LIGHT, 5);
NUMBER(ADIT_IMAGE_ENCLOSURE, 6);
NUMBER(ADIT_IMAGE_OPENINGS, 7);
NUMBER(ADIT_FLAG_DUST, 1);
NUMBER(ADIT_FLAG_GLARE, 2);
NUMBER(ADIT_FLAG_BLOCKED_LENS, 4);
NUMBER(ADIT_FLAG_TOO_DARK, 8);
NUMBER(ADIT_FLAG_TOO_BRIGHT, 16);
NUMBER(ADIT_FLAG_DIRTY_LENS, 32);

#if UINTPTR_MAX == UINT64_MAX
OFFSET(adit_image, struct_size, 0);
OFFSET(adit_image, data, 8);
OFFSET(adit_image, width, 16);
OFFSET(adit_image, height, 20);
OFFSET(adit_image, stride_bytes, 24);
OFFSET(adit_image, format, 32);
OFFSET(adit_image, reserved, 36);
OFFSET(adit_image, pixel_stride_bytes, 40);
OFFSET(adit_image, channel_stride_bytes, 48);
SIZE(adit_image, 56);

OFFSET(adit_camera, struct_size, 0);
OFFSET(adit_camera, width, 8);
OFFSET(adit_camera, height, 12);
OFFSET(adit_camera, focal_length_x_px, 16);
OFFSET(adit_camera, focal_length_y_px, 24);
OFFSET(adit_camera, principal_point_x_px, 32);
OFFSET(adit_camera, principal_point_y_px, 40);
OFFSET(adit_camera, distortion, 48);
OFFSET(adit_camera, distortion_model, 112);
SIZE(adit_camera, 120);

OFFSET(adit_open_space, struct_size, 0);
OFFSET(adit_open_space, status, 8);
OFFSET(adit_open_space, opening_count, 12);
OFFSET(adit_open_space, flags, 16);
OFFSET(adit_open_space, darkest_level, 20);
OFFSET(adit_open_space, confidence, 24);
OFFSET(adit_open_space, u_px, 32);
OFFSET(adit_open_space, v_px, 40);
OFFSET(adit_open_space, sx, 48);
OFFSET(adit_open_space, sy, 56);
OFFSET(adit_open_space, azimuth_rad, 64);
OFFSET(adit_open_space, elevation_rad, 72);
OFFSET(adit_open_space, area_fraction, 80);
OFFSET(adit_open_space, atmospheric_light, 88);
OFFSET(adit_open_space, veil_fraction, 96);
OFFSET(adit_open_space, total_ns, 104);
SIZE(adit_open_space, 112);

OFFSET(adit_opening, struct_size, 0);
OFFSET(adit_opening, touches_border, 8);
OFFSET(adit_opening, reserved, 12);
OFFSET(adit_opening, u_px, 16);
OFFSET(adit_opening, v_px, 24);
OFFSET(adit_opening, sx, 32);
OFFSET(adit_opening, sy, 40);
OFFSET(adit_opening, azimuth_rad, 48);
OFFSET(adit_opening, elevation_rad, 56);
OFFSET(adit_opening, area_fraction, 64);
OFFSET(adit_opening, confidence, 72);
OFFSET(adit_opening, half_width_rad, 80);
OFFSET(adit_opening, half_height_rad, 88);
OFFSET(adit_opening, score, 96);
OFFSET(adit_opening, contrast, 104);
OFFSET(adit_opening, left_px, 112);
OFFSET(adit_opening, top_px, 120);
OFFSET(adit_opening, right_px, 128);
OFFSET(adit_opening, bottom_px, 136);
SIZE(adit_opening, 144);

OFFSET(adit_motion, struct_size, 0);
OFFSET(adit_motion, yaw_rate_rad_s, 8);
OFFSET(adit_motion, speed_m_s, 16);
SIZE(adit_motion, 24);

OFFSET(adit_command, struct_size, 0);
OFFSET(adit_command, heading_state, 8);
OFFSET(adit_command, manoeuvre, 12);
OFFSET(adit_command, status, 16);
OFFSET(adit_command, stamp_fault, 20);
OFFSET(adit_command, yaw_rate_rad_s, 24);
OFFSET(adit_command, speed_scale, 32);
OFFSET(adit_command, target_rad, 40);
OFFSET(adit_command, free_m, 48);
SIZE(adit_command, 56);
#endif

/* A file of C has to declare something that stays. */
int adit_abi_baseline(void);
int adit_abi_baseline(void) { return ADIT_ABI_VERSION; }
