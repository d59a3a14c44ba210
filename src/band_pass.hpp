// How a flat element is applied to a plane. Internal to the morphology.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "adit/morphology.hpp"
#include "aligned_bytes.hpp"
#include "element_sum.hpp"
#include "kernels/pixel_loops.hpp"
#include "lines_ahead.hpp"
#include "margined_plane.hpp"

namespace adit {

/// Erosion or dilation: the loops that pick the better of two values, and the value that is never better.
struct Order {
  const kernels::OrderLoops& loops;
  std::uint8_t identity;
};
[[nodiscard]] Order smallest_order() noexcept;
[[nodiscard]] Order largest_order() noexcept;

/// An element as the steps of a BandPass over planes of one width.
///
/// Rows of working memory begin at the leftmost column that the result's first column needs, and are counted from the
/// topmost row that its first row needs: all steps reach to the right and down.
struct BandPlan {
  enum class From { kSource, kWindows, kMain };
  /// What a step takes in: `du` columns to the right and `dv` rows below.
  struct Operand {
    int du;
    int dv;
    From from = From::kMain;
  };
  /// The best of all operands, px.
  struct Step {
    void add(Operand operand) { operands[static_cast<std::size_t>(count++)] = operand; }

    std::array<Operand, kernels::kOperandsMax> operands{};
    int count = 0;
    int window = 0;           ///< > 0: so many rows of the one operand from dv on
    bool is_lozenge = false;  ///< the operands are its upper end, its sides and its lower end
    int dv_max = 0;
    int width = 0;  ///< columns that later steps need, whole vectors
    From to = From::kMain;
  };

  /// @param strip  columns that are done together; 0: what costs least.
  BandPlan(int width, const StructuringElement& element, int strip = 0);
  [[nodiscard]] bool is_for(int width, const StructuringElement& element) const noexcept;
  [[nodiscard]] std::size_t bytes_needed() const noexcept;

  /// Loads are held up by stores under way whose addresses are the same but for multiples of so many bytes.
  static constexpr int kAliasPeriod = 4096;
  /// So far a row of the source stands ahead of the main row that is made of it, bytes.
  static constexpr int kLead = 512;

  int plane_width;  ///< px
  int element_width;
  int element_height;
  bool is_rectangle;
  std::vector<Step> core;   ///< from the source to the main rows
  std::vector<Step> folds;  ///< of the main rows, each in place
  int reach_u = 0;          ///< columns to either side of the anchor; an ellipse of one row is a pixel
  int core_rows;
  int fold_rows;          ///< sum of all dv_max
  int strip_columns = 0;  ///< the plane is done in strips of so many columns, so that a strip's rows stay near
  std::ptrdiff_t pitch;   ///< of a working row, bytes

  int band = 0;  ///< rows that go through a step together
  int room = 0;  ///< rows that come in before those that are still needed are moved up

 private:
  void choose_strip(int reach, int strip);
};

/// The best value over an element. Rows go down through one buffer, and every fold works on them in place: behind a
/// fold lie rows that it has done, before it those that only the earlier folds have.
class BandPass {
 public:
  /// @param work  plan.bytes_needed() bytes on a cache line's boundary.
  BandPass(Order order, const BandPlan& plan, int height, std::uint8_t* work) noexcept;

  /// @param fill  fill(v, rows, first, count, to): writes columns first..first+count-1 of source rows v..v+rows-1 to
  ///              `to`. Rows are asked for in order, each once a strip, at least half an element before `out` is
  ///              written there.
  template <class Fill>
  void run(const Fill& fill, PlaneView out) noexcept {
    for (int begin = 0; begin < plan_.plane_width; begin += plan_.strip_columns) {
      start_strip(begin, std::min(plan_.strip_columns, plan_.plane_width - begin));
      bring(fill, height_, {out.row(0) + begin, out.stride_bytes});
    }
  }

  /// The same for a source that has margins as wide as the element reaches; for a plan of one strip.
  void run_over(kernels::ConstRows source, PlaneView out) noexcept;

