// SPDX-License-Identifier: Apache-2.0
#include "certify/pdf_layout.h"

#include <fmt/format.h>

namespace handsight {
namespace {

constexpr double top = 20, bottom = PdfDocument::height - 22;
constexpr double mm_a_point = 25.4 / 72;
constexpr PdfColor accent{0.09, 0.31, 0.52};

double line_height(double size) { return 1.35 * size * mm_a_point; }

/// Cut to fit: what is cut away ends in dots.
std::string fitted(std::string text, double width, double size, PdfFont font) {
  if (pdf_text_width(text, size, font) <= width) return text;
  while (!text.empty() && pdf_text_width(text + "...", size, font) > width) {
    do text.pop_back();
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80);
  }
  return text + "...";
}

}  // namespace

PdfLayout::PdfLayout(std::string title, std::string creator, std::string footer)
    : pdf_(std::move(title), std::move(creator)), footer_(std::move(footer)) {
  new_page();
}

void PdfLayout::new_page() {
  pdf_.add_page();
  y_ = top;
  pdf_.line(left, bottom + 5, right, bottom + 5, 0.2, rule);
  pdf_.text(left, bottom + 10, footer_, 7.5, PdfFont::plain, quiet);
  pdf_.text_right(right, bottom + 10, fmt::format("page {}", pdf_.pages()), 7.5, PdfFont::plain, quiet);
}

double PdfLayout::room(double height) {
  if (y_ + height > bottom) new_page();
  const double begin = y_;
  y_ += height;
  return begin;
}

void PdfLayout::title(const std::string& text, const std::string& under) {
  pdf_.rectangle(left, room(1.2), right - left, 1.2, accent);
  pdf_.text(left, room(12) + 9.5, text, 20, PdfFont::bold);
  pdf_.text(left, room(7) + 4, under, 10, PdfFont::plain, quiet);
  skip(2);
}

void PdfLayout::heading(const std::string& text) {
  if (y_ + 24 > bottom) new_page();  // never at the foot of a page
  skip(3);
  pdf_.text(left, room(7) + 5, text, 12, PdfFont::bold, accent);
}

void PdfLayout::paragraph(const std::string& text, double size) {
  for (const std::string& line : pdf_lines(text, right - left, size))
    pdf_.text(left, room(line_height(size)) + 0.95 * size * mm_a_point, line, size);
  skip(1.5);
}

void PdfLayout::row(const PdfTable& t, const std::vector<std::string>& cells, PdfFont font) {
  const double y = room(5.0);
  double x = left;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string cell = fitted(cells[i], t.widths[i] - 1.5, 8.5, font);
    if (i < t.words)
      pdf_.text(x, y + 3.6, cell, 8.5, font);
    else
      pdf_.text_right(x + t.widths[i] - 1, y + 3.6, cell, 8.5, font);
    x += t.widths[i];
  }
  pdf_.line(left, y + 5, x, y + 5, 0.1, rule);
}

void PdfLayout::table(const PdfTable& t) {
  if (y_ + 15 > bottom) new_page();
  if (!t.head.empty()) row(t, t.head, PdfFont::bold);
  for (const auto& cells : t.rows) row(t, cells, PdfFont::plain);
  skip(2);
}

void PdfLayout::facts(const std::vector<std::pair<std::string, std::string>>& all) {
  for (const auto& [name, value] : all) {
    const auto lines = pdf_lines(value, right - left - 38, 9);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double y = room(4.6) + 3.3;
      if (i == 0) pdf_.text(left, y, name, 9, PdfFont::plain, quiet);
      pdf_.text(left + 38, y, lines[i], 9);
    }
  }
  skip(1.5);
}

std::string PdfLayout::bytes() { return pdf_.bytes(); }

}  // namespace handsight
