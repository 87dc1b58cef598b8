// SPDX-License-Identifier: Apache-2.0
#include "print/target.h"

#include <gtest/gtest.h>

#include <opencv2/aruco/charuco.hpp>
#include <random>

#include "base/error.h"
#include "fixtures/drawn.h"
#include "print/dictionary.h"
#include "print/target_xml.h"
#include "targets/pattern.h"

namespace handsight {
namespace {

Target read(const std::string& text) {
  const auto document = parse_xml(text, "session.xml");
  return read_target(require_root(*document, "session.xml", "target"));
}

const char* const samples[] = {
    R"(<target kind="chessboard" columns="9" rows="6" square="0.025"/>)",
    R"(<target kind="charuco" columns="8" rows="6" square="0.03" marker="0.022" dictionary="DICT_5X5_100" sigma="1e-4"/>)",
    R"(<target kind="charuco" columns="7" rows="6" square="0.03" marker="0.022" dictionary="DICT_4X4_50" layout="old" first_id="4"/>)",
    R"(<target kind="aprilgrid" columns="6" rows="4" tag="0.088" spacing="0.3"/>)",
    R"(<target kind="tags" dictionary="DICT_APRILTAG_36h11" size="0.05" ids="3 7 9" sigma="free"/>)",
    R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.05" sigma="1e-3"><tag id="4"/><tag id="2" xyz="0.1 0 0.3" rpy="0 1.5 0.1" size="0.04" sigma="0"/><tag id="9" rpy="0.1 0.2 0.3" sigma_angle="0.02"/></target>)",
    R"(<target kind="tags" dictionary="DICT_4X4_50" sigma="free"><tag id="4" size="0.03"/><tag id="2" xyz="0.1 0 0.3" size="0.04"/></target>)",
    R"(<target kind="grid" columns="5" rows="7" marker="0.04" separation="0.013" dictionary="DICT_6X6_250" first_id="3" sigma="2e-4"/>)"};

TEST(TargetXml, ReadsBackBitForBit) {
  for (const char* text : samples) {
    const Target target = read(text);
    tinyxml2::XMLDocument document;
    auto* element = document.NewElement("target");
    document.InsertEndChild(element);
    write_target(*element, target);
    const Target again = read(xml_text(document));
    EXPECT_EQ(target_words(again), target_words(target)) << text;
    EXPECT_EQ(again.sigma, target.sigma);
    EXPECT_EQ(again.tag, target.tag);
    EXPECT_EQ(again.ids, target.ids);
    ASSERT_EQ(again.places.size(), target.places.size()) << text;
    for (std::size_t k = 0; k < target.places.size(); ++k) {
      EXPECT_EQ(again.places[k].xyz, target.places[k].xyz) << text;
      EXPECT_EQ(again.places[k].rpy, target.places[k].rpy) << text;
      EXPECT_EQ(again.places[k].size, target.places[k].size) << text;
      EXPECT_EQ(again.places[k].sigma, target.places[k].sigma) << text;
      EXPECT_EQ(again.places[k].sigma_angle, target.places[k].sigma_angle) << text;
    }
  }
}

TEST(TargetXml, TagsOfABodyLieWhereTheyAreSaidTo) {
  const Target body = read(samples[5]);
  ASSERT_EQ(body.ids, (std::vector<int>{4, 2, 9}));
  EXPECT_TRUE(has_places(body));
  EXPECT_EQ(body.places[0].size, 0.05);
  EXPECT_EQ(body.places[0].sigma, 1e-3) << "the target's";
  EXPECT_NEAR(body.places[0].sigma_angle, 1e-3 / (0.025 * std::sqrt(2)), 1e-12) << "a corner moves by the sigma";
  EXPECT_EQ(body.places[1].sigma, 0) << "its own";
  EXPECT_EQ(body.places[2].sigma_angle, 0.02);
  const auto points = target_points(body);
  ASSERT_EQ(points.size(), 12u);
  EXPECT_LT((points[0].position - Vector3(-0.025, -0.025, 0)).norm(), 1e-15) << "x right, y down: the top left corner";
  const Rigid place{rotation_from_rpy({0, 1.5, 0.1}), {0.1, 0, 0.3}};
  EXPECT_LT((points[6].position - place * Vector3(0.02, 0.02, 0)).norm(), 1e-15) << "the second tag's bottom right";
  for (const TargetPoint& point : points) EXPECT_EQ(point.piece, 0) << "one rigid body";
  const auto apart = target_points(read(samples[6]));
  EXPECT_EQ(apart.back().piece, 1) << "places that are free are not known";
}

TEST(TargetXml, KalibrsGridHasItsDefaults) {
  const Target grid = read(samples[3]);
  EXPECT_EQ(grid.dictionary, "tag36h11");
  EXPECT_EQ(grid.border, 2);
  EXPECT_EQ(point_count(grid), 96);
}

TEST(TargetXml, RefusesInOneSentence) {
  const std::pair<const char*, const char*> wrong[] = {
      {R"(<target columns="9"/>)", "kind"},
      {R"(<target kind="circles" columns="9"/>)", "circles"},
      {R"(<target kind="chessboard" columns="9" rows="6"/>)", "square"},
      {R"(<target kind="chessboard" columns="nine" rows="6" square="0.02"/>)", "nine"},
      {R"(<target kind="chessboard" columns="9" rows="6" square="nan"/>)", "nan"},
      {R"(<target kind="chessboard" columns="9" rows="6" square="-0.02"/>)", "-0.02"},
      {R"(<target kind="chessboard" columns="100" rows="100" square="0.02"/>)", "4096"},
      {R"(<target kind="chessboard" columns="2147483647" rows="2" square="0.02"/>)", "2147483647"},
      {R"(<target kind="charuco" columns="8" rows="6" square="0.03" marker="0.04" dictionary="DICT_5X5_100"/>)",
       "0.04"},
      {R"(<target kind="charuco" columns="8" rows="6" square="0.03" marker="0.02" dictionary="DICT_9X9"/>)",
       "DICT_9X9"},
      {R"(<target kind="charuco" columns="20" rows="20" square="0.03" marker="0.02" dictionary="DICT_5X5_50"/>)", "50"},
      {R"(<target kind="aprilgrid" columns="6" rows="4" tag="0.03" spacing="0"/>)", "spacing"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.05" ids=""/>)", "ids"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.05" ids="3 3"/>)", "twice"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.05" ids="50"/>)", "50"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.05" ids="3" sigma="2"/>)", "sigma"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50"><tag id="3"/></target>)", "size"},
      {R"(<target kind="tags" size="0.1"><tag id="3"/></target>)", "dictionary"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.1" ids="3"><tag id="3"/></target>)", "one of the two"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.1"><tag id="3"/><tag id="4"/></target>)", "same place"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.1"><tag id="3"/><tag id="3" xyz="1 0 0"/></target>)",
       "twice"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.1"><tag xyz="1 0 0"/></target>)", "id"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.1"><tag id="1" xyz="1 0"/></target>)", "3"},
      {R"(<target kind="tags" dictionary="DICT_4X4_50" size="0.1"><tag id="1" sigma="-1"/></target>)", "-1"},
      {R"(<target kind="grid" columns="3" rows="4" marker="0.04" dictionary="DICT_4X4_50"/>)", "separation"},
      {R"(<target kind="grid" columns="0" rows="4" marker="0.04" separation="0.01" dictionary="DICT_4X4_50"/>)", "0"},
      {R"(<target kind="grid" columns="30000" rows="40000" marker="0.04" separation="0.01" dictionary="DICT_4X4_50"/>)",
       "30000"},
  };
  for (const auto& [text, named] : wrong) {
    try {
      read(text);
      FAIL() << "taken: " << text;
    } catch (const InputError& error) {
      const std::string sentence = error.what();
      EXPECT_NE(sentence.find(named), std::string::npos) << sentence;
      EXPECT_NE(sentence.find("session.xml, line 1"), std::string::npos) << sentence;
      EXPECT_GE(sentence.size(), 20u);
      EXPECT_LE(sentence.size(), 600u);
    }
  }
}

/// OpenCV 4.6 draws the same ChArUco board, square for square and module for module.
TEST(Pattern, CharucoIsOpenCVs) {
  for (const int rows : {5, 6}) {
    Target target{.kind = TargetKind::charuco,
                  .columns = 7,
                  .rows = rows,
                  .square = 0.04,
                  .tag = 0.03,
                  .dictionary = "DICT_4X4_50"};
    const auto board = cv::aruco::CharucoBoard::create(7, rows, 0.04f, 0.03f,
                                                       cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50));
    cv::Mat drawn;
    board->draw({7 * 80, rows * 80}, drawn, 0, 1);
    const BlackAt black_at(target);
    for (int v = 5; v < drawn.rows; v += 10)  // centres of modules and squares: 10 px a module
      for (int u = 5; u < drawn.cols; u += 10)
        EXPECT_EQ(black_at((u + 0.5) / 80 * 0.04, (v + 0.5) / 80 * 0.04), drawn.at<unsigned char>(v, u) < 128)
            << u << " " << v;
  }
}

/// OpenCV 4.6 draws the same grid board, module for module, and has its corners at the same places but for its y, which
/// runs up.
TEST(Pattern, AnArucoGridIsOpenCVs) {
  const Target grid = read(
      R"(<target kind="grid" columns="4" rows="3" marker="0.03" separation="0.01" dictionary="DICT_4X4_50" first_id="5"/>)");
  const auto board =
      cv::aruco::GridBoard::create(4, 3, 0.03f, 0.01f, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), 5);
  EXPECT_EQ(grid.ids, board->ids);
  const auto points = target_points(grid);
  const double height = 3 * 0.03 + 2 * 0.01;
  const double top = board->objPoints[0][0].y;  // 0 or the height of the board, by OpenCV's version
  for (std::size_t k = 0; k < board->ids.size(); ++k)
    for (std::size_t i = 0; i < 4; ++i) {
      const cv::Point3f& corner = board->objPoints[k][i];
      const Vector3 expected(corner.x, top > 0.5 * height ? top - corner.y : corner.y, 0);
      EXPECT_LT((points[4 * k + i].position - expected).norm(), 1e-7) << k << " " << i;
    }
  cv::Mat drawn;
  board->draw({(4 * 4 - 1) * 60, (3 * 4 - 1) * 60}, drawn, 0, 1);  // 6 modules of 30 px a tag, 60 px apart
  int black = 0;
  for (std::size_t k = 0; k < grid.places.size(); ++k) {
    const BlackAt black_at(grid, static_cast<int>(k));
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column) {
        const Vector2 in_tag((column + 0.5) * 0.005 - 0.015, (row + 0.5) * 0.005 - 0.015);
        const Vector2 pixel = (in_tag + grid.places[k].xyz.head<2>()) / 0.01 * 60;
        const bool is_black = drawn.at<unsigned char>(static_cast<int>(pixel.y()), static_cast<int>(pixel.x())) < 128;
        EXPECT_EQ(black_at(in_tag.x(), in_tag.y()), is_black) << k << " " << row << " " << column;
        black += is_black;
      }
  }
  EXPECT_GT(black, 12 * 20) << "the borders at least";
}

