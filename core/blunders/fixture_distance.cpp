// SPDX-License-Identifier: Apache-2.0
#include "blunders/fixture_distance.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "estimation/fit/fit_parts.h"
#include "estimation/fit/touch_counts.h"

namespace handsight {
namespace {

constexpr double times_better = 10;  // of the rms error: a wrong distance bends all else, chance does not

double reading_rms(const Fit& f) {
  std::size_t count = 0;
  for (const ProblemObservation& o : f.problem.observations) count += o.sightings.size();
  return std::sqrt(f.solution.normal.data_cost() / static_cast<double>(std::max<std::size_t>(1, count)));
}

}  // namespace

std::optional<DistanceDoubt> doubtful_distance(const Session& session, const Fit& given, const FitOptions& options) {
  if (!session.is_touch() || session.distances.empty()) return std::nullopt;
  Session without = session;
  without.distances.clear();
  if (touches_lacking_text(without)) return std::nullopt;  // nothing would be left to contradict it
  const Fit free = fit(without, options);
  DistanceDoubt doubt{0, 0, reading_rms(given), reading_rms(free), {}};
  if (!free.converged() || !(doubt.rms_before > times_better * doubt.rms_after)) return std::nullopt;
  const std::vector<FitPart> parts = list_parts(without, free);
  double most = 0;
  for (std::size_t d = 0; d < session.distances.size(); ++d) {
    const auto of = static_cast<std::size_t>(session.distances[d].of),
               from = static_cast<std::size_t>(session.distances[d].from);
    const auto link = [&](std::size_t f) {
      return find_mount(session, part_of_fixture(session, static_cast<int>(f)).mount).link;
    };
    if (of >= parts.size() || from >= parts.size() || link(of) != link(from)) continue;
    const double measured =
        (parts[of].mount_from_sensor.translation - parts[from].mount_from_sensor.translation).norm();
    const double off = std::abs(measured - session.distances[d].by);
    if (off <= most) continue;
    most = off;
    doubt.distance = static_cast<int>(d);
    doubt.measured = measured;
  }
  if (most == 0) return std::nullopt;
  const KnownDistance& named = session.distances[static_cast<std::size_t>(doubt.distance)];
  doubt.text = message(
      "The touches contradict that {} is {:.3f} mm from {}: by them it is {:.3f} mm, and without known distances "
      "{:.3g} mm "
      "are left of them in place of {:.3g} mm. Measure it again and put it right in <apart>.",
      session.fixtures[static_cast<std::size_t>(named.of)].id, 1e3 * named.by,
      session.fixtures[static_cast<std::size_t>(named.from)].id, 1e3 * doubt.measured, 1e3 * doubt.rms_after,
      1e3 * doubt.rms_before);
  return doubt;
}

}  // namespace handsight
