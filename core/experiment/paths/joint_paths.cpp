// SPDX-License-Identifier: Apache-2.0
#include "experiment/paths/joint_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#ifdef HANDSIGHT_HAS_PATHS
#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#endif

namespace handsight {
namespace {

constexpr double most_turn = 2 * std::numbers::pi / 180;  // rad, of a step
constexpr double most_slide = 0.01;                       // m

bool slides(const Chain& chain, Eigen::Index j) {
  return chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])].kind ==
         JointKind::prismatic;
}

}  // namespace

bool JointRanges::hold(const Eigen::VectorXd& position) const {
  return (position.array() >= lower.array()).all() && (position.array() <= upper.array()).all();
}

JointRanges joint_ranges(const Chain& chain, const std::vector<Eigen::VectorXd>& taken) {
  JointRanges ranges{Eigen::VectorXd(chain.joints.size()), Eigen::VectorXd(chain.joints.size())};
  for (Eigen::Index j = 0; j < ranges.lower.size(); ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
    double low = taken.empty() ? 0 : 1e300, high = taken.empty() ? 0 : -1e300;
    for (const Eigen::VectorXd& q : taken) low = std::min(low, q[j]), high = std::max(high, q[j]);
    const double beyond = slides(chain, j) ? 0.3 : std::numbers::pi;
    const double lower = joint.lower > -1e29 ? joint.lower : low - beyond;
    const double upper = joint.upper < 1e29 ? joint.upper : high + beyond;
    const double margin = std::max(0.01 * (upper - lower), slides(chain, j) ? 0.005 : std::numbers::pi / 180);
    ranges.lower[j] = std::min(lower + margin, 0.5 * (lower + upper));
    ranges.upper[j] = std::max(upper - margin, 0.5 * (lower + upper));
  }
  return ranges;
}

std::vector<Eigen::VectorXd> steps_between(const CollisionWorld& world, const Chain& chain, const Eigen::VectorXd& from,
                                           const Eigen::VectorXd& to, int finer) {
  const Eigen::VectorXd way = to - from;
  double count = world.farthest_way(way) / usual_clearance;
  for (Eigen::Index j = 0; j < way.size(); ++j)
    count = std::max(count, std::abs(way[j]) / (slides(chain, j) ? most_slide : most_turn));
  const int steps = std::max(1, static_cast<int>(std::ceil(count))) * finer;
  std::vector<Eigen::VectorXd> points;
  for (int i = 1; i < steps; ++i) points.emplace_back(from + static_cast<double>(i) / steps * way);
  points.push_back(to);
  return points;
}

bool is_free(const CollisionWorld& world, const Chain& chain, const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  const std::vector<Eigen::VectorXd> points = steps_between(world, chain, from, to);
  if (world.touching(to)) return false;
  // Coarse first: what is in the way is mostly found at once.
  for (std::size_t stride = points.size(); stride > 1;) {
    stride = (stride + 3) / 4;
    for (std::size_t i = 0; i < points.size(); i += stride)
      if (world.touching(points[i])) return false;
  }
  return true;
}

std::optional<std::vector<Eigen::VectorXd>> way_by_going_back(const CollisionWorld& world, const Chain& chain,
                                                              const JointRanges& ranges, const Eigen::VectorXd& from,
                                                              const std::vector<Eigen::VectorXd>& back,
                                                              const Eigen::VectorXd& to, double seconds) {
  if (back.empty()) return std::nullopt;
  for (std::size_t i = 0; i < back.size(); ++i)
    if (!is_free(world, chain, i > 0 ? back[i - 1] : from, back[i])) return std::nullopt;
  const auto on = way_between(world, chain, ranges, back.back(), to, seconds);
  if (!on) return std::nullopt;
  std::vector<Eigen::VectorXd> way = back;
  way.insert(way.end(), on->begin(), on->end());
  return way;
}

double measure_length(const Eigen::VectorXd& from, const std::vector<Eigen::VectorXd>& way) {
  double length = 0;
  for (std::size_t i = 0; i < way.size(); ++i) length += (way[i] - (i > 0 ? way[i - 1] : from)).cwiseAbs().maxCoeff();
  return length;
}