  /// For a pass whose rows are fetched by another, strip by strip: at most plan.strip_columns columns from `begin` on.
  void start_strip(int begin, int columns) noexcept;
  /// For strips of planes that are too large for a near cache: what fill() will read comes from `source`, and what
  /// bring() writes goes there; both are asked for ahead.
  void read_ahead(ConstPlaneView source) noexcept {
    far_source_ = source;
    looks_ahead_ = true;
  }
  void write_ahead() noexcept { looks_ahead_ = is_out_far_ = true; }
  /// Columns of the source that this strip needs.
  [[nodiscard]] int source_begin() const noexcept { return first_; }
  [[nodiscard]] int source_columns() const noexcept { return last_ - first_; }
  /// Writes the strip's next rows, up to row `end`, to `out`.
  template <class Fill>
  void bring(const Fill& fill, int end, kernels::Rows out) noexcept {
    const int above = plan_.element_height / 2;
    out_ = out;
    out_first_ = given_;
    while (taken_ < end + plan_.element_height - 1) {
      const int from = taken_, to = std::min(from + plan_.band, end + plan_.element_height - 1);
      make_room(to);
      const int v = std::max(0, from - above), v_end = std::min(height_, to - above);
      if (v < v_end) fill(v, v_end - v, first_, last_ - first_, inside(v + above));
      taken_ = to;
      advance(std::max(0, to - (plan_.core_rows - 1)));
    }
  }

 private:
  /// Rows one below the other, of which the earliest are given up from time to time.
  struct Moving {
    [[nodiscard]] std::uint8_t* at(int row) const noexcept { return memory.first + (row - first) * memory.pitch; }

    kernels::Rows memory;
    int first = 0;  ///< the row that lies at `memory`
  };

  void make_room(int end) noexcept;
  void look_ahead(int end) noexcept;
  void make_room_in_main(int end) noexcept;
  void advance(int end) noexcept;
  void apply(const BandPlan::Step& step, int row, kernels::Rows to, int width, int rows) noexcept;
  [[nodiscard]] kernels::Rows inside(int source_row) const noexcept;
  [[nodiscard]] kernels::ConstRows at(BandPlan::Operand operand, int row) const noexcept;

  Order order_;
  const BandPlan& plan_;
  int height_;
  std::uint8_t* main_work_;  ///< where main rows may lie
  bool is_placed_ = false;
  Moving main_;
  Moving windows_;
  Moving own_source_;
  kernels::ConstRows source_;
  bool source_is_own_ = true;
  int source_first_ = 0;  ///< the row that lies at `source_`
  int begin_ = 0;         ///< columns of the strip
  int width_ = 0;
  int first_ = 0;  ///< columns of the source
  int last_ = 0;
  int taken_ = 0;  ///< rows of the source
  int done_ = 0;   ///< main rows that the core is done with
  int given_ = 0;  ///< rows of the result
  kernels::Rows out_{};
  int out_first_ = 0;  ///< the row that lies at `out_`
  bool looks_ahead_ = false;
  ConstPlaneView far_source_{};
  bool is_out_far_ = false;
  LinesAhead source_ahead_;
  LinesAhead out_ahead_;
};

/// The buffers of all calls.
struct MorphologyScratch::Buffers {
  /// How an element is applied to planes of one width.
  struct Plans {
    BandPlan alone;
    std::optional<BandPlan> before;  ///< of the dilation before an erosion by `alone`, which needs broader strips
  };
  [[nodiscard]] const Plans& plans_for(int width, const StructuringElement& element) const noexcept;

  std::vector<Plans> plans;
  AlignedBytes work;         ///< of a pass
  AlignedBytes before_work;  ///< of the dilation
  AlignedBytes plane;        ///< a copy of the input, or what the closing of a large rectangle has between its passes
  MarginedPlane margined;    ///< what is closed
};

/// The closing of a plane that has margins as wide as the ellipse `element` reaches: saves the copy that close() makes.
/// In place where it needs no strips, and then `out` is not touched. Returns the plane that has the closing.
[[nodiscard]] PlaneView close_margined(MarginedPlane& in, const StructuringElement& element, MarginedPlane& out,
                                       MorphologyScratch& scratch) noexcept;
/// Whether `out` above is needed.
[[nodiscard]] bool closes_in_strips(int width, const StructuringElement& element, MorphologyScratch& scratch) noexcept;

}  // namespace adit
