// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "command.h"
#include "estimation/report/one_marker.h"
#include "printing/json_values.h"

namespace handsight::cli {
namespace {

struct EffectiveMassArguments {
  std::string session;
  OneMarkerOptions one_marker;
  std::vector<double> marker_in_tcp;
  Output output;
};

int run(const EffectiveMassArguments& o) {
  const Session session = open_searched_session(o.session, o.output);
  OneMarkerOptions options = o.one_marker;
  if (!o.marker_in_tcp.empty())
    options.marker_in_tcp = Vector3(o.marker_in_tcp[0], o.marker_in_tcp[1], o.marker_in_tcp[2]);
  const OneMarkerResult r = effective_masses(session, options);
  std::string joints;
  for (const std::string& name : r.joints) joints += (joints.empty() ? "" : ", ") + name;
  o.output.line(fmt::format(
      "Marker {}: the force at the TCP that pulls it toward where it was measured. Springs: {}{}", options.marker,
      joints,
      r.stiffness_is_assumed ? fmt::format(" ({:g} N m/rad where none is declared)", options.default_stiffness) : ""));
  o.output.line("   id      mass    before     after   angle  predicted  after, left camera's frame");
  o.output.line("             kg        mm        mm     deg         mm  x, y, z mm");
  Json list = Json::array();
  for (const EffectiveMass& m : r.observations) {
    o.output.line(fmt::format("{:>5} {:>9.2f} {:>9.3f} {:>9.3f} {:>7.1f} {:>10.3f}  {:.3f}, {:.3f}, {:.3f}", m.id,
                              m.mass, 1e3 * m.before.norm(), 1e3 * m.after.norm(), 57.29577951308232 * m.angle,
                              1e3 * m.predicted_after, 1e3 * m.after.x(), 1e3 * m.after.y(), 1e3 * m.after.z()));
    list.push_back({{"id", m.id},
                    {"mass", m.mass},
                    {"before", numbers(m.before)},
                    {"after", numbers(m.after)},
                    {"angle", m.angle},
                    {"predicted_after_m", m.predicted_after}});
  }
  if (!r.left_out.empty())
    o.output.line(
        fmt::format("{} observations do not show the marker as a point and are left out.", r.left_out.size()));
  o.output.json({{"marker", options.marker},
                 {"joints", r.joints},
                 {"stiffness_is_assumed", r.stiffness_is_assumed},
                 {"observations", list},
                 {"left_out", r.left_out}});
  return done;
}

}  // namespace

Command add_effective_mass(const CommandLine& program) {
  auto options = std::make_shared<EffectiveMassArguments>();
  const CommandLine command =
      program.command("effective-mass", "One marker: the mass that pulls the TCP toward it, per observation");
  add_session_option(command, options->session);
  command.option("--marker", options->one_marker.marker, "Which marker");
  command.option("--stiffness", options->one_marker.default_stiffness, "N m/rad, of joints that declare none")
      .within(bounds::stiffness);
  command
      .option("--marker-in-tcp", options->marker_in_tcp,
              "m, x y z: the initial guess; a fit of the session where it is left out")
      .takes(3)
      .within(-10, 10);
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
