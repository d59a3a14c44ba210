// What perception shows and what its viewers look at, between threads: perception never waits for a viewer.
#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/io/configuration.hpp"

namespace adit::tools {

/// From where the vehicle looks, in a world that is known.
struct LivePose {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};

/// A frame and what was made of it.
struct LiveFrame {
  cv::Mat pixels;  ///< belongs to the view from now on
  cv::Mat panel;   ///< instead, of a film: io::side_by_side() of it, with the answer drawn in
  double stamp_s = 0.0;
  OpenSpace open_space;
  std::optional<HeadingCommand> command;
  std::optional<LivePose> pose;
  std::optional<double> speed_scale;  ///< share of the wanted speed; the published controller knows none
};

/// A picture of the ground, made by somebody who knows it.
struct LivePlan {
  std::string png;
  double x_min_m = 0.0, y_min_m = 0.0, cell_m = 0.0;  ///< lower left corner; side of a pixel
};

class LiveView {
 public:
  /// @param source  what is looked at, for people. @param settable  may viewers change the settings?
  LiveView(std::string source, io::Configuration configuration, bool settable, LivePlan plan = {});

  // --- perception's side
  /// Takes a frame over. Holds the lock for as long as it takes to move it in.
  void show(LiveFrame frame);
  /// The settings, if they were changed since the last call.
  [[nodiscard]] std::optional<io::Configuration> new_settings();
  /// A line for people: how it goes, or ended.
  void say(std::string line);
  /// From now on the settings stay as they are.
  void hold_settings();
  /// No frame will come any more, and none is to be waited for.
  void end();

  // --- the viewers' side
  /// The newest frame if its number is above `after`; waits up to wait_s for one. Nothing when there is none, or at the
  /// end. Numbers begin at 1.
  [[nodiscard]] std::shared_ptr<const LiveFrame> frame_after(std::int64_t after, double wait_s, std::int64_t& number);
  [[nodiscard]] bool has_ended() const;
  /// Rows above `after` and the gauges, as JSON.
  [[nodiscard]] std::string state_json(std::int64_t after) const;
  /// All settings with meaning, unit and range, as JSON.
  [[nodiscard]] std::string settings_json() const;
  [[nodiscard]] std::string settings_yaml() const;
  [[nodiscard]] io::Configuration configuration() const;
  /// "section.name=value". Returns why it is refused, "" when it is taken: perception is never given settings that it
  /// cannot work with. Perception is not waited for, nor does it wait.
  [[nodiscard]] std::string change(const std::string& assignment);
  [[nodiscard]] const LivePlan& plan() const noexcept { return plan_; }

 private:
  struct Row {
    std::int64_t number = 0;
    double stamp_s = 0.0;
    double time_s = 0.0;  ///< since the view began, by the steady clock
    OpenSpace open_space;
    std::optional<HeadingCommand> command;
    std::optional<LivePose> pose;
    std::optional<double> speed_scale;
  };
  static constexpr std::size_t kRowsKept = 3600;  ///< two minutes at 30 Hz

  std::mutex change_mutex_;  ///< one change after the other; taken before mutex_
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::string source_, line_;
  io::Configuration configuration_;
  bool settable_, changed_ = false, ended_ = false;
  LivePlan plan_;
  std::shared_ptr<const LiveFrame> newest_;
  std::int64_t number_ = 0, revision_ = 0;  ///< of the frame; of the settings
  std::deque<Row> rows_;
  double began_s_;
};

}  // namespace adit::tools
