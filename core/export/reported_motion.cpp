// SPDX-License-Identifier: Apache-2.0
#include "export/reported_motion.h"

#include <limits>

#include "base/error.h"
#include "estimation/fit/undetermined.h"

namespace handsight {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<const char*, 6> number_names{"x", "y", "z", "rx", "ry", "rz"};

/// Of the place of the motion's own origin, and of its turn.
Matrix6 at_own_origin(const EstimatedMotion& m) {
  Matrix6 at_origin = Matrix6::Identity();
  at_origin.topRightCorner<3, 3>() = -cross_matrix(m.motion.translation);
  return at_origin * m.covariance * at_origin.transpose();
}

bool rotation_is_convention(const Calibration& c) {
  return c.markers.size() - c.unseen_markers.size() < 3 && !c.markers.empty();
}

ReportedMotion reported(const Rigid& motion, const EstimatedMotion& estimated, bool is_convention) {
  ReportedMotion result{motion.translation, motion.rotation, estimated.covariance};
  const UndeterminedMotions at_origin = undetermined_motions(at_own_origin(estimated)),
                            as_written = undetermined_motions(estimated.covariance);
  for (int i = 0; i < 6; ++i) {
    const auto n = static_cast<std::size_t>(i);
    if (as_written.numbers[n])
      result.covariance.row(i).setConstant(unknown), result.covariance.col(i).setConstant(unknown);
    if (!at_origin.numbers[n]) continue;
    if (i < 3)
      result.place[i] = unknown, result.is_place = false;
    else if (!is_convention)
      result.rotation.setConstant(unknown), result.is_rotation = false;
  }
  return result;
}

Message make_text(const char* what, const ReportedMotion& m, const Message& instead) {
  std::vector<Message> numbers;
  for (int i = 0; i < 3; ++i)
    if (std::isnan(m.place[i])) numbers.push_back(verbatim(std::string(number_names[static_cast<std::size_t>(i)])));
  Message list = joined(numbers);
  if (!m.is_rotation) list = numbers.empty() ? "the rotation" : message("{} and the rotation", list);
  return message("The measurements do not determine {} of {}: {}. More poses, turned about other axes, tell it.", list,
                 what, instead);
}

}  // namespace

ReportedMotion reported_body(const CalibratedRobot& robot) {
  return reported(robot.model.tcp_from_body, robot.calibration.tcp_from_body,
                  rotation_is_convention(robot.calibration));
}

ReportedMotion reported_mount(const CalibratedRobot& robot, const Rigid& motion) {
  const auto& estimated = robot.calibration.mount_from_sensor;
  return reported(motion, estimated ? *estimated : EstimatedMotion{motion, Matrix6::Zero()}, false);
}

std::vector<Message> undetermined_texts(const CalibratedRobot& robot, const Message& instead) {
  std::vector<Message> texts;
  if (const ReportedMotion body = reported_body(robot); !body.is_whole())
    texts.push_back(make_text("tcp_from_body", body, instead));
  if (!robot.model.mount_from_sensor) return texts;
  if (const ReportedMotion mount = reported_mount(robot, *robot.model.mount_from_sensor); !mount.is_whole())
    texts.push_back(make_text("mount_from_sensor", mount, instead));
  return texts;
}

}  // namespace handsight
