// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/degrees.h"
#include "estimation/report/part_report.h"
#include "fit_output.h"
#include "json_values.h"
#include "session/fixtures/fixture_kind.h"

namespace handsight::cli {
namespace {

std::string compute_error(const ErrorSummary& e) {
  if (e.rms_pixel) return fmt::format("{:.3f} px", *e.rms_pixel);
  return e.mean_m ? fmt::format("{:.3f} mm", 1e3 * *e.mean_m) : "unknown";
}

std::string locate(const Rigid& m) {
  const Vector3 xyz = 1e3 * m.translation, rpy = degrees * rpy_from_rotation(m.rotation);
  return fmt::format("{:.3f} {:.3f} {:.3f} mm, rpy {:.3f} {:.3f} {:.3f} deg", xyz.x(), xyz.y(), xyz.z(), rpy.x(),
                     rpy.y(), rpy.z());
}

/// What touches tell of where a fixture stands on its link, with its sigmas; nothing of what has no meaning.
std::string place_text(const FixtureKind& kind, const FitPart& found) {
  const Rigid& m = found.mount_from_sensor;
  const Matrix6& c = *found.mount_covariance;
  const Vector3 z = m.rotation.col(2), xyz = 1e3 * m.translation;
  const double tilt = 1e3 * std::sqrt(std::max(0.0, c(3, 3) + c(4, 4)));
  const std::string axis = fmt::format("{:.4f} {:.4f} {:.4f}", z.x() + 0.0, z.y() + 0.0, z.z() + 0.0);
  const std::string place = fmt::format("{:.3f} {:.3f} {:.3f} mm", xyz.x() + 0.0, xyz.y() + 0.0, xyz.z() + 0.0);
  if (kind.place == FixturePlace::height)
    return fmt::format("stands {:.3f} +- {:.3f} mm along {} (+- {:.3f} mrad)", z.dot(xyz),
                       1e3 * std::sqrt(std::max(0.0, c(2, 2))), axis, tilt);
  if (kind.place == FixturePlace::axis)
    return fmt::format("goes through {} (+- {:.3f} mm) along {} (+- {:.3f} mrad)", place,
                       1e3 * std::sqrt(std::max(0.0, c(0, 0) + c(1, 1))), axis, tilt);
  const Vector3 sigma = 1e3 * (m.rotation * c.topLeftCorner<3, 3>() * m.rotation.transpose()).diagonal().cwiseSqrt();
  return fmt::format("is at {} (+- {:.3f} {:.3f} {:.3f} mm)", place, sigma.x(), sigma.y(), sigma.z());
}

/// The same as numbers of the link's frame; null where nothing is known.
Json place_json(const FixtureKind& kind, const FitPart& found) {
  if (!found.mount_covariance || !found.place_is_determined) return nullptr;
  const Rigid& m = found.mount_from_sensor;
  const Matrix6& c = *found.mount_covariance;
  const Vector3 z = m.rotation.col(2);
  const double tilt = std::sqrt(std::max(0.0, c(3, 3) + c(4, 4)));
  if (kind.place == FixturePlace::height)
    return {{kind.direction, numbers(z)},
            {"offset", z.dot(m.translation)},
            {"sigma_m", std::sqrt(std::max(0.0, c(2, 2)))},
            {"sigma_rad", tilt}};
  if (kind.place == FixturePlace::axis)
    return {{"xyz", numbers(m.translation)},
            {kind.direction, numbers(z)},
            {"sigma_m", std::sqrt(std::max(0.0, c(0, 0) + c(1, 1)))},
            {"sigma_rad", tilt}};
  const Matrix3 of_place = m.rotation * c.topLeftCorner<3, 3>() * m.rotation.transpose();
  return {{"xyz", numbers(m.translation)}, {"sigma_m", numbers(Vector3(of_place.diagonal().cwiseMax(0).cwiseSqrt()))}};
}

void add_errors(const ErrorSummary& e, const std::string& prefix, Json& json) {
  json[prefix + "rms_pixel"] = number(e.rms_pixel);
  json[prefix + "rms_m"] = number(e.rms_m);
  json[prefix + "mean_m"] = number(e.mean_m);
}

Json observations_json(const PartReport& part) {
  Json list = Json::array();
  for (const ObservationReport& o : part.per_observation)
    list.push_back({{"id", o.id},
                    {"rms_pixel", number(o.rms_pixel)},
                    {"rms_m", number(o.rms_m)},
                    {"tcp_from_tcp_est", o.deviation ? motion(o.deviation->tcp_from_tcp_est) : Json(nullptr)},
                    {"outlier", o.outlier}});
  return list;
}

}  // namespace

void print_parts(const Output& out, const Session& session, const Fit& fit, const FitReport& reported) {
  const std::vector<PartReport> parts = part_reports(session, fit, reported);
  if (parts.empty()) return;
  out.line();
  out.line(fmt::format("{:<20} {:>6} {:>12} {:>12} {:>14}", session.is_touch() ? "fixture" : "session", "used",
                       "fitted", "held out", "robot from the"));
  out.line(fmt::format("{:<20} {:>6} {:>12} {:>12} {:>14}", "", "", "", "", "others alone"));
  for (const PartReport& p : parts)
    out.line(fmt::format("{:<20} {:>6} {:>12} {:>12} {:>14}", p.title, p.used, compute_error(p.fitted),
                         compute_error(p.held_out), compute_error(p.held_out_session)));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartReport& p = parts[i];
    if (const int f = session.parts[i].fixture; f >= 0 && p.found.mount_covariance) {
      const Fixture& fixture = session.fixtures[static_cast<std::size_t>(f)];
      const std::string& link = find_mount(session, session.parts[i].mount).link;
      out.line(p.title + (p.found.place_is_determined
                              ? fmt::format(" {} on {}", place_text(*fixture.kind, p.found), link)
                              : " is not determined by these touches"));
    }
    if (session.is_touch()) continue;
    const Vector6 sigma = origin_sigma(p.found.tcp_from_body, p.found.covariance);
    out.line(fmt::format("{}: tcp_from_body {} (+- {:.3f} {:.3f} {:.3f} mm)", p.title, locate(p.found.tcp_from_body),
                         1e3 * sigma[0], 1e3 * sigma[1], 1e3 * sigma[2]));
    if (p.found.mount_covariance && session.parts[i].fixture < 0)
      out.line(fmt::format("{}: mount {}", std::string(p.title.size(), ' '), locate(p.found.mount_from_sensor)));
  }
}

