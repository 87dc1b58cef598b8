// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "diagnosis/proof/proof.h"
#include "effects/units.h"

namespace handsight {
namespace {

/// To the place of sigma's second digit.
std::string with_sigma(double value, double sigma, double factor) {
  value *= factor, sigma *= factor;
  if (!(sigma > 0)) return fmt::format("{:.3g}", value);
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(sigma))), 0, 9);
  return fmt::format("{:.{}f} +- {:.{}f}", value, places, sigma, places);
}

/// Two digits and more: 12 N m, 0.57 mrad.
std::string rounded(double value, const std::string& unit) {
  const auto [name, factor] = readable_unit(unit, std::abs(value));
  const double shown = value * factor;
  const int places = shown == 0 ? 0 : std::clamp(1 - static_cast<int>(std::floor(std::log10(std::abs(shown)))), 0, 4);
  return fmt::format("{:.{}f} {}", shown, places, name);
}

std::string sized(double value, double sigma, const std::string& of_unit) {
  const auto [unit, factor] = readable_unit(of_unit, std::abs(value));
  return fmt::format("{} {}", with_sigma(value, sigma, factor), unit);
}

std::string number_text(const ProofNumber& n) { return sized(n.value, n.sigma, n.unit); }

/// How far the quantity itself goes: an axis along y has w along -z, and the shift along z is that of w turned round.
std::string level_text(const ProofPlot& plot) {
  const double share = plot.points.empty() ? 1 : plot.points.front().share[0];
  const ProofNumber& n = plot.numbers.front();
  return sized(share * n.value, std::abs(share) * n.sigma, plot.unit);
}

std::string at_most(const ProofPlot& plot) {
  const std::string hand = plot.hand_m > 0 ? fmt::format(", {:.2g} mm at the hand", 1e3 * plot.hand_m) : std::string();
  return rounded(plot.largest, plot.unit) + hand;
}

/// One number that moves the same in every pose.
bool is_level(const ProofPlot& plot) {
  for (const ProofPoint& p : plot.points)
    if (p.share.size() != 1 || p.share[0] != plot.points.front().share[0]) return false;
  return true;
}

/// A unit of the number is one of the quantity per one of what it follows: a spring.
bool is_per_load(const ProofPlot& plot) {
  return plot.numbers.size() == 1 && plot.numbers.front().unit.find('/') != std::string::npos &&
         plot.numbers.front().unit.ends_with(plot.against_unit + ")");
}

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

double followed(const ProofPlot& plot) {
  double before = 0, left = 0;
  for (const ProofPoint& p : plot.points) {
    if (!(p.sigma > 0)) continue;
    before += p.y * p.y / (p.sigma * p.sigma);
    left += (p.y - p.curve) * (p.y - p.curve) / (p.sigma * p.sigma);
  }
  return before > 0 ? std::clamp(1 - left / before, 0.0, 1.0) : 0;
}

std::string proof_text(const ProofPlot& plot) {
  const ProofNumber& first = plot.numbers.front();
  if (is_per_load(plot)) {
    const bool bends = plot.quantity.english().starts_with("bend");
    const auto [unit, factor] = readable_unit(plot.unit, std::abs(first.value));
    return fmt::format("{} {} by {} {} for each {}: {} at most here, so {}.", plot.of,
                       bends ? "bends across its axis" : "gives way", with_sigma(first.value, first.sigma, factor),
                       unit, plot.against_unit, rounded(plot.largest_x, plot.against_unit), at_most(plot));
  }
  if (is_level(plot)) {
    const std::string of =
        plot.of.empty() || plot.quantity.english().find(plot.of) != std::string::npos ? "" : " of " + plot.of;
    return fmt::format("{}{}: {} in every pose{}.", capital(plot.quantity), of, level_text(plot),
                       plot.hand_m > 0 ? fmt::format(", {:.2g} mm at the hand at most", 1e3 * plot.hand_m) : "");
  }
  std::string numbers;
  for (const ProofNumber& n : plot.numbers)
    numbers +=
        (numbers.empty() ? "" : ", ") + (plot.numbers.size() > 1 ? n.name + " " + number_text(n) : number_text(n));
  return fmt::format("{} against {}: {}; {} at most here.", capital(plot.quantity), plot.against, numbers,
                     at_most(plot));
}

std::string proof_csv_head() {
  return "candidate,of,quantity,unit,against,against_unit,observation,x,y,sigma,curve,left\n";
}

std::string proof_csv_lines(const std::string& candidate, const ProofPlot& plot) {
  const auto field = [](const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
  };
  const std::string start = fmt::format("{},{},{},{},{},{},", field(candidate), field(plot.of), field(plot.quantity),
                                        field(plot.unit), field(plot.against), field(plot.against_unit));
  std::string lines;
  for (const ProofPoint& p : plot.points)
    lines += fmt::format("{}{},{},{},{},{},{}\n", start, p.id, p.x, p.y, p.sigma, p.curve, p.y - p.curve);
  return lines;
}

}  // namespace handsight
