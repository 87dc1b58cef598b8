// SPDX-License-Identifier: Apache-2.0
// Pages of text, lines and filled areas as PDF 1.4, with the fonts that every reader has. Places are in mm from the top
// left corner of an A4 page, text stands on its baseline.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace handsight {

enum class PdfFont { plain, bold, mono };

struct PdfColor {
  double red = 0, green = 0, blue = 0;  // 0 to 1
};

class PdfDocument {
 public:
  static constexpr double width = 210, height = 297;  // mm

  /// `title` and `creator` stand in the file's properties.
  PdfDocument(std::string title, std::string creator);

  void add_page();
  int pages() const { return static_cast<int>(pages_.size()); }

  /// `size` in points. Characters beyond Latin-1 become "?".
  void text(double x, double y, std::string_view text, double size = 9, PdfFont font = PdfFont::plain,
            PdfColor color = {});
  void text_right(double x, double y, std::string_view text, double size = 9, PdfFont font = PdfFont::plain,
                  PdfColor color = {});
  void line(double x1, double y1, double x2, double y2, double thickness = 0.2, PdfColor color = {});
  void rectangle(double x, double y, double w, double h, PdfColor fill);
  void frame(double x, double y, double w, double h, double thickness = 0.2, PdfColor color = {});
  void dot(double x, double y, double radius, PdfColor fill);

  /// The whole file's bytes.
  std::string bytes() const;

 private:
  void put(const std::string& operators) { pages_.back() += operators; }

  std::string title_, creator_;
  std::vector<std::string> pages_;  // contents
};

/// mm that a text takes.
double pdf_text_width(std::string_view text, double size, PdfFont font = PdfFont::plain);

/// The text broken between words into lines of at most `width` mm.
std::vector<std::string> pdf_lines(std::string_view text, double width, double size, PdfFont font = PdfFont::plain);

}  // namespace handsight
