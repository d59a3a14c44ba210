#include "adit/sim/scene.hpp"

#include <tbb/task_arena.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "embree.hpp"

namespace adit::sim {
namespace {

void check(const Mesh& mesh) {
  if (mesh.triangles.empty()) throw std::invalid_argument("the mesh has no triangle: nothing would be seen or hit");
  if (mesh.materials.size() != mesh.triangles.size())
    throw std::invalid_argument("the mesh has " + std::to_string(mesh.triangles.size()) + " triangles but " +
                                std::to_string(mesh.materials.size()) + " materials: give one a triangle");
  const auto vertex_count = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (!mesh.vertices[i].allFinite())
      throw std::invalid_argument("vertex " + std::to_string(i) + " of the mesh is not finite: repair the mesh");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles[i].maxCoeff() >= vertex_count)
      throw std::invalid_argument("triangle " + std::to_string(i) + " of the mesh names vertex " +
                                  std::to_string(mesh.triangles[i].maxCoeff()) + " of " + std::to_string(vertex_count) +
                                  ": repair the mesh");
}

/// The same for RTCRay16 alone and within RTCRayHit16.
void load(RTCRay16& to, const RayPacket& rays) {
  std::memcpy(to.org_x, rays.origin[0], sizeof rays.origin[0]);
  std::memcpy(to.org_y, rays.origin[1], sizeof rays.origin[1]);
  std::memcpy(to.org_z, rays.origin[2], sizeof rays.origin[2]);
  std::memcpy(to.dir_x, rays.direction[0], sizeof rays.direction[0]);
  std::memcpy(to.dir_y, rays.direction[1], sizeof rays.direction[1]);
  std::memcpy(to.dir_z, rays.direction[2], sizeof rays.direction[2]);
  std::memcpy(to.tnear, rays.tnear, sizeof rays.tnear);
  std::memcpy(to.tfar, rays.tfar, sizeof rays.tfar);
  std::memset(to.time, 0, sizeof to.time);
  std::memset(to.mask, 0xff, sizeof to.mask);
  std::memset(to.id, 0, sizeof to.id);
  std::memset(to.flags, 0, sizeof to.flags);
}

[[noreturn]] void fail(RTCDevice device, const char* doing) {
  throw std::runtime_error(std::string("Embree could not ") + doing + " (error " +
                           std::to_string(static_cast<int>(rtcGetDeviceError(device))) +
                           "); is there enough memory for the mesh?");
}

}  // namespace

RayScene::Tree::~Tree() {
  if (scene != nullptr) rtcReleaseScene(scene);
  if (device != nullptr) rtcReleaseDevice(device);
}

