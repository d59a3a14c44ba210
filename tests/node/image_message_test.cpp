#include "adit/node/image_message.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

namespace adit::node {
namespace {

struct Message {
  std::vector<std::uint8_t> bytes;
  ImageMessage m;
};

Message message(std::uint32_t width, std::uint32_t height, std::string_view encoding, std::uint32_t step) {
  Message made{std::vector<std::uint8_t>(std::size_t{step} * height), {}};
  made.m.width = width;
  made.m.height = height;
  made.m.encoding = encoding;
  made.m.step = step;
  made.m.is_bigendian = std::endian::native == std::endian::big;
  made.m.data = made.bytes.data();
  made.m.size = made.bytes.size();
  return made;
}

TEST(ImageMessageTest, EachKnownEncodingIsReadInPlace) {
  const struct {
    const char* encoding;
    PixelFormat format;
    std::uint32_t pixel_bytes;
  } cases[] = {{"mono8", PixelFormat::kGrey8, 1},   {"8UC1", PixelFormat::kGrey8, 1},
               {"bgr8", PixelFormat::kBgr8, 3},     {"8UC3", PixelFormat::kBgr8, 3},
               {"rgb8", PixelFormat::kRgb8, 3},     {"bgra8", PixelFormat::kBgra8, 4},
               {"8UC4", PixelFormat::kBgra8, 4},    {"rgba8", PixelFormat::kRgba8, 4},
               {"mono16", PixelFormat::kGrey16, 2}, {"16UC1", PixelFormat::kGrey16, 2}};
  for (const auto& c : cases) {
    const Message made = message(64, 48, c.encoding, 64 * c.pixel_bytes + 8);
    const ImageReading reading = view_of(made.m);
    EXPECT_EQ(reading.fault, "") << c.encoding;
    EXPECT_EQ(reading.view.data, made.bytes.data()) << c.encoding << ": copied";
    EXPECT_EQ(reading.view.format, c.format) << c.encoding;
    EXPECT_EQ(reading.view.width, 64);
    EXPECT_EQ(reading.view.height, 48);
    EXPECT_EQ(reading.view.stride_bytes, 64 * c.pixel_bytes + 8);
  }
}

TEST(ImageMessageTest, AnUnknownEncodingIsNamed) {
  const ImageReading reading = view_of(message(64, 48, "yuv422", 128).m);
  EXPECT_EQ(reading.view.data, nullptr);
  EXPECT_TRUE(reading.is_unknown_encoding);
  EXPECT_EQ(reading.fault,
            "encoding: 'yuv422' is not known; set the driver to mono8, mono16, bgr8, rgb8, bgra8 or rgba8");
  EXPECT_NE(view_of(message(64, 48, "bayer_rggb8", 64).m).fault.find("debayer"), std::string::npos);
  EXPECT_TRUE(view_of(message(64, 48, "", 64).m).is_unknown_encoding);
}

TEST(ImageMessageTest, AForeignWordStaysAWord) {
  const std::string fault = view_of(message(64, 48, "mono8\n" + std::string(5000, 'x'), 64).m).fault;
  EXPECT_EQ(fault.rfind("encoding: 'mono8?xxx", 0), 0u) << fault;
  EXPECT_LT(fault.size(), 200u) << "one line for the log";
}

TEST(ImageMessageTest, SixteenBitsOfTheOtherByteOrderAreRefused) {
  Message made = message(64, 48, "mono16", 128);
  made.m.is_bigendian = !made.m.is_bigendian;
  EXPECT_NE(view_of(made.m).fault.find("is_bigendian"), std::string::npos);
  made.m.encoding = "mono8";  // no byte order there
  EXPECT_EQ(view_of(made.m).fault, "");
}

TEST(ImageMessageTest, AMessageThatIsShorterThanItSaysIsNotRead) {
  Message made = message(64, 48, "bgr8", 192);
  made.m.size -= 1;
  EXPECT_EQ(view_of(made.m).fault, "data: 9215 bytes, but the frame needs 9216; the message is damaged");
  made.m.size += 1;
  made.m.step = 191;
  EXPECT_EQ(view_of(made.m).fault, "step: 191 bytes, but the frame needs 192; the message is damaged");
  made.m.step = 192;
  made.m.data = nullptr;
  EXPECT_NE(view_of(made.m).fault, "");
}

TEST(ImageMessageTest, TheLastRowNeedsNoPadding) {
  Message made = message(64, 48, "mono8", 80);
  made.m.size = 80 * 47 + 64;
  EXPECT_EQ(view_of(made.m).fault, "");
}

TEST(ImageMessageTest, SidesThatNoFrameHasAreRefusedBeforeAnythingIsMultiplied) {
  Message made = message(64, 48, "mono8", 64);
  for (const std::uint32_t side : {0u, 15u, 8193u, 0x80000000u, 0xffffffffu}) {
    ImageMessage m = made.m;
    m.width = side;
    EXPECT_NE(view_of(m).fault, "") << side;
    m = made.m;
    m.height = side;
    EXPECT_NE(view_of(m).fault, "") << side;
  }
}

}  // namespace
}  // namespace adit::node
