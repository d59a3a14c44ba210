#include "adit/io/table.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <variant>

namespace adit::io {
namespace {

/// A real number and the digits after the point that mean something.
struct Real {
  double value;
  int digits;
};
using Cell = std::variant<std::monostate, std::string_view, std::int64_t, Real>;

double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

/// Was the picture looked at, so that its levels are known?
bool is_judged(const OpenSpace& o) { return o.status != Status::kBadFrame && o.status != Status::kWrongSize; }

std::string fixed_text(double value, int digits) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr;
  return {text, end};
}

/// Azimuth and elevation of each opening in degrees, and its confidence, the best first: "-12.31 2.05 0.93; ...".
std::string openings_text(const OpenSpace& o) {
  std::string text;
  for (int i = 0; i < o.opening_count; ++i) {
    const Opening& opening = o.openings[static_cast<std::size_t>(i)];
    text.append(i > 0 ? "; " : "").append(fixed_text(degrees(opening.bearing.azimuth_rad), 2)).append(" ");
    text.append(fixed_text(degrees(opening.bearing.elevation_rad), 2)).append(" ");
    text.append(fixed_text(opening.confidence, 2));
  }
  return text;
}

/// The columns, once for header, CSV and JSON: put(name, cell).
template <class Put>
void for_each_cell(const TableRow& row, bool timing, Put&& put) {
  const OpenSpace* const any = row.open_space ? &*row.open_space : nullptr;
  const OpenSpace* const judged = any != nullptr && is_judged(*any) ? any : nullptr;
  const OpenSpace* const found = any != nullptr && any->found() ? any : nullptr;
  const auto real = [](const OpenSpace* o, int digits, auto&& value) {
    return o != nullptr ? Cell(Real{value(*o), digits}) : Cell();
  };
  const auto level = [judged](int OpenSpace::*member) {
    return judged != nullptr ? Cell(std::int64_t{judged->*member}) : Cell();
  };
  const bool clustered = judged != nullptr && judged->clusters.count > 0;
  put("source", Cell(std::string_view(row.source)));
  put("frame", Cell(row.frame));
  put("stamp_s", Cell(Real{row.stamp_s, 6}));
  put("status", Cell(any != nullptr ? to_string(any->status) : std::string_view("unreadable")));
  put("confidence", real(any, 4, [](const OpenSpace& o) { return o.confidence; }));
  put("u_px", real(found, 3, [](const OpenSpace& o) { return o.centroid_px.u_px; }));
  put("v_px", real(found, 3, [](const OpenSpace& o) { return o.centroid_px.v_px; }));
  put("sx", real(found, 6, [](const OpenSpace& o) { return o.point.sx; }));
  put("sy", real(found, 6, [](const OpenSpace& o) { return o.point.sy; }));
  put("azimuth_deg", real(found, 4, [](const OpenSpace& o) { return degrees(o.bearing.azimuth_rad); }));
  put("elevation_deg", real(found, 4, [](const OpenSpace& o) { return degrees(o.bearing.elevation_rad); }));
  put("area_fraction", real(found, 6, [](const OpenSpace& o) { return o.area_fraction; }));
  put("yaw_rate_rad_s", row.command ? Cell(Real{row.command->yaw_rate_rad_s, 6}) : Cell());
  put("heading_state", row.command ? Cell(to_string(row.command->state)) : Cell());
  put("atmospheric_light", real(judged, 3, [](const OpenSpace& o) { return o.atmospheric_light; }));
  put("darkest_level", level(&OpenSpace::darkest_level));
  put("threshold_level", clustered ? level(&OpenSpace::threshold_level) : Cell());
  put("brightest_level", level(&OpenSpace::brightest_level));
  const std::string flags = any != nullptr ? flags_text(any->flags) : std::string();
  const std::string openings = found != nullptr ? openings_text(*found) : std::string();
  put("rule", found != nullptr ? Cell(to_string(found->rule)) : Cell());
  put("openings", found != nullptr ? Cell(std::string_view(openings)) : Cell());
  put("flags", flags.empty() ? Cell() : Cell(std::string_view(flags)));
  const bool has_veil = judged != nullptr && judged->veil_fraction > 0.0;  // 0: not looked for
  put("veil_fraction", real(has_veil ? judged : nullptr, 4, [](const OpenSpace& o) { return o.veil_fraction; }));
  put("track", row.track ? Cell(std::int64_t{row.track->id}) : Cell());
  put("track_azimuth_deg", row.track ? Cell(Real{degrees(row.track->bearing.azimuth_rad), 4}) : Cell());
  put("message", row.message.empty() ? Cell() : Cell(std::string_view(row.message)));
  if (timing) put("find_ms", real(any, 4, [](const OpenSpace& o) { return static_cast<double>(o.total_ns) * 1e-6; }));
}

/// Fixed digits; empty for what is no number. Never "-0.000".
std::string text_of(const Real& real) {
  if (!std::isfinite(real.value)) return "";
  char digits[400];
  const auto end = std::to_chars(digits, digits + sizeof digits, real.value, std::chars_format::fixed, real.digits).ptr;
  std::string text(digits, end);
  if (text.front() == '-' && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string csv_text(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string escaped(1, '"');
  for (const char c : text) {
    if (c == '"') escaped += c;
    escaped += c;
  }
  escaped += '"';
  return escaped;
}

/// File names are bytes; JSON is UTF-8: what is not becomes U+FFFD.
std::string json_text(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string text_of(const Cell& cell, std::string (*quote)(std::string_view)) {
  if (const auto* text = std::get_if<std::string_view>(&cell)) return quote(*text);
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
  if (const auto* real = std::get_if<Real>(&cell)) return text_of(*real);
  return "";
}

}  // namespace

std::string flags_text(const SightFlags& flags) {
  std::string text;
  const auto add = [&text](bool up, const char* name) {
    if (up) text.append(text.empty() ? "" : "+").append(name);
  };
  add(flags.dust, "dust");
  add(flags.glare, "glare");
  add(flags.blocked_lens, "blocked_lens");
  add(flags.too_dark, "too_dark");
  add(flags.too_bright, "too_bright");
  add(flags.dirty_lens, "dirty_lens");
  return text;
}

std::string csv_header(bool timing) {
  std::string line;
  for_each_cell(TableRow{}, timing, [&line](const char* name, const Cell&) {
    if (!line.empty()) line += ',';
    line += name;
  });
  return line + "\n";
}

std::string csv_line(const TableRow& row, bool timing) {
  std::string line;
  bool first = true;
  for_each_cell(row, timing, [&](const char*, const Cell& cell) {
    if (!first) line += ',';
    first = false;
    line += text_of(cell, csv_text);
  });
  return line + "\n";
}

std::string json_line(const TableRow& row, bool timing) {
  std::string line;
  for_each_cell(row, timing, [&line](const char* name, const Cell& cell) {
    const std::string value = text_of(cell, json_text);
    line += line.empty() ? '{' : ',';
    line += '"';
    line += name;
    line += "\":";
    line += value.empty() ? "null" : value;
  });
  return line + "}\n";
}

}  // namespace adit::io
