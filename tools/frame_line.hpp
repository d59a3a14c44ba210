// Frames are read, judged, steered by and drawn, many at a time, and come out in the order they went in.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "adit/camera.hpp"
#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/io/configuration.hpp"
#include "adit/io/frame_source.hpp"
#include "report_pictures.hpp"
#include "sequence_pilot.hpp"
#include "worker_pool.hpp"

namespace adit::tools {

/// A frame on its way.
struct FrameWork {
  io::Frame frame;
  std::int64_t number = 0;              ///< over all sources
  std::optional<OpenSpace> open_space;  ///< nothing: unreadable
  std::string why;                      ///< why there is no answer: unreadable, no frame, not of the camera's size
  std::string doubt;                    ///< what may be wrong with a frame that was judged
  StageImages stages;
  std::optional<HeadingCommand> command;
  std::optional<Track> track;      ///< the opening that the pilot follows
  cv::Mat panel;                   ///< frame and depth map, if a video is wanted
  std::vector<unsigned char> png;  ///< the frame with its overlay, encoded, if frames are wanted
  bool wants_shot = false;
  std::optional<ReportShot> shot;  ///< for a report, if it wants this frame
  std::future<void> done;
};

struct LineSettings {
  io::Configuration configuration;
  std::optional<Camera> camera;
  int jobs = 1;
  std::optional<LampPattern> lamp;  ///< of the vehicle's lamp, known before
  bool learn_lamp = false;          ///< in sequences, method `adit`
  bool flash = false;  ///< frames come with the lamp on and off in turns: each is judged with the one before
  bool wants_panel = false;
  bool wants_png = false;
  std::function<bool(std::int64_t)> wants_shot;  ///< of the frame with this number; asked on the caller's thread
};

class FrameLine {
 public:
  /// @param on_judged  gets every frame once, in order, on the caller's thread, with its command.
  /// @param on_drawn   gets every readable frame once, in order, on the caller's thread, if pictures are wanted.
  using Receiver = std::function<void(FrameWork&)>;
  FrameLine(const LineSettings& settings, Receiver on_judged, Receiver on_drawn);

  /// A new row of frames: steering starts afresh.
  void begin_source(bool is_sequence);
  /// Takes a frame in; hands others out to make room. Holds a few frames for each job, never more.
  void push(io::Frame frame);
  /// Hands out all that is still on its way.
  void finish();
  /// What was learnt of the lamp in the sequence judged last; what was known where nothing was learnt.
  [[nodiscard]] LampPattern lamp() const noexcept;

 private:
  using Work = std::shared_ptr<FrameWork>;
  void judge(FrameWork& work, int worker);
  void judge_in_order(FrameWork& work);
  void draw(FrameWork& work) const;
  void steer(FrameWork& work);
  void pop_judged();
  void pop_drawn();

  LineSettings settings_;
  Receiver on_judged_;
  Receiver on_drawn_;
  [[nodiscard]] bool is_pilots() const { return pilot_ && pilot_->judges(); }
  [[nodiscard]] bool wants_stages(const FrameWork& work) const { return settings_.wants_panel || work.wants_shot; }

  std::vector<OpenSpaceFinder> finders_;  ///< one for each worker
  std::unique_ptr<SequencePilot> pilot_;  ///< of a sequence; without it frames are independent
  cv::Mat last_pixels_;                   ///< of the frame judged last, for pairs
  std::size_t room_;
  std::int64_t pushed_ = 0;
  std::deque<Work> judging_;
  std::deque<Work> drawing_;
  WorkerPool pool_;  ///< last: its threads end before what they use
};

}  // namespace adit::tools
