// SPDX-License-Identifier: Apache-2.0
#include "certify/pdf.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/text.h"

namespace handsight {
namespace {

constexpr double points_a_mm = 72 / 25.4;

// Widths of the characters from space to ~, in thousandths of the size (Adobe's metrics of the standard 14 fonts).
constexpr std::array<short, 95> plain_widths{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr std::array<short, 95> bold_widths{
    278, 333, 474, 556, 556, 889, 722, 238, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 333, 333, 584, 584, 584, 611, 975, 722, 722, 722, 722, 667,
    611, 778, 722, 278, 556, 722, 611, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 333, 278, 333, 584, 556, 333, 556, 611, 556, 611, 556, 333, 611, 611, 278, 278, 556,
    278, 889, 611, 611, 611, 611, 389, 556, 333, 611, 556, 778, 556, 556, 500, 389, 280, 389, 584};

/// One byte a character: Latin-1, which the fonts' WinAnsiEncoding agrees with.
std::string latin_1(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (length == 1)
      out += first < 0x20 ? ' ' : text[i];
    else if (length == 2 && i + 1 < text.size() && first <= 0xc3)
      out += static_cast<char>((first & 3) << 6 | (static_cast<unsigned char>(text[i + 1]) & 0x3f));
    else
      out += '?';
    i += length;
  }
  return out;
}

double width_of(char c, PdfFont font) {
  if (font == PdfFont::mono) return 600;
  const auto code = static_cast<unsigned char>(c);
  if (code < 32 || code > 126) return code == 0xb0 ? 400 : code == 0xb1 ? 584 : 556;
  return (font == PdfFont::bold ? bold_widths : plain_widths)[static_cast<std::size_t>(code - 32)];
}

double width_of(const std::string& text, double size, PdfFont font) {
  double sum = 0;
  for (const char c : text) sum += width_of(c, font);
  return sum / 1000 * size / points_a_mm;
}

std::string in_parentheses(const std::string& text) {
  std::string out = "(";
  for (const char c : text) {
    if (c == '(' || c == ')' || c == '\\') out += '\\';
    out += c;
  }
  return out + ")";
}

/// Numbers of a page description: two decimals of a point are a hundredth of a millimetre's third.
std::string number(double x) { return fmt::format("{:.3f}", std::abs(x) < 5e-4 ? 0.0 : x); }
std::string across(double mm) { return number(points_a_mm * mm); }
std::string up(double mm) { return number(points_a_mm * (PdfDocument::height - mm)); }
std::string color(const PdfColor& c, const char* which) {
  return fmt::format("{} {} {} {} ", number(c.red), number(c.green), number(c.blue), which);
}

}  // namespace

PdfDocument::PdfDocument(std::string title, std::string creator) : title_(latin_1(title)), creator_(latin_1(creator)) {}

void PdfDocument::add_page() { pages_.emplace_back(); }

void PdfDocument::text(double x, double y, std::string_view text, double size, PdfFont font, PdfColor c) {
  put(fmt::format("BT {}/F{} {} Tf {} {} Td {} Tj ET\n", color(c, "rg"), static_cast<int>(font) + 1, number(size),
                  across(x), up(y), in_parentheses(latin_1(text))));
}

void PdfDocument::text_right(double x, double y, std::string_view words, double size, PdfFont font, PdfColor c) {
  text(x - pdf_text_width(words, size, font), y, words, size, font, c);
}

void PdfDocument::line(double x1, double y1, double x2, double y2, double thickness, PdfColor c) {
  put(fmt::format("{}{} w {} {} m {} {} l S\n", color(c, "RG"), across(thickness), across(x1), up(y1), across(x2),
                  up(y2)));
}

void PdfDocument::rectangle(double x, double y, double w, double h, PdfColor fill) {
  put(fmt::format("{}{} {} {} {} re f\n", color(fill, "rg"), across(x), up(y + h), across(w), across(h)));
}

void PdfDocument::frame(double x, double y, double w, double h, double thickness, PdfColor c) {
  put(fmt::format("{}{} w {} {} {} {} re S\n", color(c, "RG"), across(thickness), across(x), up(y + h), across(w),
                  across(h)));
}

void PdfDocument::dot(double x, double y, double r, PdfColor fill) {
  constexpr double k = 0.5522847498;  // of Bezier's circle
  const auto at = [&](double dx, double dy) { return across(x + r * dx) + " " + up(y + r * dy) + " "; };
  put(color(fill, "rg") + at(1, 0) + "m " + at(1, k) + at(k, 1) + at(0, 1) + "c " + at(-k, 1) + at(-1, k) + at(-1, 0) +
      "c " + at(-1, -k) + at(-k, -1) + at(0, -1) + "c " + at(k, -1) + at(1, -k) + at(1, 0) + "c f\n");
}

std::string PdfDocument::bytes() const {
  std::vector<std::string> objects;
  std::string kids;
  for (std::size_t i = 0; i < pages_.size(); ++i) kids += fmt::format("{} 0 R ", 7 + 2 * i);
  objects.push_back("<< /Type /Catalog /Pages 2 0 R >>");
  objects.push_back(fmt::format("<< /Type /Pages /Kids [ {}] /Count {} >>", kids, pages_.size()));
  for (const char* font : {"Helvetica", "Helvetica-Bold", "Courier"})
    objects.push_back(fmt::format("<< /Type /Font /Subtype /Type1 /BaseFont /{} /Encoding /WinAnsiEncoding >>", font));
  objects.push_back(fmt::format("<< /Title {} /Creator {} >>", in_parentheses(title_), in_parentheses(creator_)));
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    objects.push_back(fmt::format(
        "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Resources << /Font << /F1 3 0 R /F2 4 0 R /F3 5 "
        "0 R >> >> /Contents {} 0 R >>",
        across(width), across(height), 8 + 2 * i));
    objects.push_back(fmt::format("<< /Length {} >>\nstream\n{}endstream", pages_[i].size(), pages_[i]));
  }
  std::string file = "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n", table;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", file.size());
    file += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
  }
  const std::size_t at = file.size();
  return file + fmt::format(
                    "xref\n0 {}\n0000000000 65535 f \n{}trailer\n<< /Size {} /Root 1 0 R /Info 6 0 R >>\nstartxref\n"
                    "{}\n%%EOF\n",
                    objects.size() + 1, table, objects.size() + 1, at);
}

double pdf_text_width(std::string_view text, double size, PdfFont font) { return width_of(latin_1(text), size, font); }

std::vector<std::string> pdf_lines(std::string_view text, double width, double size, PdfFont font) {
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word(text.substr(at, end - at)), longer = lines.back() + (lines.back().empty() ? "" : " ") + word;
    if (lines.back().empty() || pdf_text_width(longer, size, font) <= width)
      lines.back() = longer;
    else
      lines.push_back(word);
    at = end + 1;
  }
  return lines;
}

}  // namespace handsight
