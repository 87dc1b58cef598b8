// SPDX-License-Identifier: Apache-2.0
#include "widgets/images/image_contrast.h"

#include <gtest/gtest.h>

namespace handsight::widgets {
namespace {

/// Grey levels from `low` to `high`, evenly.
QImage ramp(int low, int high) {
  QImage image(100, 20, QImage::Format_Grayscale8);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) image.scanLine(y)[x] = static_cast<uchar>(low + (high - low) * x / 99);
  return image;
}

TEST(ImageContrast, FewGreyLevelsAreSpreadOverAll) {
  const QImage shown = with_stretched_contrast(ramp(40, 90));
  EXPECT_LE(qGray(shown.pixel(0, 5)), 10);
  EXPECT_GE(qGray(shown.pixel(99, 5)), 245);
  EXPECT_NEAR(qGray(shown.pixel(50, 5)), 128, 8) << "evenly";
}

TEST(ImageContrast, AnImageThatUsesThemStaysAsItIs) {
  const QImage image = ramp(10, 240);
  EXPECT_EQ(with_stretched_contrast(image), image);
  EXPECT_TRUE(with_stretched_contrast(QImage()).isNull());
}

TEST(ImageContrast, OneWhiteDotDoesNotKeepItDark) {
  QImage image = ramp(40, 90);
  image.scanLine(3)[7] = 255;
  EXPECT_GE(qGray(with_stretched_contrast(image).pixel(99, 5)), 245);
}

}  // namespace
}  // namespace handsight::widgets
