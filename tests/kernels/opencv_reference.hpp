// The morphology of OpenCV on our planes.
#pragma once

#include <opencv2/imgproc.hpp>
#include <string_view>

#include "judging.hpp"

namespace adit::judging {

inline cv::Mat opencv_element(const ElementShape& shape) {
  return cv::getStructuringElement(shape.is_ellipse ? cv::MORPH_ELLIPSE : cv::MORPH_RECT, {shape.width, shape.height});
}

/// The same pixels, not copied; OpenCV only reads them.
inline cv::Mat as_mat(const reference::Plane& plane) {
  return cv::Mat(plane.height, plane.width, CV_8UC1, const_cast<std::uint8_t*>(plane.pixels.data()));
}

inline ConstPlaneView as_plane(const cv::Mat& mat) {
  return {mat.data, mat.cols, mat.rows, static_cast<std::ptrdiff_t>(mat.step)};
}

/// Erosion, dilation and closing of one plane by OpenCV.
struct OpencvMorphology {
  cv::Mat eroded;
  cv::Mat dilated;
  cv::Mat closed;

  OpencvMorphology(const reference::Plane& plane, const ElementShape& shape) {
    const cv::Mat element = opencv_element(shape);
    cv::erode(as_mat(plane), eroded, element);
    cv::dilate(as_mat(plane), dilated, element);
    cv::morphologyEx(as_mat(plane), closed, cv::MORPH_CLOSE, element);
  }
};

/// Every CPU target against OpenCV.
inline void judge_by_opencv(const reference::Plane& in, const ElementShape& shape, MorphologyScratch& scratch) {
  const OpencvMorphology want(in, shape);
  const StructuringElement element = shape.element();
  scratch.reserve(in.width, in.height, element);
  reference::Plane out(in.width, in.height);
  for (const std::string_view target : supported_cpu_targets()) {
    const TargetInUse in_use(target);
    erode(in.view(), element, out.view(), scratch);
    ASSERT_TRUE(same_levels(out.view(), as_plane(want.eroded))) << "erosion, " << shape.name() << ", " << target;
    dilate(in.view(), element, out.view(), scratch);
    ASSERT_TRUE(same_levels(out.view(), as_plane(want.dilated))) << "dilation, " << shape.name() << ", " << target;
    close(in.view(), element, out.view(), scratch);
    ASSERT_TRUE(same_levels(out.view(), as_plane(want.closed))) << "closing, " << shape.name() << ", " << target;
  }
}

}  // namespace adit::judging
