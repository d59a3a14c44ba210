// A camera where there is none: preloaded into a program, this answers for one device as a driver of Video4Linux does
// (capabilities, format, mapped buffers, a frame each period), so that what reads cameras is run down to its system
// calls. The picture is a dark disc in lit, grained rock that goes to and fro, 640 x 480, YUYV.
//
// ADIT_STAND_IN_DEVICE        its name (/dev/video0)
// ADIT_STAND_IN_UNPLUG_AFTER  so many frames, and then it is gone
// ADIT_STAND_IN_IS_METADATA   it gives no pictures, as the second device of a USB camera does
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>

enum { kWidth = 640, kHeight = 480, kBytes = 2 * kWidth * kHeight, kBuffers = 4, kRate_hz = 30 };

static struct {
  int device;  // a timer that runs out once a period: select() waits for it as for a frame
  int memory;
  uint8_t* pixels;
  unsigned count, first, queued;
  unsigned queue[kBuffers];
  unsigned sequence;
} camera = {.device = -1, .memory = -1};

static const char* told(const char* name) {
  const char* value = getenv(name);
  return value && *value ? value : NULL;
}

static void* next(const char* name) { return dlsym(RTLD_NEXT, name); }

static int open_device(void) {
  camera.device = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC);
  camera.memory = memfd_create("frames", MFD_CLOEXEC);
  if (camera.device < 0 || camera.memory < 0 || ftruncate(camera.memory, kBuffers * kBytes) != 0) return -1;
  camera.pixels = mmap(NULL, kBuffers * kBytes, PROT_READ | PROT_WRITE, MAP_SHARED, camera.memory, 0);
  camera.count = camera.first = camera.queued = 0;
  return camera.device;
}

static int is_unplugged(void) {
  const char* after = told("ADIT_STAND_IN_UNPLUG_AFTER");
  return after && camera.sequence >= (unsigned)atoi(after);
}

static int refuse(int reason) {
  errno = reason;
  return -1;
}

static int open_as(const char* own_name, const char* path, int flags, mode_t mode) {
  const char* device = told("ADIT_STAND_IN_DEVICE");
  if (strcmp(path, device ? device : "/dev/video0") == 0) return is_unplugged() ? refuse(ENOENT) : open_device();
  return ((int (*)(const char*, int, mode_t))next(own_name))(path, flags, mode);
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return open_as("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return open_as("open64", path, flags, mode);
}

int close(int file) {
  if (file == camera.device && file >= 0) {
    munmap(camera.pixels, kBuffers * kBytes);
    ((int (*)(int))next("close"))(camera.memory);
    camera.device = camera.memory = -1;
  }
  return ((int (*)(int))next("close"))(file);
}

void* mmap(void* address, size_t length, int protection, int flags, int file, off_t offset) {
  if (file == camera.device && file >= 0) file = camera.memory;
  return ((void* (*)(void*, size_t, int, int, int, off_t))next("mmap"))(address, length, protection, flags, file,
                                                                        offset);
}

static void draw(uint8_t* yuyv, unsigned sequence) {
  const int u = kWidth / 2 + (int)(100 * sin(sequence / 20.0)), v = 220, radius = 80;
  uint32_t grain = sequence + 1;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      grain = grain * 1664525u + 1013904223u;
      const int is_open = (x - u) * (x - u) + (y - v) * (y - v) < radius * radius;
      yuyv[2 * (y * kWidth + x)] = (uint8_t)(is_open ? 18 + (grain >> 30) : 90 + (grain >> 27));
      yuyv[2 * (y * kWidth + x) + 1] = 128;  // no colour
    }
}

static int describe(struct v4l2_capability* told_of) {
  memset(told_of, 0, sizeof *told_of);
  strcpy((char*)told_of->driver, "stand_in");
  strcpy((char*)told_of->card, "a camera that is none");
  told_of->device_caps =
      (told("ADIT_STAND_IN_IS_METADATA") ? V4L2_CAP_META_CAPTURE : V4L2_CAP_VIDEO_CAPTURE) | V4L2_CAP_STREAMING;
  told_of->capabilities = told_of->device_caps | V4L2_CAP_DEVICE_CAPS;
  return 0;
}

