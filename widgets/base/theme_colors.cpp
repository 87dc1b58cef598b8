// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

QColor rgb(unsigned value) { return QColor::fromRgb(value); }

QColor mixed(const QColor& ground, const QColor& over, double share) {
  const auto mix = [share](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
  return {mix(ground.red(), over.red()), mix(ground.green(), over.green()), mix(ground.blue(), over.blue())};
}

void set_fixed_axes(Colors& c) {
  c.tcp_axes = {rgb(0xFF0000), rgb(0x00FF00), rgb(0x0000FF)};
  c.tcp_est_axes = {rgb(0x00FFFF), rgb(0xFFFF00), rgb(0xFF00FF)};
}

Colors light_colors() {
  Colors c;
  c.window = rgb(0xF4F5F7), c.panel = rgb(0xFFFFFF), c.sunken = rgb(0xE9ECF0);
  c.hairline = rgb(0xD0D5DB), c.control_edge = rgb(0x8A939D);
  c.ink1 = rgb(0x1B2128), c.ink2 = rgb(0x4A5560), c.ink3 = rgb(0x5F6A75);
  c.accent = rgb(0x0B5CAD), c.selected_row = rgb(0xDCE9F7);
  c.good = rgb(0x0B6E63), c.care = rgb(0x8A5A00), c.bad = rgb(0xA3241B);
  c.good_tint = rgb(0xEAF5F3), c.care_tint = rgb(0xFBF3E0), c.bad_tint = rgb(0xFBEAE8);
  c.candidate = rgb(0x7B3FA0);
  c.residual = {rgb(0xD5DAE0), rgb(0xAEB7C1), rgb(0xD9962B), rgb(0xBD5A14), rgb(0x8E2712), rgb(0x4A0F22)};
  c.signed_scale = {rgb(0x0F4C81), rgb(0x6FA3CF), rgb(0xEEF0F2), rgb(0xD99A5B), rgb(0x8A3B0B)};
  c.attribution_to_cameras = rgb(0x5BB8E8), c.attribution_to_body = rgb(0x6B7A1E),
  c.attribution_to_robot = rgb(0x222A33);
  c.xyz_curves = {rgb(0xA8141B), rgb(0x4E9E2A), rgb(0x1B35C4)};
  set_fixed_axes(c);
  return c;
}

Colors dark_colors() {
  Colors c;
  c.window = rgb(0x16191D), c.panel = rgb(0x1E2227), c.sunken = rgb(0x121417);
  c.hairline = rgb(0x363D45), c.control_edge = rgb(0x6E7883);
  c.ink1 = rgb(0xE8EBEE), c.ink2 = rgb(0xB4BCC5), c.ink3 = rgb(0x97A1AC);
  c.accent = rgb(0x6CB2FF), c.selected_row = rgb(0x1F3A57);
  c.good = rgb(0x4FC3B3), c.care = rgb(0xE8B04A), c.bad = rgb(0xFF8A7A);
  c.good_tint = mixed(c.panel, c.good, 0.12), c.care_tint = mixed(c.panel, c.care, 0.12);
  c.bad_tint = mixed(c.panel, c.bad, 0.12);
  c.candidate = rgb(0xC493E6);
  c.residual = {rgb(0x39414A), rgb(0x5A6570), rgb(0x9C6420), rgb(0xD38A2E), rgb(0xF3BF66), rgb(0xFFF07A)};
  c.signed_scale = {rgb(0x8CC6FF), rgb(0x3E7CB1), rgb(0x2A3037), rgb(0xB06A2C), rgb(0xFFB877)};
  c.attribution_to_cameras = rgb(0x7CC8F2), c.attribution_to_body = rgb(0x6F8F2A),
  c.attribution_to_robot = rgb(0xF2F4F6);
  c.xyz_curves = {rgb(0xE8463E), rgb(0xB0F094), rgb(0x6F9BFF)};
  set_fixed_axes(c);
  return c;
}

}  // namespace

const Colors& theme_colors(ThemeKind kind) {
  static const Colors light = light_colors();
  static const Colors dark = dark_colors();
  return kind == ThemeKind::dark ? dark : light;
}

QColor direction_color(double angle) {
  // Twelve stations of matplotlib's twilight, from -pi; pale at both ends of a turn, darkest in the middle.
  static const std::array<QColor, 12> stations = {rgb(0xE2D9E2), rgb(0xB0C4CE), rgb(0x7AA2C1), rgb(0x6276BA),
                                                  rgb(0x5D43A5), rgb(0x4A1770), rgb(0x2F1436), rgb(0x661649),
                                                  rgb(0x973B4C), rgb(0xB66757), rgb(0xC69880), rgb(0xD5C6C0)};
  if (!std::isfinite(angle)) return colors().ink3;
  const double turn = (angle + M_PI) / (2 * M_PI);
  const double place = (turn - std::floor(turn)) * stations.size();
  const auto first = static_cast<std::size_t>(place) % stations.size();
  return mixed(stations[first], stations[(first + 1) % stations.size()], place - std::floor(place));
}

}  // namespace handsight::widgets
