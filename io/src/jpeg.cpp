#include <csetjmp>
#include <cstdio>
// jpeglib.h needs <cstdio> before it.
#include <jerror.h>
#include <jpeglib.h>

#include <opencv2/imgproc.hpp>

#include "image_bytes.hpp"

namespace adit::io {
namespace {

/// libjpeg's error manager, which would print and exit, made to remember and jump.
struct Judge {
  jpeg_error_mgr manager;  // first: libjpeg hands back a pointer to it
  std::jmp_buf back;
  bool truncated = false;
  bool damaged = false;
  char message[JMSG_LENGTH_MAX] = "";
};

Judge& judge_of(j_common_ptr decoder) { return *reinterpret_cast<Judge*>(decoder->err); }

[[noreturn]] void on_error(j_common_ptr decoder) {
  Judge& judge = judge_of(decoder);
  decoder->err->format_message(decoder, judge.message);
  std::longjmp(judge.back, 1);
}

void on_message(j_common_ptr decoder, int level) {
  if (level >= 0) return;  // traces
  Judge& judge = judge_of(decoder);
  switch (decoder->err->msg_code) {
    case JWRN_JPEG_EOF:
      judge.truncated = true;
      break;
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_MUST_RESYNC:
      judge.damaged = true;
      break;
    default:  // junk between markers and the like: the picture is whole
      break;
  }
}

void on_output(j_common_ptr) {}

/// What libjpeg says of the header and the rows; true when it came to the end.
/// Objects with destructors live outside: longjmp() leaves this frame without calling them.
bool decode_rows(jpeg_decompress_struct& decoder, Judge& judge, const Bytes& bytes, cv::Mat& image) {
  if (setjmp(judge.back) != 0) return false;
  jpeg_create_decompress(&decoder);
  jpeg_mem_src(&decoder, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&decoder, TRUE);
  const bool grey = decoder.jpeg_color_space == JCS_GRAYSCALE;
  decoder.out_color_space = grey ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_start_decompress(&decoder);
  image.create(static_cast<int>(decoder.output_height), static_cast<int>(decoder.output_width),
               grey ? CV_8UC1 : CV_8UC3);
  while (decoder.output_scanline < decoder.output_height) {
    JSAMPROW row = image.ptr(static_cast<int>(decoder.output_scanline));
    jpeg_read_scanlines(&decoder, &row, 1);
  }
  jpeg_finish_decompress(&decoder);
  return true;
}

}  // namespace

bool is_jpeg(const Bytes& bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

std::string decode_jpeg(const Bytes& bytes, cv::Mat& image) {
  Judge judge;
  jpeg_decompress_struct decoder{};
  decoder.err = jpeg_std_error(&judge.manager);
  judge.manager.error_exit = on_error;
  judge.manager.emit_message = on_message;
  judge.manager.output_message = on_output;
  const bool came_to_end = decode_rows(decoder, judge, bytes, image);
  jpeg_destroy_decompress(&decoder);
  if (judge.truncated) return "the file is truncated: the JPEG ends early";
  if (judge.damaged) return "the JPEG is damaged";
  if (!came_to_end) return std::string("not a JPEG that can be read: ") + judge.message;
  if (image.channels() == 3) cv::cvtColor(image, image, cv::COLOR_RGB2BGR);
  return "";
}

}  // namespace adit::io
