/* adit: where the open space is, in the dark, from one camera. The C interface.
 *
 * Link with -ladit (pkg-config adit). Everything here is thread-compatible: different handles are independent, one
 * handle serves one thread at a time. No function prints, aborts or lets a C++ exception out.
 *
 * What stays the same from version to version (the ABI; ADIT_ABI_VERSION counts its breaks, and so does the SONAME):
 * - Handles are opaque. Enumeration values are never renumbered; new ones are added at the end.
 * - Structs begin with struct_size, which the caller sets to sizeof the struct it was compiled with (ADIT_INIT does).
 *   New members are added at the end; a library of any age writes and reads only what both sides know.
 *
 * Directions: azimuth is positive to the right of the optical axis, elevation above it, yaw rate positive to the left.
 */
#ifndef ADIT_H
#define ADIT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define ADIT_C_API __attribute__((visibility("default")))
#else
#define ADIT_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define ADIT_ABI_VERSION 0

/* What became of a call. 0 is success. */
typedef enum adit_error {
  ADIT_OK = 0,
  ADIT_INVALID_ARGUMENT = 1, /* a null pointer, a value out of range, an unknown name: adit_last_error() says which */
  ADIT_OUT_OF_MEMORY = 2,
  ADIT_INTERNAL = 3 /* a defect of the library */
} adit_error;

/* What became of a frame. Only ADIT_FOUND comes with a bearing to follow. */
typedef enum adit_status {
  ADIT_FOUND = 0,
  ADIT_TOO_DARK = 1,
  ADIT_TOO_BRIGHT = 2,
  ADIT_NO_CONTRAST = 3,
  ADIT_NO_REGION = 4,
  ADIT_BAD_FRAME = 5,
  ADIT_WRONG_SIZE = 6,
  ADIT_NO_OPENING = 7,
  ADIT_BLOCKED_LENS = 8,
  ADIT_DUST = 9,
  ADIT_FROZEN_FRAME = 10, /* this and the next: of a navigator, never of a finder */
  ADIT_TORN_FRAME = 11
} adit_status;

/* How the bytes of a pixel are laid out. Channels are 8 bits unless the name says 16. */
typedef enum adit_pixel_format {
  ADIT_GREY8 = 0,
  ADIT_BGR8 = 1,
  ADIT_RGB8 = 2,
  ADIT_BGRA8 = 3,
  ADIT_RGBA8 = 4,
  ADIT_GREY16 = 5 /* the machine's byte order */
} adit_pixel_format;

typedef enum adit_heading_state {
  ADIT_STEER = 0, /* a fresh bearing is being followed */
  ADIT_COAST = 1, /* no bearing just now: the rate runs down to zero */
  ADIT_HOLD = 2   /* no fresh bearing for hold_after_s: rate zero */
} adit_heading_state;

typedef enum adit_manoeuvre {
  ADIT_WAIT = 0,   /* nothing usable is seen: hold */
  ADIT_FOLLOW = 1, /* an open way is followed */
  ADIT_TURN = 2,   /* nothing open ahead: it turns in place towards the more open side */
  ADIT_GIVE_UP = 3 /* it has turned all the way round and found nothing: hold */
} adit_manoeuvre;

typedef enum adit_distortion {
  ADIT_NO_DISTORTION = 0,
  ADIT_PLUMB_BOB = 1,           /* k1 k2 p1 p2 k3 */
  ADIT_RATIONAL_POLYNOMIAL = 2, /* k1 k2 p1 p2 k3 k4 k5 k6 */
  ADIT_EQUIDISTANT = 3          /* k1 k2 k3 k4 */
} adit_distortion;

/* Disturbances, as bits. */
#define ADIT_FLAG_DUST 1u
#define ADIT_FLAG_GLARE 2u
#define ADIT_FLAG_BLOCKED_LENS 4u
#define ADIT_FLAG_TOO_DARK 8u
#define ADIT_FLAG_TOO_BRIGHT 16u
#define ADIT_FLAG_DIRTY_LENS 32u /* of a navigator only: a spot on the lens was told from an opening */

typedef struct adit_config adit_config;       /* every field, by name */
typedef struct adit_finder adit_finder;       /* one frame in, the open space out; no memory between frames */
typedef struct adit_navigator adit_navigator; /* frames in, commands out: what a robot runs */

