// Files that hold a piece of the work: FILE.part-I-of-N. A line that says what it is, what it holds, a line that says
// that this was all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "adit/io/output_file.hpp"
#include "shard.hpp"

namespace adit::tools {

/// What a part says of itself.
struct PartLabel {
  std::string command;  ///< "run", "eval", "fly"
  Shard shard;
  std::int64_t items = 0;   ///< of all parts together
  std::string fingerprint;  ///< of the work
  std::string kind;         ///< of the table: "csv", "jsonl"; "" where there is only one
  std::string head;         ///< what the joined file begins with, or what the command needs besides
};

/// FILE.part-I-of-N
[[nodiscard]] std::filesystem::path part_path(const std::filesystem::path& whole, const Shard& shard);

/// Writes a part; appears under its name only when it is whole.
class PartFile {
 public:
  /// @throws io::OutputError
  PartFile(const std::filesystem::path& whole, const PartLabel& label);
  void write(std::string_view text);
  /// The closing line, and all of it reaches the disk. @throws io::OutputError
  void finish();
  void commit();

 private:
  io::OutputFile file_;
  Fingerprint content_;
  std::int64_t bytes_ = 0;
  bool finished_ = false;
};

/// A part that lies on the disk.
struct Part {
  std::filesystem::path path;
  PartLabel label;
  std::int64_t begin = 0;  ///< of its content, bytes
  std::int64_t bytes = 0;
  std::string content;  ///< its fingerprint

  /// Hands over the content, piece by piece. @throws io::InputError when it is not what was written.
  void read(const std::function<void(std::string_view)>& take) const;
  [[nodiscard]] std::vector<std::string> lines() const;
};

/// FILE.part-*-of-* beside a file.
[[nodiscard]] std::vector<std::filesystem::path> parts_beside(const std::filesystem::path& whole);

/// Which parts of those that belong together are not there. @throws io::InputError as read_parts(), but for these.
[[nodiscard]] std::vector<int> missing_parts(const std::vector<std::filesystem::path>& paths);

/// All parts of one piece of work, in their order.
/// @throws io::InputError one line: a part that is damaged, missing, there twice, or of other work.
[[nodiscard]] std::vector<Part> read_parts(const std::vector<std::filesystem::path>& paths);

}  // namespace adit::tools
