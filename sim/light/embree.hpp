// The few differences between Embree 3 and 4 stand here.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "adit/sim/scene.hpp"

namespace adit::sim {

struct RayScene::Tree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Matrix<std::uint32_t, 3, 1>> triangles;

  Tree() = default;
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;
  ~Tree();
};

namespace embree {

#if RTC_VERSION_MAJOR >= 4
inline void intersect1(RTCScene scene, RTCRayHit* ray) { rtcIntersect1(scene, ray, nullptr); }
inline void occluded1(RTCScene scene, RTCRay* ray) { rtcOccluded1(scene, ray, nullptr); }
inline void intersect16(const int* valid, RTCScene scene, RTCRayHit16* rays) {
  RTCIntersectArguments with;
  rtcInitIntersectArguments(&with);
  with.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(valid, scene, rays, &with);
}
inline void occluded16(const int* valid, RTCScene scene, RTCRay16* rays) {
  RTCOccludedArguments with;
  rtcInitOccludedArguments(&with);
  with.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcOccluded16(valid, scene, rays, &with);
}
#else
inline RTCIntersectContext coherent_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}
inline void intersect1(RTCScene scene, RTCRayHit* ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, ray);
}
inline void occluded1(RTCScene scene, RTCRay* ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, ray);
}
inline void intersect16(const int* valid, RTCScene scene, RTCRayHit16* rays) {
  RTCIntersectContext context = coherent_context();
  rtcIntersect16(valid, scene, &context, rays);
}
inline void occluded16(const int* valid, RTCScene scene, RTCRay16* rays) {
  RTCIntersectContext context = coherent_context();
  rtcOccluded16(valid, scene, &context, rays);
}
#endif

}  // namespace embree
}  // namespace adit::sim
