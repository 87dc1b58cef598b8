// SPDX-License-Identifier: Apache-2.0
#include "certify/touch_page.h"

#include <array>
#include <cmath>
#include <numbers>

#include "certify/pdf_layout.h"

namespace handsight {
namespace {

constexpr PdfColor metal{0.72, 0.76, 0.8}, tip{0.13, 0.42, 0.66};
constexpr double ball = 2.2, sketch_height = 26, sketch_width = 48;  // mm

/// A circle's line.
void ring(PdfDocument& pdf, double x, double y, double radius) {
  constexpr int sides = 36;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * std::numbers::pi * i / sides, b = 2 * std::numbers::pi * (i + 1) / sides;
    pdf.line(x + radius * std::cos(a), y + radius * std::sin(a), x + radius * std::cos(b), y + radius * std::sin(b),
             0.3, ink);
  }
}

/// The probe from above, its ball here.
void probe(PdfDocument& pdf, double x, double y) {
  pdf.line(x, y - ball, x + 5, y - 15, 0.8, ink);
  pdf.dot(x, y, ball, tip);
}

/// Each in a field whose left upper corner is at x, y.
void draw_plane(PdfDocument& pdf, double x, double y) {
  pdf.rectangle(x + 4, y + 19, 36, 3, metal);
  probe(pdf, x + 20, y + 19 - ball);
}

void draw_point(PdfDocument& pdf, double x, double y) {
  pdf.rectangle(x + 12, y + 18, 18, 6, metal);
  pdf.line(x + 17.5, y + 18, x + 21, y + 22.5, 0.4, ink);
  pdf.line(x + 24.5, y + 18, x + 21, y + 22.5, 0.4, ink);
  probe(pdf, x + 21, y + 18.5);
}

void draw_line(PdfDocument& pdf, double x, double y) {
  pdf.line(x + 4, y + 23, x + 38, y + 14, 1.2, metal);
  probe(pdf, x + 19, y + 17);
}

void draw_gauge(PdfDocument& pdf, double x, double y) {
  ring(pdf, x + 33, y + 18, 6);
  pdf.line(x + 33, y + 18, x + 36, y + 14.5, 0.3, ink);
  pdf.line(x + 27, y + 18, x + 18 + ball, y + 18, 0.8, ink);
  probe(pdf, x + 18, y + 18);
}

void draw_length(PdfDocument& pdf, double x, double y) {
  pdf.line(x + 36, y + 22, x + 12, y + 18, 1, metal);
  pdf.dot(x + 36, y + 22, ball, metal);
  probe(pdf, x + 12, y + 18);
}

struct Kind {
  const char* name;
  void (*draw)(PdfDocument&, double, double);
  const char* how;
};

constexpr std::array<Kind, 5> kinds{
    {{"plane", draw_plane,
      "A plate: granite, glass, a machined face. Lower the ball until it touches, twenty times or more, near and far, "
      "with the wrist and elbow turned. Put it in two more places, tilted against the first. Reads nothing."},
     {"point", draw_point,
      "A socket: a cone or three balls in which the tip's ball sits without play. Put it in again and again, each time "
      "from another posture. Two sockets on a bar of known distance tell how long a metre is. Reads nothing."},
     {"line", draw_line,
      "A straight edge or a taut wire that the ball is laid against from two sides. Say about where it is. Reads "
      "nothing."},
     {"gauge", draw_gauge,
      "A dial gauge that the tip pushes along its axis. Write down what it shows, and in which unit. Say about where "
      "it "
      "is and where its axis points."},
     {"length", draw_length,
      "A ball bar or a draw wire from a fixed ball to the tip. Write down its length. Say about where the fixed end "
      "is."}}};

void add_kind(const Kind& kind, PdfLayout& page) {
  const double y = page.room(sketch_height + 4);
  kind.draw(page.pdf(), PdfLayout::left, y);
  const double text = PdfLayout::left + sketch_width;
  page.pdf().text(text, y + 6, kind.name, 11, PdfFont::bold);
  double line = y + 11;
  for (const std::string& words : pdf_lines(kind.how, PdfLayout::right - text, 9)) {
    page.pdf().text(text, line, words, 9);
    line += 4.2;
  }
}

void add_lines_to_fill(PdfLayout& page) {
  PdfTable table;
  table.head = {"no.", "fixture", "joint 1", "2", "3", "4", "5", "6", "7", "reading"};
  table.words = 2;
  table.widths = {10, 28, 16, 16, 16, 16, 16, 16, 16, 20};
  constexpr int lines = 34;
  for (int i = 1; i <= lines; ++i) {
    std::vector<std::string> row(table.head.size());
    row.front() = std::to_string(i);
    table.rows.push_back(std::move(row));
  }
  page.table(table);
}

}  // namespace

std::string touch_page_pdf(const std::string& software) {
  PdfLayout page("Touching: how to", software, software);
  page.title("Calibrating by touch", "With a probe on the hand: what to touch, how, and what to write down");
  for (const Kind& kind : kinds) add_kind(kind, page);
  page.heading("At the robot");
  for (const char* step :
       {"1. Fix the probe so that it cannot turn. Where its tip is need not be known; it must not change.",
        "2. Come slowly, always from one side, stop at the same force; stand still, then read the joints.",
        "3. Every touch from another posture: what the joints do in all touches alike cannot be told.",
        "4. Touch one fixture ten times in one posture: how these differ is what a touch tells (sigma).",
        "5. One line a touch: the joints' angles (rad, or say deg), what was touched, what it read and its unit.",
        "6. handsight-cli convert touches.csv --robot robot.urdf --tcp tool --out session"})
    page.paragraph(step);
  page.skip(PdfDocument::height);  // the lines have a page of their own
  page.heading("Touches");
  page.paragraph("Robot, date, unit of the angles, unit of the readings:");
  add_lines_to_fill(page);
  return page.bytes();
}

}  // namespace handsight
