/* What a flight stack in C does with adit.h, and what it may do wrong. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "adit.h"

static int failures = 0;

#define EXPECT(condition)                                             \
  do {                                                                \
    if (!(condition)) {                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      fprintf(stderr, "  adit_last_error: %s\n", adit_last_error());  \
      ++failures;                                                     \
    }                                                                 \
  } while (0)

enum { kWidth = 320, kHeight = 240 };
static uint8_t pixels[3 * kWidth * kHeight];

/* Lit rock with a dark round opening at (u, v), radius 30 px; noise keeps two frames from being the same. */
static adit_image draw(int u, int v, unsigned seed) {
  adit_image image = ADIT_INIT(adit_image);
  int x, y, c;
  for (y = 0; y < kHeight; ++y)
    for (x = 0; x < kWidth; ++x)
      for (c = 0; c < 3; ++c) {
        const int open = (x - u) * (x - u) + (y - v) * (y - v) < 900;
        seed = seed * 1103515245u + 12345u;
        pixels[3 * (y * kWidth + x) + c] = (uint8_t)((open ? 12 : 130) + (seed >> 16) % 3);
      }
  image.data = pixels;
  image.width = kWidth;
  image.height = kHeight;
  image.stride_bytes = 3 * kWidth;
  image.format = ADIT_BGR8;
  return image;
}

static void test_finder(const char* method) {
  adit_config* config = adit_config_create();
  adit_finder* finder = NULL;
  adit_open_space seen = ADIT_INIT(adit_open_space);
  adit_opening opening = ADIT_INIT(adit_opening);
  adit_image image = draw(220, 120, 1u);
  int32_t width = 0, height = 0;
  EXPECT(adit_config_set(config, "method", method) == ADIT_OK);
  EXPECT(adit_finder_create(config, NULL, &finder) == ADIT_OK);
  EXPECT(adit_finder_image(finder, ADIT_IMAGE_DARK_CHANNEL, &width, &height) == NULL);
  EXPECT(adit_finder_find(finder, &image, &seen) == ADIT_OK);
  EXPECT(seen.status == ADIT_FOUND);
  EXPECT(fabs(seen.u_px - 220.0) < 12.0 && fabs(seen.v_px - 120.0) < 12.0);
  EXPECT(seen.azimuth_rad > 0.1 && seen.sx > 0.1); /* to the right is positive */
  EXPECT(seen.opening_count >= 1 && seen.total_ns > 0);
  EXPECT(adit_finder_opening(finder, 0, &opening) == ADIT_OK);
  EXPECT(opening.u_px == seen.u_px && opening.azimuth_rad == seen.azimuth_rad);
  EXPECT(adit_finder_opening(finder, seen.opening_count, &opening) == ADIT_INVALID_ARGUMENT);
  EXPECT(strstr(adit_last_error(), "index") != NULL);

  /* Bottom-up: the same pixels by a negative stride are the mirrored picture. */
  image.data = pixels + 3 * kWidth * (kHeight - 1);
  image.stride_bytes = -3 * kWidth;
  EXPECT(adit_finder_explain(finder, &image, &seen) == ADIT_OK);
  EXPECT(seen.status == ADIT_FOUND && fabs(seen.v_px - (kHeight - 1 - 120)) < 12.0);
  EXPECT(adit_finder_image(finder, ADIT_IMAGE_DARK_CHANNEL, &width, &height) != NULL);
  EXPECT(width == kWidth && height == kHeight);
  EXPECT((adit_finder_image(finder, ADIT_IMAGE_OPENINGS, NULL, NULL) != NULL) == (strcmp(method, "adit") == 0));
  EXPECT(adit_finder_image(finder, 99, NULL, NULL) == NULL);

  /* Mirrored: pixels from the right to the left. */
  image.data = pixels + 3 * (kWidth - 1);
  image.stride_bytes = 3 * kWidth;
  image.pixel_stride_bytes = -3;
  EXPECT(adit_finder_find(finder, &image, &seen) == ADIT_OK);
  EXPECT(seen.status == ADIT_FOUND && fabs(seen.u_px - (kWidth - 1 - 220)) < 12.0 && fabs(seen.v_px - 120.0) < 12.0);
  /* The channels from the other end, which is no matter to their minimum. */
  image.data = pixels + 2;
  image.pixel_stride_bytes = 3;
  image.channel_stride_bytes = -1;
  EXPECT(adit_finder_find(finder, &image, &seen) == ADIT_OK);
  EXPECT(seen.status == ADIT_FOUND && fabs(seen.u_px - 220.0) < 12.0);

  /* What is no frame is an answer, not an error. */
  image.format = 77;
  EXPECT(adit_finder_find(finder, &image, &seen) == ADIT_OK && seen.status == ADIT_BAD_FRAME);
  EXPECT(strcmp(adit_status_name(seen.status), "bad_frame") == 0);
  EXPECT(seen.opening_count == 0 && seen.azimuth_rad == 0.0);
  adit_finder_destroy(finder);
  adit_config_destroy(config);
}

