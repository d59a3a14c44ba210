// The shading loops. CMake compiles this file once per CPU target, with ADIT_SHADE_TARGET naming it.
#include <bit>

#include "blur_row.hpp"
#include "facet_noise.hpp"
#include "lane_vectors.hpp"
#include "lanes.hpp"
#include "sensor_rows.hpp"
#include "tile.hpp"
#include "triangle_lanes.hpp"

#define ADIT_TEXT_(x) #x
#define ADIT_TEXT(x) ADIT_TEXT_(x)
#define ADIT_JOIN_(a, b) a##b
#define ADIT_JOIN(a, b) ADIT_JOIN_(a, b)

namespace adit::sim {
namespace {

constexpr float kPi = 3.14159265f;
constexpr int kPacketLanes = kBlock * kBlock;
// Lanes do not touch each other's memory.
#define ADIT_LANES _Pragma("GCC ivdep")

#include "blur.inl"
#include "compose.inl"
#include "lamps.inl"
#include "parallax.inl"
#include "sensor_rows.inl"
#include "sight.inl"
#include "surface.inl"

}  // namespace

extern const ShadeKernels ADIT_JOIN(kShade_, ADIT_SHADE_TARGET);
const ShadeKernels ADIT_JOIN(kShade_, ADIT_SHADE_TARGET) = {ADIT_TEXT(ADIT_SHADE_TARGET),
                                                            aim,
                                                            see,
                                                            surface,
                                                            lamp,
                                                            virtual_lights,
                                                            soft_light,
                                                            blur_row,
                                                            compose,
                                                            parallax,
                                                            mosaic_row,
                                                            tone_row};

}  // namespace adit::sim