/* Sets a struct to zero and its struct_size: adit_image image = ADIT_INIT(adit_image); */
#ifdef __cplusplus
#define ADIT_INIT(type) \
  type { sizeof(type) }
#else
#define ADIT_INIT(type) \
  { .struct_size = sizeof(type) }
#endif

/* Pixels that belong to the caller; read during the call only. Row v starts at data + v * stride_bytes; the stride may
 * be negative (bottom-up images) and may hold padding. Pixels lie side by side in a row and channels in a pixel where
 * the last two are 0; else they lie so far apart (mirrored pictures, every second column, planes), in either direction.
 * Sides: 16 to 8192 px. */
typedef struct adit_image {
  size_t struct_size;
  const uint8_t* data;
  int32_t width;
  int32_t height;
  ptrdiff_t stride_bytes;
  int32_t format; /* adit_pixel_format */
  int32_t reserved;
  ptrdiff_t pixel_stride_bytes;
  ptrdiff_t channel_stride_bytes;
} adit_image;

/* A calibration, as in a ROS camera_info file; px, of the frames' size. */
typedef struct adit_camera {
  size_t struct_size;
  int32_t width;
  int32_t height;
  double focal_length_x_px;
  double focal_length_y_px;
  double principal_point_x_px;
  double principal_point_y_px;
  double distortion[8];
  int32_t distortion_model; /* adit_distortion */
} adit_camera;

/* The answer for one frame. Angles, centroid and confidence are 0 unless found. */
typedef struct adit_open_space {
  size_t struct_size;
  int32_t status;           /* adit_status */
  int32_t opening_count;    /* see adit_finder_opening */
  uint32_t flags;           /* ADIT_FLAG_... */
  int32_t darkest_level;    /* of the closed dark channel, 0 to 255 */
  double confidence;        /* 0 to 1; what it means depends on the method, see docs/method.md */
  double u_px;              /* of the best opening's centroid, to the right */
  double v_px;              /* down */
  double sx;                /* eq. (10), on the plane z = 1, to the right */
  double sy;                /* down */
  double azimuth_rad;       /* positive to the right */
  double elevation_rad;     /* positive upwards */
  double area_fraction;     /* of the frame, 0 to 1 */
  double atmospheric_light; /* grey levels, 0 to 255 */
  double veil_fraction;     /* 0 clear air, 1 nothing but veil; method adit */
  int64_t total_ns;         /* time the whole chain took */
} adit_open_space;

/* One of the openings of the last frame, the best first. */
typedef struct adit_opening {
  size_t struct_size;
  int32_t touches_border;
  int32_t reserved;
  double u_px, v_px, sx, sy, azimuth_rad, elevation_rad, area_fraction, confidence;
  double half_width_rad, half_height_rad; /* half the angle between the edges of the box about it */
  double score, contrast;
  double left_px, top_px, right_px, bottom_px; /* that box; its last pixels belong to it */
} adit_opening;

/* What the caller knows of the vehicle's motion; NaN for what is not known. */
typedef struct adit_motion {
  size_t struct_size;
  double yaw_rate_rad_s; /* positive to the left */
  double speed_m_s;      /* forward */
} adit_motion;

typedef struct adit_command {
  size_t struct_size;
  int32_t heading_state; /* adit_heading_state */
  int32_t manoeuvre;     /* adit_manoeuvre */
  int32_t status;        /* adit_status, with what only a sequence shows */
  int32_t stamp_fault;   /* 0 none, 1 not later, 2 backwards, 3 jump */
  double yaw_rate_rad_s; /* positive to the left */
  double speed_scale;    /* share of the wanted speed, 0 to 1 */
  double target_rad;     /* azimuth that is steered to, positive to the right */
  double free_m;         /* free way straight ahead, on the pseudo-range's scale */
} adit_command;

