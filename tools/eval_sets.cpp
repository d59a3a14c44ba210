#include "eval_sets.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "adit/io/errors.hpp"
#include "eval_sets_parts.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMarks = "openings.json";
constexpr const char* kTruth = "truth.csv";

/// The file that a set is known by; empty when the folder has none.
fs::path set_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return path;
  for (const char* name : {kTruth, kMarks})
    if (fs::exists(path / name, error)) return path / name;
  return {};
}

void read_file(const fs::path& file, const std::string& prefix, EvalSet& set) {
  if (file.extension() == ".csv") {
    read_rendered(file, prefix, set);
  } else {
    read_marked(file, prefix, set);
  }
}

/// The folders in a folder that have a set's file, by name.
void read_folders(const fs::path& path, EvalSet& set) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.is_directory())
      if (const fs::path file = set_file(entry.path()); !file.empty()) files.insert(file);
  if (files.empty())
    throw io::InputError(path.string() + ": neither " + kMarks + " (make it with 'adit mark') nor " + kTruth +
                         " of 'adit render' is in this folder");
  for (const fs::path& file : files) read_file(file, file.parent_path().filename().string() + "/", set);
}

/// Frames of one place, in a row.
void number_sequences(EvalSet& set) {
  std::map<std::string, int> numbers;
  for (EvalFrame& frame : set.frames) {
    // A flight passes through many places; its frames are those of one folder.
    const std::string row = frame.ranges.empty() ? frame.place : frame.image.parent_path().string();
    frame.sequence = numbers.emplace(row, static_cast<int>(numbers.size())).first->second;
  }
}

}  // namespace

std::string place_of_name(const std::string& file_name) {
  std::string stem = fs::path(file_name).stem().string();
  while (!stem.empty() && stem.back() >= '0' && stem.back() <= '9') stem.pop_back();
  while (!stem.empty() && std::string("-_. ").find(stem.back()) != std::string::npos) stem.pop_back();
  return stem;
}

EvalSet read_eval_set(const fs::path& path, bool sequence) {
  std::error_code error;
  if (!fs::exists(path, error)) throw io::InputError(path.string() + ": no such folder or file");
  const fs::path file = set_file(path);
  EvalSet set;
  // "frames/", "." and a file in it all mean the folder.
  const fs::path whole = fs::weakly_canonical(path);
  set.name = (fs::is_directory(path, error) ? whole : whole.parent_path()).filename().string();
  if (file.empty()) {
    read_folders(path, set);
  } else {
    read_file(file, "", set);
  }
  if (sequence) number_sequences(set);
  return set;
}

}  // namespace adit::tools
