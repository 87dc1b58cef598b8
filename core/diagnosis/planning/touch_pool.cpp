// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/touch_pool.h"

#include <algorithm>

#include "chain/touching.h"
#include "session/fixtures/fixture_kind.h"
#include "session/touch_xml.h"

namespace handsight {
namespace {

constexpr double least_reach = 0.02;  // m: a fixture is as large as this at least

/// How a fixture has been touched, in its frame.
struct Touched {
  std::vector<Vector3> tips;
  std::vector<double> values;
  double side = 0;  // of the TCP: more than 0: along z
};

/// The share of a place that the fixture leaves free: along a plane, along an edge.
Vector3 free_part(const FixtureKind& kind, const Vector3& x) {
  switch (kind.place) {
    case FixturePlace::height:
      return {x.x(), x.y(), 0};
    case FixturePlace::axis:
      return {0, 0, x.z()};
    case FixturePlace::origin:
      return Vector3::Zero();
  }
  return Vector3::Zero();
}

class Fixtures {
 public:
  Fixtures(const Session& session, const Fit& fit) : session_(session), fit_(fit), touched_(session.fixtures.size()) {
    for (const ProblemObservation& o : fit.problem.observations) {
      const Observation& from = session.observations[static_cast<std::size_t>(o.index)];
      Touched& t = touched_[static_cast<std::size_t>(from.part)];
      const Rigid from_tcp = sensor_from_tcp_at(o, estimate(fit));
      const Sighting& s = o.sightings.front();
      t.tips.push_back(from_tcp * marker_at(o, estimate(fit), s.marker));
      t.values.push_back(touch_value(s));
      t.side += from_tcp.translation.z();
    }
  }

  const Touched& touched(std::size_t f) const { return touched_[f]; }

  Vector3 place_of_tip(std::size_t f, const Eigen::VectorXd& position) const {
    return place_in_fixture(fit_, static_cast<int>(f), position, 0);
  }

  /// Where touches have been, and from the side that they came from.
  bool is_as_touched(std::size_t f, const Eigen::VectorXd& position) const {
    const Touched& t = touched_[f];
    const FixtureKind& kind = *session_.fixtures[f].kind;
    Vector3 middle = Vector3::Zero();
    for (const Vector3& x : t.tips) middle += free_part(kind, x) / static_cast<double>(t.tips.size());
    double reach = least_reach;
    for (const Vector3& x : t.tips) reach = std::max(reach, (free_part(kind, x) - middle).norm());
    if ((free_part(kind, place_of_tip(f, position)) - middle).norm() > reach) return false;
    return !kind.is_one_sided || place_in_fixture(fit_, static_cast<int>(f), position, -1).z() * t.side > 0;
  }

 private:
  const Session& session_;
  const Fit& fit_;
  std::vector<Touched> touched_;
};

/// A posture from anywhere, or near one that was taken.
Eigen::VectorXd make_start(const Session& session, const PoseJudge& judge, std::mt19937_64& random) {
  const bool anywhere = uniform(random) < 0.5;
  const auto taken = static_cast<std::size_t>(uniform(random) * static_cast<double>(session.observations.size()));
  Eigen::VectorXd position = session.observations[taken].position;
  for (Eigen::Index j = 0; j < position.size(); ++j) {
    const double drawn = judge.lower()[j] + uniform(random) * (judge.upper()[j] - judge.lower()[j]);
    position[j] = anywhere ? drawn : 0.7 * position[j] + 0.3 * drawn;
  }
  return position;
}

}  // namespace

Vector3 place_in_fixture(const Fit& fit, int fixture, const Eigen::VectorXd& position, int marker) {
  const ObservationState c = states_at(fit.problem.source->chain.parts[static_cast<std::size_t>(fixture)], position);
  const ObservedEnds seen = observed_ends(c, moved_sites(c, fit.problem.terms));
  const Rigid root_from_fixture = seen.ends.root_from_mount * estimate(fit).mount(fixture) * seen.mount_motion;
  const Vector3 in_tcp =
      marker < 0 ? Vector3(Vector3::Zero()) : estimate(fit).markers_in_tcp[static_cast<std::size_t>(marker)];
  return inverse(root_from_fixture) * (seen.ends.root_from_tcp * in_tcp);
}

TouchPool touch_pool(const Session& session, const Fit& fit, const PoseJudge& judge, int count, std::uint64_t seed) {
  constexpr int tries_a_pose = 8;
  const Fixtures fixtures(session, fit);
  std::mt19937_64 random(seed);
  TouchPool pool;
  const auto each = std::max(1, count / static_cast<int>(session.fixtures.size()));
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Touched& touched = fixtures.touched(f);
    if (touched.tips.empty()) continue;
    const FixtureKind& kind = *session.fixtures[f].kind;
    const TipInFixture tip = [&](const Eigen::VectorXd& q) { return fixtures.place_of_tip(f, q); };
    int found = 0;
    for (int attempt = 0; attempt < tries_a_pose * each && found < each; ++attempt) {
      const auto like = static_cast<std::size_t>(uniform(random) * static_cast<double>(touched.values.size()));
      const auto numbers = static_cast<Eigen::Index>(kind.numbers.size());
      const Eigen::VectorXd wanted = Eigen::VectorXd::Constant(numbers, numbers > 1 ? 0 : touched.values[like]);
      const auto position =
          touching_posture(tip, kind, wanted, make_start(session, judge, random), judge.lower(), judge.upper());
      if (!position || judge.violation(*position) > 0 || !fixtures.is_as_touched(f, *position)) continue;
      pool.poses.push_back(*position);
      pool.fixtures.push_back(static_cast<int>(f));
      ++found;
    }
  }
  if (pool.poses.empty())
    throw InputError(
        message("{}: no posture within the joint limits touches a fixture; check the limits in the "
                "robot's file.",
                session.file.filename().string()));
  return pool;
}

}  // namespace handsight
