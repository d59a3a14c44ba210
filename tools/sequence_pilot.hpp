// Who follows the frames of a recording or a camera: the same for `adit run` and `adit view`.
#pragma once

#include <optional>

#include "adit/camera.hpp"
#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/io/configuration.hpp"
#include "adit/lamp.hpp"
#include "adit/navigator.hpp"

namespace adit::tools {

/// What one frame of a sequence came to.
struct Followed {
  OpenSpace open_space;
  HeadingCommand command;
  std::optional<double> speed_scale;  ///< share of the wanted speed; the published controller knows none
  std::optional<Track> track;         ///< the opening that is followed; nothing: none, or nobody keeps track
};

/// The navigator; for the method `paper` the published controller. A recording does not turn when it is told to: the
/// camera is taken to stand, not to follow the commands.
class SequencePilot {
 public:
  /// @throws std::invalid_argument naming the field, the value and the range.
  SequencePilot(const io::Configuration& configuration, const std::optional<Camera>& camera);

  /// Does the pilot judge frames itself, in the order of their taking? Else each is judged alone, by any finder, and
  /// follow() takes what it saw.
  [[nodiscard]] bool judges() const noexcept { return navigator_.has_value(); }
  /// Where the pilot judges. @param images  filled where it is given.
  [[nodiscard]] Followed see(const ImageView& frame, double stamp_s, StageImages* images = nullptr);
  /// The same of a pair of frames, lamp on and lamp off, `frame` the later one.
  [[nodiscard]] Followed see_flash(const ImageView& frame, const ImageView& before, double stamp_s);
  /// Where it does not.
  [[nodiscard]] Followed follow(const OpenSpace& seen, double stamp_s);
  /// No frame came at stamp_s.
  [[nodiscard]] HeadingCommand miss(double stamp_s);

  /// As Navigator::use_lamp; nothing for the published controller.
  void use_lamp(const LampPattern& known, bool learn);
  /// Nothing for the published controller.
  [[nodiscard]] std::optional<LampPattern> lamp() const;

 private:
  Followed steer(const Sight& sight, double stamp_s);

  std::optional<Navigator> navigator_;
  std::optional<HeadingController> controller_;
};

}  // namespace adit::tools
