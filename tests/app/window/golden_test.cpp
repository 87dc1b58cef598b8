// SPDX-License-Identifier: Apache-2.0
// The main states of the window look as they did: pictures of a sixth of the size, with a tolerance for fonts and the
// software's rendering. HANDSIGHT_GOLDEN=write makes them anew (tests/app/golden), and whole ones in the build folder
// (golden): look at each before it is kept.
#include <gtest/gtest.h>

#include <QImage>
#include <filesystem>

#include "app/window/pages.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

constexpr QSize whole(1440, 900), small(240, 150);
constexpr double most_mean = 3;    // of 255: all together
constexpr double most_block = 26;  // of 255: the mean of any 10 x 10 px of the small picture

double difference(const QImage& a, const QImage& b, const QRect& area) {
  double sum = 0;
  for (int y = area.top(); y <= area.bottom(); ++y)
    for (int x = area.left(); x <= area.right(); ++x) {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      sum += (std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue())) / 3.0;
    }
  return sum / (area.width() * area.height());
}

void expect_as_before(QWidget& window, const char* name) {
  QTest::qWait(300);
  const QImage full = window.grab().toImage();
  const QImage now =
      full.scaled(small, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB32);
  const auto file = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "tests/app/golden" / (std::string(name) + ".png");
  if (qEnvironmentVariable("HANDSIGHT_GOLDEN") == "write") {
    std::filesystem::create_directories(file.parent_path());
    ASSERT_TRUE(now.save(QString::fromStdString(file.string())));
    const auto to_look_at = std::filesystem::path(HANDSIGHT_BINARY_DIR) / "golden";
    std::filesystem::create_directories(to_look_at);
    ASSERT_TRUE(full.save(QString::fromStdString((to_look_at / file.filename()).string())));
    return;
  }
  const QImage before = QImage(QString::fromStdString(file.string())).convertToFormat(QImage::Format_RGB32);
  ASSERT_EQ(before.size(), small) << file;
  EXPECT_LT(difference(now, before, QRect(QPoint(), small)), most_mean) << name;
  constexpr int block = 10;
  double worst = 0;
  QRect where;
  for (int y = 0; y < small.height(); y += block)
    for (int x = 0; x < small.width(); x += block) {
      const QRect area(x, y, block, block);
      const double here = difference(now, before, area);
      if (here > worst) worst = here, where = area;
    }
  EXPECT_LT(worst, most_block) << name << " differs most at " << 6 * where.x() << ", " << 6 * where.y();
}

TEST(Golden, MainStatesLookAsTheyDid) {
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(whole);
  QTest::mouseMove(desk.window.windowHandle(), QPoint(5, 5));
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "first_steps").string())));
  LabelPage label{desk};
  ASSERT_TRUE(label.corners_are_found());
  expect_as_before(desk.window, "label");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "hidden_3").string())));
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  expect_as_before(desk.window, "explain");
  explain.look_at(0);
  ASSERT_TRUE(desk.wait([&] { return desk.window.workbench().predicted_error().has_value(); }));
  expect_as_before(desk.window, "explain_proof");
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  QTest::mouseMove(desk.window.windowHandle(), QPoint(5, 5));
  QTest::qWait(1500);
  expect_as_before(desk.window, "explain_added");
  desk.key(Qt::Key_3, Qt::ControlModifier);
  desk.settle();
  expect_as_before(desk.window, "inspect");
  desk.key(Qt::Key_5, Qt::ControlModifier);
  desk.settle();
  expect_as_before(desk.window, "export");
}

}  // namespace
}  // namespace handsight::test
