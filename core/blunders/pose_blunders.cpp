// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "blunders/blunder_kinds.h"
#include "blunders/places.h"
#include "blunders/rotation_readings.h"
#include "blunders/seen_points.h"
#include "robot/robot.h"
#include "session/pose_points.h"

namespace handsight {
namespace {

bool has_target_poses(const Session& s) { return s.pose_sensor.has_value(); }
bool has_flange_poses(const Session& s) { return s.robot.is_of_poses; }

/// "target", "flange" and "both", as far as the session has such poses.
std::vector<std::string> pose_tables(const Session& s) {
  std::vector<std::string> tables;
  if (has_target_poses(s)) tables.emplace_back("target");
  if (has_flange_poses(s)) tables.emplace_back("flange");
  if (tables.size() == 2) tables.emplace_back("both");
  return tables;
}

struct Tables {
  bool target = false, flange = false;
};

Tables tables_at(const std::string& name, const Session& s, const char* id) {
  const std::vector<std::string> all = pose_tables(s);
  if (std::find(all.begin(), all.end(), name) == all.end())
    throw InputError(message("{}: the session has no poses of {:?}; it has those of: {}.", id, name,
                             all.empty() ? Message("nothing") : verbatim(fmt::format("{}", fmt::join(all, " ")))));
  return {name != "flange", name != "target"};
}

const char* table_text(const std::string& name) {
  return name == "target" ? "the target's poses" : name == "flange" ? "the flange's poses" : "all poses";
}

Rigid flange_of(const Observation& o) { return base_from_flange(o.position); }
void set_flange(Observation& o, const Rigid& pose) { o.position = make_position(pose); }

/// The points that stand for poses follow them; those of observations that show nothing stay away.
void show_again(Session& s) {
  if (s.pose_sensor) show_poses(s, pose_lever(*s.pose_sensor));
}

template <class Change>
void change_rotations(Session& s, const Tables& tables, const Change& change) {
  for (Observation& o : s.observations) {
    if (tables.target && o.target_pose) o.target_pose->rotation = change(o.target_pose->rotation);
    if (!tables.flange) continue;
    Rigid pose = flange_of(o);
    pose.rotation = change(pose.rotation);
    set_flange(o, pose);
  }
  show_again(s);
}

BlunderKind pose_inverted() {
  BlunderKind k;
  k.id = "pose_inverted";
  k.of_poses = true;
  k.places = [](const Session& s) {
    std::vector<std::string> tables = pose_tables(s);
    if (tables.size() == 3) tables.pop_back();
    return tables;
  };
  k.mend = [](const std::string& where, Session& s) {
    const Tables tables = tables_at(where, s, "pose_inverted");
    for (Observation& o : s.observations) {
      if (tables.target && o.target_pose) o.target_pose = inverse(*o.target_pose);
      if (tables.flange) set_flange(o, inverse(flange_of(o)));
    }
    show_again(s);
  };
  k.text = [](const std::string& where, const Session& s) {
    if (where == "target" && !s.robot.is_of_poses && s.mount.estimate)
      return message(
          "The target's poses are inverted: they say where the sensor is in the target's frame, where the target in "
          "the sensor's is expected; or the sensor is on {} and the target on {}, which is the same to these numbers.",
          s.tcp, s.mount.link);
    const char* const other_side = s.tcp == "base"
                                       ? ", or the sensor stands beside the robot and the flange carries the target"
                                       : ", or the flange carries the sensor and the target stands beside the robot";
    if (where == "target" && s.robot.is_of_poses)
      return message(
          "The target's poses are inverted: they say where the sensor is in the target's frame, where the target in "
          "the sensor's is expected{}, which is the same to these numbers.",
          other_side);
    if (where == "target")
      return Message(
          "The target's poses are inverted: they say where the sensor is in the target's frame, where the "
          "target in the sensor's is expected.");
    return message("The flange's poses are inverted: they say where the base is in the flange's frame{}.", other_side);
  };
  k.fix = [](const std::string& where, const Session& s) {
    if (where == "target" && !s.robot.is_of_poses && s.mount.estimate)
      return message(
          "Invert each <target_pose> in {} (each pose in the table of the target that it was made of), or convert with "
          "--mount {} --tcp {}.",
          session_name(s), s.tcp, s.mount.link);
    const char* const as_it_was_not = s.tcp == "base" ? "with" : "without";
    if (where == "target" && s.robot.is_of_poses)
      return message(
          "Convert {} --eye-on-base, or invert each <target_pose> in {} (each pose in the table of the target that it "
          "was made of).",
          as_it_was_not, session_name(s));
    if (where == "target")
      return message("Invert each <target_pose> in {} (each pose in the table of the target that it was made of).",
                     session_name(s));
    return message(
        "Invert each <flange_pose> in {} (each pose in the table of the flange), or convert {} --eye-on-base.",
        session_name(s), as_it_was_not);
  };
  return k;
}

constexpr double least_rescaled = 0.1;  // less is told as the target's size once the poses are read as they are

/// The factor of all places of the target by which it goes best with the hand: coarse first, then the lowest of the
/// valley.
double find_scale(const Session& points) {
  const auto left_at = [&](double factor) {
    Session s = points;
    for (Observation& o : s.observations)
      if (o.target_pose) o.target_pose->translation *= factor;
    show_again(s);
    const auto found = solve_hand_eye(s);
    return found ? found->mean_square : 1e300;
  };
  double best = 1, least = 1e300, step = std::log(1.25);
  for (int i = -9; i <= 9; ++i)
    if (const double left = left_at(std::exp(i * step)); left < least) least = left, best = std::exp(i * step);
  for (int pass = 0; pass < 12; ++pass, step *= 0.6)
    for (const double factor : {best * std::exp(-0.5 * step), best * std::exp(0.5 * step)})
      if (const double left = left_at(factor); left < least) least = left, best = factor;
  return best;
}

std::vector<std::string> with_each(const std::vector<std::string>& tables, const std::vector<std::string>& values) {
  std::vector<std::string> places;
  for (const std::string& table : tables)
    for (const std::string& value : values) places.push_back(std::string(table).append("=").append(value));
  return places;
}

Matrix3 reordered(const Matrix3& rotation, bool first_is_w) {
  const Eigen::Quaterniond q(rotation);
  // Eigen's constructor takes w x y z.
  const Eigen::Quaterniond again =
      first_is_w ? Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()) : Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y());
  return again.toRotationMatrix();
}

