// SPDX-License-Identifier: Apache-2.0
#include "vision/image/image_file.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "base/error.h"
#include "base/files.h"
#include "temporary_folder.h"
#include "vision/image/image_header.h"

namespace handsight {
namespace {

using testing::HasSubstr;

Image pattern(int width, int height) {
  Image image(width, height);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      image.row(v)[u] =
          static_cast<std::uint8_t>(128 + 60 * std::sin(0.31 * u) * std::cos(0.23 * v) + (u * 7 + v * 13) % 11);
  return image;
}

std::string encoded(const std::string& extension, const cv::Mat& picture) {
  std::vector<std::uint8_t> bytes;
  EXPECT_TRUE(cv::imencode(extension, picture, bytes));
  return {bytes.begin(), bytes.end()};
}

cv::Mat as_mat(const Image& image) {
  return cv::Mat(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data())).clone();
}

void write(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string refusal(const std::filesystem::path& file) {
  try {
    read_image(file);
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    EXPECT_GE(sentence.size(), 20u);
    EXPECT_LE(sentence.size(), 600u);
    return sentence;
  }
  return "";
}

/// A JPEG with an EXIF block put behind its start: orientation 6 (turned by 90 degrees) and a thumbnail's end marker.
std::string with_exif(const std::string& jpeg) {
  std::string exif("Exif\0\0II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0", 32);
  exif += "\xff\xd8 thumbnail \xff\xd9";
  const std::size_t length = exif.size() + 2;
  const std::string block =
      std::string("\xff\xe1") + static_cast<char>(length >> 8) + static_cast<char>(length & 255) + exif;
  return jpeg.substr(0, 2) + block + jpeg.substr(2);
}

TEST(ImageFile, PngReadsBackAsWritten) {
  const TemporaryFolder folder;
  const Image image = pattern(61, 47);
  write_png(image, folder.path / "a.png");
  const Image read = read_image(folder.path / "a.png");
  EXPECT_EQ(read.width, 61);
  EXPECT_EQ(read.height, 47);
  EXPECT_EQ(read.pixels, image.pixels);
  write_png(pattern(20, 10), folder.path / "a.png");  // replaces
  EXPECT_EQ(read_image(folder.path / "a.png").width, 20);
  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path)) ++files;
  EXPECT_EQ(files, 1);  // no temporary file is left
  EXPECT_THROW(write_png(image, folder.path / "none" / "a.png"), InputError);
}

TEST(ImageFile, ReadsTheUsualFormats) {
  const TemporaryFolder folder;
  const Image image = pattern(61, 47);
  for (const std::string extension : {".png", ".pgm", ".bmp", ".tiff", ".jpg", ".webp"}) {
    const auto file = folder.path / ("a" + extension);
    write(file, encoded(extension, as_mat(image)));
    const auto reported = image_size(read_file(file));
    ASSERT_TRUE(reported && reported->width == 61 && reported->height == 47) << extension;
    const Image read = read_image(file);
    ASSERT_EQ(read.width, 61) << extension;
    ASSERT_EQ(read.height, 47) << extension;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      ASSERT_NEAR(read.pixels[i], image.pixels[i], extension == ".jpg" || extension == ".webp" ? 12 : 0) << extension;
  }
}

TEST(ImageFile, ColoursAreWeighedAsInTheThesis) {
  const TemporaryFolder folder;
  cv::Mat colours(1, 4, CV_8UC3);
  colours.at<cv::Vec3b>(0, 0) = {255, 0, 0};  // blue, green, red
  colours.at<cv::Vec3b>(0, 1) = {0, 255, 0};
  colours.at<cv::Vec3b>(0, 2) = {0, 0, 255};
  colours.at<cv::Vec3b>(0, 3) = {10, 200, 90};
  write(folder.path / "c.png", encoded(".png", colours));
  const Image read = read_image(folder.path / "c.png");
  EXPECT_NEAR(read.pixels[0], 0.114 * 255, 0.51);
  EXPECT_NEAR(read.pixels[1], 0.587 * 255, 0.51);
  EXPECT_NEAR(read.pixels[2], 0.299 * 255, 0.51);
  EXPECT_NEAR(read.pixels[3], 0.114 * 10 + 0.587 * 200 + 0.299 * 90, 0.51);
}

