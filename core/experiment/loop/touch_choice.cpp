// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/touch_choice.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "chain/touching.h"
#include "diagnosis/planning/touch_pool.h"
#include "session/fixtures/list.h"
#include "session/touch_xml.h"

namespace handsight {
namespace {

constexpr int touch_pool_size = 400;
constexpr double usual_error = 5e-3;   // m: a robot that is not calibrated touches so far from where it should
constexpr double most_residuals = 10;  // of what the fit leaves

/// Away from the fixture, in its frame: along what it reads on the side of the TCP, else along the probe.
Vector3 way_back(const FixtureKind& kind, const Vector3& tip, const Vector3& tcp) {
  if (kind.place == FixturePlace::height) return {0, 0, tcp.z() < tip.z() ? -1.0 : 1.0};
  const Vector3 along = tcp - tip;
  return along.norm() > 1e-6 ? Vector3(along.normalized()) : Vector3::UnitZ();
}

/// Where the robot stands before it touches; nothing where it cannot.
std::optional<Eigen::VectorXd> stand_before(const Session& session, const Fit& fit, const Reach& reach, int fixture,
                                            const Eigen::VectorXd& touching) {
  const FixtureKind& kind = *session.fixtures[static_cast<std::size_t>(fixture)].kind;
  if (!reach.ranges.hold(touching)) return std::nullopt;
  if (kind.stays_on_tip) return can_be_taken(reach, touching) ? std::optional(touching) : std::nullopt;
  const TipInFixture tip = [&](const Eigen::VectorXd& q) { return place_in_fixture(fit, fixture, q, 0); };
  const Vector3 at = tip(touching);
  const Vector3 before = at + touch_clearance * way_back(kind, at, place_in_fixture(fit, fixture, touching, -1));
  const auto stand = touching_posture(tip, fixtures::point, before, touching, reach.ranges.lower, reach.ranges.upper);
  return stand && can_be_taken(reach, *stand) ? stand : std::nullopt;
}

class TouchChooser {
 public:
  TouchChooser(const Session& session, const ExperimentModel& model, const Knowledge& known, const Reach& reach,
               const ChoiceOptions& options)
      : session_(session), model_(model), known_(known), reach_(reach), options_(options) {}

  std::vector<ChosenPose> run() {
    if (options_.with_repeat && options_.count >= 3) add_repeat();
    if (known_.competing) add_planned(true);
    add_planned(false);
    return std::move(chosen_);
  }

 private:
  int left() const { return options_.count - static_cast<int>(chosen_.size()); }

  bool add(int fixture, const Eigen::VectorXd& touching, PoseReason reason) {
    const auto stand = stand_before(session_, *known_.fit, reach_, fixture, touching);
    if (stand) chosen_.push_back({*stand, reason, fixture, touching});
    return stand.has_value();
  }

  void add_repeat() {
    std::vector<const Observation*> taken;
    for (const Observation& o : session_.observations)
      if (is_used(o)) taken.push_back(&o);
    if (taken.empty()) return;
    const Observation& again = *taken[(options_.seed * 7) % taken.size()];
    add(again.part, again.position, PoseReason::repeat);
  }

  /// Some more than are wanted: not before each the robot can stand.
  void add_planned(bool between) {
    if (left() <= 0) return;
    PlanOptions plan_options;
    plan_options.count = 2 * left() + 2;
    plan_options.effects = model_.held;
    plan_options.estimated = model_.estimated;
    if (between)
      plan_options.between = known_.competing;
    else
      plan_options.estimated.insert(plan_options.estimated.end(), known_.likely.begin(), known_.likely.end());
    plan_options.pool = touch_pool_size;
    plan_options.seed = options_.seed + (between ? 1000003 : 0);
    try {
      const Plan planned = plan(session_, plan_options);
      if (between && !planned.tells_apart) return;
      for (const PlannedPose& pose : planned.poses)
        if (left() > 0) add(pose.fixture, pose.position, between ? PoseReason::between : PoseReason::precision);
    } catch (const InputError&) {  // no touch of the pool can be had
    }
  }

  const Session& session_;
  const ExperimentModel& model_;
  const Knowledge& known_;
  const Reach& reach_;
  const ChoiceOptions& options_;
  std::vector<ChosenPose> chosen_;
};

}  // namespace

std::vector<ChosenPose> choose_touches(const Session& session, const ExperimentModel& model, const Knowledge& known,
                                       const Reach& reach, const ChoiceOptions& options) {
  return TouchChooser(session, model, known, reach, options).run();
}

Observation observation_of_touch(const Session& session, int fixture, const TouchAnswer& answer,
                                 const Eigen::VectorXd& position) {
  const Fixture& asked = session.fixtures[static_cast<std::size_t>(fixture)];
  if (answer.fixture != asked.id)
    throw DriverFault(message("The driver was to touch the fixture {} and says that it has touched {}.",
                              in_quotes(asked.id), in_quotes(answer.fixture)));
  if (asked.kind->value == TouchValue::whole && !answer.value)
    throw DriverFault(
        message("The driver's touch of {} has no \"value\": a length is what it reads there.", in_quotes(asked.id)));
  Observation o;
  o.part = fixture;
  o.position = position;
  o.torque = answer.torque;
  o.sightings = touch_sightings(asked, answer.marker, answer.value.value_or(0));
  return o;
}

OnlineStep decided_touch(const Fit& fit, const Session& session, const Observation& o) {
  const FixtureKind& kind = *session.fixtures[static_cast<std::size_t>(o.part)].kind;
  const Sighting& s = o.sightings.front();
  const Eigen::VectorXd held = held_by(kind, place_in_fixture(fit, o.part, o.position, s.marker));
  const double read = kind.value == TouchValue::none ? 0 : held_by(kind, *s.point)[0];
  const double off = (held.array() - read).matrix().norm(), most = usual_error + most_residuals * fit.residual_rms;
  OnlineStep step;
  step.id = o.id;
  step.accepted = off <= most;
  if (!step.accepted)
    step.reason =
        message("the tip is {:.3g} mm from where the touched fixture must be (limit {:.3g})", 1e3 * off, 1e3 * most);
  return step;
}

}  // namespace handsight
