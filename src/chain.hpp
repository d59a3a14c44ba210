// What an OpenSpaceFinder owns: its configuration, its camera and the buffers for one size of frame.
#pragma once

#include <new>
#include <optional>
#include <stdexcept>

#include "adit/dark_channel.hpp"
#include "adit/finder.hpp"
#include "adit/morphology.hpp"
#include "adit/region.hpp"
#include "adit_chain.hpp"
#include "margined_plane.hpp"

namespace adit {

/// Buffers and elements for frames of one size. Made whole or not at all.
struct Workspace {
  /// @param camera  the calibrated one, or null.
  Workspace(const FinderConfig& config, const Camera* camera, int width_px, int height_px);

  int width;
  int height;
  StructuringElement patch;
  StructuringElement element;
  Camera assumed_camera;  ///< stands in where no calibration is given
  MorphologyScratch scratch;
  MarginedPlane dark;    ///< its closing too, where that needs no strips
  MarginedPlane closed;  ///< in strips
  PlaneView closing{};   ///< the last frame's
  std::vector<std::uint32_t> columns;
  LevelTable transmission{};  ///< of the last frame, as is the next
  LevelTable depth{};
  std::optional<AditChain> adit;  ///< only for that method; it needs none of the planes above
};

struct OpenSpaceFinder::Chain {
  explicit Chain(const FinderConfig& c) : config(c) {}

  /// kFound for a frame that can be judged, with the workspace sized for it.
  [[nodiscard]] Status admit(const ImageView& frame) noexcept;
  void reserve(int width, int height);
  [[nodiscard]] const Camera& camera() const noexcept {
    return calibrated_camera ? *calibrated_camera : workspace->assumed_camera;
  }

  FinderConfig config;
  std::optional<Camera> calibrated_camera;
  std::optional<Workspace> workspace;
  LampPattern lamp;
};

}  // namespace adit