TEST(ImageFile, SixteenBitsAreScaled) {
  const TemporaryFolder folder;
  cv::Mat deep(1, 3, CV_16U);
  deep.at<std::uint16_t>(0, 0) = 0;
  deep.at<std::uint16_t>(0, 1) = 257 * 100;
  deep.at<std::uint16_t>(0, 2) = 65535;
  write(folder.path / "d.png", encoded(".png", deep));
  EXPECT_EQ(read_image(folder.path / "d.png").pixels, (std::vector<std::uint8_t>{0, 100, 255}));
}

/// A camera of 12 bits in a file of 16 gives the image that 8 bits give, at every depth that cameras have.
TEST(ImageFile, BitsThatAreNotUsedDoNotMakeItDark) {
  const TemporaryFolder folder;
  Image image = pattern(61, 47);
  image.pixels[100] = 255;
  for (const int bits : {8, 10, 12, 14, 16})
    for (const std::string extension : {".png", ".tiff", ".pgm"}) {
      cv::Mat deep;
      as_mat(image).convertTo(deep, CV_16U, ((1 << bits) - 1) / 255.0);
      write(folder.path / ("d" + extension), encoded(extension, deep));
      const Image read = read_image(folder.path / ("d" + extension));
      for (std::size_t i = 0; i < image.pixels.size(); ++i)
        ASSERT_NEAR(read.pixels[i], image.pixels[i], 1) << bits << extension;
    }
}

/// The three kinds of WebP, whose sizes stand in different places.
TEST(ImageFile, WebPOfEveryKindTellsItsSize) {
  const cv::Mat grey = as_mat(pattern(61, 47));
  cv::Mat colours, clear;
  cv::cvtColor(grey, colours, cv::COLOR_GRAY2BGR);
  cv::cvtColor(grey, clear, cv::COLOR_GRAY2BGRA);
  clear.at<cv::Vec4b>(3, 3)[3] = 10;
  std::set<std::string> kinds;
  for (const int quality : {50, 101})
    for (const cv::Mat& picture : {colours, clear}) {
      std::vector<std::uint8_t> bytes;
      ASSERT_TRUE(cv::imencode(".webp", picture, bytes, {cv::IMWRITE_WEBP_QUALITY, quality}));
      const std::string text(bytes.begin(), bytes.end());
      kinds.insert(text.substr(12, 4));
      const auto reported = image_size(text);
      ASSERT_TRUE(reported) << text.substr(12, 4);
      EXPECT_EQ(reported->width, 61);
      EXPECT_EQ(reported->height, 47);
      EXPECT_FALSE(is_cut_off(text));
      EXPECT_TRUE(is_cut_off(text.substr(0, text.size() - 20)));
    }
  EXPECT_GE(kinds.size(), 2u);
}

TEST(ImageFile, PixelsStayWhereTheSensorHadThem) {
  const TemporaryFolder folder;
  const std::string jpeg = encoded(".jpg", as_mat(pattern(61, 47)));
  write(folder.path / "plain.jpg", jpeg);
  write(folder.path / "turned.jpg", with_exif(jpeg));
  const Image plain = read_image(folder.path / "plain.jpg"), turned = read_image(folder.path / "turned.jpg");
  EXPECT_EQ(turned.width, 61);  // camera numbers hold for the sensor, not for how people hold the camera
  EXPECT_EQ(turned.pixels, plain.pixels);
}

