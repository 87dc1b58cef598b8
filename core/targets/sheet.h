// SPDX-License-Identifier: Apache-2.0
// Targets on paper: where everything lies on the sheet, and the sheet as PDF, SVG or PNG, true to scale.
#pragma once

#include <string>
#include <vector>

#include "targets/pattern.h"

namespace handsight {

/// A line of text; `at` is the left end of its base line, m from the top left of the sheet.
struct SheetText {
  Vector2 at = Vector2::Zero();
  double height = 0.003;  // m, of the letters' body
  std::string text;
};

/// A sheet: black boxes (m from its top left corner, y down) that do not overlap, and texts.
struct Sheet {
  std::string paper;  // "A4", "A4 landscape", ... or "own size"
  double width = 0, height = 0;
  std::vector<Box> black;
  std::vector<SheetText> texts;
  std::vector<Vector2> piece_origins;  // where the origin of each piece's frame lies
};

/// The target in the middle of the smallest paper from A4 to A0, upright or landscape, that holds it with a white rim
/// of 10 mm, or of a sheet of its own size; beneath it a ruler of 100 mm (less where the sheet is narrow) to check the
/// print with, and what the target is: in words and as <target .../>. Single tags stand side by side, each with its
/// number; an ArUco grid board is printed as it is.
Sheet make_sheet(const Target& target);

std::string pdf_text(const Sheet& sheet);
std::string svg_text(const Sheet& sheet);

/// Bytes of a grey PNG with so many dots per inch, which it says; edges between dots are grey. InputError where that
/// would be more pixels than bounds::most_pixels.
std::string png_bytes(const Sheet& sheet, double dots_per_inch = 300);

}  // namespace handsight
