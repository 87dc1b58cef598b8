// SPDX-License-Identifier: Apache-2.0
// A target that is described wrongly is found out: by what the images show in its place.
#include "targets/target_guess.h"

#include <gtest/gtest.h>

#include "board_targets.h"
#include "fixtures/target_images.h"
#include "print/target_xml.h"
#include "targets/drawn_over.h"
#include "targets/tag_survey.h"
#include "targets/target_detection.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

using fixtures::TargetView;

Camera guess_camera() {
  return {.width = 640, .height = 480, .fx = 620, .fy = 622, .cx = 322, .cy = 236, .k1 = -0.18, .k2 = 0.06};
}

std::vector<Image> list_images(const Target& target) {
  static const auto rays = fixtures::fine_rays(guess_camera());
  const PrintedPattern pattern = pattern_of(target);
  const Vector2 centre = pattern.outline.top_left + 0.5 * pattern.outline.size;
  std::vector<Image> images;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.5, 0.2}, {-0.3, 0.5}}) {
    TargetView view;
    view.camera = guess_camera();
    view.camera_from_target.rotation = rotation_from_vector<double>(Vector3(x, y, 0.2));
    view.camera_from_target.translation =
        Vector3(0, 0, 0.5) - view.camera_from_target.rotation * Vector3(centre.x(), centre.y(), 0);
    images.push_back(make_image(target, view, rays));
  }
  return images;
}

using fixture::charuco;
using fixture::chessboard;
using fixture::grid;

struct Mistake {
  Target real;
  std::string fits;  // what the sentence has to say
};

TEST(TargetGuess, NamesWhatFits) {
  std::vector<Mistake> mistakes;
  const auto add = [&](const Target& like, const std::string& fits, const auto& change) {
    Mistake mistake{like, fits};
    change(mistake.real);
    mistakes.push_back(mistake);
  };
  add(charuco, "`--layout old`", [](Target& t) { t.old_layout = true; });
  add(charuco, "`--first-id 24`", [](Target& t) { t.first_id = 24; });
  add(charuco, "`--layout old --first-id 24`", [](Target& t) { t.old_layout = true, t.first_id = 24; });
  add(charuco, "`--columns 6 --rows 8`", [](Target& t) { t.columns = 6, t.rows = 8; });
  add(charuco, "`--columns 7 --rows 5`", [](Target& t) { t.columns = 7, t.rows = 5; });
  add(charuco, "`--dictionary DICT_6X6_50`", [](Target& t) { t.dictionary = "DICT_6X6_250"; });
  add(charuco, "`--marker 0.017`", [](Target& t) { t.tag = 0.017; });
  add(grid, "`--columns 5 --rows 3`", [](Target& t) { t.columns = 5, t.rows = 3; });
  add(grid, "`--first-id 30`", [](Target& t) { t.first_id = 30; });
  for (const Mistake& mistake : mistakes) {
    const Target& described = mistake.real.kind == TargetKind::charuco ? charuco : grid;
    const std::vector<Image> images = list_images(mistake.real);
    const TargetGuess guess = guess_target(images, described, TargetWording::options);
    EXPECT_NE(guess.text.find("fits " + mistake.fits), std::string::npos) << mistake.fits << ": " << guess.text;
    ASSERT_TRUE(guess.target.has_value()) << mistake.fits;
    EXPECT_FALSE(detect_target(images[0], prepare(*guess.target)).points.empty());
  }
}

TEST(TargetGuess, OfAnotherKind) {
  const TargetGuess board = guess_target(list_images(charuco), chessboard, TargetWording::attributes);
  ASSERT_TRUE(board.target.has_value()) << board.text;
  EXPECT_EQ(board.target->kind, TargetKind::charuco);
  EXPECT_NE(board.text.find("kind=\"charuco\" columns=\"8\" rows=\"6\""), std::string::npos) << board.text;
  const TargetGuess chess = guess_target(list_images(chessboard), charuco, TargetWording::attributes);
  EXPECT_NE(chess.text.find("kind=\"chessboard\" columns=\"9\" rows=\"6\""), std::string::npos) << chess.text;
}

TEST(TargetGuess, AChessboardCountedBySquares) {
  Target by_squares = chessboard;
  by_squares.columns = 10, by_squares.rows = 7;
  const TargetGuess guess = guess_target(list_images(chessboard), by_squares, TargetWording::options);
  EXPECT_NE(guess.text.find("`--columns 9 --rows 6`"), std::string::npos) << guess.text;
}

