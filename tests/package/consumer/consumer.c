/* What a flight stack in C does with adit. */
#include <adit.h>
#include <stdio.h>

int main(void) {
  static uint8_t pixels[64 * 48];
  adit_config* config = adit_config_create();
  adit_finder* finder = NULL;
  adit_open_space seen = ADIT_INIT(adit_open_space);
  adit_image image = ADIT_INIT(adit_image);
  size_t i;
  for (i = 0; i < sizeof pixels; ++i) pixels[i] = 100;
  image.data = pixels;
  image.width = 64;
  image.height = 48;
  image.stride_bytes = 64;
  image.format = ADIT_GREY8;
  if (adit_config_set(config, "method", "paper") != ADIT_OK || adit_finder_create(config, NULL, &finder) != ADIT_OK ||
      adit_finder_find(finder, &image, &seen) != ADIT_OK) {
    fprintf(stderr, "%s\n", adit_last_error());
    return 1;
  }
  printf("adit says: %s\n", adit_status_name(seen.status));
  adit_finder_destroy(finder);
  adit_config_destroy(config);
  return 0;
}