/// With an even number of rows boards from before OpenCV 4.6 begin with a white square, which then holds the first tag.
TEST(Pattern, OldCharucoBeginsWhite) {
  Target target{.kind = TargetKind::charuco,
                .columns = 7,
                .rows = 6,
                .square = 0.04,
                .tag = 0.03,
                .dictionary = "DICT_4X4_50",
                .old_layout = true};
  EXPECT_FALSE(BlackAt(target)(0.002, 0.002));
  EXPECT_LT(placed_tags(target)[0].top_left.x(), 0.04);
  target.rows = 5;
  EXPECT_TRUE(BlackAt(target)(0.002, 0.002));
}

/// AprilTag's own tag36h11 number 5 (apriltag_to_image of libapriltag 3.3); OpenCV has it upside down.
TEST(Dictionary, AprilTagsStandAsAprilTagDrawsThem) {
  const char* rows[] = {"########", "#....###", "#..###.#", "#..#..##", "#.#.#..#", "###...##", "#.#..###", "########"};
  const TagPattern own = tag_pattern(*find_dictionary("tag36h11"), 5, 1),
                   opencv = tag_pattern(*find_dictionary("DICT_APRILTAG_36h11"), 5, 1);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      EXPECT_EQ(own.is_white(column, row), rows[row][column] == '.');
      EXPECT_EQ(opencv.is_white(7 - column, 7 - row), own.is_white(column, row));
    }
  EXPECT_EQ(turned(own, 2).white, opencv.white);
}

