// The frame as a camera with a JPEG stream would deliver it. Packing and unpacking are done strip by strip, each with a
// row of blocks of its neighbours: what a pixel becomes depends on no more than that, so the strips together are what
// the whole frame would be.
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
// jpeglib.h needs <cstdio> before it.
#include <jpeglib.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "../light/parts.hpp"

namespace adit::sim {
namespace {

constexpr int kBlockRow = 16;               ///< of colours at half the resolution
constexpr int kStripLeast = 6 * kBlockRow;  ///< what neighbours lend should stay small beside it

/// libjpeg's error manager, which would print and exit, made to remember and jump.
struct Judge {
  jpeg_error_mgr manager;  // first: libjpeg hands back a pointer to it
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX] = "";

  Judge() {
    jpeg_std_error(&manager);
    manager.error_exit = [](j_common_ptr coder) {
      Judge& judge = *reinterpret_cast<Judge*>(coder->err);
      coder->err->format_message(coder, judge.message);
      std::longjmp(judge.back, 1);
    };
    manager.output_message = [](j_common_ptr) {};
  }
};

struct Strip {
  int begin, end;                ///< its rows
  int packed_begin, packed_end;  ///< with what the neighbours lend
  std::unique_ptr<unsigned char, decltype(&std::free)> packed{nullptr, &std::free};
  unsigned long size = 0;
  std::string fault{};
};

std::vector<Strip> strips_of(int height, int most) {
  const int count = std::clamp(height / kStripLeast, 1, std::max(most, 1));
  std::vector<Strip> strips;
  for (int i = 0; i < count; ++i) {
    const auto border = [&](int k) { return k == count ? height : height * k / count / kBlockRow * kBlockRow; };
    Strip strip{.begin = border(i), .end = border(i + 1), .packed_begin = 0, .packed_end = 0};
    strip.packed_begin = std::max(0, strip.begin - kBlockRow);
    strip.packed_end = std::min(height, strip.end + kBlockRow);
    strips.push_back(std::move(strip));
  }
  return strips;
}

/// Objects with destructors live outside of this and the next: longjmp() leaves the frame without calling them.
bool pack_rows(jpeg_compress_struct& coder, Judge& judge, int quality, const Frame& frame, Strip& strip,
               unsigned char** packed) {
  if (setjmp(judge.back) != 0) return false;
  jpeg_create_compress(&coder);
  jpeg_mem_dest(&coder, packed, &strip.size);
  coder.image_width = static_cast<JDIMENSION>(frame.width);
  coder.image_height = static_cast<JDIMENSION>(strip.packed_end - strip.packed_begin);
  coder.input_components = 3;
  coder.in_color_space = JCS_EXT_BGR;
  jpeg_set_defaults(&coder);
  jpeg_set_quality(&coder, quality, TRUE);
  jpeg_start_compress(&coder, TRUE);
  while (coder.next_scanline < coder.image_height) {
    const std::size_t at = static_cast<std::size_t>(strip.packed_begin) + coder.next_scanline;
    JSAMPROW row = const_cast<JSAMPROW>(&frame.bgr[at * 3 * static_cast<std::size_t>(frame.width)]);
    jpeg_write_scanlines(&coder, &row, 1);
  }
  jpeg_finish_compress(&coder);
  return true;
}

bool unpack_rows(jpeg_decompress_struct& decoder, Judge& judge, const Strip& strip, std::uint8_t* spare, Frame& frame) {
  if (setjmp(judge.back) != 0) return false;
  jpeg_create_decompress(&decoder);
  jpeg_mem_src(&decoder, strip.packed.get(), strip.size);
  jpeg_read_header(&decoder, TRUE);
  decoder.out_color_space = JCS_EXT_BGR;
  jpeg_start_decompress(&decoder);
  for (int v = strip.packed_begin; v < strip.end; ++v) {
    JSAMPROW row = v < strip.begin ? spare : &frame.bgr[static_cast<std::size_t>(v) * 3 * frame.width];
    jpeg_read_scanlines(&decoder, &row, 1);
  }
  return true;  // what the neighbour below lends is left
}

void pack(int quality, const Frame& frame, Strip& strip) {
  Judge judge;
  jpeg_compress_struct coder{};
  coder.err = &judge.manager;
  unsigned char* packed = nullptr;
  if (!pack_rows(coder, judge, quality, frame, strip, &packed)) strip.fault = judge.message;
  jpeg_destroy_compress(&coder);
  strip.packed.reset(packed);
}

void unpack(Strip& strip, Frame& frame) {
  Judge judge;
  jpeg_decompress_struct decoder{};
  decoder.err = &judge.manager;
  std::vector<std::uint8_t> spare(static_cast<std::size_t>(3) * frame.width);
  if (!unpack_rows(decoder, judge, strip, spare.data(), frame)) strip.fault = judge.message;
  jpeg_destroy_decompress(&decoder);
}

void check(const std::vector<Strip>& strips) {
  for (const Strip& strip : strips)
    if (!strip.fault.empty())
      throw std::runtime_error("sensor.jpeg_quality: no JPEG can be made of the frame: " + strip.fault);
}

}  // namespace

void jpeg_pass(const Renderer::Parts& parts, Frame& frame) {
  const int quality = parts.rig.sensor.jpeg_quality;
  if (quality <= 0) return;
  std::vector<Strip> strips = strips_of(frame.height, parts.threads());
  const int count = static_cast<int>(strips.size());
  parts.each(count, [&](int i) { pack(quality, frame, strips[static_cast<std::size_t>(i)]); });
  check(strips);
  parts.each(count, [&](int i) { unpack(strips[static_cast<std::size_t>(i)], frame); });
  check(strips);
}

}  // namespace adit::sim
