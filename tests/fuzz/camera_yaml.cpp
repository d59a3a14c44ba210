// Calibration files of any bytes: refused in one line, or a camera that can be built.
#include <string_view>

#include "adit/io/camera_file.hpp"
#include "adit/io/errors.hpp"
#include "byte_source.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  try {
    const adit::CameraModel model = adit::io::camera_of_yaml(text, "NAME");
    adit::fuzz::require(!fault_of(model), "an accepted calibration is a camera");
    const adit::Camera camera(model);
    (void)camera.normalised_of({0.0, 0.0});
  } catch (const adit::io::ConfigError& error) {
    adit::fuzz::require_message(error.what(), "NAME");
  }
  return 0;
}
