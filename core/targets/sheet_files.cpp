// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/bounds.h"
#include "base/error.h"
#include "targets/sheet.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

constexpr double point_per_metre = 72 / 0.0254;

std::string escaped(const std::string& text, std::string_view special, char escape) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) result += escape;
    result += c;
  }
  return result;
}

std::string xml_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

/// Lengths in 1e-7 m: what a decimal text of them keeps.
std::string page_content(const Sheet& sheet) {
  std::string content = "0 g\n";
  for (const Box& box : sheet.black)
    content += fmt::format("{:.5f} {:.5f} {:.5f} {:.5f} re\n", box.top_left.x() * point_per_metre,
                           (sheet.height - box.top_left.y() - box.size.y()) * point_per_metre,
                           box.size.x() * point_per_metre, box.size.y() * point_per_metre);
  content += "f\n";  // one fill: boxes that touch leave no seam
  for (const SheetText& text : sheet.texts)
    content += fmt::format("BT /F1 {:.3f} Tf {:.3f} {:.3f} Td ({}) Tj ET\n", text.height * point_per_metre,
                           text.at.x() * point_per_metre, (sheet.height - text.at.y()) * point_per_metre,
                           escaped(text.text, "()\\", '\\'));
  return content;
}

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

std::string big_endian(std::uint32_t number) {
  return {static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8),
          static_cast<char>(number)};
}

/// PNG's chunk of pixels per metre, to stand after the header.
std::string resolution_chunk(double dots_per_inch) {
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dots_per_inch / 0.0254));
  const std::string body = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';
  return big_endian(9) + body + big_endian(crc32(body));
}

/// Adds to every pixel the share of it that the box covers.
void cover(cv::Mat& black, const Box& box, double dots) {
  const double left = box.top_left.x() * dots, top = box.top_left.y() * dots;
  const double right = left + box.size.x() * dots, bottom = top + box.size.y() * dots;
  const auto share = [](double from, double to, int pixel) {
    return std::max(std::min(to, pixel + 1.0) - std::max(from, static_cast<double>(pixel)), 0.0);
  };
  for (int v = std::max(0, static_cast<int>(top)); v < std::min<double>(black.rows, bottom); ++v)
    for (int u = std::max(0, static_cast<int>(left)); u < std::min<double>(black.cols, right); ++u)
      black.at<float>(v, u) += static_cast<float>(share(left, right, u) * share(top, bottom, v));
}

}  // namespace

std::string pdf_text(const Sheet& sheet) {
  const std::string content = page_content(sheet);
  const std::array<std::string, 5> objects{
      "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {:.5f} {:.5f}] /Contents 4 0 R /Resources << /Font << "
                  "/F1 5 0 R >> >> >>",
                  sheet.width * point_per_metre, sheet.height * point_per_metre),
      fmt::format("<< /Length {} >>\nstream\n{}endstream", content.size(), content),
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"};
  std::string text = "%PDF-1.6\n", table;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", text.size());
    text += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
  }
  const std::size_t start = text.size();
  text += fmt::format("xref\n0 {}\n0000000000 65535 f \n{}trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{}\n%%EOF\n",
                      objects.size() + 1, table, objects.size() + 1, start);
  return text;
}

std::string svg_text(const Sheet& sheet) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.4f}mm\" height=\"{1:.4f}mm\" "
      "viewBox=\"0 0 {0:.4f} {1:.4f}\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<path fill=\"black\" "
      "d=\"",
      1e3 * sheet.width, 1e3 * sheet.height);
  for (const Box& box : sheet.black)
    text += fmt::format("M{:.5f} {:.5f}h{:.5f}v{:.5f}h{:.5f}z\n", 1e3 * box.top_left.x(), 1e3 * box.top_left.y(),
                        1e3 * box.size.x(), 1e3 * box.size.y(), -1e3 * box.size.x());
  text += "\"/>\n";
  for (const SheetText& line : sheet.texts)
    text += fmt::format(
        "<text x=\"{:.3f}\" y=\"{:.3f}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{:.3f}\">{}</text>\n",
        1e3 * line.at.x(), 1e3 * line.at.y(), 1e3 * line.height, xml_escaped(line.text));
  return text + "</svg>\n";
}

std::string png_bytes(const Sheet& sheet, double dots_per_inch) {
  const double dots = dots_per_inch / 0.0254;
  const double width = std::ceil(sheet.width * dots), height = std::ceil(sheet.height * dots);
  if (!(width * height <= bounds::most_pixels))
    throw InputError(
        message("The sheet of {:.0f} x {:.0f} mm has more than {:.0f} million pixels at {:g} dots per inch; "
                "use fewer, or PDF or SVG.",
                1e3 * sheet.width, 1e3 * sheet.height, bounds::most_pixels / 1e6, dots_per_inch));
  cv::Mat black(static_cast<int>(height), static_cast<int>(width), CV_32F, cv::Scalar(0));
  for (const Box& box : sheet.black) cover(black, box, dots);
  Image image(black.cols, black.rows);
  cv::Mat grey(black.rows, black.cols, CV_8U, image.pixels.data());
  cv::Mat(255 * (1 - black)).convertTo(grey, CV_8U);
  for (const SheetText& text : sheet.texts) {
    const double scale = text.height * dots * 0.7 / 22;  // capital letters of this font are 22 px high at scale 1
    cv::putText(grey, text.text, {static_cast<int>(text.at.x() * dots), static_cast<int>(text.at.y() * dots)},
                cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(0), std::max(1, static_cast<int>(scale * 1.5)),
                cv::LINE_AA);
  }
  std::string png = encoded_png(image);
  constexpr std::size_t after_header = 8 + 25;
  return png.insert(after_header, resolution_chunk(dots_per_inch));
}

}  // namespace handsight
