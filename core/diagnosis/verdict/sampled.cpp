// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/sampled.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/verdict/explanation.h"

namespace handsight {
namespace {

constexpr int most = 4000, size = 3000;
constexpr std::size_t at_once = 4000;  // observations whose chains are in memory together
constexpr double clearly_worse = 1.1;  // times the held-out error

/// Root mean squares of parts as that of all together, each weighing as much as it has observations.
class Mean {
 public:
  void add(const ErrorSummary& part, double weight) {
    weight_ += weight;
    const auto square = [&](const std::optional<double>& v, double& sum) { sum += v ? weight * *v * *v : 0; };
    square(part.rms_pixel, pixel_);
    square(part.rms_m, metre_);
    square(part.hand_m, hand_);
    mean_ += part.mean_m ? weight * *part.mean_m : 0;
    largest_ = std::max(largest_, part.max_m.value_or(0));
    has_pixel_ = has_pixel_ || part.rms_pixel;
    has_metre_ = has_metre_ || part.rms_m;
    has_hand_ = has_hand_ || part.hand_m;
  }
  ErrorSummary all() const {
    ErrorSummary e;
    if (has_pixel_) e.rms_pixel = std::sqrt(pixel_ / weight_);
    if (has_metre_) {
      e.rms_m = std::sqrt(metre_ / weight_);
      e.mean_m = mean_ / weight_;
      e.max_m = largest_;
    }
    if (has_hand_) e.hand_m = std::sqrt(hand_ / weight_);
    return e;
  }

 private:
  double weight_ = 0, hand_ = 0, pixel_ = 0, metre_ = 0, mean_ = 0, largest_ = 0;
  bool has_pixel_ = false, has_metre_ = false, has_hand_ = false;
};

ErrorSummary error_on_the_others(const Session& session, const Sample& sample, const Fit& fit) {
  Mean mean;
  for (std::size_t first = 0; first < sample.left_out.size(); first += at_once) {
    const std::size_t last = std::min(first + at_once, sample.left_out.size());
    const std::vector<int> some(sample.left_out.begin() + static_cast<std::ptrdiff_t>(first),
                                sample.left_out.begin() + static_cast<std::ptrdiff_t>(last));
    mean.add(error_on(take_part(session, some), fit), static_cast<double>(some.size()));
  }
  return mean.all();
}

double measure_size(const ErrorSummary& e) { return e.rms_pixel ? *e.rms_pixel : e.rms_m.value_or(0); }

}  // namespace

std::optional<Sample> sample_to_judge(const Session& session) { return take_sample(session, most, size); }

void check_on_the_others(const Session& session, const Sample& sample, Diagnosis& d) {
  if (d.stopped) return;
  d.sample =
      SampleCheck{static_cast<int>(sample.taken.size()), static_cast<int>(sample.taken.size() + sample.left_out.size()),
                  error_on_the_others(session, sample, d.model.fit)};
  d.report.observations = static_cast<int>(session.observations.size());
  const bool is_worse = measure_size(d.sample->others) > clearly_worse * measure_size(d.report.held_out);
  d.reason += message(
      " Judged by {} of the {} observations, evenly over the session; the model meets the others to "
      "{}{}",
      d.sample->taken, d.sample->all, reported_error(d.sample->others),
      is_worse ? ", which is worse than what was held out here: wrong points among them, or "
                 "something that these did not show."
               : ", no worse than these.");
}

}  // namespace handsight
