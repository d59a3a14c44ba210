// How an element of a given size is put together from windows of rows and columns, worked out while compiling.
#pragma once

namespace adit::kernels {

/// Larger elements are made in another way (LargeEllipse, RectanglePass), px.
inline constexpr int kSweepHalfMax_px = 15;

/// A round flat element is the union of centred rectangles, from the widest (and lowest) to the narrowest (and
/// highest). Taking the best value distributes over itself, so each step of widening serves all wider rectangles
/// (Horner's scheme): the window of the first rectangle's rows is widened by what it is wider than the second, joined
/// with the window of the second's rows, and so on.
struct SweepRecipe {
  struct Step {
    int shift = 0;        ///< best of what lies this many columns to the left and to the right, px
    bool centre = false;  ///< and of what lies between
    int joins = -1;       ///< and of this rectangle's window of rows
  };
  static constexpr int kRectanglesMax = kSweepHalfMax_px + 1;
  static constexpr int kStepsMax = 32;

  int rectangle_count = 0;
  int reach_v[kRectanglesMax] = {};  ///< half height of each rectangle, px; rises
  int reach_u[kRectanglesMax] = {};  ///< half width, px; falls
  int lag[kRectanglesMax] = {};      ///< steps before the rectangle is joined
  int step_count = 0;
  Step steps[kStepsMax] = {};

  [[nodiscard]] constexpr int height() const { return 2 * reach_v[rectangle_count - 1] + 1; }
};

// Static: a function that all targets share could be taken from the object of another CPU.

/// Half the chord of OpenCV's ellipse at `dv` rows from the middle: sqrt(half^2 - dv^2), to the nearest whole number.
/// No square root of a whole number lies halfway between two whole numbers.
static constexpr int half_chord_of_ellipse(int half, int dv) {
  const int square = half * half - dv * dv;
  int chord = 0;
  while ((2 * chord + 1) * (2 * chord + 1) <= 4 * square) ++chord;
  return chord;
}

/// Widens by `reach`: three windows of c columns side by side make one of up to 3 c. The window between two others is
/// left out where those two meet, and where the rectangle that is joined contains it.
static constexpr void add_widening(SweepRecipe& recipe, int reach, int joins) {
  const int window = 2 * reach + 1;
  for (int columns = 1; columns < window;) {
    const int shift = columns < (window - columns) / 2 ? columns : (window - columns) / 2;
    const bool last = columns + 2 * shift == window;
    const bool contained = columns == 1 && last && joins >= 0;
    recipe.steps[recipe.step_count++] = {shift, 2 * shift >= columns && !contained, last ? joins : -1};
    columns += 2 * shift;
  }
}

/// The ellipse inscribed in a square of 2 * half + 1 px.
static constexpr SweepRecipe round_recipe(int half) {
  SweepRecipe recipe;
  int& count = recipe.rectangle_count;
  for (int dv = 0; dv <= half; ++dv) {
    const int chord = half_chord_of_ellipse(half, dv);
    if (count == 0 || recipe.reach_u[count - 1] != chord) recipe.reach_u[count++] = chord;
    recipe.reach_v[count - 1] = dv;
  }
  for (int j = 0; j < count; ++j) {
    recipe.lag[j] = recipe.step_count;
    const bool is_last = j + 1 == count;
    add_widening(recipe, recipe.reach_u[j] - (is_last ? 0 : recipe.reach_u[j + 1]), is_last ? -1 : j + 1);
  }
  return recipe;
}

/// The square itself.
static constexpr SweepRecipe square_recipe(int half) {
  SweepRecipe recipe;
  recipe.rectangle_count = 1;
  recipe.reach_u[0] = half;
  recipe.reach_v[0] = half;
  add_widening(recipe, half, -1);
  return recipe;
}

}  // namespace adit::kernels