BlunderKind quaternion_order() {
  BlunderKind k;
  k.id = "quaternion_order";
  k.of_poses = true;
  k.places = [](const Session& s) { return with_each(pose_tables(s), {"wxyz", "xyzw"}); };
  k.mend = [](const std::string& where, Session& s) {
    const auto [table, order] = name_and_value(where);
    const bool first_is_w = order == "wxyz";
    if (!first_is_w && order != "xyzw")
      throw InputError(message("quaternion_order: {:?} is no order; expected wxyz or xyzw.", order));
    change_rotations(s, tables_at(table, s, "quaternion_order"),
                     [&](const Matrix3& rotation) { return reordered(rotation, first_is_w); });
  };
  k.text = [](const std::string& where, const Session&) {
    const auto [table, order] = name_and_value(where);
    return message("The quaternions of {} have w {}; they were read with w {}.", table_text(table),
                   order == "wxyz" ? "first" : "last", order == "wxyz" ? "last" : "first");
  };
  k.fix = [](const std::string& where, const Session& s) {
    const auto [table, order] = name_and_value(where);
    return message(
        "In {} bring the quaternions of {} into the order x y z w (in the table that they come from name the "
        "columns {}).",
        session_name(s), table_text(table), verbatim(order == "wxyz" ? "qw,qx,qy,qz" : "qx,qy,qz,qw"));
  };
  return k;
}

/// What an observation may have been.
struct Readings {
  std::vector<Rigid> flange;  // base_from_flange
  std::vector<Rigid> target;  // sensor_from_target; empty: none
};

std::vector<Rigid> list_readings(const Rigid& pose, bool is_read_again, const std::string& convention) {
  if (!is_read_again) return {pose};
  std::vector<Rigid> all;
  for (const Matrix3& rotation : read_again(pose.rotation, convention)) all.push_back({rotation, pose.translation});
  return all;
}

