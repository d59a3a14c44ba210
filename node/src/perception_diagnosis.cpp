// What the perception node says of itself.
#include "adit/node/perception.hpp"
#include "text.hpp"

namespace adit::node {
namespace {

// No image for this long, and the camera counts as gone: as the controller's hover_after_s.
constexpr double kImageOverdue_s = 0.5;
constexpr double kImageGone_s = 5.0;

std::string flags_text(const SightFlags& flags) {
  std::string text;
  const auto add = [&](bool is_set, const char* name) {
    if (is_set) text += (text.empty() ? "" : ", ") + std::string(name);
  };
  add(flags.dust, "dust");
  add(flags.glare, "glare");
  add(flags.blocked_lens, "blocked lens");
  add(flags.too_dark, "too dark");
  add(flags.too_bright, "too bright");
  add(flags.dirty_lens, "dirty lens");
  return text.empty() ? "none" : text;
}

}  // namespace

void Perception::diagnose_stream(Diagnosis& d, Time_ns now_ns) const {
  if (!last_image_ns_) {
    d.worsen(Level::kError, "no image has come yet: is the camera's topic remapped to `image`?");
    return;
  }
  const double age_s = seconds_of(now_ns - *last_image_ns_);
  d.add("age (s)", text_of(age_s, 3));
  if (age_s > kImageGone_s) d.worsen(Level::kError, "no image for " + text_of(age_s, 1) + " s");
  if (age_s > kImageOverdue_s) d.worsen(Level::kWarn, "no image for " + text_of(age_s, 1) + " s");
  if (last_status_ == Status::kWrongSize) d.worsen(Level::kError, last_fault_);
  if (!last_fault_.empty()) d.worsen(Level::kWarn, last_fault_);
  if (last_status_ == Status::kFrozenFrame)
    d.worsen(Level::kError, "the camera is frozen: it sends the same frame again and again");
}

void Perception::diagnose_camera(Diagnosis& d) const {
  if (!camera_fault_.empty()) d.worsen(Level::kWarn, "camera_info: " + camera_fault_);
  if (!camera_ && camera_fault_.empty())
    d.worsen(Level::kWarn, std::string(camera_infos_ > 0 ? "the camera is not calibrated" : "no camera_info has come") +
                               "; the lens is taken for " + text_of(finder_config().assumed_hfov_deg, 0) +
                               " deg wide (assumed_hfov_deg)");
}

Diagnosis Perception::diagnosis(Time_ns now_ns) const {
  Diagnosis d;
  d.message = std::string(to_string(last_status_));
  diagnose_stream(d, now_ns);
  diagnose_camera(d);
  d.add("status", std::string(to_string(last_status_)));
  d.add("flags", flags_text(last_flags_));
  d.add("method", std::string(to_string(finder_config().method)));
  d.add("images", std::to_string(images_));
  d.add("images unusable", std::to_string(unusable_images_));
  d.add("encodings unknown", std::to_string(unknown_encodings_));
  d.add("camera_infos", std::to_string(camera_infos_));
  d.add("camera_infos unusable", std::to_string(broken_camera_infos_));
  d.add("sizes changed", std::to_string(size_changes_));
  d.add("images not of the camera's size", std::to_string(wrong_sizes_));
  d.add("yaw rates", std::to_string(yaw_rates_));
  d.add("images with a yaw rate", std::to_string(images_with_yaw_rate_));
  add_stamps(d, stamps_);
  add_latency(d, "arrival", arrival_);
  add_latency(d, "latency", latency_);
  return d;
}

}  // namespace adit::node
