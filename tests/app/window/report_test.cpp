// SPDX-License-Identifier: Apache-2.0
// The report as somebody reads it who gets nothing else: pages with plots on them.
#include <gtest/gtest.h>

#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>

#include "app/window/pages.h"
#include "base/files.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

class ReportTest : public testing::Test {
 protected:
  void open(const char* name) {
    ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, name).string())));
    ASSERT_TRUE(desk.settle());
  }
  std::filesystem::path written(const char* button, const char* file) {
    desk.key(Qt::Key_5, Qt::ControlModifier);
    desk.type_into(desk.find<QLineEdit>("export_path"), QString::fromStdString((folder.path / "out.xml").string()));
    desk.press_button(button);
    EXPECT_TRUE(desk.wait([&] { return std::filesystem::exists(folder.path / file); }, 10000));
    return folder.path / file;
  }
  /// The pictures of an HTML report, as a browser would show them.
  static std::vector<QImage> pictures_in(const QString& html) {
    std::vector<QImage> pictures;
    const QRegularExpression source("src=\"data:image/png;base64,([^\"]*)\"");
    for (auto match = source.globalMatch(html); match.hasNext();)
      pictures.push_back(QImage::fromData(QByteArray::fromBase64(match.next().captured(1).toLatin1())));
    return pictures;
  }
  std::vector<QImage> pages_of(const QString& reader, const std::filesystem::path& pdf) const {
    const QString stem = QString::fromStdString((folder.path / "page").string());
    EXPECT_EQ(QProcess::execute(reader, {"-png", "-r", "60", QString::fromStdString(pdf.string()), stem}), 0);
    std::vector<std::filesystem::path> files;
    for (const auto& file : std::filesystem::directory_iterator(folder.path))
      if (file.path().filename().string().starts_with("page")) files.push_back(file.path());
    std::sort(files.begin(), files.end());
    std::vector<QImage> pages;
    for (const auto& file : files) pages.emplace_back(QString::fromStdString(file.string()));
    return pages;
  }
  /// The share of pixels that differ clearly from the commonest colour: what is drawn on the ground.
  static double ink(const QImage& image, const QRect& area) {
    std::map<QRgb, int> counts;
    const QImage plain = image.convertToFormat(QImage::Format_RGB32);
    for (int y = area.top(); y <= area.bottom(); ++y)
      for (int x = area.left(); x <= area.right(); ++x) ++counts[plain.pixel(x, y)];
    const auto ground =
        std::max_element(counts.begin(), counts.end(), [](auto& a, auto& b) { return a.second < b.second; });
    int drawn = 0;
    for (const auto& [color, count] : counts)
      if (std::abs(qGray(color) - qGray(ground->first)) > 24) drawn += count;
    return drawn / (1.0 * area.width() * area.height());
  }
  TemporaryFolder folder;
  Desk desk;
};

TEST_F(ReportTest, EveryPictureOfTheHtmlIsLargeAndDrawnAllOver) {
  open("hidden_3");
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  const QString html = QString::fromStdString(read_file(written("report_html", "out.html")));
  const auto pictures = pictures_in(html);
  // Staircase, cloud, where it failed before and after, the proof of each of three springs, histogram, map, robot.
  ASSERT_EQ(pictures.size(), 10U);
  EXPECT_EQ(html.count("gives way by"), 3);
  // The cloud: far below the middle at first, gone from there with the effect.
  const QImage& cloud = pictures[1];
  const auto below = [&](int pane) {
    const int side = cloud.height() / 4, x = cloud.width() * (pane == 0 ? 27 : 73) / 100 - side / 2;
    return ink(cloud, {x, cloud.height() * 62 / 100, side, side});
  };
  EXPECT_GT(below(0), 2 * below(1)) << "both panes show the same";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const QImage& p = pictures[i];
    ASSERT_GE(p.width(), 1000) << i;
    ASSERT_GE(p.height(), 400) << i;
    EXPECT_GT(ink(p, p.rect()), 0.003) << "picture " << i << " is blank";
    // Not only in a corner: both halves of it show something.
    EXPECT_GT(ink(p, {0, 0, p.width() / 2, p.height()}), 0.001) << i;
    EXPECT_GT(ink(p, {p.width() / 2, 0, p.width() / 2, p.height()}), 0.001) << i;
    EXPECT_GT(qGray(p.pixel(2, p.height() - 2)), 200) << "picture " << i << " is not on light paper";
  }
  EXPECT_TRUE(html.contains("oint elasticity") || html.contains("gives way")) << "the effect in the model";
  EXPECT_FALSE(html.contains("<pre>"));
  EXPECT_TRUE(html.contains("<html lang=\"en\">"));
  EXPECT_TRUE(html.contains("<title>Hidden 3: Justin</title>"));
  EXPECT_TRUE(html.contains("width=device-width")) << "a telephone would show it as on a wide screen";
  EXPECT_EQ(html.count("<div class=\"wide\"><table"), html.count("<table")) << "a wide table scrolls by itself";
}

