#include "eval_sets.hpp"

#include <algorithm>
#include <map>

#include "adit/io/errors.hpp"
#include "eval_sets_parts.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMarks = "openings.json";
constexpr const char* kTruth = "truth.csv";

/// The file that a set is known by.
fs::path set_file(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw io::InputError(path.string() + ": no such folder or file");
  if (!fs::is_directory(path, error)) return path;
  for (const char* name : {kTruth, kMarks})
    if (fs::exists(path / name, error)) return path / name;
  throw io::InputError(path.string() + ": neither " + kMarks + " (make it with 'adit mark') nor " + kTruth +
                       " of 'adit render' is in this folder");
}

}  // namespace

std::string place_of_name(const std::string& file_name) {
  std::string stem = fs::path(file_name).stem().string();
  while (!stem.empty() && stem.back() >= '0' && stem.back() <= '9') stem.pop_back();
  while (!stem.empty() && std::string("-_. ").find(stem.back()) != std::string::npos) stem.pop_back();
  return stem;
}

EvalSet read_eval_set(const fs::path& path, bool sequence) {
  const fs::path file = set_file(path);
  EvalSet set;
  // "frames/", "." and a file in it all mean the folder.
  set.name = fs::weakly_canonical(file).parent_path().filename().string();
  if (file.extension() == ".csv") {
    read_rendered(file, set);
  } else {
    read_marked(file, set);
  }
  if (sequence) {
    std::map<std::string, int> numbers;
    for (EvalFrame& frame : set.frames)
      frame.sequence = set.rendered ? 0 : numbers.emplace(frame.place, static_cast<int>(numbers.size())).first->second;
  }
  return set;
}

}  // namespace adit::tools
