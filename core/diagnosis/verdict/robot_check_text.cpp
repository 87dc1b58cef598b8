// SPDX-License-Identifier: Apache-2.0
// A check in words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/verdict/robot_check.h"

namespace handsight {
namespace {

constexpr double sigmas_inside = 2;

struct Shown {
  double scale;
  std::string unit;
};

Shown shown(const std::string& unit) {
  if (unit == "m") return {1e3, " mm"};
  if (unit == "rad") return {1e3, " mrad"};
  if (unit == "1") return {100, " %"};
  return {1, " " + unit};
}

/// Two digits of the sigma, and the value to the same place.
Message with_sigma(double value, double sigma) {
  if (!(sigma > 0)) return message("{:.3g}", value);
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(sigma))), 0, 9);
  return message("{:.{}f} +- {:.{}f}", value, places, sigma, places);
}

}  // namespace

Message prediction_text(const CheckPrediction& p) {
  const Shown unit = shown(p.unit);
  return message("{} {}{}{}.", p.before, with_sigma(unit.scale * p.value, unit.scale * p.sigma), unit.unit,
                 p.after.empty() ? Message() : message(" {}", p.after));
}

CheckAnswer answer_check(const CheckPrediction& p, double measured, double measured_sigma) {
  CheckAnswer answer;
  const double both = std::max(std::hypot(p.sigma, measured_sigma), 1e-12);
  answer.sigmas = std::abs(measured - p.value) / both;
  answer.is_inside = answer.sigmas <= sigmas_inside;
  answer.could_be_nothing = std::abs(measured) <= sigmas_inside * measured_sigma;
  const Message far = message("{:.{}f} sigma from the prediction", answer.sigmas, answer.sigmas < 9.95 ? 1 : 0);
  if (answer.is_inside)
    answer.text = answer.could_be_nothing
                      ? message("Inside: {}, but so would nothing be. The check was too coarse to tell.", far)
                      : message("Inside: {}. That speaks for this cause.", far);
  else
    answer.text = answer.could_be_nothing
                      ? message("Outside: {}, and nothing shows. That speaks against this cause.", far)
                      : message("Outside: {}. It is another cause, or not this one alone.", far);
  return answer;
}

}  // namespace handsight
