// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "chain/chain.h"
#include "convert/choose_turns.h"
#include "convert/convert_inputs.h"
#include "convert/pair_poses.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/sure_fit.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

constexpr double clearly = 2;  // times: what the next best reading leaves more

/// The points of one marker as poses without a turn; rows in which it was not seen are left out.
NamedPoses as_poses(const PointSeries& points) {
  NamedPoses seen{"points", "", {.times = {}, .poses = {}}};
  seen.series.row_count = points.points.size();
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    if (!points.points[i].front()) continue;
    seen.series.poses.push_back({Matrix3::Identity(), *points.points[i].front()});
    seen.series.places.push_back(i);
    if (!points.times.empty()) seen.series.times.push_back(points.times[i]);
  }
  return seen;
}

/// One reading of the flange's turns, and what a fit leaves with it.
struct FittedReading {
  TurnReading reading;
  Session session;
  double rms = 1e300;  // m of a coordinate
};

FittedReading fitted_as(const Session& session, const NamedPoses& flange, const TurnReading& reading) {
  FittedReading trial{reading, session};
  PoseSeries series = flange.series;
  read_turns(flange.turns, reading, series);
  for (std::size_t i = 0; i < trial.session.observations.size(); ++i)
    trial.session.observations[i].position = make_position(series.poses[i]);
  try {
    const Fit f = fit(trial.session, {.smallest_step = 1e-9});
    if (!has_no_answer(f)) trial.rms = f.residual_rms;
  } catch (const InputError&) {  // no answer
  }
  return trial;
}

Message left_text(const FittedReading& trial) {
  return trial.rms < 1 ? message("{:.3g} mm", 1e3 * trial.rms) : Message("more than a metre");
}

/// The reading of the flange's turns by which the points stand still best; the session's file is written anew with it.
void choose_turns_by_points(const NamedPoses& flange, Conversion& c) {
  std::vector<FittedReading> trials;
  for (const TurnReading& reading : flange.turns.readings) trials.push_back(fitted_as(c.session, flange, reading));
  std::stable_sort(trials.begin(), trials.end(),
                   [](const FittedReading& a, const FittedReading& b) { return a.rms < b.rms; });
  const FittedReading &best = trials[0], &next = trials[1];
  if (!(clearly * best.rms < next.rms))
    throw InputError(
        message("{}: {} may be {}, or {}: the points go with both ({} and {} are left); say it with "
                "--angles (rotation_vector, rpy, abc, wpr, oat, staubli ...) and --degrees, or in the "
                "header ([deg]).",
                flange.file, flange.turns.columns, reading_text(best.reading), reading_text(next.reading),
                left_text(best), left_text(next)));
  c.notes.push_back(message("{}: {} are read as {}: {} is left of the points, and {} by the next best reading.",
                            flange.file, columns_text(flange.turns, best.reading), reading_text(best.reading),
                            left_text(best), left_text(next)));
  c.session = best.session;
  c.session.source.reset();  // poses are written anew
  replace_file(c.session.file, session_text(c.session));
  c.session = read_session(c.session.file);
}

}  // namespace

Conversion from_flange_points(NamedPoses flange, const PointSeries& points, bool eye_in_hand, const ConvertOptions& o,
                              Conversion c) {
  if (points.points.front().size() > 1)
    throw InputError(
        message("There are poses of the flange and points of {} markers; expected one marker, or the "
                "robot's URDF and a table of its joint readings.",
                points.points.front().size()));
  NamedPoses seen = as_poses(points);
  pair_poses(flange, seen, o, c.notes);
  SessionParts parts;
  set_flange(parts, flange.series, eye_in_hand, c.notes);
  parts.times = seen.series.times.empty() ? flange.series.times : seen.series.times;
  for (const Rigid& pose : seen.series.poses) parts.points.push_back({pose.translation});
  c.notes.push_back(eye_in_hand ? "The flange carries the sensor, which sees a marker that stands still; where the "
                                  "flange carries the marker: --eye-on-base."
                                : "The flange carries the marker, which a sensor that stands still sees.");
  c.session = write_measured_session(parts, o);
  if (is_open(flange)) choose_turns_by_points(flange, c);
  return c;
}

}  // namespace handsight
