// find() allocates nothing once sized, and answers bad_frame when there is no memory.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/navigator.hpp"
#include "frames.hpp"
#include "lit_plan.hpp"
#include "spread_frame.hpp"

namespace {
std::atomic<long> allocations{0};
std::atomic<bool> memory_is_out{false};
}  // namespace

// Not inlined, none of them: GCC would see malloc() or free() beside one that it has not inlined, and warn. All that
// the core's standard library calls, or the address sanitizer finds its own new with our delete.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (memory_is_out) throw std::bad_alloc();
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  if (memory_is_out) throw std::bad_alloc();
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return memory_is_out ? nullptr : std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace adit {
namespace {

long allocations_during(auto&& work) {
  const long before = allocations;
  work();
  return allocations - before;
}

TEST(Allocation, TheCounterCounts) {
  // Called by name: a compiler may leave out a new and its delete, but not these.
  EXPECT_GT(allocations_during([] { ::operator delete(::operator new(1000)); }), 0);
}

TEST(Allocation, NoneInTheNavigatorAfterTheFirstFrame) {
  test::LitPlan plan;
  plan.add_passage({{-10, 0}, {4, 0}}, 4.0, true, false);
  const test::Frame ahead = plan.seen_from({-6, 0.5, 0}, 1), wall = plan.seen_from({2, 0, 0}, 2);
  for (const Method method : {Method::kPaper, Method::kAdit}) {
    NavigatorConfig config;
    config.finder.method = method;
    Navigator navigator(config);
    (void)navigator.update(ahead.view(), 0.0);
    EXPECT_EQ(allocations_during([&] {
                for (int i = 1; i < 60; ++i)
                  (void)navigator.update((i < 20 ? ahead : wall).view(), 0.05 * i, {0.1, 1.0});
                (void)navigator.tick(3.2);
                navigator.reset();
              }),
              0);
  }
}

TEST(Allocation, NoneAfterTheFirstFrame) {
  for (const auto clustering : {Clustering::kExact, Clustering::kLloyd}) {
    FinderConfig config = paper_preset();
    config.clustering = clustering;
    OpenSpaceFinder finder(config);
    for (const auto format : {PixelFormat::kGrey8, PixelFormat::kBgr8, PixelFormat::kRgba8, PixelFormat::kGrey16}) {
      const test::Frame first = test::in_format(test::tunnel({}), format);
      const test::Frame other = test::in_format(test::tunnel({.u_px = 100, .seed = 9}), format);
      const test::Frame black(160, 120, format, 0);
      if (format == PixelFormat::kGrey8) (void)finder.find(first.view());
      EXPECT_EQ(allocations_during([&] {
                  (void)finder.find(first.view());
                  (void)finder.find(other.view());
                  (void)finder.find(black.view());
                  (void)finder.find({});
                }),
                0);
    }
  }
}

TEST(Allocation, NoneAtAllAfterReserve) {
  const test::Frame frame = test::coloured_tunnel({});
  OpenSpaceFinder finder(paper_preset());
  finder.reserve(160, 120);
  EXPECT_EQ(allocations_during([&] { (void)finder.find(frame.view()); }), 0);
}

TEST(Allocation, NoneByTheMethodAdit) {
  const test::Frame frame = test::coloured_tunnel({});
  const test::Frame wall = test::noise(160, 120, PixelFormat::kBgr8, 3);
  FinderConfig config = paper_preset();
  config.method = Method::kAdit;
  OpenSpaceFinder finder(config);
  finder.reserve(160, 120);
  EXPECT_EQ(allocations_during([&] {
              (void)finder.find(frame.view());
              (void)finder.find(wall.view());
            }),
            0);
}

TEST(Allocation, NoneForFramesInAnyLayout) {
  const test::Frame frame = test::coloured_tunnel({});
  for (const Method method : {Method::kPaper, Method::kAdit}) {
    NavigatorConfig config;
    config.finder.method = method;
    Navigator navigator(config);
    (void)navigator.update(frame.view(), 0.0);
    const auto spreads = test::spreads_of(frame);
    EXPECT_EQ(allocations_during([&] {
                double stamp_s = 0.0;
                for (const test::SpreadFrame& spread : spreads) (void)navigator.update(spread.view, stamp_s += 0.05);
              }),
              0);
  }
}

TEST(Allocation, NoneInTheController) {
  HeadingController controller;
  OpenSpace seen;
  seen.status = Status::kFound;
  EXPECT_EQ(allocations_during([&] {
              for (int i = 0; i < 100; ++i) {
                (void)controller.update(seen, 0.03 * i);
                (void)controller.tick(0.03 * i + 0.01);
              }
            }),
            0);
}

TEST(Allocation, WithoutMemoryTheFrameIsBadAndTheNextIsNot) {
  const test::Frame small = test::coloured_tunnel({});
  const test::Frame large = test::coloured_tunnel({.width = 200, .height = 150});
  OpenSpaceFinder finder(paper_preset());
  EXPECT_EQ(finder.find(small.view()).status, Status::kFound);
  memory_is_out = true;
  const Status without = finder.find(large.view()).status;
  memory_is_out = false;
  EXPECT_EQ(without, Status::kBadFrame);
  EXPECT_EQ(finder.find(large.view()).status, Status::kFound);
  EXPECT_EQ(finder.find(small.view()).status, Status::kFound);
}

}  // namespace
}  // namespace adit
