#include "parts.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "adit/io/errors.hpp"
#include "version.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

constexpr int kLayout = 1;  // of the label; another number is another layout
constexpr std::size_t kClosingMax = 64;

std::string label_line(const PartLabel& label) {
  const nlohmann::ordered_json json{{"adit_part", kLayout},
                                    {"version", ADIT_VERSION},
                                    {"command", label.command},
                                    {"shard", label.shard.index},
                                    {"shards", label.shard.count},
                                    {"items", label.items},
                                    {"fingerprint", label.fingerprint},
                                    {"kind", label.kind},
                                    {"head", label.head}};
  return json.dump() + "\n";
}

std::string closing_line(std::int64_t bytes, const std::string& content) {
  return "end " + std::to_string(bytes) + " " + content + "\n";
}

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw io::InputError(path.string() + ": " + why);
}

Part read_part(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (!file || fs::is_directory(path) || !std::getline(file, line)) refuse(path, "this part cannot be read");
  Part part{path, {}, static_cast<std::int64_t>(line.size()) + 1, 0, ""};
  const auto json = nlohmann::json::parse(line, nullptr, false);
  try {
    if (json.is_discarded() || json.at("adit_part").get<int>() != kLayout) refuse(path, "this is no part of adit's");
    if (json.at("version") != ADIT_VERSION)
      refuse(path, "made by adit " + json.at("version").get<std::string>() + ", this is adit " ADIT_VERSION);
    part.label = {json.at("command"), {json.at("shard"), json.at("shards")},
                  json.at("items"),   json.at("fingerprint"),
                  json.at("kind"),    json.at("head")};
  } catch (const nlohmann::json::exception&) {
    refuse(path, "this is no part of adit's");
  }
  const auto size = static_cast<std::int64_t>(fs::file_size(path));
  const std::int64_t tail = std::min<std::int64_t>(size - part.begin, kClosingMax);
  std::string closing(static_cast<std::size_t>(tail), '\0');
  file.seekg(size - tail);
  file.read(closing.data(), tail);
  const std::size_t last = closing.rfind('\n', closing.size() < 2 ? 0 : closing.size() - 2);
  closing = closing.substr(last == std::string::npos ? 0 : last + 1);
  part.bytes = size - part.begin - static_cast<std::int64_t>(closing.size());
  part.content = closing.size() > 17 ? closing.substr(closing.size() - 17, 16) : "";
  if (part.bytes < 0 || closing != closing_line(part.bytes, part.content))
    refuse(path, "this part is not whole; run --shard " + part.label.shard.text() + " again");
  return part;
}

/// "2, 5 and 7"
std::string list_of(const std::vector<int>& numbers) {
  constexpr std::size_t kMost = 12;
  std::string text;
  const std::size_t shown = std::min(numbers.size(), kMost);
  for (std::size_t i = 0; i < shown; ++i)
    text.append(i == 0 ? "" : i + 1 == numbers.size() ? " and " : ", ").append(std::to_string(numbers[i]));
  return numbers.size() > kMost ? text + " and " + std::to_string(numbers.size() - kMost) + " more" : text;
}

void check_one_work(const Part& first, const Part& other) {
  if (other.label.command != first.label.command || other.label.kind != first.label.kind)
    refuse(other.path, "a part of 'adit " + other.label.command + "' " + other.label.kind + ", but " +
                           first.path.string() + " is one of 'adit " + first.label.command + "' " + first.label.kind);
  if (other.label.shard.count != first.label.shard.count)
    refuse(other.path, "one of " + std::to_string(other.label.shard.count) + " parts, but " + first.path.string() +
                           " is one of " + std::to_string(first.label.shard.count));
  if (other.label.fingerprint != first.label.fingerprint || other.label.items != first.label.items ||
      other.label.head != first.label.head)
    refuse(other.path, "a part of other work than " + first.path.string() +
                           ": its inputs or settings were others; run --shard " + other.label.shard.text() + " again");
}

/// By their number.
std::map<int, Part> gathered(const std::vector<fs::path>& paths) {
  std::map<int, Part> parts;
  for (const fs::path& path : paths) {
    Part part = read_part(path);
    if (!parts.empty()) check_one_work(parts.begin()->second, part);
    const auto [there, is_new] = parts.emplace(part.label.shard.index, part);
    if (!is_new)
      refuse(path, "part " + part.label.shard.text() + " is there twice: also as " + there->second.path.string());
  }
  if (parts.empty()) throw io::InputError("no parts are given");
  return parts;
}

std::vector<int> missing_of(const std::map<int, Part>& parts) {
  std::vector<int> missing;
  for (int i = 1; i <= parts.begin()->second.label.shard.count; ++i)
    if (!parts.contains(i)) missing.push_back(i);
  return missing;
}

}  // namespace

fs::path part_path(const fs::path& whole, const Shard& shard) {
  fs::path path = whole;
  path += ".part-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
  return path;
}

PartFile::PartFile(const fs::path& whole, const PartLabel& label) : file_(part_path(whole, label.shard)) {
  file_.write(label_line(label));
}

void PartFile::write(std::string_view text) {
  content_.add_bytes(text.data(), text.size());
  bytes_ += static_cast<std::int64_t>(text.size());
  file_.write(text);
}

void PartFile::finish() {
  if (finished_) return;
  finished_ = true;
  file_.write(closing_line(bytes_, content_.text()));
  file_.finish();
}

void PartFile::commit() {
  finish();
  file_.commit();
}

void Part::read(const std::function<void(std::string_view)>& take) const {
  std::ifstream file(path, std::ios::binary);
  file.seekg(begin);
  std::string chunk;
  Fingerprint found;
  for (std::int64_t left = bytes; left > 0; left -= static_cast<std::int64_t>(chunk.size())) {
    chunk.resize(static_cast<std::size_t>(std::min<std::int64_t>(left, 1 << 20)));
    if (!file.read(chunk.data(), static_cast<std::streamsize>(chunk.size())))
      refuse(path, "this part cannot be read to its end");
    found.add_bytes(chunk.data(), chunk.size());
    take(chunk);
  }
  if (found.text() != content)
    refuse(path, "this part was changed after it was written; run --shard " + label.shard.text() + " again");
}

std::vector<std::string> Part::lines() const {
  std::string text;
  read([&text](std::string_view chunk) { text += chunk; });
  std::vector<std::string> all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    all.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return all;
}

std::vector<fs::path> parts_beside(const fs::path& whole) {
  std::vector<fs::path> found;
  const std::string begin = whole.filename().string() + ".part-";
  std::error_code error;
  const fs::path folder = whole.has_parent_path() ? whole.parent_path() : fs::path(".");
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && name.find("-of-", begin.size()) != std::string::npos) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> missing_parts(const std::vector<fs::path>& paths) { return missing_of(gathered(paths)); }

std::vector<Part> read_parts(const std::vector<fs::path>& paths) {
  std::map<int, Part> parts = gathered(paths);
  if (const std::vector<int> missing = missing_of(parts); !missing.empty()) {
    const std::string count = std::to_string(parts.begin()->second.label.shard.count);
    throw io::InputError("of " + count + " parts, " + std::to_string(missing.size()) +
                         (missing.size() == 1 ? " is" : " are") + " missing: " + list_of(missing) + "; run --shard " +
                         std::to_string(missing.front()) + "/" + count + (missing.size() == 1 ? "" : " and so on") +
                         " again");
  }
  std::vector<Part> all;
  for (auto& [index, part] : parts) all.push_back(std::move(part));
  return all;
}

}  // namespace adit::tools
