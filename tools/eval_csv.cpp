#include "eval_csv.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>

#include "adit/io/errors.hpp"

namespace adit::tools {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw io::InputError(path.string() + ": this table cannot be read; is it there?");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

bool next_csv_row(const std::string& text, std::size_t& at, int& line, std::vector<std::string>& cells) {
  cells.clear();
  if (at >= text.size()) return false;
  std::string cell;
  bool quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\n') ++line;
    if (quoted) {
      if (c != '"') {
        cell += c;
      } else if (at + 1 < text.size() && text[at + 1] == '"') {
        cell += text[++at];
      } else {
        quoted = false;
      }
    } else if (c == '"' && cell.empty()) {
      quoted = true;
    } else if (c == ',') {
      cells.push_back(std::move(cell));
      cell.clear();
    } else if (c == '\n') {
      ++at;
      break;
    } else if (c != '\r') {
      cell += c;
    }
  }
  cells.push_back(std::move(cell));
  return true;
}

std::vector<std::string> csv_cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::size_t at = 0;
  int line = 1;
  next_csv_row(row, at, line, cells);
  return cells;
}

CsvTable::CsvTable(const std::filesystem::path& path) : name_(path.string()) {
  std::string text = read(path);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  std::size_t at = 0;
  int line = 1;
  next_csv_row(text, at, line, header_);
  Row row;
  for (row.line = line; next_csv_row(text, at, line, row.cells); row.line = line) {
    if (row.cells.size() == 1 && row.cells[0].empty()) continue;
    if (row.cells.size() != header_.size())
      throw io::InputError(name_ + ":" + std::to_string(row.line) + ": " + std::to_string(row.cells.size()) +
                           " cells, but the header has " + std::to_string(header_.size()));
    rows_.push_back(row);
  }
  if (rows_.empty()) throw io::InputError(name_ + ": the table has no rows");
}

std::optional<std::size_t> CsvTable::column(const std::string& name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  if (found == header_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header_.begin());
}

std::size_t CsvTable::needed(const std::string& name) const {
  if (const auto found = column(name)) return *found;
  throw io::InputError(name_ + ":1: there is no column " + name);
}

double CsvTable::number(std::size_t row, std::optional<std::size_t> column) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!column || text(row, *column).empty()) return kNone;
  const std::string& cell = text(row, *column);
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
    throw io::InputError(place(row) + ": " + header_[*column] + " is '" + cell + "', which is no number");
  return value;
}

std::string CsvTable::place(std::size_t row) const { return name_ + ":" + std::to_string(rows_[row].line); }

}  // namespace adit::tools
