// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/driven_joints.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace handsight {
namespace {

constexpr double most_off = M_PI / 180;  // rad: farther from where it was sent the robot is not driven on
constexpr double most_off_slide = 0.01;  // m

}  // namespace

Eigen::VectorXd JointOrder::to_session(const Eigen::VectorXd& of_driver) const {
  Eigen::VectorXd q(of_driver.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = of_driver[place_in_driver[static_cast<std::size_t>(j)]];
  return q;
}

Eigen::VectorXd JointOrder::to_driver(const Eigen::VectorXd& of_session) const {
  Eigen::VectorXd q(of_session.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) q[place_in_driver[static_cast<std::size_t>(j)]] = of_session[j];
  return q;
}

JointOrder joint_order(const Session& session, const DriverHello& hello) {
  JointOrder order;
  for (const std::string& joint : session.joints) {
    const auto place = std::find(hello.joints.begin(), hello.joints.end(), joint);
    if (place != hello.joints.end()) order.place_in_driver.push_back(place - hello.joints.begin());
  }
  if (order.place_in_driver.size() == session.joints.size() && hello.joints.size() == session.joints.size())
    return order;
  throw DriverFault(message("The driver moves {} joints, not those of the session: expected {}, in any order.",
                            hello.joints.size(), shortened(fmt::format("{}", fmt::join(session.joints, " ")), 299)));
}

void require_arrival(const Chain& chain, const std::vector<std::string>& joints, const Eigen::VectorXd& sent,
                     const Eigen::VectorXd& position) {
  for (Eigen::Index j = 0; j < sent.size(); ++j) {
    const int joint = chain.joints[static_cast<std::size_t>(j)];
    const bool slides = chain.robot.joints[static_cast<std::size_t>(joint)].kind == JointKind::prismatic;
    const double off = position[j] - sent[j];
    if (std::abs(off) <= (slides ? most_off_slide : most_off)) continue;
    throw DriverFault(message(
        "The driver says that {} stands {:.3g} {} from where it was sent; more than {} stops an experiment, and it was "
        "told to stop.",
        joints[static_cast<std::size_t>(j)], slides ? 1e3 * off : off * 180 / M_PI, slides ? "mm" : "degrees",
        slides ? "10 mm" : "1 degree"));
  }
}

}  // namespace handsight
