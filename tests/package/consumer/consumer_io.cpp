// Uses adit::io without naming OpenCV in its own build.
#include <adit/io/image_file.hpp>
#include <filesystem>
#include <fstream>

bool reads_back(const adit::ImageView& frame) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "adit_consumer.pgm";
  std::ofstream file(path, std::ios::binary);
  file << "P5\n" << frame.width << ' ' << frame.height << "\n255\n";
  for (int v = 0; v < frame.height; ++v) {
    file.write(reinterpret_cast<const char*>(frame.row(v)), frame.width);
  }
  file.close();
  const auto image = adit::io::read_image(path);
  const adit::ImageView back = adit::io::view_of(image);
  std::filesystem::remove(path);
  return back.width == frame.width && back.height == frame.height;
}
