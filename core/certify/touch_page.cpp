// SPDX-License-Identifier: Apache-2.0
#include "certify/touch_page.h"

#include <cmath>
#include <numbers>

#include "certify/pdf_layout.h"
#include "session/fixtures/list.h"

namespace handsight {
namespace {

constexpr PdfColor metal{0.72, 0.76, 0.8}, tip{0.13, 0.42, 0.66};
constexpr double sketch_height = 26, sketch_width = 48;  // mm

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
  pdf.line(x, y - sketch_ball, x + 5, y - 15, 0.8, ink);
  pdf.dot(x, y, sketch_ball, tip);
}

/// In a field whose left upper corner is at x, y.
void draw(const SketchStroke& s, PdfDocument& pdf, double x, double y) {
  const PdfColor color = s.is_metal ? metal : ink;
  switch (s.kind) {
    case SketchStroke::Kind::line:
      return pdf.line(x + s.x, y + s.y, x + s.to_x, y + s.to_y, s.width, color);
    case SketchStroke::Kind::rectangle:
      return pdf.rectangle(x + s.x, y + s.y, s.to_x, s.to_y, color);
    case SketchStroke::Kind::ball:
      return pdf.dot(x + s.x, y + s.y, sketch_ball, color);
    case SketchStroke::Kind::ring:
      return ring(pdf, x + s.x, y + s.y, s.width);
    case SketchStroke::Kind::probe:
      return probe(pdf, x + s.x, y + s.y);
  }
}

void add_kind(const FixtureKind& kind, PdfLayout& page) {
  const double y = page.room(sketch_height + 4);
  for (const SketchStroke& stroke : kind.sketch) draw(stroke, page.pdf(), PdfLayout::left, y);
  const double text = PdfLayout::left + sketch_width;
  page.pdf().text(text, y + 6, kind.tag, 11, PdfFont::bold);
  double line = y + 11;
  for (const std::string& words : pdf_lines(kind.how_to, PdfLayout::right - text, 9)) {
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
  for (const FixtureKind* kind : fixture_kinds()) add_kind(*kind, page);
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