/// The last one where there are not so many.
void take(Observation& o, const Readings& r, const Tables& tables, std::size_t flange, std::size_t target) {
  if (tables.flange) set_flange(o, r.flange[std::min(flange, r.flange.size() - 1)]);
  if (tables.target && o.target_pose) o.target_pose = r.target[std::min(target, r.target.size() - 1)];
}

bool is_open(const Readings& r) { return r.flange.size() > 1 || r.target.size() > 1; }

/// Of each observation's readings the one that goes best with what was found.
void choose_readings(Session& s, const std::vector<Readings>& readings, const Tables& tables, const HandEye& found) {
  Session one = s;
  for (std::size_t i = 0; i < s.observations.size(); ++i) {
    double least = 1e300;
    std::size_t best_flange = 0, best_target = 0;
    for (std::size_t f = 0; f < readings[i].flange.size(); ++f)
      for (std::size_t t = 0; t < std::max<std::size_t>(1, readings[i].target.size()); ++t) {
        one.observations = {s.observations[i]};
        take(one.observations[0], readings[i], tables, f, t);
        show_again(one);
        const std::vector<HandSight> sights = list_sights(one);
        const double left = sights.empty() ? 0 : left_in(sights[0], found);
        if (left < least) least = left, best_flange = f, best_target = t;
      }
    take(s.observations[i], readings[i], tables, best_flange, best_target);
  }
  show_again(s);
}

/// Chooses from this start until the choice stays; what is left.
double settle_readings(Session& s, const std::vector<Readings>& readings, const Tables& tables,
                       std::optional<HandEye> from) {
  for (int pass = 0; pass < 4 && from; ++pass) {
    choose_readings(s, readings, tables, *from);
    from = solve_hand_eye(s);
  }
  return from ? from->mean_square : 1e300;
}

/// Those alone whose reading is not open; few of them say nothing.
std::optional<HandEye> by_sure_ones(Session s, const std::vector<Readings>& readings) {
  constexpr std::ptrdiff_t enough = 8;
  std::vector<Observation> sure;
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (!is_open(readings[i])) sure.push_back(s.observations[i]);
  s.observations = std::move(sure);
  const auto seen = std::count_if(s.observations.begin(), s.observations.end(), is_used);
  return seen < enough ? std::nullopt : solve_hand_eye(s);
}

/// Of several starts the one that leaves least.
void choose_from_several(Session& s, const std::vector<Readings>& readings, const Tables& tables) {
  Session best;
  double least = 1e301;
  const auto compete = [&](Session start, const std::optional<HandEye>& from) {
    const double left = settle_readings(start, readings, tables, from);
    if (left < least) least = left, best = std::move(start);
  };
  if (const auto sure = by_sure_ones(s, readings)) compete(s, sure);
  for (const std::size_t number : {0, 1}) {
    Session start = s;
    for (std::size_t i = 0; i < readings.size(); ++i) take(start.observations[i], readings[i], tables, number, number);
    show_again(start);
    compete(start, solve_hand_eye(start));
  }
  if (least < 1e300) s = std::move(best);
}

void read_rotations_again(Session& s, const Tables& tables, const std::string& convention) {
  std::vector<Readings> readings;
  for (Observation& o : s.observations) {
    Readings& r = readings.emplace_back();
    r.flange = tables.flange ? list_readings(flange_of(o), true, convention) : std::vector<Rigid>{Rigid{}};
    if (o.target_pose) r.target = list_readings(*o.target_pose, tables.target, convention);
    take(o, r, tables, 0, 0);
  }
  show_again(s);
  if (std::none_of(readings.begin(), readings.end(), is_open)) return;
  Session points = as_point_session(with_few_markers(s));
  choose_from_several(points, readings, tables);
  for (std::size_t i = 0; i < s.observations.size(); ++i) {
    s.observations[i].position = points.observations[i].position;
    s.observations[i].target_pose = points.observations[i].target_pose;
  }
  show_again(s);
}

