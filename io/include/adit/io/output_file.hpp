// Files that appear under their name only when they are whole.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace adit::io {

/// A temporary name beside the final one. commit() puts the file in its place in one step (fsync, rename); without it,
/// the destructor removes the temporary. Whoever looks at the final name sees the old file or the whole new one.
class PendingFile {
 public:
  /// Creates the temporary: ".NAME.part-PID.EXT" in the same folder. A symbolic link is followed.
  /// @throws OutputError when the folder is missing or not writable, or the name is a folder or a device.
  explicit PendingFile(const std::filesystem::path& path);
  ~PendingFile();
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;

  [[nodiscard]] const std::filesystem::path& final_path() const noexcept { return final_path_; }
  [[nodiscard]] const std::filesystem::path& temporary_path() const noexcept { return temporary_path_; }

  /// Waits until the disk has all of it. @throws OutputError
  void sync();
  /// sync() and the final name. @throws OutputError
  void commit();

 private:
  std::filesystem::path final_path_;
  std::filesystem::path temporary_path_;  ///< empty after commit() or a move
};

/// A file written from begin to end. "-" is standard output; devices and pipes are written as they are, without a
/// temporary and without a delay.
class OutputFile {
 public:
  /// @throws OutputError
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  /// @throws OutputError "PATH: cannot be written: No space left on device"
  void write(std::string_view text);
  /// Nothing more will be written: all of it reaches the disk, still under the temporary name. @throws OutputError
  void finish();
  /// finish(), if that was not done, and the final name. @throws OutputError
  void commit();

  /// For messages: the path, or "standard output".
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  void flush();

  std::string name_;
  std::unique_ptr<PendingFile> pending_;  ///< none for standard output, devices and pipes
  int descriptor_ = -1;
  std::string buffer_;
};

/// Writes a whole file at once. @throws OutputError
void write_file(const std::filesystem::path& path, std::string_view content);

/// Makes a folder and those above it, where they are not there. @throws OutputError
void make_folder(const std::filesystem::path& folder);

}  // namespace adit::io