static void test_config(void) {
  adit_config* config = adit_config_create();
  adit_finder* finder = NULL;
  char text[32];
  size_t count = 0;
  while (adit_config_field(config, count) != NULL) {
    /* Every field gives a text that it takes. */
    const char* field = adit_config_field(config, count++);
    EXPECT(adit_config_get(config, field, text, sizeof text) == ADIT_OK);
    EXPECT(adit_config_set(config, field, text) == ADIT_OK);
  }
  EXPECT(count > 40);
  EXPECT(strcmp(adit_config_field(config, 0), "finder.method") == 0);
  EXPECT(adit_config_set_number(config, "finder.omega", 0.5) == ADIT_OK);
  EXPECT(adit_config_get(config, "omega", text, sizeof text) == ADIT_OK && strcmp(text, "0.5") == 0);
  EXPECT(adit_config_get(config, "omega", text, 2) == ADIT_OK && strcmp(text, "0") == 0);
  /* Refused, with the name, and nothing has changed. */
  EXPECT(adit_config_set_number(config, "omega", 1.5) == ADIT_INVALID_ARGUMENT);
  EXPECT(strstr(adit_last_error(), "omega") != NULL && strstr(adit_last_error(), "1.5") != NULL);
  EXPECT(adit_config_set(config, "omega", "much") == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_config_set(config, "omega", "0.5x") == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_config_set_number(config, "omega", NAN) == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_config_set_number(config, "cluster_count", 3.5) == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_config_set_number(config, "cluster_count", 1e300) == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_config_set(config, "method", "magic") == ADIT_INVALID_ARGUMENT);
  EXPECT(strstr(adit_last_error(), "paper adit") != NULL);
  EXPECT(adit_config_set(config, "no_such_field", "1") == ADIT_INVALID_ARGUMENT);
  EXPECT(strstr(adit_last_error(), "no_such_field") != NULL);
  EXPECT(adit_config_set(config, NULL, "1") == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_config_set(NULL, "omega", "1") == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_config_get(config, "omega", text, sizeof text) == ADIT_OK && strcmp(text, "0.5") == 0);
  EXPECT(adit_finder_create(NULL, NULL, &finder) == ADIT_INVALID_ARGUMENT && finder == NULL);
  EXPECT(adit_finder_create(config, NULL, NULL) == ADIT_INVALID_ARGUMENT);
  adit_config_destroy(config);
  adit_config_destroy(NULL);
  adit_finder_destroy(NULL);
  adit_navigator_destroy(NULL);
}

static void test_camera(void) {
  adit_config* config = adit_config_create();
  adit_finder* finder = NULL;
  adit_camera camera = ADIT_INIT(adit_camera);
  adit_open_space seen = ADIT_INIT(adit_open_space);
  adit_image image = draw(220, 120, 2u);
  EXPECT(adit_config_set(config, "method", "paper") == ADIT_OK);
  EXPECT(adit_finder_create(config, &camera, &finder) == ADIT_INVALID_ARGUMENT && finder == NULL);
  camera.width = kWidth;
  camera.height = kHeight;
  camera.focal_length_x_px = camera.focal_length_y_px = 200.0;
  camera.principal_point_x_px = 159.5;
  camera.principal_point_y_px = 119.5;
  EXPECT(adit_finder_create(config, &camera, &finder) == ADIT_OK);
  EXPECT(adit_finder_find(finder, &image, &seen) == ADIT_OK && seen.status == ADIT_FOUND);
  EXPECT(fabs(seen.sx - (seen.u_px - 159.5) / 200.0) < 1e-9);
  image.width = kWidth / 2;
  EXPECT(adit_finder_find(finder, &image, &seen) == ADIT_OK && seen.status == ADIT_WRONG_SIZE);
  adit_finder_destroy(finder);
  camera.distortion_model = 9;
  EXPECT(adit_finder_create(config, &camera, &finder) == ADIT_INVALID_ARGUMENT);
  adit_config_destroy(config);
}

