#include "chain.hpp"

#include "band_pass.hpp"
#include "number_text.hpp"

namespace adit {
namespace {

int size_px(int set_px, int vga_px, int width) noexcept { return set_px > 0 ? set_px : scaled_size_px(vga_px, width); }

StructuringElement patch_of(const FinderConfig& config, int width) {
  const int size = size_px(config.patch_size_px, config.patch_size_vga_px, width);
  return StructuringElement::rectangle(size, size);
}

StructuringElement element_of(const FinderConfig& config, int width) {
  const int size = size_px(config.structuring_element_size_px, config.structuring_element_size_vga_px, width);
  return StructuringElement::ellipse(size, size);
}

}  // namespace

Workspace::Workspace(const FinderConfig& config, const Camera* camera, int width_px, int height_px)
    : width(width_px),
      height(height_px),
      patch(patch_of(config, width_px)),
      element(element_of(config, width_px)),
      assumed_camera(pinhole(width_px, height_px, config.assumed_hfov_deg)) {
  if (config.method == Method::kAdit) {
    adit.emplace(config, camera != nullptr ? *camera : assumed_camera, width, height);
    return;
  }
  scratch.reserve(width, height, patch);
  scratch.reserve(width, height, element);
  const int reach_u = element.width() / 2, reach_v = element.height() / 2;
  dark.reserve(width, height, reach_u, reach_v);
  if (closes_in_strips(width, element, scratch)) closed.reserve(width, height, reach_u, reach_v);
  columns.resize(static_cast<std::size_t>(width));
}

Status OpenSpaceFinder::Chain::admit(const ImageView& frame) noexcept {
  if (!fault_of(frame).empty()) return Status::kBadFrame;
  if (calibrated_camera) {
    const CameraModel& model = calibrated_camera->model();
    if (model.width != frame.width || model.height != frame.height) return Status::kWrongSize;
  }
  try {
    reserve(frame.width, frame.height);
  } catch (const std::exception&) {  // no memory
    return Status::kBadFrame;
  }
  return Status::kFound;
}

void OpenSpaceFinder::Chain::reserve(int width, int height) {
  if (width < kSideMin_px || width > kSideMax_px)
    throw std::invalid_argument(range_fault("width", width, kSideMin_px, kSideMax_px, "px"));
  if (height < kSideMin_px || height > kSideMax_px)
    throw std::invalid_argument(range_fault("height", height, kSideMin_px, kSideMax_px, "px"));
  if (workspace && workspace->width == width && workspace->height == height) return;
  workspace.reset();  // first: two sets of buffers of a large frame need not fit
  workspace.emplace(config, calibrated_camera ? &*calibrated_camera : nullptr, width, height);
  if (workspace->adit && lamp.frames > 0.0) workspace->adit->set_lamp(lamp);
}

}  // namespace adit
