// SPDX-License-Identifier: Apache-2.0
#include "widgets/scene/smooth_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace handsight::widgets {
namespace {

/// Black left of an upright edge at this column, white right of it, as a renderer without smooth edges draws it.
QImage edge_at(double column, const QSize& size) {
  QImage image(size, QImage::Format_RGB32);
  for (int v = 0; v < size.height(); ++v)
    for (int u = 0; u < size.width(); ++u) image.setPixel(u, v, u + 0.5 < column ? qRgb(0, 0, 0) : qRgb(255, 255, 255));
  return image;
}

QImage smooth_edge(double column, const QSize& size) {
  SmoothPicture smooth;
  while (!smooth.is_done()) smooth.add(edge_at(column + smooth.next_offset().x(), size));
  return smooth.mean();
}

TEST(SmoothPictureTest, AnEdgeWithinAPixelHasItsShareOfGrey) {
  for (int eighth = 0; eighth <= 8; ++eighth) {
    const double column = 4 + eighth / 8.0;
    const QImage image = smooth_edge(column, {9, 2});
    EXPECT_EQ(qRed(image.pixel(3, 1)), 0);
    EXPECT_NEAR(qBlue(image.pixel(4, 1)), 255 * (1 - eighth / 8.0), 255 / 8.0 + 1) << column;
    EXPECT_EQ(qGreen(image.pixel(5, 1)), 255);
  }
}

TEST(SmoothPictureTest, NoTwoPicturesShareARowOrAColumnAndTheirMiddleIsThePixels) {
  SmoothPicture smooth;
  std::set<double> columns, rows;
  QPointF sum;
  for (; !smooth.is_done(); smooth.add(edge_at(1, {2, 2}))) {
    const QPointF at = smooth.next_offset();
    columns.insert(at.x());
    rows.insert(at.y());
    sum += at;
    EXPECT_LE(std::max(std::abs(at.x()), std::abs(at.y())), 0.5);
  }
  EXPECT_EQ(columns.size(), SmoothPicture::pictures);
  EXPECT_EQ(rows.size(), SmoothPicture::pictures);
  EXPECT_LT(std::hypot(sum.x(), sum.y()) / SmoothPicture::pictures, 0.07);
}

TEST(SmoothPictureTest, WhatHasChangedBeginsAnew) {
  SmoothPicture smooth;
  EXPECT_TRUE(smooth.mean().isNull());
  smooth.add(edge_at(0, {4, 4}));
  smooth.add(edge_at(8, {5, 4}));  // another size
  EXPECT_EQ(smooth.mean().size(), QSize(5, 4));
  EXPECT_EQ(qRed(smooth.mean().pixel(0, 0)), 0);
  smooth.begin_anew();
  EXPECT_TRUE(smooth.mean().isNull());
}

}  // namespace
}  // namespace handsight::widgets