#ifdef HANDSIGHT_HAS_PATHS

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

Eigen::VectorXd position_in(const ob::State* state, unsigned int count) {
  return Eigen::Map<const Eigen::VectorXd>(state->as<ob::RealVectorStateSpace::StateType>()->values, count);
}

class FreeMotion : public ob::MotionValidator {
 public:
  FreeMotion(const ob::SpaceInformationPtr& space, const CollisionWorld& world, const Chain& chain)
      : ob::MotionValidator(space), world_(world), chain_(chain) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const unsigned int count = si_->getStateDimension();
    return is_free(world_, chain_, position_in(a, count), position_in(b, count));
  }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    if (checkMotion(a, b)) return true;
    last.second = 0;
    if (last.first) si_->copyState(last.first, a);
    return false;
  }

 private:
  const CollisionWorld& world_;
  const Chain& chain_;
};

ob::ScopedState<ob::RealVectorStateSpace> read_state(const ob::StateSpacePtr& space, const Eigen::VectorXd& position) {
  ob::ScopedState<ob::RealVectorStateSpace> state(space);
  for (Eigen::Index j = 0; j < position.size(); ++j) state[static_cast<unsigned int>(j)] = position[j];
  return state;
}

std::optional<std::vector<Eigen::VectorXd>> way_round(const CollisionWorld& world, const Chain& chain,
                                                      const JointRanges& ranges, const Eigen::VectorXd& from,
                                                      const Eigen::VectorXd& to, double seconds) {
  ompl::msg::noOutputHandler();
  const auto count = static_cast<unsigned int>(from.size());
  const auto space = std::make_shared<ob::RealVectorStateSpace>(count);
  ob::RealVectorBounds bounds(count);
  for (unsigned int j = 0; j < count; ++j) {
    bounds.setLow(j, std::min(ranges.lower[j], from[j]));  // where it stands may lie in the margin
    bounds.setHigh(j, std::max(ranges.upper[j], from[j]));
  }
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  setup.setStateValidityChecker(
      [&](const ob::State* state) { return !world.touching(position_in(state, count)).has_value(); });
  setup.getSpaceInformation()->setMotionValidator(
      std::make_shared<FreeMotion>(setup.getSpaceInformation(), world, chain));
  setup.setStartAndGoalStates(read_state(space, from), read_state(space, to));
  const auto planner = std::make_shared<og::RRTConnect>(setup.getSpaceInformation());
  planner->setRange(0.6 * std::sqrt(static_cast<double>(count)));
  setup.setPlanner(planner);
  if (setup.solve(seconds) != ob::PlannerStatus::EXACT_SOLUTION) return std::nullopt;
  og::PathGeometric& path = setup.getSolutionPath();
  og::PathSimplifier(setup.getSpaceInformation()).reduceVertices(path);
  std::vector<Eigen::VectorXd> way;
  for (std::size_t i = 1; i < path.getStateCount(); ++i)
    way.push_back(position_in(path.getState(static_cast<unsigned int>(i)), count));
  way.back() = to;
  // What it was made of is checked again: nothing moves on the word of a library alone.
  for (std::size_t i = 0; i < way.size(); ++i)
    if (!is_free(world, chain, i > 0 ? way[i - 1] : from, way[i])) return std::nullopt;
  return way;
}

}  // namespace

std::optional<std::vector<Eigen::VectorXd>> way_between(const CollisionWorld& world, const Chain& chain,
                                                        const JointRanges& ranges, const Eigen::VectorXd& from,
                                                        const Eigen::VectorXd& to, double seconds) {
  if (!ranges.hold(to) || world.touching(to)) return std::nullopt;
  if (is_free(world, chain, from, to)) return std::vector{to};
  if (world.touching(from)) return std::nullopt;
  return way_round(world, chain, ranges, from, to, seconds);
}

#else

std::optional<std::vector<Eigen::VectorXd>> way_between(const CollisionWorld&, const Chain&, const JointRanges&,
                                                        const Eigen::VectorXd&, const Eigen::VectorXd&, double) {
  throw InputError(*what_paths_need());
}

#endif

}  // namespace handsight
