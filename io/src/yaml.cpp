#include "yaml.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace adit::io {
namespace {

/// Edits (insert, drop, replace) that turn one name into the other.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

/// Is this the start of a longer name that nothing else begins with?
bool begins(std::string_view name, std::string_view known) {
  return name.size() >= 3 && known.substr(0, name.size()) == name;
}

template <class Number>
bool parse_whole(std::string_view text, Number& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Number parsed{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
  if (error != std::errc{} || end != text.data() + text.size()) return false;
  value = parsed;
  return true;
}

}  // namespace

std::string place_of(std::string_view name, const YAML::Mark& mark) {
  if (mark.is_null() || mark.line < 0) return std::string(name);
  return std::string(name) + ":" + std::to_string(mark.line + 1);
}

YAML::Node load_yaml(std::string_view text, std::string_view name) {
  YAML::Node root;
  try {
    root = YAML::Load(std::string(text));
  } catch (const YAML::Exception& e) {
    throw ConfigError(place_of(name, e.mark) + ": not YAML: " + on_one_line(e.msg, 200));
  }
  if (!root.IsMap() && !root.IsNull()) {
    throw ConfigError(place_of(name, root.Mark()) + ": not a list of keys and values (key: value)");
  }
  return root;
}

std::string on_one_line(std::string_view text, std::size_t longest) {
  std::string shown(text.substr(0, longest));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return shown + (text.size() > longest ? "..." : "");
}

std::string in_quotes(std::string_view text) { return std::string("'").append(on_one_line(text)).append("'"); }

constexpr std::size_t kListedMost = 20, kNearest = 4;

std::string hint_for(std::string_view name, const std::vector<std::string>& known) {
  const auto distance = [name](const std::string& k) { return begins(name, k) ? 1 : edits_between(name, k); };
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return distance(a) < distance(b);
  });
  if (nearest != known.end() && distance(*nearest) <= std::max<std::size_t>(2, nearest->size() / 3)) {
    return "; did you mean " + in_quotes(*nearest) + "?";
  }
  if (known.size() > kListedMost) {  // a line is to be read, not searched
    std::vector<std::string> near = known;
    std::stable_sort(near.begin(), near.end(),
                     [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
    std::string list = "; the nearest are: ";
    for (std::size_t i = 0; i < kNearest; ++i) list += (i == 0 ? "" : ", ") + near[i];
    return list + "; 'adit config' prints all";
  }
  std::string list = "; known are: ";
  for (std::size_t i = 0; i < known.size(); ++i) list += (i == 0 ? "" : ", ") + known[i];
  return list;
}

bool parse_number(std::string_view text, double& value) {
  double parsed = 0.0;
  if (!parse_whole(text, parsed) || !std::isfinite(parsed)) return false;
  value = parsed;
  return true;
}

bool parse_number(std::string_view text, int& value) { return parse_whole(text, value); }

std::string shortest(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  return {digits, end};
}

}  // namespace adit::io
