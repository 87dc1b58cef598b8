// SPDX-License-Identifier: Apache-2.0
#include "certify/certificate_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr PdfColor inside{0.13, 0.42, 0.66}, outside{0.78, 0.25, 0.13};

/// Light to dark, readable in grey too.
PdfColor shade(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  constexpr PdfColor low{0.93, 0.96, 0.85}, middle{0.25, 0.68, 0.72}, high{0.03, 0.15, 0.38};
  const PdfColor &a = s < 0.5 ? low : middle, &b = s < 0.5 ? middle : high;
  const double t = s < 0.5 ? 2 * s : 2 * s - 1;
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

/// One of these digits times a power of ten, at least so large.
double round_up(double value, std::initializer_list<double> digits) {
  const double power = std::pow(10, std::floor(std::log10(std::max(value, 1e-9))));
  for (const double digit : digits)
    if (digit * power >= value * (1 - 1e-9)) return digit * power;
  return 10 * power;
}

/// The end of a scale, whose quarters are reported.
double scale_end(double value) { return round_up(value, {1, 1.2, 1.6, 2, 2.4, 3.2, 4, 6, 8}); }

struct Axes {
  double x = 0, y = 0, size = 0;  // mm, of the square's left and lower edge
  double low_across = 0, low_up = 0, scale = 1;

  double across(double value) const { return x + (value - low_across) * scale; }
  double up(double value) const { return y - (value - low_up) * scale; }
};

Axes axes_of(const MapView& view, double x, double y, double size) {
  Axes a{x, y, size};
  double high_across = -1e30, high_up = -1e30;
  a.low_across = a.low_up = 1e30;
  for (const MapCell& c : view.cells) {
    a.low_across = std::min(a.low_across, c.across - view.cell / 2);
    a.low_up = std::min(a.low_up, c.up - view.cell / 2);
    high_across = std::max(high_across, c.across + view.cell / 2);
    high_up = std::max(high_up, c.up + view.cell / 2);
  }
  a.scale = size / std::max({high_across - a.low_across, high_up - a.low_up, 1e-6});
  return a;
}

/// Every `step` metres a mark on both axes.
void draw_scale(PdfDocument& pdf, const MapView& view, const Axes& a) {
  const double step = round_up(a.size / a.scale / 5, {1, 2, 5});
  pdf.frame(a.x, a.y - a.size, a.size, a.size, 0.15, rule);
  for (int i = static_cast<int>(std::ceil(a.low_across / step)); a.across(i * step) <= a.x + a.size + 1e-9; ++i) {
    pdf.line(a.across(i * step), a.y, a.across(i * step), a.y + 1, 0.15, quiet);
    const std::string text = fmt::format("{:.2g}", i * step + 0.0);
    pdf.text(a.across(i * step) - pdf_text_width(text, 6.5) / 2, a.y + 3.6, text, 6.5, PdfFont::plain, quiet);
  }
  for (int i = static_cast<int>(std::ceil(a.low_up / step)); a.up(i * step) >= a.y - a.size - 1e-9; ++i) {
    pdf.line(a.x - 1, a.up(i * step), a.x, a.up(i * step), 0.15, quiet);
    pdf.text_right(a.x - 1.5, a.up(i * step) + 0.8, fmt::format("{:.2g}", i * step + 0.0), 6.5, PdfFont::plain, quiet);
  }
  pdf.text_right(a.x + a.size, a.y + 6.6, fmt::format("{} in m", view.across), 6.5, PdfFont::plain, quiet);
  pdf.text(a.x - 8, a.y - a.size - 1.5, fmt::format("{} in m", view.up), 6.5, PdfFont::plain, quiet);
}

void draw_bar(PdfDocument& pdf, double x, double y, double height, double highest) {
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i)
    pdf.rectangle(x, y - (i + 1) * height / steps, 3.5, height / steps + 0.05, shade((i + 0.5) / steps));
  pdf.frame(x, y - height, 3.5, height, 0.15, rule);
  for (int i = 0; i <= 4; ++i)
    pdf.text(x + 4.5, y - i * height / 4 + 0.8, fmt::format("{:.3g}", 1e3 * highest * i / 4), 6.5, PdfFont::plain,
             quiet);
  pdf.text(x, y - height - 1.5, "mm", 6.5, PdfFont::plain, quiet);
}