TEST(ImageFile, RefusesWhatIsCutOff) {
  const TemporaryFolder folder;
  const cv::Mat picture = as_mat(pattern(161, 147));
  for (const std::string extension : {".png", ".jpg", ".pgm", ".bmp", ".tiff", ".webp"}) {
    const std::string whole = encoded(extension, picture);
    const auto file = folder.path / ("cut" + extension);
    for (const double share : {0.02, 0.3, 0.6, 0.9, 0.97}) {
      write(file, whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
      EXPECT_THAT(refusal(file), HasSubstr("cut" + extension)) << "at " << share;
    }
    write(file, whole.substr(0, whole.size() - 1));
    if (extension != ".tiff") {  // whose last byte need not be of the picture
      EXPECT_THAT(refusal(file), HasSubstr("cut" + extension)) << "the last byte";
    }
  }
  const std::string jpeg = with_exif(encoded(".jpg", picture));
  write(folder.path / "cut.jpg", jpeg.substr(0, jpeg.size() / 2));
  EXPECT_THAT(refusal(folder.path / "cut.jpg"), HasSubstr("cut.jpg")) << "the thumbnail's end is not the image's";
}

TEST(ImageFile, RefusesDamagedPng) {
  const TemporaryFolder folder;
  std::string bytes = encoded(".png", as_mat(pattern(161, 147)));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
  write(folder.path / "bad.png", bytes);
  EXPECT_THAT(refusal(folder.path / "bad.png"), HasSubstr("bad.png"));
}

TEST(ImageFile, RefusesMissingAndForeignFiles) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.path / "none.png"), HasSubstr("none.png"));
  write(folder.path / "empty.png", "");
  EXPECT_THAT(refusal(folder.path / "empty.png"), HasSubstr("empty.png"));
  write(folder.path / "text.png", "this is no image, whatever its name says");
  EXPECT_THAT(refusal(folder.path / "text.png"), HasSubstr("text.png"));
  EXPECT_THAT(refusal(folder.path), HasSubstr(folder.path.filename().string()));
}

TEST(ImageFile, SaysWhereSizeAndCameraDiffer) {
  Camera camera;
  camera.width = 640;
  camera.height = 480;
  EXPECT_NO_THROW(check_image_size(Image(640, 480), camera, "left.png"));
  try {
    check_image_size(Image(320, 240), camera, "left.png");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("left.png"));
    EXPECT_THAT(error.what(), HasSubstr("320"));
    EXPECT_THAT(error.what(), HasSubstr("640"));
  }
}

TEST(ImageHeader, TellsTheSizeOfEveryKind) {
  const cv::Mat picture = as_mat(pattern(37, 23));
  for (const char* extension : {".png", ".jpg", ".pgm", ".bmp", ".tiff"}) {
    const std::string bytes = encoded(extension, picture);
    const auto size = image_size(bytes);
    ASSERT_TRUE(size) << extension;
    EXPECT_EQ(size->width, 37) << extension;
    EXPECT_EQ(size->height, 23) << extension;
    for (std::size_t end = 0; end < std::min<std::size_t>(bytes.size(), 400); ++end) image_size(bytes.substr(0, end));
  }
  EXPECT_FALSE(image_size(""));
  EXPECT_FALSE(image_size("hello"));
  EXPECT_FALSE(image_size("P5\n0 4\n255\n"));
}

TEST(ImageFile, IsNotDecodedWhereItsHeaderIsEnough) {
  const TemporaryFolder folder;
  std::string bytes = encoded(".png", as_mat(pattern(32, 24)));
  bytes[16] = 0;
  bytes[17] = 1;  // 65568 px wide, as it says
  bytes[21] = 1;
  write(folder.path / "large.png", bytes);
  EXPECT_THAT(refusal(folder.path / "large.png"), HasSubstr("65568 x 65560 pixels; at most 64 million are read"));
  write(folder.path / "good.png", encoded(".png", as_mat(pattern(32, 24))));
  Camera camera{.width = 30, .height = 24};
  EXPECT_THROW(read_image(folder.path / "good.png", camera, "good.png"), InputError);
  camera.width = 32;
  EXPECT_EQ(read_image(folder.path / "good.png", camera, "good.png").width, 32);
}

TEST(ImageFile, BrokenFilesPrintNothing) {
  const TemporaryFolder folder;
  std::string bytes = encoded(".png", as_mat(pattern(64, 48)));
  for (std::size_t i = 60; i < bytes.size() - 20; i += 7) bytes[i] = static_cast<char>(~bytes[i]);
  write(folder.path / "broken.png", bytes);
  testing::internal::CaptureStderr();
  refusal(folder.path / "broken.png");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace handsight
