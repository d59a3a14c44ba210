// The chain of stages of the method `adit`: a row of named calls on a small grid.
#pragma once

#include "adit/camera.hpp"
#include "adit/finder.hpp"
#include "cusp.hpp"
#include "enclosure.hpp"
#include "noise_floor.hpp"
#include "opening_search.hpp"
#include "veil.hpp"

namespace adit {

/// Buffers and tables of the method for frames of one size.
class AditChain {
 public:
  AditChain(const FinderConfig& config, const Camera& camera, int frame_width_px, int frame_height_px);

  /// Makes cells of a frame of the size given. Allocates nothing, nor does any of what follows but draw().
  void take(const ImageView& frame, const FinderConfig& config) noexcept;
  /// Makes cells of what is brighter in the brighter of two frames: the lamp's own light.
  void take_pair(const ImageView& one, const ImageView& other, const FinderConfig& config) noexcept;
  /// Judges the cells; fills in everything of `out` but the times.
  void find(const FinderConfig& config, const Camera& camera, OpenSpace& out) noexcept;

  void set_lamp(const LampPattern& pattern) noexcept;
  [[nodiscard]] LampGlimpse lamp_glimpse() const noexcept;

  /// The pictures of the frame judged last, enlarged to its size.
  void draw(StageImages& images) const;

 private:
  [[nodiscard]] bool hides_all_rock(const VeilSight& veil, const SightFlags& flags) const noexcept;
  void clean() noexcept;
  void brighten_outside_beam() noexcept;
  void search(bool by_cusp) noexcept;
  [[nodiscard]] Status judge_levels(const FinderConfig& config, const OpenSpace& out) const noexcept;
  void weigh(bool by_cusp) noexcept;
  void rank_by_cusp() noexcept;
  struct LevelRange {
    std::int16_t least, most;  ///< parts of a grey level
  };
  LevelRange note_levels(OpenSpace& out) const noexcept;
  double note_flags(const FinderConfig& config, const VeilSight& veil, OpenSpace& out) const noexcept;
  void note_openings(const FinderConfig& config, const Camera& camera, const VeilSight& veil, bool veil_off,
                     OpenSpace& out) noexcept;
  void note_opening(const Candidate& from, const Camera& camera, Opening& to) const noexcept;
  void note_way_through_dust(const Camera& camera, const VeilSight& veil, Opening& to) noexcept;

  int frame_width_px_;
  int frame_height_px_;
  CellGrid grid_;
  ReductionRows rows_;
  FilterScratch filter_;
  NoiseFloor noise_floor_;
  EnclosureScratch enclosing_;
  SearchScratch search_;
  VeilFit veil_fit_;
  CuspFit cusp_;
  std::vector<std::int16_t> no_cusp_;  ///< weights of a row where the cusp says nothing
  LobeOnCells lobe_on_cells_;
  LightTable table_{};
  std::vector<std::int16_t> elevation_weight_;  ///< of each row of cells, 0 to 256
  double noise_share_ = 0.0;                    ///< of single cells, in the frame judged last
  bool lamp_known_ = false;
  bool light_usable_ = false;  ///< the frame judged last showed rock in clear air
  CellPlane lamp_;             ///< how far the lamp's pattern lies below its middle, parts of a stop
  CellPlane other_level_;      ///< of the second frame of a pair
  CellPlane level_;            ///< parts of a grey level
  CellPlane cleaned_;          ///< without specks and thin lines
  CellPlane light_;            ///< parts of a stop
  CellPlane map_;              ///< enclosure, weighted and smoothed
  CellPlane depth_;            ///< enclosure, weighted, not capped
  Candidates candidates_;
};

}  // namespace adit
