#include "scenes.hpp"

#include <utility>

#include "adit/dark_channel.hpp"

namespace adit::bench {
namespace {

/// Sizes as the finder's defaults scale them.
int patch_size_px(int width) { return scaled_size_px(paper_preset().patch_size_vga_px, width); }
int element_size_px(int width) { return scaled_size_px(paper_preset().structuring_element_size_vga_px, width); }

std::string name_of(reference::Content content, int width, int height) {
  std::string name = std::to_string(width);
  return name.append("x").append(std::to_string(height)).append("/").append(reference::to_string(content));
}

}  // namespace

Scene::Scene(reference::Content content, int width, int height)
    : name(name_of(content, width, height)),
      frame(content, PixelFormat::kBgr8, width, height, 1),
      patch(StructuringElement::rectangle(patch_size_px(width), patch_size_px(width))),
      element(StructuringElement::ellipse(element_size_px(width), element_size_px(width))),
      dark(width, height),
      closed(width, height) {
  const FinderConfig config = paper_preset();
  MorphologyScratch buffers = scratch();
  dark_channel(view(), patch, config.grey16_depth_bits, dark.view(), buffers);
  close(dark.view(), element, closed.view(), buffers);
  atmospheric_light =
      adit::atmospheric_light(view(), config.grey16_depth_bits, dark.view(), config.atmospheric_light_fraction);
  const LevelTable transmission = transmission_table(atmospheric_light, config.omega, config.transmission_min);
  scattering_depth = scattering_depth_table(transmission, config.scattering_coefficient);
  histogram = histogram_of(closed.view());
  clusters = cluster_exact(scattering_depth, histogram, config.cluster_count);
}

MorphologyScratch Scene::scratch() const {
  MorphologyScratch buffers;
  buffers.reserve(view().width, view().height, patch);
  buffers.reserve(view().width, view().height, element);
  return buffers;
}

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> made;
    for (const reference::Content content : {reference::Content::kTunnel, reference::Content::kNoise}) {
      made.emplace_back(content, 640, 480);
      made.emplace_back(content, 3840, 2160);
    }
    return made;
  }();
  return all;
}

}  // namespace adit::bench
