// SPDX-License-Identifier: Apache-2.0
#include "widgets/images/image_view.h"

#include <gmock/gmock.h>

#include <QSignalSpy>
#include <cmath>

#include "app/window/painted_text.h"
#include "widgets/images/loupe.h"
#include "widgets/mouse.h"

namespace handsight::widgets {
namespace {

QImage checkers() {
  QImage image(640, 480, QImage::Format_Grayscale8);
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) image.scanLine(v)[u] = ((u < 320) != (v < 240)) ? 230 : 20;
  return image;
}

TEST(ImageView, PixelCentresAreIntegersAtEveryZoom) {
  ImageView view;
  view.set_image(checkers());
  test::show(view, {640, 480});
  for (const double zoom : {0.5, 1.0, 7.3}) {
    view.set_viewport({Vector2(100.25, 50.5), zoom});
    const QPointF a = view.to_screen({10, 20}), b = view.to_screen({11, 20});
    EXPECT_NEAR(b.x() - a.x(), zoom, 1e-9);
    EXPECT_NEAR((view.to_image(a) - Vector2(10, 20)).norm(), 0, 1e-9);
  }
  // The left half of pixel (319, 100) is bright, that of (320, 100) dark: the border lies at u = 319.5.
  view.set_viewport({Vector2(319.5, 100), 20});
  const QImage shown = view.grab().toImage();
  const QPointF border = view.to_screen({319.5, 100});
  EXPECT_GT(qGray(shown.pixel(static_cast<int>(border.x()) + 3, static_cast<int>(border.y()))) +
                qGray(shown.pixel(static_cast<int>(border.x()) - 3, static_cast<int>(border.y()))),
            200);
  EXPECT_NE(qGray(shown.pixel(static_cast<int>(border.x()) + 3, static_cast<int>(border.y()))),
            qGray(shown.pixel(static_cast<int>(border.x()) - 3, static_cast<int>(border.y()))));
}

/// Markers that lie closer together than their numbers are large.
TEST(ImageView, NumbersOfMarkersThatLieCloseDoNotCoverEachOther) {
  ImageView view;
  view.set_image(checkers());
  std::vector<ImageMark> marks;
  for (int i = 0; i < 5; ++i) marks.push_back({.marker = i, .position = Vector2(300 + 4 * i, 200 + 3 * (i % 2))});
  view.set_marks(marks);
  test::show(view, {640, 480});
  std::vector<test::PaintedText> numbers;
  for (const test::PaintedText& text : test::texts_of(view))
    if (text.text.size() == 1 && text.text[0].isDigit()) numbers.push_back(text);
  EXPECT_EQ(numbers.size(), 5U) << "there is room for all of them";
  for (std::size_t a = 0; a < numbers.size(); ++a)
    for (std::size_t b = a + 1; b < numbers.size(); ++b)
      EXPECT_FALSE(numbers[a].place.intersects(numbers[b].place))
          << numbers[a].text.toStdString() << " and " << numbers[b].text.toStdString();
}

TEST(ImageView, TheNumbersOfABoardDoNotBuryIt) {
  ImageView view;
  view.set_image(checkers());
  std::vector<ImageMark> marks;
  for (int i = 0; i < 25; ++i)
    marks.push_back({.marker = i, .position = Vector2(250 + 14 * (i % 5), 180 + 14 * (i / 5))});
  view.set_marks(marks);
  test::show(view, {640, 480});
  std::vector<QRectF> numbers;
  for (const test::PaintedText& text : test::texts_of(view))
    if (bool is_number = false; text.text.toInt(&is_number), is_number) numbers.push_back(text.place);
  EXPECT_LT(numbers.size(), 25U) << "where there is no room there is none";
  for (std::size_t a = 0; a < numbers.size(); ++a)
    for (std::size_t b = a + 1; b < numbers.size(); ++b) EXPECT_FALSE(numbers[a].intersects(numbers[b]));
}

TEST(ImageView, TheWheelKeepsWhatIsUnderThePointer) {
  ImageView view;
  view.set_image(checkers());
  test::show(view, {600, 500});
  QSignalSpy moved(&view, &ImageView::viewport_changed);
  const QPointF at(140, 333);
  const Vector2 before = view.to_image(at);
  test::wheel(&view, at, 5);
  EXPECT_EQ(moved.size(), 1);
  EXPECT_GT(view.viewport().zoom, 2.5);
  EXPECT_NEAR((view.to_image(at) - before).norm(), 0, 1e-9);
  QTest::keyClick(&view, Qt::Key_F);
  EXPECT_LT(view.viewport().zoom, 1.1);
}

TEST(ImageView, LabellingSaysWhereAndDragsMarkers) {
  ImageView view;
  view.set_image(checkers());
  view.set_labelling(true);
  view.set_marks({{1, Vector2(200, 200), MarkRole::measured, {}, 2, {}}});
  test::show(view, {640, 480});
  QSignalSpy pointed(&view, &ImageView::pointed), dragged(&view, &ImageView::marker_dragged);
  test::click(&view, view.to_screen({320, 240}), Qt::AltModifier);
  ASSERT_EQ(pointed.size(), 1);
  EXPECT_LT((pointed[0][0].value<Vector2>() - Vector2(320, 240)).norm(), 1);
  EXPECT_TRUE(pointed[0][1].value<Qt::KeyboardModifiers>() & Qt::AltModifier);
  test::drag(&view, view.to_screen({200, 200}), view.to_screen({230, 190}));
  ASSERT_GE(dragged.size(), 2);
  EXPECT_EQ(dragged.back()[0].toInt(), 1);
  EXPECT_LT((dragged.back()[1].value<Vector2>() - Vector2(230, 190)).norm(), 1);
  EXPECT_TRUE(dragged.back()[2].toBool());
  EXPECT_EQ(pointed.size(), 1);  // a drag is no click
}

TEST(ImageView, ArrowKeysNudgeTheSelectedMarker) {
  ImageView view;
  view.set_image(checkers());
  view.set_labelling(true);
  view.set_marks({{2, Vector2(200, 200), MarkRole::measured, {}, 2, {}}});
  view.set_selected_marker(2);
  test::show(view, {640, 480});
  QSignalSpy nudged(&view, &ImageView::marker_nudged), removed(&view, &ImageView::marker_removed);
  QSignalSpy renumbered(&view, &ImageView::marker_renumbered);
  QTest::keyClick(&view, Qt::Key_Left);
  QTest::keyClick(&view, Qt::Key_Down, Qt::ShiftModifier);
  ASSERT_EQ(nudged.size(), 2);
  EXPECT_NEAR((nudged[0][1].value<Vector2>() - Vector2(-0.1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((nudged[1][1].value<Vector2>() - Vector2(0, 1)).norm(), 0, 1e-12);
  QTest::keyClick(&view, Qt::Key_0);
  ASSERT_EQ(renumbered.size(), 1);
  EXPECT_EQ(renumbered[0][1].toInt(), 0);
  QTest::keyClick(&view, Qt::Key_Delete);
  EXPECT_EQ(removed.size(), 1);
}

TEST(ImageView, CandidatesCanBeTaken) {
  ImageView view;
  view.set_image(checkers());
  view.set_candidates({{7, Vector2(400, 100), "0.3 px", false}});
  test::show(view, {640, 480});
  QSignalSpy chosen(&view, &ImageView::candidate_chosen), hovered(&view, &ImageView::candidate_hovered);
  test::hover(&view, view.to_screen({401, 101}));
  ASSERT_EQ(hovered.size(), 1);
  test::click(&view, view.to_screen({400, 100}));
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), 7);
}

// An X-corner is its own half-turn: the difference is flat there and not beside it.
TEST(Loupe, TheHalfTurnOfACornerIsFlat) {
  const QImage image = checkers();
  const auto roughness = [&](const Vector2& at) {
    const QImage d = half_turn_difference(image, at, 6);
    int most = 0;
    for (int v = 0; v < d.height(); ++v)
      for (int u = 0; u < d.width(); ++u) most = std::max(most, std::abs(qGray(d.pixel(u, v)) - 128));
    return most;
  };
  EXPECT_LE(roughness({319.5, 239.5}), 1);
  EXPECT_GE(roughness({317.5, 239.5}), 80);
}

}  // namespace
}  // namespace handsight::widgets