TEST(TargetGuess, InAMirrorAndWhiteForBlack) {
  std::vector<Image> in_mirror, white;
  for (const Image& image : list_images(charuco)) {
    in_mirror.push_back(mirrored(image));
    white.push_back(inverted(image));
  }
  EXPECT_NE(guess_target(in_mirror, charuco, TargetWording::options).text.find("mirror"), std::string::npos);
  EXPECT_NE(guess_target(white, charuco, TargetWording::options).text.find("white for black"), std::string::npos);
}

TEST(TargetGuess, SaysNothingOfATargetThatIsThere) {
  EXPECT_EQ(guess_target(list_images(charuco), charuco, TargetWording::options).text, "");
  EXPECT_EQ(guess_target(list_images(grid), grid, TargetWording::options).text, "");
}

TEST(TargetGuess, OfImagesWithoutAnyTag) {
  const std::vector<Image> grey{Image(640, 480, 120)};
  const TargetGuess guess = guess_target(grey, charuco, TargetWording::options);
  EXPECT_FALSE(guess.target.has_value());
  EXPECT_NE(guess.text.find("no tags of any"), std::string::npos) << guess.text;
}

TEST(TargetDetection, ATagThatIsThereTwiceIsToldApartFromAnUnclearOne) {
  const Target one{.kind = TargetKind::tags, .tag = 0.05, .dictionary = "DICT_5X5_100", .ids = {3}};
  const Target three{.kind = TargetKind::tags, .tag = 0.05, .dictionary = "DICT_5X5_100", .ids = {3, 7, 9}};
  static const auto rays = fixtures::fine_rays(guess_camera());
  TargetView view;
  view.camera = guess_camera();
  view.camera_from_target.translation = Vector3(-0.1, 0, 0.5);
  const Image left = make_image(one, view, rays);
  view.camera_from_target.translation = Vector3(0.1, 0, 0.5);
  Image both = make_image(one, view, rays);
  for (int v = 0; v < both.height; ++v) std::copy(left.row(v), left.row(v) + left.width / 2, both.row(v));
  for (const Target& target : {one, three}) {
    const TargetSighting sighting = detect_target(both, prepare(target));
    EXPECT_TRUE(sighting.points.empty());
    EXPECT_EQ(sighting.repeated, std::vector<int>{3});
    EXPECT_NE(sighting.reason.find("number 3 is there two times"), std::string::npos) << sighting.reason;
  }
}

struct FieldCase {
  std::string folder, says;
};

TEST(TargetGuess, OfBoardsThatWereDescribedWrongly) {
  const std::filesystem::path all = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras";
  if (!std::filesystem::exists(all)) GTEST_SKIP() << all << " is not here";
  const Target described{
      .kind = TargetKind::charuco, .columns = 8, .rows = 6, .square = 0.035, .tag = 0.024, .dictionary = "DICT_4X4_50"};
  for (const FieldCase& one : {FieldCase{"legacy", "`--layout old`"}, FieldCase{"ids24", "`--first-id 24`"},
                               FieldCase{"inverted", "white for black"}, FieldCase{"mirrored", "mirror"}}) {
    std::vector<Image> images;
    for (const auto& entry : std::filesystem::directory_iterator(all / "charuco_described_wrongly" / one.folder))
      images.push_back(read_image(entry.path()));
    const TargetGuess guess = guess_target(images, described, TargetWording::options);
    EXPECT_NE(guess.text.find(one.says), std::string::npos) << one.folder << ": " << guess.text;
  }
  // The same images are found by another size, with columns and rows exchanged and with another dictionary.
  std::vector<Image> plain;
  for (const auto& entry : std::filesystem::directory_iterator(all / "charuco_described_wrongly/plain"))
    plain.push_back(read_image(entry.path()));
  for (auto change : {+[](Target& t) { std::swap(t.columns, t.rows); }, +[](Target& t) { t.columns = 5, t.rows = 7; },
                      +[](Target& t) { t.dictionary = "DICT_6X6_250"; }}) {
    Target wrong = described;
    change(wrong);
    const TargetGuess guess = guess_target(plain, wrong, TargetWording::options);
    ASSERT_TRUE(guess.target.has_value()) << describe_target(wrong) << ": " << guess.text;
    EXPECT_EQ(guess.target->columns, 8);
    EXPECT_EQ(guess.target->rows, 6);
    EXPECT_EQ(guess.target->dictionary, "DICT_4X4_50");
  }
}

