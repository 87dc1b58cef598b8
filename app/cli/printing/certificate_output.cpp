// SPDX-License-Identifier: Apache-2.0
#include "certificate_output.h"

#include <fmt/format.h>

#include "base/degrees.h"
#include "certify/certificate_pdf.h"
#include "json_values.h"

namespace handsight::cli {
namespace {

Json mm(double m) { return number(1e3 * m); }
Json mm(const std::optional<double>& m) { return m ? mm(*m) : Json(nullptr); }
Json mm(const Vector3& m) { return numbers(Vector3(1e3 * m)); }
Json deg(const std::optional<double>& rad) { return rad ? number(degrees * *rad) : Json(nullptr); }
Json deg(const Vector3& rad) { return numbers(Vector3(degrees * rad)); }

Json errors_json(const ErrorFigures& f) {
  return {{"mean_mm", mm(f.mean)},   {"rms_mm", mm(f.rms)},        {"p95_mm", mm(f.p95)},
          {"max_mm", mm(f.largest)}, {"rms_deg", deg(f.rms_turn)}, {"max_deg", deg(f.largest_turn)}};
}

Json pose_json(const PoseFigures& f, bool shows_turn) {
  const Json none = nullptr;
  return {{"AP_mm", mm(f.ap)},
          {"AP_xyz_mm", mm(f.ap_xyz)},
          {"AP_abc_deg", shows_turn ? deg(f.ap_abc) : none},
          {"RP_mm", mm(f.rp)},
          {"RP_abc_deg", shows_turn && f.rp_abc ? deg(*f.rp_abc) : none}};
}

Json distance_json(const DistanceFigures& f) { return {{"AD_mm", mm(f.ad)}, {"RD_mm", mm(f.rd)}}; }

Json poses_json(const IsoTest& iso) {
  Json list = Json::array();
  for (const IsoPose& p : iso.poses)
    list.push_back({{"first_id", p.first_id},
                    {"cycles", p.before.cycles},
                    {"before", pose_json(p.before, p.shows_turn)},
                    {"after", pose_json(p.after, p.shows_turn)}});
  return list;
}

Json distances_json(const IsoTest& iso) {
  Json list = Json::array();
  for (const IsoDistance& d : iso.distances)
    list.push_back({{"from_id", d.from_id},
                    {"to_id", d.to_id},
                    {"cycles", d.after.cycles},
                    {"distance_mm", mm(d.after.commanded)},
                    {"before", distance_json(d.before)},
                    {"after", distance_json(d.after)}});
  return list;
}

Json directions_json(const IsoTest& iso) {
  Json list = Json::array();
  for (const IsoDirections& d : iso.directions)
    list.push_back({{"first_id", d.first_id},
                    {"cycles", d.cycles},
                    {"vAP_mm", mm(d.figures.vap)},
                    {"vAP_abc_deg", deg(d.figures.vap_abc)}});
  return list;
}

Json plan_json(const IsoTest& iso) {
  Json list = Json::array();
  for (const PoseToRecord& p : iso.plan)
    list.push_back(
        {{"place", p.place}, {"cycles", p.cycles}, {"position", numbers(p.position)}, {"hand_m", numbers(p.hand)}});
  return list;
}

Json iso_json(const IsoTest& iso) {
  return {{"AP_conforms", iso.has_accuracy},
          {"AD_conforms", iso.has_distance},
          {"vAP_conforms", iso.has_directions},
          {"poses", poses_json(iso)},
          {"distances", distances_json(iso)},
          {"directions", directions_json(iso)},
          {"lacking", iso.lacking},
          {"plan", plan_json(iso)}};
}

Json view_json(const std::vector<ExpectedError>& errors, int across, int up) {
  const MapView view = map_view(errors, across, up);
  Json cells = Json::array();
  for (const MapCell& c : view.cells)
    cells.push_back({{view.across, number(c.across)},
                     {view.up, number(c.up)},
                     {"before_mm", mm(c.before)},
                     {"limit_mm", mm(c.limit)},
                     {"poses", c.poses}});
  return {{"cell_m", number(view.cell)}, {"cells", cells}};
}

Json observations_json(const Certificate& c) {
  Json list = Json::array();
  for (const AttainedPose& p : c.poses)
    list.push_back({{"id", p.id},
                    {"before_mm", mm((p.before.translation - p.commanded.translation).norm())},
                    {"after_mm", mm((p.after.translation - p.commanded.translation).norm())},
                    {"limit_mm", mm(length_limit(p.covariance, 0.95))}});
  return list;
}

Json files_json(const Certificate& c) {
  Json list = Json::array();
  for (const CertifiedFile& f : c.files)
    list.push_back({{"what", f.what}, {"name", f.name}, {"bytes", f.bytes}, {"sha256", f.sha256}});
  return list;
}

}  // namespace

Json certificate_json(const Certificate& c) {
  const Coverage& v = c.coverage;
  return {{"number", certificate_number(c)},
          {"date", c.date},
          {"software", c.software},
          {"session", c.title},
          {"robot", c.robot},
          {"hand", c.hand},
          {"sensor", c.sensor},
          {"calibration", c.model_from},
          {"observations", c.observations},
          {"used", c.used},
          {"folds", c.folds},
          {"before", errors_json(c.before)},
          {"after", errors_json(c.after)},
          {"coverage",
           {{"level", 0.95},
            {"inside", v.inside},
            {"all", v.all},
            {"low", number(v.interval.low)},
            {"high", number(v.interval.high)},
            {"median_limit_mm", mm(c.median_limit)}}},
          {"iso9283", iso_json(c.iso)},
          {"map", {{"top", view_json(c.expected, 0, 1)}, {"side", view_json(c.expected, 0, 2)}}},
          {"per_observation", observations_json(c)},
          {"files", files_json(c)}};
}

void print_certificate(const Output& output, const Certificate& c) {
  output.line("error of the hand      uncorrected   corrected (held out)");
  const auto line = [&](const char* what, double before, double after) {
    output.line(fmt::format("{:<20} {:>9.3f} mm {:>11.3f} mm", what, 1e3 * before, 1e3 * after));
  };
  line("rms", c.before.rms, c.after.rms);
  line("95 of 100 below", c.before.p95, c.after.p95);
  line("greatest", c.before.largest, c.after.largest);
  output.line(fmt::format("{} of {} errors inside their promised 95 % limits ({:.1f} to {:.1f} %).", c.coverage.inside,
                          c.coverage.all, 100 * c.coverage.interval.low, 100 * c.coverage.interval.high));
  for (const std::string& sentence : c.iso.lacking) output.line(sentence);
}

}  // namespace handsight::cli
