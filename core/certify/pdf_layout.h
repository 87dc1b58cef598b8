// SPDX-License-Identifier: Apache-2.0
// What pages of a report are put together from: headings, paragraphs, tables; a new page where one is full.
#pragma once

#include <string>
#include <vector>

#include "certify/pdf.h"

namespace handsight {

/// Of lines and letters, of what stands beside them, and of what divides.
inline constexpr PdfColor ink{0.1, 0.12, 0.15}, quiet{0.35, 0.39, 0.44}, rule{0.72, 0.76, 0.8};

struct PdfTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::vector<double> widths;  // mm, of the columns
  std::size_t words = 1;       // so many columns at the left hold words, the others numbers to the right
};

class PdfLayout {
 public:
  static constexpr double left = 20, right = PdfDocument::width - 20;

  /// `footer` stands under every page, with its number.
  PdfLayout(std::string title, std::string creator, std::string footer);

  void title(const std::string& text, const std::string& under);
  void heading(const std::string& text);
  void paragraph(const std::string& text, double size = 9);
  void table(const PdfTable& table);
  void facts(const std::vector<std::pair<std::string, std::string>>& facts);

  /// Room of this height (mm) in one piece; where it begins. A new page where this one has not so much left.
  double room(double height);
  void skip(double height) { y_ += height; }
  PdfDocument& pdf() { return pdf_; }

  /// The file, with the numbers of its pages.
  std::string bytes();

 private:
  void new_page();
  void row(const PdfTable& table, const std::vector<std::string>& cells, PdfFont font);

  PdfDocument pdf_;
  std::string footer_;
  double y_ = 0;  // mm, of the next line's top
};

}  // namespace handsight