static int set_format(struct v4l2_format* format) {
  if (format->type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return refuse(EINVAL);
  memset(&format->fmt, 0, sizeof format->fmt);
  format->fmt.pix = (struct v4l2_pix_format){.width = kWidth,
                                             .height = kHeight,
                                             .pixelformat = V4L2_PIX_FMT_YUYV,
                                             .field = V4L2_FIELD_NONE,
                                             .bytesperline = 2 * kWidth,
                                             .sizeimage = kBytes,
                                             .colorspace = V4L2_COLORSPACE_SRGB};
  return 0;
}

static int set_rate(struct v4l2_streamparm* rate) {
  if (rate->type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return refuse(EINVAL);
  rate->parm.capture.capability = V4L2_CAP_TIMEPERFRAME;
  rate->parm.capture.timeperframe = (struct v4l2_fract){1, kRate_hz};
  return 0;
}

static int lay_out(struct v4l2_buffer* buffer) {
  if (buffer->index >= camera.count) return refuse(EINVAL);
  buffer->length = kBytes;
  buffer->m.offset = buffer->index * kBytes;
  return 0;
}

static int take_back(struct v4l2_buffer* buffer) {
  if (buffer->index >= camera.count || camera.queued == kBuffers) return refuse(EINVAL);
  camera.queue[(camera.first + camera.queued++) % kBuffers] = buffer->index;
  return 0;
}

static int give(struct v4l2_buffer* buffer) {
  if (is_unplugged()) return refuse(ENODEV);
  uint64_t periods;
  if (camera.queued == 0 || read(camera.device, &periods, sizeof periods) != sizeof periods) return refuse(EAGAIN);
  buffer->index = camera.queue[camera.first];
  camera.first = (camera.first + 1) % kBuffers;
  --camera.queued;
  buffer->sequence = ++camera.sequence;  // none is lost: a busy machine sees the same pictures, later
  buffer->bytesused = buffer->length = kBytes;
  buffer->field = V4L2_FIELD_NONE;
  buffer->flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  buffer->timestamp.tv_sec = now.tv_sec;
  buffer->timestamp.tv_usec = now.tv_nsec / 1000;
  draw(camera.pixels + buffer->index * kBytes, camera.sequence);
  return 0;
}

static int run(int runs) {
  const long period_ns = 1000000000L / kRate_hz;
  const struct itimerspec every = {{0, period_ns}, {0, period_ns}}, never = {{0, 0}, {0, 0}};
  camera.first = camera.queued = runs ? camera.queued : 0;
  return timerfd_settime(camera.device, 0, runs ? &every : &never, NULL);
}

int ioctl(int file, unsigned long request, ...) {
  va_list rest;
  va_start(rest, request);
  void* told_or_asked = va_arg(rest, void*);
  va_end(rest);
  if (file != camera.device || file < 0)
    return ((int (*)(int, unsigned long, void*))next("ioctl"))(file, request, told_or_asked);
  switch (request) {
    case VIDIOC_QUERYCAP:
      return describe(told_or_asked);
    case VIDIOC_G_FMT:
    case VIDIOC_S_FMT:
    case VIDIOC_TRY_FMT:
      return set_format(told_or_asked);
    case VIDIOC_G_PARM:
    case VIDIOC_S_PARM:
      return set_rate(told_or_asked);
    case VIDIOC_G_INPUT:
      *(int*)told_or_asked = 0;
      return 0;
    case VIDIOC_S_INPUT:
      return 0;
    case VIDIOC_REQBUFS: {
      struct v4l2_requestbuffers* wanted = told_or_asked;
      camera.count = wanted->count = wanted->count < kBuffers ? wanted->count : kBuffers;
      return 0;
    }
    case VIDIOC_QUERYBUF:
      return lay_out(told_or_asked);
    case VIDIOC_QBUF:
      return take_back(told_or_asked);
    case VIDIOC_DQBUF:
      return give(told_or_asked);
    case VIDIOC_STREAMON:
      return run(1);
    case VIDIOC_STREAMOFF:
      return run(0);
    default:
      return refuse(ENOTTY);
  }
}
