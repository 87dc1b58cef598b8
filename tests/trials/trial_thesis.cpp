// SPDX-License-Identifier: Apache-2.0
// The thesis's simulation (section 5.1): six poses, every marker measured 1 cm nearer along the camera's z.
#include <fmt/format.h>

#include "estimation/report/fit_report.h"
#include "estimation/report/one_marker.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

constexpr double degrees = 57.29577951308232;

const char* display_name(Objective objective) {
  return objective == Objective::image ? "image" : objective == Objective::camera ? "camera" : "angle-axis";
}

void three_markers(Session session, bool estimate_mount) {
  session.mount.estimate = estimate_mount;
  fmt::print("\nThree markers, mount {}\n",
             estimate_mount ? "estimated (from where it is said to be)" : "fixed where it is said to be");
  for (const Objective objective : {Objective::angle_axis, Objective::camera, Objective::image}) {
    const FitOptions options{.objective = objective};
    const Fit f = fit(session, options);
    const FitReport r = report(session, f, options);
    double metres = 0, rad = 0;
    for (const ObservationReport& o : r.per_observation) {
      metres += o.deviation->tcp_from_tcp_est.translation.squaredNorm();
      rad += vector_from_rotation(o.deviation->tcp_from_tcp_est.rotation).squaredNorm();
    }
    const double n = r.used;
    fmt::print("  {:<10} image {:.3g} px rms, markers {:.3g} mm rms; TCP->TCPest {:.3g} mm, {:.3g} deg rms\n",
               display_name(objective), *r.fitted.rms_pixel, 1e3 * *r.fitted.rms_m, 1e3 * std::sqrt(metres / n),
               degrees * std::sqrt(rad / n));
  }
}

void one_marker(const Session& session) {
  // What the thesis prints: norms of the deviations left, m.
  const double thesis[] = {0.0085, 0.0087, 0.0080, 0.0081, 0.0093, 0.0093};
  Session nominal = session;
  nominal.mount.estimate = true;
  const Fit f = fit(nominal);  // the true body: the shift is all in the mount
  const OneMarkerResult r = effective_masses(session, {.marker_in_tcp = estimate(f).markers_in_tcp[0]});
  fmt::print("\nOne marker: the pull at the TCP, per observation (thesis: mm left of 10)\n");
  fmt::print("  observation  before mm  left mm  predicted by the angle mm  off %  angle deg  thesis left mm\n");
  double worst = 0;
  for (std::size_t i = 0; i < r.observations.size(); ++i) {
    const EffectiveMass& m = r.observations[i];
    const double off = 100 * std::abs(m.after.norm() - m.predicted_after) / m.before.norm();
    worst = std::max(worst, off);
    fmt::print("  {:>11}  {:>9.3f}  {:>7.3f}  {:>25.3f}  {:>5.2f}  {:>9.1f}  {:>14}\n", m.id, 1e3 * m.before.norm(),
               1e3 * m.after.norm(), 1e3 * m.predicted_after, off, degrees * m.angle,
               i < 6 ? fmt::format("{:.1f}", 1e3 * thesis[i]) : "");
  }
  fmt::print("  largest difference {:.2f} % of the deviation: {}\n", worst, worst <= 1 ? "ok" : "NOT MET (1 %)");
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  using namespace handsight;
  const Session session = read_session(argc > 1 ? argv[1] : HANDSIGHT_SOURCE_DIR "/sample_sessions/thesis_simulation");
  three_markers(session, true);
  three_markers(session, false);
  one_marker(session);
}
