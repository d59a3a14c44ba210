// The perception node's logic: images in, open spaces and headings out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/node/camera_info.hpp"
#include "adit/node/diagnosis.hpp"
#include "adit/node/image_message.hpp"
#include "adit/node/latency.hpp"
#include "adit/node/parameters.hpp"
#include "adit/node/stamp_check.hpp"

namespace adit {
enum class Manoeuvre : std::uint8_t;  // navigator.hpp
}

namespace adit::node {

struct PerceptionSettings;  // settings.hpp

/// What one image showed, and what to do about it. Plain numbers: copying it allocates nothing.
struct Sighting {
  Time_ns stamp_ns = 0;    ///< of the image; the time of its coming where the driver does not stamp
  OpenSpace open_space;    ///< its status with what only a sequence shows
  HeadingCommand heading;  ///< yaw rate positive to the left
  double forward_m_s = 0.0;
  Manoeuvre manoeuvre{};  ///< kWait unless said
};

/// What came of an image.
struct ImageAnswer {
  std::optional<Sighting> sighting;  ///< nothing: the image is not to be used
  std::string fault;                 ///< why, in one line; also for images that are used in spite of it
};

/// Not thread-safe: one call at a time.
class Perception {
 public:
  Perception();
  /// @throws std::invalid_argument naming the field, the value and the range.
  explicit Perception(const PerceptionSettings& settings);
  ~Perception();

  [[nodiscard]] const PerceptionSettings& settings() const noexcept;
  [[nodiscard]] const FinderConfig& finder_config() const noexcept;
  /// Steering starts afresh. @throws as the constructor; then nothing is changed.
  void configure(const PerceptionSettings& settings);
  /// The same by name, as parameter servers do it. What set() takes is in force after apply().
  [[nodiscard]] std::vector<Parameter> parameters() const;
  /// A whole number is taken for a double, and a double without a fraction for a whole number.
  /// @return why it is refused, naming the parameter, the value and the range; "" when it is taken.
  [[nodiscard]] std::string set(const std::string& name, const ParameterValue& value);
  void apply();

  /// Takes a calibration; the same again and again costs nothing. What is wrong with it is kept for diagnosis().
  void take(const CameraInfoMessage& message);
  /// Takes a gyroscope's rate about the vertical, positive to the left.
  void take_yaw_rate(double yaw_rate_rad_s, Time_ns stamp_ns) noexcept;
  /// Judges an image and steers by it.
  [[nodiscard]] ImageAnswer take(const ImageMessage& message, Time_ns now_ns);
  /// An image came whose bytes are no picture: counted, and told by diagnosis().
  void take_unreadable(std::string fault, Time_ns now_ns);
  /// What was made of the image was sent off. @param stamp_ns  of Sighting.
  void sent(Time_ns stamp_ns, Time_ns now_ns) noexcept { latency_.add(now_ns - stamp_ns); }

  /// The stages of the last image that take() was given, for pictures; judged once more, by a finder of its own.
  /// Nothing when the message cannot be judged.
  [[nodiscard]] std::optional<StageImages> explain(const ImageMessage& message);

  [[nodiscard]] const std::optional<CameraModel>& camera() const noexcept { return camera_; }
  [[nodiscard]] const StampCheck& stamps() const noexcept { return stamps_; }
  [[nodiscard]] const LatencyMeter& latency() const noexcept { return latency_; }
  [[nodiscard]] std::int64_t unusable_images() const noexcept { return unusable_images_; }
  [[nodiscard]] std::int64_t size_changes() const noexcept { return size_changes_; }
  [[nodiscard]] Diagnosis diagnosis(Time_ns now_ns) const;

 private:
  struct Chain;  ///< finder, frame watch and controller, or the navigator
  struct Parts;
  void rebuild();
  [[nodiscard]] double stamp_s(Time_ns stamp_ns) noexcept;
  void watch_size(const ImageView& view) noexcept;
  void diagnose_camera(Diagnosis& diagnosis) const;
  void diagnose_stream(Diagnosis& diagnosis, Time_ns now_ns) const;

  std::unique_ptr<Parts> parts_;  ///< settings and chain
  std::optional<CameraModel> camera_;
  std::string camera_fault_;
  std::int64_t camera_infos_ = 0, broken_camera_infos_ = 0;

  StampCheck stamps_;
  LatencyMeter arrival_;  ///< of the images: what camera, driver and transport take
  LatencyMeter latency_;
  std::optional<Time_ns> origin_ns_;  ///< seconds are counted from here: the first stamp
  std::optional<Time_ns> last_image_ns_;
  std::optional<double> yaw_rate_rad_s_;
  Time_ns yaw_rate_ns_ = 0;
  std::int64_t yaw_rates_ = 0, images_with_yaw_rate_ = 0;
  int width_ = 0, height_ = 0;
  double commanded_m_s_ = 0.0;
  Status last_status_ = Status::kBadFrame;
  SightFlags last_flags_;
  std::string last_fault_;  ///< of the last image; empty when it was used
  std::int64_t images_ = 0, unusable_images_ = 0, unknown_encodings_ = 0, size_changes_ = 0, wrong_sizes_ = 0;
};

}  // namespace adit::node
