// SPDX-License-Identifier: Apache-2.0
// Every effect of the catalogue has a drawing, and no two are the same picture.
#include "widgets/drawings/effect_drawing.h"

#include <gtest/gtest.h>

#include <QImage>
#include <vector>

#include "effects/effect.h"

namespace handsight::widgets {
namespace {

QImage drawn(const std::string& id, ThemeKind kind, int side = 96) {
  QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
  image.fill(theme_colors(kind).panel);
  QPainter painter(&image);
  paint_effect(painter, QRectF(0, 0, side, side), id, theme_colors(kind));
  return image;
}

/// Share of the pixels that differ clearly.
double difference(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 40;
  return static_cast<double>(count) / (a.width() * a.height());
}

/// Pixels of the border, where a drawing that does not fit is cut off.
int inked_at_border(const QImage& image, const QColor& ground) {
  int count = 0;
  for (int i = 0; i < image.width(); ++i)
    for (const QPoint& at : {QPoint(i, 0), QPoint(i, image.height() - 1), QPoint(0, i), QPoint(image.width() - 1, i)})
      count += image.pixelColor(at) != ground;
  return count;
}

std::vector<std::string> all_ids() {
  std::vector<std::string> ids = {""};  // the unnamed curve
  for (const Effect& effect : catalogue()) ids.push_back(effect.id);
  return ids;
}

TEST(EffectDrawing, EachEffectOfTheCatalogueHasOne) {
  ASSERT_GE(all_ids().size(), 23u);
  for (const std::string& id : all_ids()) EXPECT_TRUE(has_effect_drawing(id)) << id;
  EXPECT_FALSE(has_effect_drawing("gravity_on_the_moon"));
}

TEST(EffectDrawing, NoTwoAreTheSamePicture) {
  const std::vector<std::string> ids = all_ids();
  std::vector<QImage> pictures;
  for (const std::string& id : ids) pictures.push_back(drawn(id, ThemeKind::light));
  pictures.push_back(drawn("gravity_on_the_moon", ThemeKind::light));
  for (std::size_t i = 0; i < pictures.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(difference(pictures[i], pictures[k]), 0.05) << (i < ids.size() ? ids[i] : "?") << " and " << ids[k];
}

// A drawing is one of lines: enough of them to be seen, not so many that it is a blot; in both themes, and of the
// model's solid and the effect's purple ink.
TEST(EffectDrawing, ShowsModelAndEffectInBothThemes) {
  for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
    const Colors& c = theme_colors(kind);
    for (const std::string& id : all_ids()) {
      const QImage image = drawn(id, kind, 192);
      int inked = 0, purple = 0;
      for (int y = 0; y < 192; ++y)
        for (int x = 0; x < 192; ++x) {
          inked += image.pixelColor(x, y) != c.panel;
          purple += image.pixelColor(x, y) == c.candidate;
        }
      EXPECT_GT(inked, 192 * 192 / 20) << id;
      EXPECT_LT(inked, 192 * 192 * 2 / 3) << id;
      EXPECT_GT(purple, 100) << id;
    }
  }
}

TEST(EffectDrawing, StaysInsideOfItsSquare) {
  for (const std::string& id : all_ids())
    EXPECT_EQ(inked_at_border(drawn(id, ThemeKind::light), theme_colors(ThemeKind::light).panel), 0) << id;
}

}  // namespace
}  // namespace handsight::widgets