/* Pictures of a stage, for people. */
typedef enum adit_stage_image {
  ADIT_IMAGE_DARK_CHANNEL = 0,     /* uint8_t, grey levels */
  ADIT_IMAGE_SCATTERING_DEPTH = 1, /* float, unitless; small is far */
  ADIT_IMAGE_CLOSING = 2,          /* float, the same after the closing */
  ADIT_IMAGE_CLUSTER = 3,          /* uint8_t, 0 is the darkest */
  ADIT_IMAGE_BINARY = 4,           /* uint8_t, 255 in the darkest cluster */
  ADIT_IMAGE_LIGHT = 5,            /* float, stops below full scale; method adit */
  ADIT_IMAGE_ENCLOSURE = 6,        /* float, the score map; method adit */
  ADIT_IMAGE_OPENINGS = 7          /* uint8_t, 1 the best opening, 2 the next, ...; method adit */
} adit_stage_image;

/* ---- the library ---- */

/* "0.1.0" */
ADIT_C_API const char* adit_version(void);
/* ADIT_ABI_VERSION of the library; the caller's must be the same. */
ADIT_C_API int adit_abi_version(void);
/* Why the last call of this thread that failed did so, as one line; "" when none did. Valid until the next failure. */
ADIT_C_API const char* adit_last_error(void);
/* "found", "too_dark", ...; "unknown" for a value that is none. */
ADIT_C_API const char* adit_status_name(int status);
/* The instruction set in use: "avx2", "neon", "plain", ... */
ADIT_C_API const char* adit_cpu_target(void);

/* ---- configuration ---- */

/* All fields at their defaults. NULL only when there is no memory. */
ADIT_C_API adit_config* adit_config_create(void);
ADIT_C_API void adit_config_destroy(adit_config* config);
/* Sets a field: "method" or "finder.method" to "adit", "omega" to "0.9", "steering.prefer" to "left". A name without
 * section is looked for in all sections. Nothing changes when the name or the value is refused. */
ADIT_C_API adit_error adit_config_set(adit_config* config, const char* field, const char* value);
ADIT_C_API adit_error adit_config_set_number(adit_config* config, const char* field, double value);
/* The value as text, cut to size bytes with its closing zero. */
ADIT_C_API adit_error adit_config_get(const adit_config* config, const char* field, char* text, size_t size);
/* The fields there are: "finder.method", ...; NULL past the last. The text lives as long as the config. */
ADIT_C_API const char* adit_config_field(const adit_config* config, size_t index);

/* ---- finder ---- */

/* @param camera  NULL: frames of any size, and an ideal pinhole with assumed_hfov_deg. */
ADIT_C_API adit_error adit_finder_create(const adit_config* config, const adit_camera* camera, adit_finder** finder);
ADIT_C_API void adit_finder_destroy(adit_finder* finder);
/* Judges one frame. A frame that cannot be judged is no error: its status says so. Allocates nothing once the size of
 * the frames is known. */
ADIT_C_API adit_error adit_finder_find(adit_finder* finder, const adit_image* image, adit_open_space* open_space);
/* The same, and keeps the pictures of its stages for adit_finder_image(). */
ADIT_C_API adit_error adit_finder_explain(adit_finder* finder, const adit_image* image, adit_open_space* open_space);
/* One of the openings of the last frame. @param index  below open_space.opening_count */
ADIT_C_API adit_error adit_finder_opening(const adit_finder* finder, int32_t index, adit_opening* opening);
/* A picture of the last explained frame, width x height values, rows one after the other, valid until the next call
 * with this finder. NULL when there is none (nothing explained yet, or the method or frame made none). */
ADIT_C_API const void* adit_finder_image(const adit_finder* finder, int which, int32_t* width, int32_t* height);

/* ---- navigator ---- */

ADIT_C_API adit_error adit_navigator_create(const adit_config* config, const adit_camera* camera,
                                            adit_navigator** navigator);
ADIT_C_API void adit_navigator_destroy(adit_navigator* navigator);
/* Judges the frame and says what to do. @param stamp_s  when the frame was taken. @param motion  NULL: not known.
 * @param open_space  NULL, or where the answer for the frame goes. */
ADIT_C_API adit_error adit_navigator_update(adit_navigator* navigator, const adit_image* image, double stamp_s,
                                            const adit_motion* motion, adit_command* command,
                                            adit_open_space* open_space);
/* The command when no new frame has come by now_s. */
ADIT_C_API adit_error adit_navigator_tick(adit_navigator* navigator, double now_s, adit_command* command);
ADIT_C_API adit_error adit_navigator_reset(adit_navigator* navigator);

#ifdef __cplusplus
}
#endif

#endif
