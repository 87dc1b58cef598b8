// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/sampled.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/verdict/explanation.h"
#include "estimation/report/mean_error.h"

namespace handsight {
namespace {

constexpr int most = 4000, size = 3000;
constexpr std::size_t at_once = 4000;  // observations whose chains are in memory together
constexpr double clearly_worse = 1.1;  // times the held-out error

ErrorSummary error_on_the_others(const Session& session, const Sample& sample, const Fit& fit) {
  MeanError mean;
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
