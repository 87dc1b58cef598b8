// SPDX-License-Identifier: Apache-2.0
#include "targets/sheet.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "fixtures/tag_bodies.h"
#include "targets/target_detection.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

const Target all[] = {
    {.kind = TargetKind::chessboard, .columns = 9, .rows = 6, .square = 0.018},
    {.kind = TargetKind::charuco, .columns = 8, .rows = 6, .square = 0.02, .tag = 0.015, .dictionary = "DICT_5X5_100"},
    {.kind = TargetKind::aprilgrid,
     .columns = 5,
     .rows = 4,
     .tag = 0.025,
     .spacing = 0.3,
     .dictionary = "tag36h11",
     .border = 2},
    {.kind = TargetKind::tags, .tag = 0.04, .dictionary = "DICT_4X4_50", .ids = {3, 7, 9, 11}},
    fixture::tag_grid()};

class SheetFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("handsight_sheet_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

/// Every corner where the sheet has it, within `most` m.
void expect_geometry(const Target& target, const Sheet& sheet, const Image& image, double dots_per_inch, double most) {
  const TargetSighting sighting = detect_target(image, prepare(target));
  const auto points = printed_points(target);
  ASSERT_EQ(sighting.points.size(), points.size()) << display_name(target.kind) << ": " << sighting.reason;
  for (const TargetPixel& seen : sighting.points) {
    const TargetPoint& point = points[static_cast<std::size_t>(seen.number)];
    const Vector2 expected = sheet.piece_origins[static_cast<std::size_t>(point.piece)] + point.position.head<2>();
    const Vector2 metres = (seen.pixel + Vector2::Constant(0.5)) / dots_per_inch * 0.0254;
    EXPECT_LT((metres - expected).norm(), most) << display_name(target.kind) << " point " << seen.number;
  }
}

TEST_F(SheetFiles, PdfIsTrueToScale) {
  if (std::system("pdftoppm -v >/dev/null 2>&1") != 0) GTEST_SKIP() << "pdftoppm (poppler-utils) is not installed";
  for (const Target& target : all) {
    const Sheet sheet = make_sheet(target);
    const fs::path pdf = folder_ / "board.pdf", page = folder_ / "page";
    replace_file(pdf, pdf_text(sheet));
    ASSERT_EQ(std::system(("pdftoppm -r 150 -gray -singlefile '" + pdf.string() + "' '" + page.string() + "'").c_str()),
              0);
    expect_geometry(target, sheet, read_image(page.string() + ".pgm"), 150,
                    0.05e-3);  // edges are drawn to a quarter of a dot
  }
}

TEST_F(SheetFiles, PdfSaysWhatItIs) {
  if (std::system("pdftotext -v >/dev/null 2>&1") != 0) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  replace_file(folder_ / "board.pdf", pdf_text(make_sheet(all[1])));
  ASSERT_EQ(std::system(("pdftotext -layout '" + (folder_ / "board.pdf").string() + "'").c_str()), 0);
  const std::string text = read_file(folder_ / "board.txt");
  for (const char* word :
       {"ChArUco", "8 x 6", "20 mm", "DICT_5X5_100", "kind=\"charuco\"", "marker=\"0.015\"", "100 mm"})
    EXPECT_NE(text.find(word), std::string::npos) << word << " in:\n" << text;
}

TEST_F(SheetFiles, PngIsTrueToScaleAndSaysItsDots) {
  for (const Target& target : all) {
    const Sheet sheet = make_sheet(target);
    const std::string bytes = png_bytes(sheet, 127);  // 5000 dots a metre exactly
    EXPECT_NE(bytes.find(std::string("pHYs\0\0\x13\x88\0\0\x13\x88\1", 13)), std::string::npos);
    replace_file(folder_ / "board.png", bytes);
    expect_geometry(target, sheet, read_image(folder_ / "board.png"), 127, 0.02e-3);  // a tenth of a dot
  }
}

/// The ruler: 101 ticks a millimetre apart, below the target, inside the sheet.
TEST(Sheet, RulerIsAMillimetreATick) {
  for (const Target& target : all) {
    const Sheet sheet = make_sheet(target);
    std::vector<double> ticks;
    for (const Box& box : sheet.black)
      if (box.size.x() < 0.3e-3) ticks.push_back(box.top_left.x() + 0.5 * box.size.x());
    ASSERT_EQ(ticks.size(), 101u);
    for (std::size_t i = 0; i < ticks.size(); ++i)
      EXPECT_NEAR(ticks[i] - ticks[0], 1e-3 * static_cast<double>(i), 1e-9);
    for (const Box& box : sheet.black) {
      EXPECT_GE(box.top_left.minCoeff(), 0.009);
      EXPECT_LE(box.top_left.x() + box.size.x(), sheet.width - 0.009);
      EXPECT_LE(box.top_left.y() + box.size.y(), sheet.height);
    }
  }
}

TEST(Sheet, TakesTheSmallestPaper) {
  EXPECT_EQ(make_sheet(all[0]).paper, "A4");
  Target large = all[0];
  large.square = 0.035;
  EXPECT_EQ(make_sheet(large).paper, "A3 landscape");
  large.square = 0.5;
  EXPECT_EQ(make_sheet(large).paper, "own size");
}

TEST(Sheet, TooManyDotsAreRefused) {
  Target large = all[0];
  large.square = 0.5;
  EXPECT_THROW(png_bytes(make_sheet(large), 600), InputError);
}

}  // namespace
}  // namespace handsight