Json parts_json(const Session& session, const Fit& fit, const FitReport& reported) {
  Json list = Json::array();
  const std::vector<PartReport> parts = part_reports(session, fit, reported);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartReport& p = parts[i];
    Json one{{"title", p.title}, {"observations", p.observations}, {"used", p.used}};
    one["tcp_from_body"] = {{"matrix", motion(p.found.tcp_from_body)}, {"covariance", matrix(p.found.covariance)}};
    one["mount"] = {{"matrix", motion(p.found.mount_from_sensor)},
                    {"covariance", p.found.mount_covariance ? matrix(*p.found.mount_covariance) : Json(nullptr)}};
    if (const int f = session.parts[i].fixture; f >= 0)
      one["place"] = place_json(*session.fixtures[static_cast<std::size_t>(f)].kind, p.found);
    add_errors(p.fitted, "", one);
    add_errors(p.held_out, "held_out_", one);
    one["held_out_session_pixel"] = number(p.held_out_session.rms_pixel);
    one["held_out_session_rms_m"] = number(p.held_out_session.rms_m);
    one["held_out_session_mean_m"] = number(p.held_out_session.mean_m);
    Json markers = Json::array();
    for (const Vector3& x : p.found.markers_in_body) markers.push_back(numbers(x));
    one["markers"] = markers;
    one["per_observation"] = observations_json(p);
    list.push_back(one);
  }
  return list;
}

}  // namespace handsight::cli