/* A caller of yesterday knows less, a caller of tomorrow more. */
static void test_sizes(void) {
  struct {
    adit_open_space known;
    char later[64];
  } tomorrow;
  adit_config* config = adit_config_create();
  adit_finder* finder = NULL;
  adit_open_space yesterday;
  adit_image image = draw(160, 120, 3u);
  EXPECT(adit_config_set(config, "method", "paper") == ADIT_OK);
  EXPECT(adit_finder_create(config, NULL, &finder) == ADIT_OK);
  memset(&yesterday, 0xAB, sizeof yesterday);
  yesterday.struct_size = offsetof(adit_open_space, opening_count);
  EXPECT(adit_finder_find(finder, &image, &yesterday) == ADIT_OK);
  EXPECT(yesterday.status == ADIT_FOUND);
  EXPECT(yesterday.struct_size == offsetof(adit_open_space, opening_count));
  EXPECT(*(const unsigned char*)&yesterday.opening_count == 0xAB); /* not its to write */
  memset(&tomorrow, 0xAB, sizeof tomorrow);
  tomorrow.known.struct_size = sizeof tomorrow;
  EXPECT(adit_finder_find(finder, &image, &tomorrow.known) == ADIT_OK);
  EXPECT(tomorrow.known.opening_count >= 1 && tomorrow.later[0] == 0 && tomorrow.later[63] == 0);
  yesterday.struct_size = 0;
  EXPECT(adit_finder_find(finder, &image, &yesterday) == ADIT_INVALID_ARGUMENT);
  EXPECT(strstr(adit_last_error(), "struct_size") != NULL);
  EXPECT(adit_finder_find(finder, NULL, &tomorrow.known) == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_finder_find(finder, &image, NULL) == ADIT_INVALID_ARGUMENT);
  EXPECT(adit_finder_find(NULL, &image, &tomorrow.known) == ADIT_INVALID_ARGUMENT);
  adit_finder_destroy(finder);
  adit_config_destroy(config);
}

static void test_navigator(void) {
  adit_config* config = adit_config_create();
  adit_navigator* navigator = NULL;
  adit_command command = ADIT_INIT(adit_command);
  adit_open_space seen = ADIT_INIT(adit_open_space);
  adit_motion motion = ADIT_INIT(adit_motion);
  adit_image image;
  int frame;
  EXPECT(adit_config_set(config, "method", "adit") == ADIT_OK);
  EXPECT(adit_navigator_create(config, NULL, &navigator) == ADIT_OK);
  motion.yaw_rate_rad_s = NAN;
  motion.speed_m_s = 1.0;
  for (frame = 0; frame < 15; ++frame) {
    image = draw(220, 120, 10u + (unsigned)frame);
    EXPECT(adit_navigator_update(navigator, &image, 0.05 * frame, &motion, &command, &seen) == ADIT_OK);
    EXPECT(seen.status == ADIT_FOUND && command.status == ADIT_FOUND);
  }
  EXPECT(command.manoeuvre == ADIT_FOLLOW && command.yaw_rate_rad_s < 0.0); /* the opening is to the right */
  for (frame = 0; frame < 4; ++frame)                                       /* the camera hangs */
    EXPECT(adit_navigator_update(navigator, &image, 0.8 + 0.05 * frame, NULL, &command, NULL) == ADIT_OK);
  EXPECT(command.status == ADIT_FROZEN_FRAME);
  EXPECT(adit_navigator_tick(navigator, 9.0, &command) == ADIT_OK);
  EXPECT(command.heading_state == ADIT_HOLD && command.yaw_rate_rad_s == 0.0);
  EXPECT(adit_navigator_reset(navigator) == ADIT_OK);
  EXPECT(adit_navigator_update(navigator, &image, 0.0, NULL, NULL, NULL) == ADIT_INVALID_ARGUMENT);
  adit_navigator_destroy(navigator);
  adit_config_destroy(config);
}

int main(void) {
  EXPECT(strcmp(adit_version(), ADIT_VERSION_WANTED) == 0);
  EXPECT(adit_abi_version() == ADIT_ABI_VERSION);
  EXPECT(adit_cpu_target()[0] != '\0');
  EXPECT(strcmp(adit_status_name(-1), "unknown") == 0);
  EXPECT(strcmp(adit_last_error(), "") == 0);
  test_finder("paper");
  test_finder("adit");
  test_config();
  test_camera();
  test_sizes();
  test_navigator();
  printf("%s\n", failures == 0 ? "all good" : "FAILED");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
