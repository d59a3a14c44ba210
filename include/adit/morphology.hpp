// Grey erosion, dilation and closing with a flat element (paper, eq. 4 and 5), on 8-bit planes.
#pragma once

#include <memory>
#include <vector>

#include "adit/api.hpp"
#include "adit/image.hpp"

namespace ADIT_API adit {

/// A flat structuring element: for each of its rows, a chord that is centred on the anchor.
/// The anchor is the middle; both sides are odd, so there is one.
class StructuringElement {
 public:
  /// All of width x height. @throws std::invalid_argument unless both are odd and 1 to 1023 px.
  [[nodiscard]] static StructuringElement rectangle(int width_px, int height_px);
  /// The ellipse inscribed in width x height, the same pixels as OpenCV's MORPH_ELLIPSE.
  /// @throws std::invalid_argument unless both are odd and 1 to 1023 px.
  [[nodiscard]] static StructuringElement ellipse(int width_px, int height_px);

  [[nodiscard]] int width() const noexcept { return width_; }    ///< px
  [[nodiscard]] int height() const noexcept { return height_; }  ///< px
  /// Half width of the chord in row v (0 to height - 1): it spans [-half, +half] about the anchor's column.
  [[nodiscard]] int half_chord(int v) const noexcept { return half_chords_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] bool is_rectangle() const noexcept { return is_rectangle_; }

 private:
  StructuringElement(int width_px, int height_px, std::vector<int> half_chords);
  int width_;
  int height_;
  bool is_rectangle_;
  std::vector<int> half_chords_;
};

/// The buffers that morphology works in. Sized once by reserve(); the calls below then allocate nothing.
class MorphologyScratch {
 public:
  MorphologyScratch();
  ~MorphologyScratch();
  MorphologyScratch(MorphologyScratch&&) noexcept;
  MorphologyScratch& operator=(MorphologyScratch&&) noexcept;

  /// Makes room for planes of width x height px and this element. May throw std::bad_alloc.
  void reserve(int width, int height, const StructuringElement& element);

  struct Buffers;
  [[nodiscard]] Buffers& buffers() noexcept { return *buffers_; }

 private:
  std::unique_ptr<Buffers> buffers_;
};

// Pixels outside the plane take no part (OpenCV's default border). `out` has the size of `in` and may be the same
// plane. The scratch must have been reserved for this size and element.

/// Eq. (4), erosion: the smallest value under the element.
void erode(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept;
/// Eq. (4), dilation: the largest value under the element.
void dilate(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept;
/// Eq. (5), closing: dilation, then erosion. Bit for bit cv::morphologyEx(MORPH_CLOSE).
void close(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept;

}  // namespace adit