const char* convention_text(const std::string& convention) {
  if (convention == "rotation_vector") return "rotation vectors, and were read as roll pitch yaw";
  if (convention == "rpy") return "roll pitch yaw, and were read as rotation vectors";
  if (convention == "moving_xyz") return "turns about the moving axes x, y, z, and were read as roll pitch yaw";
  if (convention == "zyx") return "turns about z first, then y, x, and were read as roll pitch yaw";
  return "turns about z, y, z, and were read as roll pitch yaw";
}

const char* convention_fix(const std::string& convention) {
  if (convention == "rotation_vector")
    return "turn the three numbers into quaternions as rotation vectors (axis times angle)";
  if (convention == "rpy") return "turn the three numbers into quaternions as roll pitch yaw (fixed axes x, y, z)";
  if (convention == "moving_xyz") return "turn the three numbers into quaternions as Rx(1st) Ry(2nd) Rz(3rd)";
  if (convention == "zyx") return "turn the three numbers into quaternions as Rz(1st) Ry(2nd) Rx(3rd)";
  return "turn the three numbers into quaternions as Rz(1st) Ry(2nd) Rz(3rd)";
}

BlunderKind euler_convention() {
  BlunderKind k;
  k.id = "euler_convention";
  k.of_poses = true;
  k.places = [](const Session& s) { return with_each(pose_tables(s), rotation_conventions()); };
  k.mend = [](const std::string& where, Session& s) {
    const auto [table, convention] = name_and_value(where);
    const auto& all = rotation_conventions();
    if (std::find(all.begin(), all.end(), convention) == all.end())
      throw InputError(
          message("euler_convention: {:?} is not known; expected one of: {}.", convention, fmt::join(all, " ")));
    read_rotations_again(s, tables_at(table, s, "euler_convention"), convention);
  };
  k.text = [](const std::string& where, const Session&) {
    const auto [table, convention] = name_and_value(where);
    return message("The rotations of {} are {}.", table_text(table), convention_text(convention));
  };
  k.fix = [](const std::string& where, const Session& s) {
    const auto [table, convention] = name_and_value(where);
    return message("In the table that {} of {} come from, {}.", table_text(table), session_name(s),
                   convention_fix(convention));
  };
  return k;
}

/// Places of the target's poses times a factor: the target is of another size than the program was told.
BlunderKind target_scaled() {
  BlunderKind k;
  k.id = "target_scaled";
  k.is_tried_alone = false;  // alone it is the size of the target, which is told as such (target_size.h)
  k.numbers = 1;
  k.places = [](const Session& s) {
    return has_target_poses(s) ? std::vector<std::string>{"target"} : std::vector<std::string>();
  };
  k.settle = [](const std::string& where, const Session& points) {
    const double factor = find_scale(points);
    if (std::abs(factor - 1) < least_rescaled)
      throw InputError("target_scaled: the places of the target's poses need no factor.");
    return fmt::format("{}={:.4g}", where.substr(0, where.find('=')), factor);
  };
  k.mend = [](const std::string& where, Session& s) {
    const double factor = number_in(name_and_value(where).second, "target_scaled");
    if (!(factor > 0)) throw InputError(message("target_scaled: expected a factor above 0, such as 0.5."));
    for (Observation& o : s.observations)
      if (o.target_pose) o.target_pose->translation *= factor;
    show_again(s);
  };
  k.text = [](const std::string& where, const Session&) {
    const double factor = number_in(name_and_value(where).second, "target_scaled");
    return message("The target is {:.1f} % {} than the size given to the program that found its poses.",
                   100 * std::abs(factor - 1), factor > 1 ? "larger" : "smaller");
  };
  k.fix = [](const std::string& where, const Session& s) {
    return message(
        "Measure the target over its whole length and give the right size to that program; until then multiply the "
        "places of each <target_pose> in {} by {}.",
        session_name(s), name_and_value(where).second);
  };
  return k;
}

}  // namespace

std::vector<BlunderKind> pose_blunders() {
  return {pose_inverted(), quaternion_order(), euler_convention(), target_scaled()};
}

}  // namespace handsight