/// What is printed is what images are compared with.
TEST(Pattern, BoxesAndPlacesAgree) {
  std::mt19937 random(5);
  for (const char* text : samples) {
    const Target target = read(text);
    const PrintedPattern pattern = pattern_of(target);
    const BlackAt black_at(target);
    double area = 0;
    for (const Box& box : pattern.black) area += box.size.prod();
    EXPECT_LT(area, pattern.outline.size.prod());
    for (int i = 0; i < 4000; ++i) {
      std::uniform_real_distribution<double> share(-0.05, 1.05);
      const Vector2 place =
          pattern.outline.top_left + fixture::drawn_2([&] { return share(random); }).cwiseProduct(pattern.outline.size);
      int boxes = 0;
      for (const Box& box : pattern.black) {
        const Vector2 in = place - box.top_left;
        boxes += in.x() >= 0 && in.y() >= 0 && in.x() < box.size.x() && in.y() < box.size.y();
      }
      ASSERT_LE(boxes, 1) << text;  // they do not overlap
      EXPECT_EQ(black_at(place.x(), place.y()), boxes == 1) << text << " at " << place.transpose();
    }
  }
}

/// Kalibr: number 0 at the bottom left, then to the right, then up.
TEST(Target, GridNumbersRunFromTheBottomLeft) {
  const Target grid = read(samples[3]);
  const auto tags = placed_tags(grid);
  EXPECT_EQ(tags[0].top_left.x(), 0);
  EXPECT_GT(tags[0].top_left.y(), tags[6].top_left.y());
  EXPECT_GT(tags[1].top_left.x(), tags[0].top_left.x());
  EXPECT_NEAR(tags[18].top_left.y(), 0, 1e-12);
}

}  // namespace
}  // namespace handsight
