#include "live_view.hpp"

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "adit/io/errors.hpp"
#include "adit/io/settings.hpp"
#include "adit/io/table.hpp"
#include "adit/navigator.hpp"
#include "version.hpp"

namespace adit::tools {
namespace {

using Json = nlohmann::ordered_json;

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Json number_json(bool there, double value, double step) {
  if (!there || !std::isfinite(value)) return nullptr;
  return std::round(value / step) * step;
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

LiveView::LiveView(std::string source, io::Configuration configuration, bool settable, LivePlan plan)
    : source_(std::move(source)),
      configuration_(configuration),
      settable_(settable),
      plan_(std::move(plan)),
      began_s_(now_s()) {}

void LiveView::show(LiveFrame frame) {
  auto shared = std::make_shared<const LiveFrame>(std::move(frame));
  {
    const std::scoped_lock lock(mutex_);
    ++number_;
    rows_.push_back({number_, shared->stamp_s, now_s() - began_s_, shared->open_space, shared->command, shared->pose,
                     shared->speed_scale});
    if (rows_.size() > kRowsKept) rows_.pop_front();
    newest_.swap(shared);
  }  // the old frame is let go of outside
  arrived_.notify_all();
}

std::optional<io::Configuration> LiveView::new_settings() {
  const std::scoped_lock lock(mutex_);
  if (!changed_) return std::nullopt;
  changed_ = false;
  return configuration_;
}

void LiveView::say(std::string line) {
  const std::scoped_lock lock(mutex_);
  line_ = std::move(line);
}

void LiveView::hold_settings() {
  const std::scoped_lock lock(mutex_);
  settable_ = false;
}

void LiveView::end() {
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
  }
  arrived_.notify_all();
}

std::shared_ptr<const LiveFrame> LiveView::frame_after(std::int64_t after, double wait_s, std::int64_t& number) {
  std::unique_lock lock(mutex_);
  arrived_.wait_for(lock, std::chrono::duration<double>(wait_s), [&] { return ended_ || number_ > after; });
  if (ended_ || number_ <= after) return nullptr;
  number = number_;
  return newest_;
}

bool LiveView::has_ended() const {
  const std::scoped_lock lock(mutex_);
  return ended_;
}

std::string LiveView::state_json(std::int64_t after) const {
  const std::scoped_lock lock(mutex_);
  Json rows = Json::array();
  double find_ms = 0.0;
  for (const Row& row : rows_) {
    if (row.number <= after) continue;
    const OpenSpace& o = row.open_space;
    const bool found = o.found(), steers = row.command.has_value();
    constexpr double kDegree = 180.0 / std::numbers::pi;
    Json cells = {row.number,
                  number_json(true, row.pose ? row.stamp_s : row.time_s, 1e-3),  // recordings may begin again
                  std::string(to_string(o.status)),
                  number_json(true, o.confidence, 1e-3),
                  number_json(found, o.point.sx, 1e-4),
                  number_json(found, o.point.sy, 1e-4),
                  number_json(found, o.bearing.azimuth_rad * kDegree, 1e-2),
                  number_json(steers, steers ? row.command->yaw_rate_rad_s : 0.0, 1e-4),
                  steers ? std::string(to_string(row.command->state)) : std::string(),
                  io::flags_text(o.flags),
                  number_json(true, static_cast<double>(o.total_ns) * 1e-6, 1e-3),
                  number_json(row.speed_scale.has_value(), row.speed_scale.value_or(0.0), 1e-3)};
    if (row.pose)
      cells.insert(cells.end(), {number_json(true, row.pose->x_m, 1e-3), number_json(true, row.pose->y_m, 1e-3),
                                 number_json(true, row.pose->yaw_rad, 1e-4)});
    rows.push_back(std::move(cells));
  }
  // Frames of the last second.
  double rate_hz = 0.0;
  for (auto row = rows_.rbegin(); row != rows_.rend() && now_s() - began_s_ - row->time_s <= 1.0; ++row) {
    rate_hz += 1.0;
    find_ms = std::max(find_ms, static_cast<double>(row->open_space.total_ns) * 1e-6);
  }
  return dumped({{"version", ADIT_VERSION},
                 {"source", source_},
                 {"line", line_},
                 {"began", began_s_},
                 {"settable", settable_},
                 {"settings", revision_},
                 {"frames", number_},
                 {"rate_hz", rate_hz},
                 {"find_ms_max", number_json(true, find_ms, 1e-3)},
                 {"has_plan", !plan_.png.empty()},
                 {"plan", {plan_.x_min_m, plan_.y_min_m, plan_.cell_m}},
                 {"rows", std::move(rows)}});
}

std::string LiveView::settings_json() const {
  io::Configuration now = configuration(), usual;
  io::Settings settings, defaults;
  io::visit_sections(now, [&](const char* name, auto& section) { settings.add(name, section); });
  io::visit_sections(usual, [&](const char* name, auto& section) { defaults.add(name, section); });
  Json json = Json::array();
  for (std::size_t s = 0; s < settings.sections().size(); ++s) {
    const io::SettingSection& section = settings.sections()[s];
    Json fields = Json::array();
    for (std::size_t f = 0; f < section.settings.size(); ++f) {
      const io::Setting& field = section.settings[f];
      fields.push_back({{"name", field.note.name},
                        {"unit", field.note.unit},
                        {"minimum", field.note.minimum},
                        {"maximum", field.note.maximum},
                        {"meaning", field.note.meaning},
                        {"choices", field.choices},
                        {"value", field.value()},
                        {"default", defaults.sections()[s].settings[f].value()}});
    }
    json.push_back({{"section", section.name}, {"fields", std::move(fields)}});
  }
  return dumped(json);
}

std::string LiveView::settings_yaml() const { return io::to_yaml(configuration()); }

io::Configuration LiveView::configuration() const {
  const std::scoped_lock lock(mutex_);
  return configuration_;
}

std::string LiveView::change(const std::string& assignment) {
  const std::scoped_lock one_by_one(change_mutex_);
  io::Configuration changed = configuration();
  try {
    io::set_field(assignment, changed);
    (void)Navigator(io::navigator_config_of(changed));
  } catch (const io::ConfigError& e) {
    return e.what();
  } catch (const std::invalid_argument& e) {  // of several fields together
    return e.what();
  }
  const std::scoped_lock lock(mutex_);
  if (!settable_) return "the settings of this view cannot be changed";
  configuration_ = changed;
  changed_ = true;
  ++revision_;
  return "";
}

}  // namespace adit::tools
