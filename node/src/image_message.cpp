#include "adit/node/image_message.hpp"

#include <bit>
#include <optional>

#include "text.hpp"

namespace adit::node {
namespace {

std::optional<PixelFormat> format_of(std::string_view encoding) noexcept {
  if (encoding == "mono8" || encoding == "8UC1") return PixelFormat::kGrey8;
  if (encoding == "bgr8" || encoding == "8UC3") return PixelFormat::kBgr8;
  if (encoding == "rgb8") return PixelFormat::kRgb8;
  if (encoding == "bgra8" || encoding == "8UC4") return PixelFormat::kBgra8;
  if (encoding == "rgba8") return PixelFormat::kRgba8;
  if (encoding == "mono16" || encoding == "16UC1") return PixelFormat::kGrey16;
  return std::nullopt;
}

std::string unknown_encoding(std::string_view encoding) {
  return "encoding: " + quoted(encoding) +
         (encoding.starts_with("bayer")
              ? " has not been demosaiced; put image_proc's debayer between, or set the driver to mono8 or bgr8"
              : " is not known; set the driver to mono8, mono16, bgr8, rgb8, bgra8 or rgba8");
}

std::string too_short(const char* field, std::size_t bytes, std::size_t needed) {
  return std::string(field) + ": " + std::to_string(bytes) + " bytes, but the frame needs " + std::to_string(needed) +
         "; the message is damaged";
}

}  // namespace

ImageReading view_of(const ImageMessage& m) {
  const auto format = format_of(m.encoding);
  if (!format) return {{}, unknown_encoding(m.encoding), true};
  const std::size_t row_bytes = std::size_t{m.width} * static_cast<std::size_t>(bytes_per_pixel(*format));
  if (m.width < kSideMin_px || m.height < kSideMin_px || m.width > kSideMax_px || m.height > kSideMax_px)
    return {{},
            "size: " + std::to_string(m.width) + " x " + std::to_string(m.height) + " px; each side must be " +
                std::to_string(kSideMin_px) + " to " + std::to_string(kSideMax_px) + " px",
            false};
  if (m.step < row_bytes) return {{}, too_short("step", m.step, row_bytes), false};
  const std::size_t needed = std::size_t{m.step} * (m.height - 1) + row_bytes;
  if (m.data == nullptr || m.size < needed)
    return {{}, too_short("data", m.data == nullptr ? 0 : m.size, needed), false};
  constexpr bool kIsBigEndianHere = std::endian::native == std::endian::big;
  if (*format == PixelFormat::kGrey16 && m.is_bigendian != kIsBigEndianHere)
    return {
        {}, "is_bigendian: 16-bit pixels in the other byte order; set the driver to this machine's, or to mono8", true};
  const ImageView view{m.data, static_cast<int>(m.width), static_cast<int>(m.height),
                       static_cast<std::ptrdiff_t>(m.step), *format};
  if (const auto fault = fault_of(view); !fault.empty()) return {{}, std::string(fault), false};
  return {view, "", false};
}

}  // namespace adit::node
