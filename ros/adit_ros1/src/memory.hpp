// What a process that passes images on does with its memory.
#pragma once

#include <malloc.h>

namespace adit_ros1 {

/// Images come and go thirty times a second, a megabyte each time: glibc would give each back to the kernel and fetch
/// it again page by page (measured: 85 page faults a frame, a third of what a camera node does). Call it before the
/// first image.
inline void keep_freed_memory() noexcept {
  constexpr int kLargest = 32 << 20;  // bytes; what mallopt allows at most, and more than a frame of 3840 x 2160
  mallopt(M_MMAP_THRESHOLD, kLargest);
  mallopt(M_TRIM_THRESHOLD, 2 * kLargest);
}

}  // namespace adit_ros1