void draw_row(const MapView& top, const MapView& side, double MapCell::*which, const std::string& title,
              PdfLayout& layout) {
  constexpr double size = 66;
  const double y = layout.room(size + 18);
  PdfDocument& pdf = layout.pdf();
  double highest = 0;
  for (const MapView* view : {&top, &side})
    for (const MapCell& c : view->cells) highest = std::max(highest, c.*which);
  highest = scale_end(highest);
  pdf.text(PdfLayout::left, y + 3.5, title, 9, PdfFont::bold, ink);
  double x = PdfLayout::left + 9;
  for (const MapView* view : {&top, &side}) {
    const Axes a = axes_of(*view, x, y + size + 9, size);
    for (const MapCell& c : view->cells)
      pdf.rectangle(a.across(c.across - view->cell / 2), a.up(c.up + view->cell / 2), view->cell * a.scale,
                    view->cell * a.scale, shade(c.*which / highest));
    draw_scale(pdf, *view, a);
    x += size + 13;
  }
  draw_bar(pdf, x - 9, y + size + 9, size, highest);
}

}  // namespace

void draw_maps(const Certificate& c, PdfLayout& layout) {
  if (c.expected.empty()) return;
  const MapView top = map_view(c.expected, 0, 1), side = map_view(c.expected, 0, 2);
  draw_row(top, side, &MapCell::before, "Uncorrected: the expected error of the hand, from above and from the side",
           layout);
  draw_row(top, side, &MapCell::limit, "Corrected: below this in 95 of 100 cases, from above and from the side",
           layout);
}

void draw_coverage(const Certificate& c, PdfLayout& layout) {
  constexpr double size = 70;
  const double y = layout.room(size + 12) + size + 3;
  PdfDocument& pdf = layout.pdf();
  double highest = 0;
  for (const AttainedPose& p : c.poses)
    highest =
        std::max({highest, length_limit(p.covariance, 0.95), (p.after.translation - p.commanded.translation).norm()});
  highest = scale_end(highest);
  const Axes a{PdfLayout::left + 9, y, size, 0, 0, size / highest};
  pdf.line(a.x, a.y, a.x + size, a.y - size, 0.25, quiet);
  for (const AttainedPose& p : c.poses) {
    const double limit = length_limit(p.covariance, 0.95),
                 error = (p.after.translation - p.commanded.translation).norm();
    pdf.dot(a.across(limit), a.up(error), 0.6, error <= limit ? inside : outside);
  }
  pdf.frame(a.x, a.y - size, size, size, 0.15, rule);
  for (int i = 0; i <= 4; ++i) {
    const double value = highest * i / 4;
    const std::string text = fmt::format("{:.3g}", 1e3 * value);
    pdf.text(a.across(value) - pdf_text_width(text, 6.5) / 2, a.y + 3.6, text, 6.5, PdfFont::plain, quiet);
    pdf.text_right(a.x - 1.5, a.up(value) + 0.8, text, 6.5, PdfFont::plain, quiet);
  }
  pdf.text_right(a.x + size, a.y + 7, "promised limit, mm", 6.5, PdfFont::plain, quiet);
  pdf.text(a.x + 1.5, a.y - size + 3.5, "measured error, mm", 6.5, PdfFont::plain, quiet);
  double line = y - size + 6;
  for (const std::string& text : pdf_lines(
           "Each point is an observation that was held out of the fit that judges it. Below the line the error was "
           "inside the limit that was promised for it; where the promise is right, one point in twenty lies above.",
           PdfLayout::right - a.x - size - 8, 9)) {
    pdf.text(a.x + size + 8, line, text, 9);
    line += 4.4;
  }
}

}  // namespace handsight