RayScene::RayScene(const Mesh& mesh) : tree_(std::make_unique<Tree>()) {
  check(mesh);
  // Not "threads=1": that would keep the whole program to one thread for as long as the device lives.
  tree_->device = rtcNewDevice(nullptr);
  if (tree_->device == nullptr) fail(nullptr, "start");
  tree_->vertices = mesh.vertices;
  // Embree reads 16 bytes from the last vertex's address.
  tree_->vertices.emplace_back(Eigen::Vector3f::Zero());
  tree_->triangles = mesh.triangles;
  RTCGeometry geometry = rtcNewGeometry(tree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, tree_->vertices.data(), 0,
                             sizeof(Eigen::Vector3f), tree_->vertices.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, tree_->triangles.data(), 0,
                             3 * sizeof(std::uint32_t), tree_->triangles.size());
  rtcCommitGeometry(geometry);
  tree_->scene = rtcNewScene(tree_->device);
  rtcSetSceneFlags(tree_->scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(tree_->scene, geometry);
  rtcReleaseGeometry(geometry);
  // Built by one thread: the tree, and with it the winner where two triangles share the hit, is the same in every run.
  if (rtcGetDeviceProperty(tree_->device, RTC_DEVICE_PROPERTY_JOIN_COMMIT_SUPPORTED) != 0)
    tbb::task_arena(1).execute([&] { rtcJoinCommitScene(tree_->scene); });
  else
    rtcCommitScene(tree_->scene);
  if (rtcGetDeviceError(tree_->device) != RTC_ERROR_NONE) fail(tree_->device, "build the tree of the mesh");
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

std::size_t RayScene::triangle_count() const noexcept { return tree_->triangles.size(); }

std::optional<Hit> RayScene::closest_hit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                                         float range_max_m) const {
  RTCRayHit ray{};
  ray.ray = {origin.x(),  origin.y(),  origin.z(), 0.0f, direction.x(), direction.y(), direction.z(), 0.0f,
             range_max_m, 0xffffffffu, 0,          0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  embree::intersect1(tree_->scene, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  Hit hit;
  hit.range_m = ray.ray.tfar;
  hit.place = origin + direction * ray.ray.tfar;
  hit.normal = Eigen::Vector3f(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z).normalized();
  if (hit.normal.dot(direction) > 0.0f) hit.normal = -hit.normal;
  hit.triangle = ray.hit.primID;
  return hit;
}

bool RayScene::occluded(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const {
  constexpr float kEnd_m = 1e-3f;
  const float length = (to - from).norm();
  if (length <= 2.0f * kEnd_m) return false;
  const Eigen::Vector3f d = (to - from) / length;
  RTCRay ray{from.x(), from.y(), from.z(), kEnd_m, d.x(), d.y(), d.z(), 0.0f, length - kEnd_m, 0xffffffffu, 0, 0};
  embree::occluded1(tree_->scene, &ray);
  return ray.tfar < 0.0f;
}

std::vector<float> RayScene::horizontal_ranges_m(const Eigen::Vector3f& origin, float yaw_rad,
                                                 std::span<const float> angles_rad, float range_max_m) const {
  std::vector<float> ranges(angles_rad.size(), range_max_m);
  RayPacket rays{};
  HitPacket hits{};
  for (std::size_t first = 0; first < angles_rad.size(); first += kPacket) {
    const std::size_t count = std::min<std::size_t>(kPacket, angles_rad.size() - first);
    for (std::size_t i = 0; i < kPacket; ++i) {
      const float angle = yaw_rad + (i < count ? angles_rad[first + i] : 0.0f);
      for (int k = 0; k < 3; ++k) rays.origin[k][i] = origin[k];
      rays.direction[0][i] = std::cos(angle);
      rays.direction[1][i] = std::sin(angle);
      rays.direction[2][i] = 0.0f;
      rays.tnear[i] = 0.0f;
      rays.tfar[i] = i < count ? range_max_m : -1.0f;
    }
    intersect(rays, hits);
    for (std::size_t i = 0; i < count; ++i)
      if (hits.triangle[i] != kNoTriangle) ranges[first + i] = hits.t[i];
  }
  return ranges;
}

void RayScene::intersect(const RayPacket& rays, HitPacket& hits) const {
  RTCRayHit16 packet;
  alignas(64) int valid[kPacket];
  load(packet.ray, rays);
  for (int i = 0; i < kPacket; ++i) {
    valid[i] = rays.tfar[i] >= rays.tnear[i] ? -1 : 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.primID[i] = kNoTriangle;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  embree::intersect16(valid, tree_->scene, &packet);
  std::memcpy(hits.t, packet.ray.tfar, sizeof hits.t);
  std::memcpy(hits.normal[0], packet.hit.Ng_x, sizeof hits.normal[0]);
  std::memcpy(hits.normal[1], packet.hit.Ng_y, sizeof hits.normal[1]);
  std::memcpy(hits.normal[2], packet.hit.Ng_z, sizeof hits.normal[2]);
  std::memcpy(hits.u, packet.hit.u, sizeof hits.u);
  std::memcpy(hits.v, packet.hit.v, sizeof hits.v);
  std::memcpy(hits.triangle, packet.hit.primID, sizeof hits.triangle);
}

std::uint32_t RayScene::occluded(const RayPacket& rays) const {
  RTCRay16 packet;
  alignas(64) int valid[kPacket];
  load(packet, rays);
  for (int i = 0; i < kPacket; ++i) {
    valid[i] = rays.tfar[i] >= rays.tnear[i] ? -1 : 0;
  }
  embree::occluded16(valid, tree_->scene, &packet);
  std::uint32_t bits = 0;
  for (int i = 0; i < kPacket; ++i)
    if (valid[i] != 0 && packet.tfar[i] < 0.0f) bits |= 1u << i;
  return bits;
}

}  // namespace adit::sim