TEST(TargetGuess, ImagesOfCamerasAreNotDrawnOver) {
  for (const Target& target : {charuco, grid, chessboard})
    for (const Image& image : list_images(target)) EXPECT_FALSE(is_drawn_over(image));
  EXPECT_FALSE(is_drawn_over(Image(640, 480, 120)));
}

TEST(TargetGuess, OfCircles) {
  const Target real = target_from_words({{"kind", "circles"},
                                         {"columns", "4"},
                                         {"rows", "9"},
                                         {"spacing", "0.018"},
                                         {"diameter", "0.014"},
                                         {"layout", "asymmetric"}},
                                        "test");
  const std::vector<Image> images = list_images(real);
  Target turned = real;
  std::swap(turned.columns, turned.rows);
  EXPECT_NE(guess_target(images, turned, TargetWording::options).text.find("fits `--columns 4 --rows 9`"),
            std::string::npos);
  Target symmetric = real;
  symmetric.dictionary = "symmetric";
  const TargetGuess guess = guess_target(images, symmetric, TargetWording::attributes);
  EXPECT_NE(guess.text.find("layout=\"asymmetric\""), std::string::npos) << guess.text;
  const TargetGuess other = guess_target(list_images(chessboard), real, TargetWording::options);
  EXPECT_NE(other.text.find("--kind chessboard"), std::string::npos) << other.text;
}

TEST(TargetGuess, OfImagesThatWereDrawnOver) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/drawn_over/images";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const Target board{
      .kind = TargetKind::charuco, .columns = 8, .rows = 6, .square = 0.035, .tag = 0.024, .dictionary = "DICT_4X4_50"};
  const PreparedTarget prepared = prepare(board);
  std::vector<Image> images;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    images.push_back(read_image(entry.path()));
    const std::string reason = detect_target(images.back(), prepared).reason;
    EXPECT_NE(reason.find("drawn"), std::string::npos) << entry.path() << ": " << reason;
  }
  const TargetGuess guess = guess_target(images, board, TargetWording::options);
  EXPECT_NE(guess.text.find("drawn into them"), std::string::npos) << guess.text;
}

TEST(TargetGuess, OfATagThatIsThereThreeTimes) {
  const std::filesystem::path folder =
      std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/one_tag_number_twice/images";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const PreparedTarget prepared = prepare({.kind = TargetKind::tags, .tag = 0.1, .dictionary = "tag36h11", .ids = {0}});
  int said = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    said += detect_target(read_image(entry.path()), prepared).reason.find("number 0 is there") != std::string::npos;
  EXPECT_GE(said, 1);
}

/// Nobody has described anything: what is there, its lengths to each other.
TEST(TargetGuess, SaysWhatIsShownWhereNothingIsDescribed) {
  const auto of_board = shown_target(list_images(charuco));
  ASSERT_TRUE(of_board);
  EXPECT_EQ(of_board->kind, TargetKind::charuco);
  EXPECT_EQ(std::pair(of_board->columns, of_board->rows), std::pair(charuco.columns, charuco.rows));
  EXPECT_NEAR(of_board->tag / of_board->square, charuco.tag / charuco.square, 0.03);
  const auto of_squares = shown_target(list_images(chessboard));
  ASSERT_TRUE(of_squares);
  EXPECT_EQ(of_squares->kind, TargetKind::chessboard);
  EXPECT_EQ(of_squares->columns * of_squares->rows, chessboard.columns * chessboard.rows);
  const auto of_grid = shown_target(list_images(grid));
  ASSERT_TRUE(of_grid);
  EXPECT_EQ(of_grid->kind, TargetKind::aprilgrid);
  EXPECT_EQ(std::pair(of_grid->columns, of_grid->rows), std::pair(grid.columns, grid.rows));
  EXPECT_NEAR(of_grid->spacing, grid.spacing, 0.03);
  EXPECT_EQ(of_grid->border, grid.border);
  EXPECT_FALSE(shown_target(std::vector<Image>(3, Image(640, 480, 128))));
}

}  // namespace
}  // namespace handsight
