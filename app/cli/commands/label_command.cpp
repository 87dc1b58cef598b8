// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/numbers.h"
#include "command.h"
#include "printing/json_values.h"
#include "session/session_xml.h"
#include "vision/corners/corner_detector.h"
#include "vision/image/image_file.h"
#include "vision/markers/first_observation.h"

namespace handsight::cli {
namespace {

struct LabelArguments {
  std::string session;
  std::int64_t observation = 0;
  std::vector<std::string> left;
  std::vector<int> markers;  // their numbers; empty: 0, 1, 2, ...
  Output output;
};

Vector2 parse_point(const std::string& text) {
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  double u = 0, v = 0;
  int used = 0;
  if (std::sscanf(spaced.c_str(), "%lf %lf %n", &u, &v, &used) != 2 || used != static_cast<int>(spaced.size()) ||
      !std::isfinite(u) || !std::isfinite(v))
    throw InputError(message("--left \"{}\" is not a point; write \"u,v\" in px, for example \"312.5,204\".", text));
  return {u, v};
}

Observation& observation_with(Session& session, std::int64_t id) {
  for (Observation& o : session.observations)
    if (o.id == id) return o;
  throw InputError(message("The session has no observation {}; its ids are {} to {}.", id,
                           session.observations.front().id, session.observations.back().id));
}

/// Which markers the points are: as many as can be seen, three at least where the session has three.
std::vector<int> marker_numbers(const LabelArguments& options, int marker_count) {
  std::vector<int> all = options.markers;
  if (all.empty())
    for (std::size_t m = 0; m < options.left.size(); ++m) all.push_back(static_cast<int>(m));
  const std::set<int> different(all.begin(), all.end());
  if (all.size() != options.left.size() || different.size() != all.size() || *different.begin() < 0 ||
      *different.rbegin() >= marker_count)
    throw InputError(
        message("--left has {} points for the markers {}; the session has markers 0 to {}: one point for each "
                "marker, each once.",
                options.left.size(), fmt::join(all, " "), marker_count - 1));
  if (static_cast<int>(all.size()) < std::min(3, marker_count))
    throw InputError(message("--left has {} points; a pose needs {} of the session's {} markers.", all.size(),
                             std::min(3, marker_count), marker_count));
  return all;
}

int run(const LabelArguments& options) {
  Session session = open_session(options.session, options.output);
  if (session.target || session.pose_sensor)
    throw InputError(message(
        "{}: nothing is to be labelled in a session with a <target>: its points name themselves; run online or fit.",
        session.file.filename().string()));
  if (!session.rig) throw InputError("A tracker session has no images to label; its markers are points already.");
  require_pair(session, "label");
  Observation& observation = observation_with(session, options.observation);
  if (observation.images[0].empty() || observation.images[1].empty())
    throw InputError(message("Observation {} has no images to label; name a left and a right image in its <images>.",
                             observation.id));
  const std::vector<int> list_numbers = marker_numbers(options, session.marker_count);
  std::vector<Vector2> pointed;
  for (const std::string& text : options.left) pointed.push_back(parse_point(text));
  const Image left =
      read_image(folder(session) / observation.images[0], session.rig->at(0).camera, observation.images[0]);
  const Image right =
      read_image(folder(session) / observation.images[1], session.rig->at(1).camera, observation.images[1]);
  const FirstLabels labels =
      label_first(make_stereo(*session.rig), detect_corners(left), detect_corners(right), pointed);
  Json result{{"observation", observation.id}, {"refusal", labels.refusal}, {"markers", Json::array()}};
  if (!labels.refusal.empty()) {
    options.output.json(result);
    throw InputError(labels.refusal);
  }
  observation.sightings.clear();
  for (std::size_t m = 0; m < labels.markers.size(); ++m) {
    const LabelledMarker& l = labels.markers[m];
    Sighting& sighting = observation.sightings.emplace_back(Sighting{.marker = list_numbers[m], .by = MarkedBy::hand});
    see(sighting, 0, l.left, pixel_sigma(l.left_covariance));
    see(sighting, 1, l.right, pixel_sigma(l.right_covariance));
    result["markers"].push_back({{"index", list_numbers[m]},
                                 {"left", numbers(l.left)},
                                 {"right", numbers(l.right)},
                                 {"point", numbers(l.point.point)},
                                 {"epipolar_distance_pixel", l.point.epipolar_distance},
                                 {"other_candidates", l.other_candidates}});
    options.output.line(fmt::format(
        "marker {}  left {:8.2f} {:8.2f}  right {:8.2f} {:8.2f}  depth {:.3f} m  {:.2f} px from its epipolar line",
        list_numbers[m], l.left.x(), l.left.y(), l.right.x(), l.right.y(), l.point.point.z(),
        l.point.epipolar_distance));
  }
  for (std::size_t a = 0; a < labels.markers.size(); ++a)
    for (std::size_t b = a + 1; b < labels.markers.size(); ++b)
      options.output.line(fmt::format("side {}-{}  {:.1f} mm", list_numbers[a], list_numbers[b],
                                      1e3 * (labels.markers[b].point.point - labels.markers[a].point.point).norm()));
  std::sort(observation.sightings.begin(), observation.sightings.end(),
            [](const Sighting& a, const Sighting& b) { return a.marker < b.marker; });
  observation.decision = Decision::none;
  observation.reason = {};
  replace_session(session);
  options.output.json(result);
  options.output.line(fmt::format("Saved: observation {} is labelled.", observation.id));
  return done;
}

}  // namespace

Command add_label(const CommandLine& program) {
  auto options = std::make_shared<LabelArguments>();
  const CommandLine command =
      program.command("label", "Labels the first observation: snaps to corners, finds the right image's");
  add_session_option(command, options->session);
  command.option("--observation", options->observation, "Id of the observation").required();
  command.option("--left", options->left, "\"u,v\" in the left image, one for each marker").required().takes(1, 64);
  command.option("--markers", options->markers,
                 "Their numbers, where not every marker is seen: 0 1 2 ... where left out");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
