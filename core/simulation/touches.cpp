// SPDX-License-Identifier: Apache-2.0
#include "simulation/touches.h"

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "chain/touching.h"
#include "session/fixtures/fixture_kind.h"
#include "session/touch_xml.h"
#include "simulation/random.h"

namespace handsight {
namespace {

constexpr double usual_touch_sigma = 2e-5;  // m
constexpr int most_attempts = 400;

enum Purpose : std::uint64_t {
  touch_time_stream = 3,
  value_stream = 50,
  reading_stream = 100,
  distance_stream = 1 << 22
};

/// What a reading at this fixture is to show.
double wanted_value(const FixtureKind& kind, Random& random) {
  const SimulatedValue& s = kind.simulated;
  double value = s.first;
  if (s.count > 1) value += s.apart * random.integer(s.count);
  if (s.travel > 0) value += random.uniform(-s.travel, s.travel);
  return value;
}

Eigen::VectorXd errors(const FixtureKind& kind, double sigma, Random& random) {
  Eigen::VectorXd e(static_cast<Eigen::Index>(kind.numbers.size()));
  for (double& number : e) number = sigma * random.gaussian();
  return e;
}

struct Limits {
  Eigen::VectorXd lower, upper;
};

Limits limits_of(const Chain& chain) {
  const auto count = static_cast<Eigen::Index>(chain.joints.size());
  Limits limits{Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (Eigen::Index j = 0; j < count; ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
    limits.lower[j] = std::max(joint.lower, -std::numbers::pi);
    limits.upper[j] = std::min(joint.upper, std::numbers::pi);
  }
  return limits;
}

/// The observation states of the next touch, but for its posture.
struct Next {
  double elapsed = 0, duration = 0;
  int order = 0;
  std::optional<Eigen::VectorXd> before;  // per joint of the robot
};

ObservationState states_in(const Chain& part, const Next& next, const Eigen::VectorXd& position) {
  ObservationState c = states_at(part, position);
  c.elapsed = next.elapsed;
  c.duration = next.duration;
  c.order = next.order;
  if (next.before) c.approach = (c.sensor - *next.before).cwiseSign();
  return c;
}

/// A hand that comes from below a plate cannot.
bool stands_well(const TouchSimulation& s, const FixtureKind& kind, const ObservationState& c, int fixture) {
  return !kind.is_one_sided || s.place(c, fixture, -1).z() > 0;
}

}  // namespace

double touch_sigma(const Session& like, const SimulationOptions& options, std::size_t fixture) {
  return options.noise ? *options.noise : like.fixtures[fixture].sigma.value_or(usual_touch_sigma);
}

std::vector<Observation> simulated_touches(const TouchSimulation& s) {
  const Random root(s.options.seed);
  Random times = root.child(touch_time_stream);
  const Limits limits = limits_of(s.chain);
  std::vector<Observation> all(static_cast<std::size_t>(s.options.observations));
  double time = 0;
  for (Observation& o : all) o.time = std::round(1e3 * (time += times.uniform(3, 6))) / 1e3;
  Next next;
  next.duration = all.back().time - all.front().time;
  for (std::size_t k = 0; k < all.size(); ++k) {
    Observation& o = all[k];
    const std::size_t f = k * s.like.fixtures.size() / all.size();
    const Fixture& fixture = s.like.fixtures[f];
    const Chain& part = s.chain.parts[f];
    const int marker = static_cast<int>(k) % s.like.marker_count;
    o.id = static_cast<std::int64_t>(k);
    o.part = static_cast<int>(f);
    next.elapsed = o.time - all.front().time;
    next.order = static_cast<int>(k);
    Random values = root.child(value_stream).child(k), readings = root.child(reading_stream + k);
    const double value = wanted_value(*fixture.kind, values);
    const Eigen::VectorXd wanted = errors(*fixture.kind, touch_sigma(s.like, s.options, f), readings).array() + value;
    const auto at = [&](const Eigen::VectorXd& q) { return states_in(part, next, q); };
    const TipInFixture tip = [&](const Eigen::VectorXd& q) { return s.place(at(q), static_cast<int>(f), marker); };
    for (int attempt = 0; attempt < most_attempts && o.position.size() == 0; ++attempt)
      if (auto q = touching_posture(tip, *fixture.kind, wanted, s.posture(), limits.lower, limits.upper);
          q && stands_well(s, *fixture.kind, at(*q), static_cast<int>(f)))
        o.position = std::move(*q);
    if (o.position.size() == 0)
      throw InputError(
          message("No posture in {} searches touches the fixture {} within the joint limits; place it nearer to the "
                  "robot, or widen --joint-range.",
                  most_attempts, fixture.id));
    o.sightings = touch_sightings(s.like.fixtures[f], marker, value);
    next.before = at(o.position).sensor;
  }
  return all;
}

void read_touches(const TouchSimulation& s, std::vector<Observation>& given) {
  const Random root(s.options.seed);
  Next next;
  if (!given.empty()) next.duration = given.back().time - given.front().time;
  for (std::size_t k = 0; k < given.size(); ++k) {
    Observation& o = given[k];
    const auto f = static_cast<std::size_t>(o.part);
    const Fixture& fixture = s.like.fixtures[f];
    next.elapsed = o.time - given.front().time;
    next.order = static_cast<int>(k);
    const ObservationState c = states_in(s.chain.parts[f], next, o.position);
    Random readings = root.child(reading_stream + k);
    const Vector3 place = s.place(c, o.part, 0);
    const Eigen::VectorXd held =
        held_by(*fixture.kind, place) + errors(*fixture.kind, touch_sigma(s.like, s.options, f), readings);
    o.sightings = touch_sightings(fixture, 0, held[0]);
    if (fixture.kind->value == TouchValue::none)
      for (Sighting& sighting : o.sightings)
        for (Eigen::Index i = 0; i < held.size(); ++i) (*sighting.point)[i] = held[i];
    next.before = c.sensor;
  }
}

std::optional<Observation> next_touch(const TouchSimulation& s, const std::vector<Observation>& given) {
  Observation o = given.back();
  const auto f = static_cast<std::size_t>(o.part);
  const Fixture& fixture = s.like.fixtures[f];
  Next next;
  next.elapsed = next.duration = o.time - given.front().time;
  next.order = static_cast<int>(given.size()) - 1;
  if (given.size() > 1) {
    const Observation& before = given[given.size() - 2];
    next.before = states_at(s.chain.parts[static_cast<std::size_t>(before.part)], before.position).sensor;
  }
  Random readings = Random(s.options.seed).child(reading_stream + static_cast<std::uint64_t>(next.order));
  const Eigen::VectorXd error = errors(*fixture.kind, touch_sigma(s.like, s.options, f), readings);
  const TipInFixture tip = [&](const Eigen::VectorXd& q) {
    return s.place(states_in(s.chain.parts[f], next, q), o.part, 0);
  };
  if (is_instrument(*fixture.kind)) {
    o.sightings = touch_sightings(fixture, 0, held_by(*fixture.kind, tip(o.position))[0] + error[0]);
    return o;
  }
  const Limits limits = limits_of(s.chain);
  const auto touching = touching_posture(tip, *fixture.kind, error, o.position, limits.lower, limits.upper);
  if (!touching) return std::nullopt;
  o.position = *touching;
  o.sightings = touch_sightings(fixture, 0, 0);
  return o;
}

void declare_touches(const SimulationOptions& options, Session& session) {
  Random random = Random(options.seed).child(distance_stream);
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const double sigma = touch_sigma(session, options, f);
    session.fixtures[f].sigma = options.declare_noise && sigma > 0 ? std::optional(sigma) : std::nullopt;
  }
  session.sigma_point = session.fixtures.front().sigma;
  for (Observation& o : session.observations)
    for (Sighting& s : o.sightings) s.point_sigma = session.fixtures[static_cast<std::size_t>(o.part)].sigma;
  const auto place = [&](int f) {
    const Mount& mount = f == 0 ? session.mount : session.other_mounts[static_cast<std::size_t>(f - 1)];
    return mount.mount_from_sensor.translation;
  };
  for (KnownDistance& d : session.distances) d.by = (place(d.of) - place(d.from)).norm() + d.sigma * random.gaussian();
}

}  // namespace handsight
