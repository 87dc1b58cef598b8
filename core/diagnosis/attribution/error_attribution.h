// SPDX-License-Identifier: Apache-2.0
// Whose fault an observation's error is (the cameras, the marker body, the robot), which single change would make it
// right, and the smallest wrong corner that it could have shown.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/message.h"
#include "camera/rig.h"
#include "estimation/fit/fit_result.h"
#include "estimation/problem/problem.h"
#include "geometry/rigid.h"
#include "session/session.h"

namespace handsight {

/// Squared residuals of one observation (px^2, m^2) by what could take them up, and their degrees of freedom: cameras:
/// what is left when every marker may be anywhere; body: what more is left when the body may be anywhere; robot: what
/// the body's own pose takes away.
struct ResidualParts {
  double cameras = 0, body = 0, robot = 0;
  int camera_rows = 0, body_rows = 0, robot_rows = 0;
  double total = 0;  // against the model
  int rows = 0;
  std::optional<Rigid> sensor_from_body;  // the body's own pose, the markers in the TCP frame standing for it
};

/// Of an observation at a model's unknowns; nothing in `robot` where it does not show three markers.
ResidualParts residual_parts(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns);

/// Probability of noise alone below which an error counts as seen.
inline constexpr double least_likely_noise = 1e-5;

/// Root of a sum of squares by the numbers in it; 0 of none.
inline double rms(double squares, int rows) { return rows > 0 ? std::sqrt(std::max(squares, 0.0) / rows) : 0; }

/// What the observations of a session show at the median (rms of one degree of freedom, px or m): a missing effect
/// bends the markers' estimate, so that all of them show some.
struct TypicalParts {
  double cameras = 0, body = 0;
};
TypicalParts typical_parts(const std::vector<ResidualParts>& used);

/// Whose fault an error is.
enum class ErrorCause { none, cameras, body, robot };
/// "cameras", "body" or "robot", as JSON has it; empty of none.
std::string_view error_cause_name(ErrorCause cause);

/// Shares of what exceeds the noise (0 to 1, together 1 or all 0): cameras: the images of a marker do not fit
/// together; body: the markers do not lie to each other as the body's do; robot: the body as a whole is not where the
/// robot says.
struct ErrorAttribution {
  double cameras = 0, body = 0, robot = 0;
  ErrorCause cause = ErrorCause::none;  // to look at first; none: nothing stands out of the noise
};
ErrorAttribution attribute_error(const ResidualParts& parts, double noise, const TypicalParts& typical);
/// Of all observations together.
ErrorAttribution attribute_error(const std::vector<ResidualParts>& used, double noise);

/// The smallest change after which the rest of an observation agrees.
struct SingleChange {
  enum class Kind { none, corner, marker, images, body, pose } kind = Kind::none;
  int marker = -1;                   // of corner and marker
  int camera = 0;                    // of corner: of the rig
  Vector2 shift = Vector2::Zero();   // of corner: px, from where it was measured to where the rest says it is
  Vector3 offset = Vector3::Zero();  // of marker: m, in the body's own directions (TCP frame)
  double size = 0;                   // px of images; px or m of body; m of pose
  double angle = 0;                  // rad, of pose
};
SingleChange single_change(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns, double noise,
                           const TypicalParts& typical, const ResidualParts& parts, ErrorCause cause);
/// "Marker 2, right image, 3.4 px further left."; empty of none. `rig` is null in a tracker session.
Message change_text(const SingleChange& change, const Rig* rig);

/// The error of one corner (px; of a tracker's point m) that this observation would show with odds of 4 to 1, at a
/// false alarm in 100,000, whatever the robot does: that of its least visible corner. Nothing where some error of a
/// corner could hide altogether.
std::optional<double> smallest_visible(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns,
                                       double noise);

struct ObservationAttribution {
  std::int64_t id = 0;
  int index = 0;  // into Session::observations
  ResidualParts parts;
  ErrorAttribution attribution;
  SingleChange change;
  std::optional<double> smallest_visible;  // px or m
};

/// Of every used observation of `session`, in order of time, against a fit that may have left out some of its points;
/// empty where nothing is known of the noise.
std::vector<ObservationAttribution> attribute_observations(const Session& session, const Fit& fit);

}  // namespace handsight
