// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/model_version.h"

#include "base/error.h"
#include "estimation/export.h"

namespace handsight::app {

ErrorAndNoise error_and_noise(const ModelVersion& version) {
  ErrorAndNoise result;
  if (!version.fit) return result;
  const FitReport& report = *version.report;
  result.in_pixels = version.fit->problem.rig.has_value();
  const auto of = [&](const ErrorSummary& e) { return result.in_pixels ? e.rms_pixel : e.rms_m; };
  result.error = of(report.held_out);
  result.held_out = result.error.has_value();
  if (!result.error) result.error = of(report.fitted);
  result.noise = version.fit->noise;
  return result;
}

Vector6 origin_sigma(const Fit& fit) {
  Matrix6 at_origin = Matrix6::Identity();
  at_origin.topRightCorner<3, 3>() = -cross_matrix(fit.tcp_from_body.translation);
  return (at_origin * fit.covariance * at_origin.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
}

ModelVersionPointer make_version(const Session& session, const ModelSettings& settings, std::int64_t revision,
                                 QString cause, const SecondLooks& looks) {
  auto version = std::make_shared<ModelVersion>();
  version->revision = revision;
  version->cause = std::move(cause);
  version->settings = settings;
  version->options.objective = settings.objective;
  version->options.fix_markers = settings.fix_markers;
  try {
    auto fitted = std::make_shared<Fit>(fit(session, version->options));
    auto told = std::make_shared<FitReport>(report(session, *fitted, version->options));
    for (std::size_t i = 0; i < told->per_observation.size(); ++i)
      version->row_of[told->per_observation[i].id] = static_cast<int>(i);
    version->inspection =
        std::make_shared<Inspection>(inspect(session, *fitted, *told, version->options.effects, looks));
    version->calibration = std::make_shared<Calibration>(
        calibration_of(session, *fitted, *told, version->options, "handsight " HANDSIGHT_VERSION));
    version->scatter = tcp_scatter(*fitted);
    version->fit = std::move(fitted);
    version->report = std::move(told);
  } catch (const InputError& error) {
    version->refusal = QString::fromStdString(error.what());
  }
  return version;
}

}  // namespace handsight::app
