// SPDX-License-Identifier: Apache-2.0
// Measurements in time, and how those of two sources are paired.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

/// m: farther than any device sees a hand. Larger lengths are millimetres.
inline constexpr double longest_m = 50;

/// Joint readings, in order of time where there are times.
struct JointSeries {
  std::vector<std::string> names;
  std::vector<double> times;               // s; empty: one a row, in the order of the others
  std::vector<Eigen::VectorXd> positions;  // rad or m
};

/// Poses of one thing in another's frame, and what each is called by where its file says so: lists of one an instant.
struct PoseSeries {
  std::vector<double> times = {};  // s; empty: not given
  std::vector<Rigid> poses = {};
  std::vector<double> numbers = {};      // of a column that numbers the instants
  std::vector<std::string> names = {};   // of the images of the same instants
  std::vector<std::size_t> places = {};  // the row in the file, from 0, where rows without a pose are left out
  std::size_t row_count = 0;             // of the file with those rows; 0: every row has its pose
};

/// Points that a device measured; what it did not see is absent.
struct PointSeries {
  std::vector<double> times;
  std::vector<std::vector<std::optional<Vector3>>> points;  // m, one list an instant, all of one length
};

/// How events of one source are paired with joint readings.
struct PairingOptions {
  double lag = 0;              // s: an event of time t shows the robot as it was at t - lag by the joints' clock
  double still_for = 0.2;      // s, about the event; 0: moving is allowed
  double still_within = 2e-3;  // rad (m): how far a joint may move in that time
  double widest_gap = 0.25;    // s between two readings that may be interpolated
};

struct Pairing {
  std::vector<std::size_t> events;                // those that were paired, in order
  std::vector<Eigen::VectorXd> positions;         // of the joints then
  std::size_t outside = 0, moving = 0, gaps = 0;  // events left out: no readings then, not standing, too far apart
  std::size_t repeated = 0;                       // of a standstill that has its event already
};

/// One event for each standstill: the one nearest its middle. With still_for 0 every event.
Pairing paired(const JointSeries& joints, const std::vector<double>& events, const PairingOptions& options);

/// The lag, s, within which events move as the joints do: where the speeds of both agree best. Nothing where they do
/// not (correlation below 0.5), or too little moves. `speeds`: of the events, any unit.
std::optional<double> estimated_lag(const JointSeries& joints, const std::vector<double>& times,
                                    const std::vector<double>& speeds, double most = 1.0);

/// How fast poses move (m/s, a radian counts as 0.3 m), one number a pose.
std::vector<double> compute_speeds(const PoseSeries& series);

}  // namespace handsight
