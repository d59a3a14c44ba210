#include <algorithm>

#include "chain.hpp"

namespace adit {
namespace {

std::vector<std::uint8_t> pixels_of(ConstPlaneView plane) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height));
  for (int v = 0; v < plane.height; ++v) pixels.insert(pixels.end(), plane.row(v), plane.row(v) + plane.width);
  return pixels;
}

template <class Value>
std::vector<Value> looked_up(const std::vector<std::uint8_t>& levels, const std::array<Value, 256>& table) {
  std::vector<Value> out(levels.size());
  std::transform(levels.begin(), levels.end(), out.begin(), [&table](std::uint8_t level) { return table[level]; });
  return out;
}

std::array<float, 256> as_floats(const LevelTable& table) {
  std::array<float, 256> out{};
  std::transform(table.begin(), table.end(), out.begin(), [](double value) { return static_cast<float>(value); });
  return out;
}

std::array<std::uint8_t, 256> cluster_table(const Clusters& clusters) {
  std::array<std::uint8_t, 256> out{};
  int cluster = 0;
  for (int level = 0; level < 256; ++level) {
    while (cluster + 1 < clusters.count && level > clusters.last_level[static_cast<std::size_t>(cluster)]) ++cluster;
    out[static_cast<std::size_t>(level)] = static_cast<std::uint8_t>(cluster);
  }
  return out;
}

std::array<std::uint8_t, 256> binary_table(int threshold_level) {
  std::array<std::uint8_t, 256> out{};
  std::fill_n(out.begin(), threshold_level + 1, std::uint8_t{255});
  return out;
}

}  // namespace

OpenSpace OpenSpaceFinder::explain(const ImageView& frame, StageImages& images) {
  images = {};
  const OpenSpace out = find(frame);
  if (out.status == Status::kBadFrame || out.status == Status::kWrongSize) return out;
  if (chain_->config.method == Method::kAdit) {
    FinderConfig published = chain_->config;
    published.method = Method::kPaper;
    (void)OpenSpaceFinder(published).explain(frame, images);
    chain_->workspace->adit->draw(images);
    return out;
  }
  Workspace& work = *chain_->workspace;
  const std::vector<std::uint8_t> closed = pixels_of(work.closing);
  // The closing may have taken its place.
  dark_channel(frame, work.patch, chain_->config.grey16_depth_bits, work.dark.pixels(), work.scratch);
  const std::vector<std::uint8_t> dark = pixels_of(work.dark.pixels());
  images.width = work.width;
  images.height = work.height;
  images.dark_channel = dark;
  images.transmission = looked_up(dark, as_floats(work.transmission));
  images.scattering_depth = looked_up(dark, as_floats(work.depth));
  images.closing = looked_up(closed, as_floats(work.depth));
  images.closing_level = closed;
  images.cluster = looked_up(closed, cluster_table(out.clusters));
  images.binary = looked_up(closed, binary_table(out.threshold_level));
  return out;
}

}  // namespace adit
