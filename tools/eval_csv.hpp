// Tables of others: CSV as RFC 4180 has it, columns by name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace adit::tools {

/// Reads one row of a CSV text, and moves `at` to the next and `line` to its number; false at the end of the text.
bool next_csv_row(const std::string& text, std::size_t& at, int& line, std::vector<std::string>& cells);

/// The cells of a text of one row.
[[nodiscard]] std::vector<std::string> csv_cells_of(const std::string& row);

class CsvTable {
 public:
  /// Lines end with \n or \r\n; quoted cells may hold commas and line ends. Empty lines are passed over.
  /// @throws io::InputError "FILE:LINE: ..." when it is missing, has no rows, or a row is shorter or longer than the
  /// header.
  explicit CsvTable(const std::filesystem::path& path);

  [[nodiscard]] std::size_t size() const noexcept { return rows_.size(); }
  /// Where a column stands; nothing when it is not there.
  [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const;
  /// @throws io::InputError that names the column.
  [[nodiscard]] std::size_t needed(const std::string& name) const;
  [[nodiscard]] const std::string& text(std::size_t row, std::size_t column) const { return rows_[row].cells[column]; }
  /// NaN for an empty cell or a missing column. @throws io::InputError for what is no number.
  [[nodiscard]] double number(std::size_t row, std::optional<std::size_t> column) const;
  /// "FILE:LINE" of a row.
  [[nodiscard]] std::string place(std::size_t row) const;

 private:
  struct Row {
    int line = 0;
    std::vector<std::string> cells;
  };
  std::string name_;
  std::vector<std::string> header_;
  std::vector<Row> rows_;
};

}  // namespace adit::tools
