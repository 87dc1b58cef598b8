// SPDX-License-Identifier: Apache-2.0
// Poses from tables: the columns that hold them, and what their turns may be read as.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "geometry/angle_kinds.h"
#include "readers/series.h"
#include "readers/table.h"

namespace handsight {

struct TurnReading {
  AngleKind kind = AngleKind::quaternion_xyzw;
  bool degrees = false;
  bool turn_first = false;  // without a header: the first three columns are the turn, the last three the place
};

/// The numbers by which a table tells its turns.
struct Turns {
  Message columns;                           // "rx ry rz", as sentences call them
  std::vector<std::vector<double>> numbers;  // one list a pose, as written
  std::vector<std::vector<double>> places;   // the columns before them, where they may be the turn; else empty
  std::vector<TurnReading> readings;         // what they may be, the likeliest first; one: the table says it
  bool first_is_usual = false;               // the first is to be taken wherever it serves
  bool is_reported = false;                  // by PoseTableOptions::angles
};

/// Poses, their turns by the first reading.
struct ReadPoses {
  std::string role;  // what the table's columns call them ("flange"); empty: nothing
  PoseSeries series;
  Turns turns;
};

/// What who brings a table says of it.
struct PoseTableOptions {
  std::string angles;    // a name of angle_kind_names; empty: not said
  bool degrees = false;  // where the header does not say so
};

/// Has the table the poses of one thing or of two: columns x y z and a rotation under any of their usual names, 12 or
/// 16 numbers of a matrix, or without a header places and quaternions? `has_robot`: six columns without a header are
/// two points or six joints there, and a place and three angles where nothing else is known.
bool is_pose_table(const Table& table, bool has_robot);

/// Of one thing or of two. Rows in which a number is missing are left out. Sentences in `notes`. InputError where a
/// pose cannot be one, or `angles` does not suit the columns.
std::vector<ReadPoses> read_pose_table(const Table& table, bool has_robot, const PoseTableOptions& options,
                                       std::vector<Message>& notes);

/// Turns the series' poses as this reading has it.
void read_turns(const Turns& turns, const TurnReading& reading, PoseSeries& series);

/// "rotation vectors (axis times angle) in degrees".
Message reading_text(const TurnReading& reading);

/// The columns that are the turn by this reading, as sentences call them.
Message columns_text(const Turns& turns, const TurnReading& reading);

/// What columns without names may be: three numbers any kind of angles, four a quaternion.
std::vector<TurnReading> list_readings(std::vector<AngleKind> kinds, const std::string& unit, bool says_degrees,
                                       bool usually_degrees, double largest);

}  // namespace handsight
