#include "adit/io/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

#include "adit/io/errors.hpp"

namespace adit::io {
namespace {

constexpr std::size_t kBufferBytes = 1u << 16;

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw OutputError(name + ": cannot be written: " + why);
}

bool is_special(const std::filesystem::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// The file that a symbolic link leads to, so that the link stays a link.
std::filesystem::path target_of(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target;
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

std::filesystem::path temporary_for(const std::filesystem::path& path) {
  static std::atomic<unsigned> counter{0};
  std::string name = ".";
  name += path.stem().string().substr(0, 180);
  name += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  name += path.extension().string();  // last: encoders choose the container by it
  return folder_of(path) / name;
}

/// What the disk really took. Returns errno, 0 when all is well.
int sync_path(const std::filesystem::path& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  if (file < 0) return errno;
  const int outcome = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  return outcome;
}

}  // namespace

PendingFile::PendingFile(const std::filesystem::path& path) : final_path_(target_of(path)) {
  struct stat status {};
  const bool exists = ::stat(final_path_.c_str(), &status) == 0;
  if (path.empty() || !final_path_.has_filename()) refuse("'" + path.string() + "'", "not the name of a file");
  if (exists && S_ISDIR(status.st_mode)) refuse(path.string(), "it is a folder");
  if (exists && !S_ISREG(status.st_mode)) refuse(path.string(), "it is a device or a pipe");
  if (exists && ::access(final_path_.c_str(), W_OK) != 0) refuse(path.string(), std::strerror(errno));
  if (::stat(folder_of(final_path_).c_str(), &status) != 0) {
    refuse(path.string(),
           errno == ENOENT ? "no such folder: " + folder_of(final_path_).string() : std::strerror(errno));
  }
  temporary_path_ = temporary_for(final_path_);
  const int file = ::open(temporary_path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) {
    temporary_path_.clear();
    refuse(path.string(), std::strerror(errno));
  }
  ::close(file);
}

PendingFile::~PendingFile() {
  if (!temporary_path_.empty()) ::unlink(temporary_path_.c_str());
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : final_path_(std::move(other.final_path_)), temporary_path_(std::exchange(other.temporary_path_, {})) {}

void PendingFile::sync() {
  if (const int error = sync_path(temporary_path_, O_RDONLY); error != 0) {
    refuse(final_path_.string(), std::strerror(error));
  }
}

void PendingFile::commit() {
  sync();
  if (::rename(temporary_path_.c_str(), final_path_.c_str()) != 0) refuse(final_path_.string(), std::strerror(errno));
  temporary_path_.clear();
  // The new name itself; some file systems cannot, and the file is whole all the same.
  sync_path(folder_of(final_path_), O_RDONLY | O_DIRECTORY);
}

OutputFile::OutputFile(const std::filesystem::path& path) : name_(path.string()) {
  if (path == "-") {
    name_ = "standard output";
    descriptor_ = ::dup(STDOUT_FILENO);
  } else if (is_special(path)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    pending_ = std::make_unique<PendingFile>(path);
    descriptor_ = ::open(pending_->temporary_path().c_str(), O_WRONLY | O_CLOEXEC);
  }
  if (descriptor_ < 0) refuse(name_, std::strerror(errno));
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : name_(std::move(other.name_)),
      pending_(std::move(other.pending_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)) {}

void OutputFile::write(std::string_view text) {
  buffer_ += text;
  if (!pending_ || buffer_.size() >= kBufferBytes) flush();
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(name_, errno == EPIPE ? "the reader has gone" : std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void OutputFile::finish() {
  if (descriptor_ < 0) return;
  flush();
  if (::close(std::exchange(descriptor_, -1)) != 0) refuse(name_, std::strerror(errno));
  if (pending_) pending_->sync();
}

void OutputFile::commit() {
  finish();
  if (pending_) pending_->commit();
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder, error)) {
    throw OutputError(folder.string() +
                      ": this folder cannot be made: " + (error ? error.message() : "a file has its name"));
  }
}

}  // namespace adit::io
