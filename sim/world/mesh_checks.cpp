#include "mesh_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "adit/sim/mesh_file.hpp"
#include "adit/sim/world_error.hpp"

namespace adit::sim {
namespace {

namespace fs = std::filesystem;

/// A file of kTriangleMax triangles in the most wordy of the formats is about this large.
constexpr std::uintmax_t kFileMax_bytes = 1'000'000'000;

/// A binary STL says at once how many triangles it holds, and Assimp believes it.
void check_binary_stl(const std::string& path, std::uintmax_t size_bytes) {
  constexpr std::uintmax_t kHead_bytes = 84, kTriangle_bytes = 50;
  if (size_bytes < kHead_bytes) return;
  std::ifstream file(path, std::ios::binary);
  std::array<char, kHead_bytes> head{};
  if (!file.read(head.data(), head.size())) return;
  std::uint32_t count = 0;
  std::memcpy(&count, head.data() + 80, sizeof(count));
  const bool is_text = std::memcmp(head.data(), "solid", 5) == 0;
  const std::uintmax_t wanted_bytes = kHead_bytes + kTriangle_bytes * std::uintmax_t{count};
  if (wanted_bytes == size_bytes) {
    refuse_if_too_many(path, count);
  } else if (!is_text && wanted_bytes > size_bytes) {
    refuse(path, fmt::format("cut short: its head promises {} triangles ({} bytes), the file has {} bytes", count,
                             wanted_bytes, size_bytes));
  }
}

/// Bytes of a binary PLY's number; 0: no such type.
std::uint64_t bytes_of_ply(const std::string& type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "int" || type == "uint" || type == "float" || type == "int32" || type == "uint32" || type == "float32")
    return 4;
  return type == "double" || type == "float64" ? 8 : 0;
}

/// A PLY's head says what must follow. Assimp would wait for ever for the end of a head that is cut off.
void check_ply(const std::string& path, std::uintmax_t size_bytes) {
  constexpr int kHeadLinesMax = 1000;
  std::ifstream file(path, std::ios::binary);
  std::string line, word, type, format;
  std::uint64_t count = 0, wanted_bytes = 0, wanted_lines = 0;
  bool is_whole = false;
  for (int i = 0; i < kHeadLinesMax && !is_whole && std::getline(file, line); ++i) {
    std::istringstream words(line);
    words >> word;
    if (i == 0 && word != "ply") refuse(path, "begins with no 'ply'; it is no PLY file");
    if (word == "format") words >> format;
    if (word == "element") {
      if (!(words >> word >> count)) refuse(path, fmt::format("'{}' names no count", line));
      if (word == "face") refuse_if_too_many(path, count);
      wanted_lines += count;
    } else if (word == "property" && words >> type) {
      if (type == "list") words >> type;  // of a list at least the count is there
      wanted_bytes += count * bytes_of_ply(type);
    }
    is_whole = word == "end_header";
  }
  if (!is_whole) refuse(path, "cut short: its head has no end_header");
  const auto head_bytes = static_cast<std::uintmax_t>(file.tellg());
  // Text needs at least a digit and an end of line for each.
  const std::uint64_t least_bytes =
      format == "ascii" ? 2 * wanted_lines - std::min<std::uint64_t>(wanted_lines, 1) : wanted_bytes;
  if (count > kFileMax_bytes || head_bytes + least_bytes > size_bytes)
    refuse(path, fmt::format("cut short: its head promises {} lines or {} bytes more than the file has", wanted_lines,
                             wanted_bytes));
}

}  // namespace

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw WorldError(fmt::format("{}: {}", path, why));
}

void refuse_if_too_many(const std::string& path, std::uint64_t triangles) {
  if (triangles > kTriangleMax)
    refuse(path, fmt::format("{} triangles, {} at the most; simplify the mesh or cut it", triangles, kTriangleMax));
}

void check_mesh_file(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) refuse(path, "no such file; give a mesh (STL, OBJ, DAE, PLY)");
  const std::string extension = extension_of(path);
  constexpr std::array<const char*, 4> kKnown{".stl", ".obj", ".dae", ".ply"};
  if (std::find(kKnown.begin(), kKnown.end(), extension) == kKnown.end())
    refuse(path,
           fmt::format("'{}' is no format of a mesh that is read here; give .stl, .obj, .dae or .ply", extension));
  const std::uintmax_t size_bytes = fs::file_size(path, error);
  if (error) refuse(path, "cannot be read");
  if (size_bytes > kFileMax_bytes)
    refuse(path, fmt::format("{} bytes, {} at the most; simplify the mesh or cut it", size_bytes, kFileMax_bytes));
  if (extension == ".stl") check_binary_stl(path, size_bytes);
  if (extension == ".ply") check_ply(path, size_bytes);
}

}  // namespace adit::sim
