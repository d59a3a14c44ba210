// How a flat element is applied to a plane. Internal to the morphology.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "adit/morphology.hpp"
#include "aligned_bytes.hpp"
#include "element_sum.hpp"
#include "kernels/pixel_loops.hpp"

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
    int dv_max = 0;
    int width = 0;  ///< columns that later steps need, whole vectors
    From to = From::kMain;
  };

  BandPlan(int width, const StructuringElement& element);
  [[nodiscard]] bool is_for(int width, const StructuringElement& element) const noexcept;
  [[nodiscard]] std::size_t bytes_needed() const noexcept;

  int plane_width;  ///< px
  int element_width;
  int element_height;
  bool is_rectangle;
  std::vector<Step> core;   ///< from the source to the main rows; none where the core is a pixel
  std::vector<Step> folds;  ///< of the main rows, each in place
  int reach_u = 0;          ///< columns to either side of the anchor; an ellipse of one row is a pixel
  int core_rows;
  int fold_rows;          ///< sum of all dv_max
  int strip_columns = 0;  ///< the plane is done in strips of so many columns, so that a strip's rows stay in level 1
  std::ptrdiff_t pitch;   ///< of a working row, bytes

  int band = 0;  ///< rows that go through a step together
  int room = 0;  ///< rows that come in before those that are still needed are moved up

 private:
  void choose_strip(int reach);
};

/// Sets what lies before column `begin` of a working row, and from `end` on. In whole blocks, which is quicker: columns
/// between them may be set too, and are to be written afterwards.
void set_margins(std::uint8_t* row, std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t pitch,
                 std::uint8_t value) noexcept;

/// The best value over an element. Rows go down through one buffer, and every fold works on them in place: behind a
/// fold lie rows that it has done, before it those that only the earlier folds have.
class BandPass {
 public:
  BandPass(Order order, const BandPlan& plan, int height, std::uint8_t* work) noexcept;

  /// @param fill  fill(v, first, count, to): writes columns first..first+count-1 of source row v to `to`. Rows are
  /// asked
  ///              for in order, each once a strip, at least half an element before `out` is written there.
  template <class Fill>
  void run(const Fill& fill, PlaneView out) noexcept {
    const int source_end = height_ + plan_.element_height - 1;
    for (int begin = 0; begin < plan_.plane_width; begin += plan_.strip_columns) {
      start_strip(begin);
      clear_source();
      for (int done = 0; done < source_end;) {
        const int end = std::min(done + plan_.band, source_end);
        make_room(end);
        for (; done < end; ++done) {
          std::uint8_t* to = prepare_row(done);
          if (const int v = done - plan_.element_height / 2; v >= 0 && v < height_) fill(v, first_, last_ - first_, to);
        }
        advance(std::max(0, done - (plan_.core_rows - 1)), out);
      }
    }
  }

  /// The same where the source lies in memory as working rows do: plan.pitch bytes from one to the next, the plane's
  /// first column reach_u bytes on, and around it, half an element high, what is never better. For a plan of one strip
  /// whose core is not a pixel.
  void run_over(std::uint8_t* source, PlaneView out) noexcept {
    start_strip(0);
    source_ = {source, height_ + plan_.element_height - 1};
    for (int end = 0; end < height_ + plan_.fold_rows;) {
      end = std::min(end + plan_.band, height_ + plan_.fold_rows);
      keep(main_, std::max(0, done_ - plan_.fold_rows), end);
      advance(end, out);
    }
  }

 private:
  /// Rows one below the other, of which the earliest are given up from time to time.
  struct Rows {
    std::uint8_t* memory = nullptr;
    int count = 0;
    int first = 0;  ///< the row that lies at `memory`
  };

  void start_strip(int begin) noexcept;
  void clear_source() noexcept;
  void make_room(int end) noexcept;
  void keep(Rows& rows, int first, int end) noexcept;
  std::uint8_t* prepare_row(int source_row) noexcept;
  void advance(int end, PlaneView out) noexcept;
  void apply(const BandPlan::Step& step, int row, int rows) noexcept;
  void give(int from, int end, PlaneView out) noexcept;
  [[nodiscard]] std::uint8_t* at(const Rows& rows, int row) const noexcept {
    return rows.memory + (row - rows.first) * plan_.pitch;
  }
  [[nodiscard]] std::uint8_t* at(BandPlan::From from, int row) const noexcept {
    if (from == BandPlan::From::kMain) return at(main_, row);
    return from == BandPlan::From::kSource ? at(source_, row) : at(windows_, row);
  }

  Order order_;
  const BandPlan& plan_;
  int height_;
  bool core_is_pixel_;  ///< then the source's rows are the main rows
  Rows main_;
  Rows source_;
  Rows windows_;
  int begin_ = 0;  ///< columns of the strip
  int width_ = 0;
  int first_ = 0;  ///< columns of the source
  int last_ = 0;
  int done_ = 0;  ///< main rows that the core is done with
};

/// The buffers of all calls.
struct MorphologyScratch::Buffers {
  [[nodiscard]] const BandPlan& plan_for(int width, const StructuringElement& element) const noexcept;

  std::vector<BandPlan> plans;
  AlignedBytes work;   ///< of a pass
  AlignedBytes plane;  ///< between dilation and erosion, or a copy of the input
};

}  // namespace adit
