#include "text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "adit/io/errors.hpp"

namespace adit::io {
namespace {

constexpr std::size_t kSettingsBytesMax = 1u << 20;

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

/// Reads up to bytes_max bytes; returns the reason when that fails.
std::string read_into(const std::filesystem::path& path, std::size_t bytes_max, std::vector<unsigned char>& bytes) {
  if (std::string fault = fault_of_file(path); !fault.empty()) return fault;
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.number < 0) return std::strerror(errno);
  struct stat status {};
  if (::fstat(file.number, &status) == 0 && status.st_size > 0) {
    if (static_cast<std::size_t>(status.st_size) > bytes_max) return "is far too large";
    bytes.reserve(static_cast<std::size_t>(status.st_size) + 1);
  }
  unsigned char block[65536];
  while (true) {
    const ssize_t got = ::read(file.number, block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::strerror(errno);
    if (got == 0) break;
    if (bytes.size() + static_cast<std::size_t>(got) > bytes_max) return "is far too large";
    bytes.insert(bytes.end(), block, block + got);
  }
  return bytes.empty() ? kEmptyFile : "";
}

}  // namespace

std::string fault_of_file(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    return errno == ENOENT || errno == ENOTDIR ? "no such file" : std::strerror(errno);
  }
  if (S_ISDIR(status.st_mode)) return "is a folder, not a file";
  if (S_ISREG(status.st_mode) && status.st_size == 0) return kEmptyFile;
  return "";
}

std::vector<unsigned char> read_bytes(const std::filesystem::path& path) {
  constexpr std::size_t kBytesMax = std::size_t{1} << 30;
  std::vector<unsigned char> bytes;
  const std::string fault = read_into(path, kBytesMax, bytes);
  if (!fault.empty()) throw InputError(path.string() + ": " + fault);
  return bytes;
}

std::string read_settings_text(const std::filesystem::path& path) {
  std::vector<unsigned char> bytes;
  const std::string fault = read_into(path, kSettingsBytesMax, bytes);
  if (!fault.empty()) throw ConfigError(path.string() + ": " + fault);
  return {bytes.begin(), bytes.end()};
}

}  // namespace adit::io