TEST_F(ReportTest, ThePagesOfThePdfShowPlotsWithinTheirMargins) {
  const QString reader = QStandardPaths::findExecutable("pdftoppm");
  ASSERT_FALSE(reader.isEmpty()) << "pdftoppm is missing: install poppler-utils, as ./test does.";
  open("hundred_poses");
  const auto pdf = written("report_pdf", "out.pdf");
  const std::vector<QImage> pages = pages_of(reader, pdf);
  ASSERT_GE(pages.size(), 2U);
  double most = 0;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const QImage& page = pages[i];
    const int margin = page.width() * 12 / 210;  // mm of A4; the margins are 18 mm
    EXPECT_LT(ink(page, {page.width() - margin, 0, margin, page.height()}), 1e-4) << "page " << i << " runs off";
    most = std::max(most, ink(page, page.rect()));
  }
  EXPECT_GT(most, 0.05) << "no page has a plot on it";
}

/// The first page has the story with its picture; the last one is not half empty.
TEST_F(ReportTest, NoLastPageIsHalfEmpty) {
  const QString reader = QStandardPaths::findExecutable("pdftoppm");
  ASSERT_FALSE(reader.isEmpty()) << "pdftoppm is missing: install poppler-utils, as ./test does.";
  open("hidden_3");
  ExplainPage explain{desk};
  ASSERT_TRUE(explain.open());
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  const auto pages = pages_of(reader, written("report_pdf", "out.pdf"));
  ASSERT_GE(pages.size(), 2U);
  const QRect upper_half(0, 0, pages[0].width(), pages[0].height() / 2);
  EXPECT_GT(ink(pages.front(), upper_half), 0.02) << "the story and its picture";
  const QImage& last = pages.back();
  const int number = last.height() * 25 / 297;  // mm of A4: below the page's number stands
  EXPECT_GT(ink(last, {0, last.height() / 2, last.width(), last.height() / 2 - number}), 1e-3)
      << "nothing below the middle of the last page";
}

TEST_F(ReportTest, NoNumberOfTheMatrixIsTornOnPaper) {
  const QString reader = QStandardPaths::findExecutable("pdftotext");
  ASSERT_FALSE(reader.isEmpty()) << "pdftotext is missing: install poppler-utils, as ./test does.";
  open("hidden_8");
  QProcess read;
  read.start(reader, {QString::fromStdString(written("report_pdf", "out.pdf").string()), "-"});
  ASSERT_TRUE(read.waitForFinished());
  static const QRegularExpression whole("(?<![\\d.])\\d\\.\\d{8}(?!\\d)");
  int numbers = 0;
  for (auto i = whole.globalMatch(QString::fromUtf8(read.readAllStandardOutput())); i.hasNext(); i.next()) ++numbers;
  EXPECT_EQ(numbers, 12);
}

/// The certificate is made in the background and stands beside the XML.
TEST_F(ReportTest, TheCertificateStandsBesideTheReport) {
  open("hidden_3");
  const auto pdf = written("certificate", "out.certificate.pdf");
  ASSERT_TRUE(std::filesystem::exists(pdf)) << desk.find<QLabel>("export_said")->text().toStdString();
  const std::string bytes = read_file(pdf);
  EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
  EXPECT_NE(bytes.find("ISO 9283"), std::string::npos);
}

}  // namespace
}  // namespace handsight::test
