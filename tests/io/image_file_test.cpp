#include "adit/io/image_file.hpp"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "adit/io/errors.hpp"
#include "scratch_folder.hpp"

namespace {

using adit::io::InputError;
using adit::io::read_image;
using adit::testing::message_of;
using adit::testing::read_text;
using adit::testing::ScratchFolder;
using adit::testing::truncate_copy;
using adit::testing::write_text;

cv::Mat noise(int type, int width = 97, int height = 61) {
  cv::Mat image(height, width, type);
  cv::RNG(7).fill(image, cv::RNG::UNIFORM, 0, image.depth() == CV_16U ? 65535 : 255);
  return image;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

std::string save(const std::filesystem::path& path, const cv::Mat& image) {
  EXPECT_TRUE(cv::imwrite(path.string(), image));
  return path.string();
}

TEST(ImageFile, EveryKindComesAsItIs) {
  const ScratchFolder folder;
  for (const char* name : {"a.png", "a.bmp", "a.tif", "a.ppm", "a.PNG"}) {
    EXPECT_TRUE(same(read_image(save(folder / name, noise(CV_8UC3))), noise(CV_8UC3))) << name;
  }
  for (const char* name : {"g.png", "g.bmp", "g.tif", "g.pgm"}) {
    EXPECT_TRUE(same(read_image(save(folder / name, noise(CV_8UC1))), noise(CV_8UC1))) << name;
  }
  for (const char* name : {"d.png", "d.tif", "d.pgm"}) {
    EXPECT_TRUE(same(read_image(save(folder / name, noise(CV_16UC1))), noise(CV_16UC1))) << name;
  }
  EXPECT_TRUE(same(read_image(save(folder / "alpha.png", noise(CV_8UC4))), noise(CV_8UC4)));
}

TEST(ImageFile, SixteenBitColourComesAsEightBit) {
  const ScratchFolder folder;
  cv::Mat deep(20, 20, CV_16UC3, cv::Scalar(0, 257, 65535));
  const cv::Mat read = read_image(save(folder / "deep.png", deep));
  EXPECT_TRUE(same(read, cv::Mat(20, 20, CV_8UC3, cv::Scalar(0, 1, 255))));
}

TEST(ImageFile, JpegHasThePixelsThatOpenCvReads) {
  const ScratchFolder folder;
  for (const int type : {CV_8UC1, CV_8UC3}) {
    for (const int progressive : {0, 1}) {
      const auto path = folder / "a.jpg";
      ASSERT_TRUE(cv::imwrite(path.string(), noise(type), {cv::IMWRITE_JPEG_PROGRESSIVE, progressive}));
      EXPECT_TRUE(same(read_image(path), cv::imread(path.string(), cv::IMREAD_UNCHANGED))) << type;
    }
  }
}

TEST(ImageFile, TurnedByExifIsNotTurned) {
  const ScratchFolder folder;
  const std::string jpeg = read_text(save(folder / "a.jpg", noise(CV_8UC3, 40, 20)));
  // Big-endian TIFF with one entry: orientation (0x0112) = 6, a quarter turn.
  const std::string exif(
      "\xff\xe1\x00\x22"
      "Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
      36);
  const auto turned = write_text(folder / "turned.jpg", jpeg.substr(0, 2) + exif + jpeg.substr(2));
  ASSERT_EQ(cv::imread(turned.string()).size(), cv::Size(20, 40)) << "the test's file is not turned";
  EXPECT_EQ(read_image(turned).size(), cv::Size(40, 20));
}

TEST(ImageFile, TruncatedAnywhereIsRefused) {
  const ScratchFolder folder;
  for (const char* name : {"a.jpg", "a.png", "a.bmp", "a.tif", "a.ppm", "a.pgm"}) {
    const auto whole = save(folder / name, noise(std::string(name) == "a.pgm" ? CV_16UC1 : CV_8UC3));
    for (const double share : {0.001, 0.02, 0.3, 0.6, 0.95, 0.9999}) {
      const auto cut = truncate_copy(whole, folder / (std::string("cut-") + name), share);
      const std::string why = message_of<InputError>([&] { (void)read_image(cut); });
      EXPECT_TRUE(why.starts_with(cut.string() + ": ")) << name << " " << share << " " << why;
    }
  }
}

TEST(ImageFile, ProgressiveJpegThatEndsEarlyIsRefused) {
  const ScratchFolder folder;
  const auto whole = folder / "a.jpg";
  ASSERT_TRUE(cv::imwrite(whole.string(), noise(CV_8UC3), {cv::IMWRITE_JPEG_PROGRESSIVE, 1}));
  const auto cut = truncate_copy(whole, folder / "cut.jpg", 0.7);
  EXPECT_NE(message_of<InputError>([&] { (void)read_image(cut); }).find("truncated"), std::string::npos);
}

TEST(ImageFile, DamagedPngIsRefused) {
  const ScratchFolder folder;
  std::string png = read_text(save(folder / "a.png", noise(CV_8UC3)));
  png[png.size() / 2] = static_cast<char>(png[png.size() / 2] ^ 0x10);
  const auto bad = write_text(folder / "bad.png", png);
  EXPECT_NE(message_of<InputError>([&] { (void)read_image(bad); }).find("checksum"), std::string::npos);
}

TEST(ImageFile, EachFaultHasItsReason) {
  const ScratchFolder folder;
  const auto why = [](const std::filesystem::path& path) {
    return message_of<InputError>([&] { (void)read_image(path); });
  };
  EXPECT_EQ(why(folder / "none.png"), (folder / "none.png").string() + ": no such file");
  EXPECT_EQ(why(folder.path()), folder.path().string() + ": is a folder, not a file");
  EXPECT_EQ(why(write_text(folder / "e.png", "")), (folder / "e.png").string() + ": the file is empty");
  EXPECT_NE(why(write_text(folder / "t.png", "no picture at all")), "");
  cv::Mat real(20, 20, CV_32FC1, cv::Scalar(0.5));
  EXPECT_NE(why(save(folder / "f.tif", real)).find("neither 8-bit"), std::string::npos);
}

TEST(ImageFile, ViewWrapsWithoutCopy) {
  cv::Mat whole = noise(CV_8UC3);
  const cv::Mat part = whole(cv::Rect(3, 5, 40, 30));
  const adit::ImageView view = adit::io::view_of(part);
  EXPECT_EQ(view.data, part.data);
  EXPECT_EQ(view.width, 40);
  EXPECT_EQ(view.height, 30);
  EXPECT_EQ(view.stride_bytes, 97 * 3);
  EXPECT_EQ(view.format, adit::PixelFormat::kBgr8);
  EXPECT_EQ(adit::io::view_of(noise(CV_16UC1)).format, adit::PixelFormat::kGrey16);
  EXPECT_EQ(adit::io::view_of(cv::Mat(9, 9, CV_32FC1)).data, nullptr);
}

}  // namespace
