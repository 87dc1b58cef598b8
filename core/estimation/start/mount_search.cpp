// SPDX-License-Identifier: Apache-2.0
#include "estimation/start/mount_search.h"

#include <algorithm>
#include <cmath>

#include "estimation/solvers/least_squares.h"

namespace handsight {
namespace {

constexpr double least_turn = 0.15;           // rad: what turns less says nothing about axes
constexpr double least_sine = 0.25;           // between two axes
constexpr double most_turn = 2.94;            // rad: near half a turn the axis has two signs
constexpr double robot_turn = 0.05;           // rad: what arms do beside what they are commanded
constexpr std::size_t most_pairs = 20000;     // of motions, tried
constexpr std::size_t most_generating = 400;  // motions that pairs are made of

Rigid mount_from_tcp(const MountWitness& w) { return inverse(w.posture.root_from_mount) * w.posture.root_from_tcp; }

/// The motion from the reference to a witness, as the hand made it and as the body was seen to make it.
struct Motion {
  int witness = 0, body = 0;
  Rigid of_hand, of_body;  // in the mount's frame, in the sensor's
  Vector3 hand_axis, body_axis;
  double tolerance = 0;  // rad
};

std::vector<Motion> possible_motions(const std::vector<MountWitness>& witnesses, std::size_t reference) {
  std::vector<Motion> motions;
  const MountWitness& from = witnesses[reference];
  const Rigid tcp_from_mount = inverse(mount_from_tcp(from)),
              body_from_sensor = inverse(from.bodies[0].sensor_from_body);
  for (std::size_t w = 0; w < witnesses.size(); ++w) {
    if (w == reference) continue;
    for (std::size_t b = 0; b < witnesses[w].bodies.size(); ++b) {
      const SeenBody& seen = witnesses[w].bodies[b];
      Motion m{static_cast<int>(w),
               static_cast<int>(b),
               mount_from_tcp(witnesses[w]) * tcp_from_mount,
               seen.sensor_from_body * body_from_sensor,
               {},
               {},
               robot_turn + 3 * std::hypot(seen.turn_sigma, from.bodies[0].turn_sigma)};
      m.hand_axis = vector_from_rotation(m.of_hand.rotation);
      m.body_axis = vector_from_rotation(m.of_body.rotation);
      if (std::abs(m.hand_axis.norm() - m.body_axis.norm()) <= m.tolerance) motions.push_back(std::move(m));
    }
  }
  return motions;
}

bool tells_an_axis(const Motion& m) {
  const double turn = m.hand_axis.norm();
  return turn > std::max(least_turn, m.tolerance) && turn < most_turn;
}

/// R a = b for both axes and their cross product; t from both (R_hand - 1) t = R t_body - t_hand.
std::optional<Rigid> mount_from_two(const Motion& p, const Motion& q) {
  const Vector3 hand_p = p.hand_axis.normalized(), hand_q = q.hand_axis.normalized();
  const Vector3 body_p = p.body_axis.normalized(), body_q = q.body_axis.normalized();
  if (hand_p.cross(hand_q).norm() < least_sine || body_p.cross(body_q).norm() < least_sine) return std::nullopt;
  const double between =
      std::acos(std::clamp(hand_p.dot(hand_q), -1.0, 1.0)) - std::acos(std::clamp(body_p.dot(body_q), -1.0, 1.0));
  if (std::abs(between) > p.tolerance / p.hand_axis.norm() + q.tolerance / q.hand_axis.norm()) return std::nullopt;
  Matrix3 hand, body;
  hand << hand_p, hand_q, hand_p.cross(hand_q).normalized();
  body << body_p, body_q, body_p.cross(body_q).normalized();
  Rigid mount;
  mount.rotation = nearest_rotation(hand * body.transpose());
  Eigen::Matrix<double, 6, 3> left;
  Eigen::Matrix<double, 6, 1> right;
  left << p.of_hand.rotation - Matrix3::Identity(), q.of_hand.rotation - Matrix3::Identity();
  right << mount.rotation * p.of_body.translation - p.of_hand.translation,
      mount.rotation * q.of_body.translation - q.of_hand.translation;
  mount.translation = left.colPivHouseholderQr().solve(right);
  return mount;
}

/// How far from agreeing, as a share of what is allowed: 1 and more does not agree.
struct Gates {
  double offset = 0, turn = 0;  // m, rad: besides the bodies' own sigmas
};

double miss_of(const SeenBody& seen, const Rigid& predicted, const Vector3& center, const Gates& gates) {
  const double offset = (seen.sensor_from_body * center - predicted * center).norm() / (gates.offset + 3 * seen.sigma);
  const double turn = vector_from_rotation(seen.sensor_from_body.rotation * predicted.rotation.transpose()).norm() /
                      (gates.turn + 3 * seen.turn_sigma);
  return std::hypot(offset, turn);
}

struct Vote {
  std::vector<int> chosen;
  std::size_t agreeing = 0;
  double cost = 0;  // of every witness its miss squared, 1 where it does not agree
};

Vote vote(const std::vector<MountWitness>& witnesses, const Rigid& mount_from_sensor, const Rigid& tcp_from_body,
          const Vector3& center, const Gates& gates) {
  Vote v;
  const Rigid sensor_from_mount = inverse(mount_from_sensor);
  for (const MountWitness& w : witnesses) {
    const Rigid predicted = sensor_from_mount * mount_from_tcp(w) * tcp_from_body;
    int best = -1;
    double least = 1;
    for (std::size_t b = 0; b < w.bodies.size(); ++b)
      if (const double miss = miss_of(w.bodies[b], predicted, center, gates); miss < least) {
        least = miss;
        best = static_cast<int>(b);
      }
    v.chosen.push_back(best);
    v.agreeing += best >= 0 ? 1 : 0;
    v.cost += least * least;
  }
  return v;
}

/// The mount and the markers, fitted to those that agree.
std::optional<Unknowns> fitted(const Problem& problem, const std::vector<MountWitness>& witnesses, const Vote& v,
                               const Rigid& mount_from_sensor, const Rigid& tcp_from_body, const KnownMarkers& known) {
  Problem agreeing = problem;
  agreeing.observations.clear();
  agreeing.mount_is_estimated = true;
  for (std::size_t w = 0; w < witnesses.size(); ++w) {
    if (v.chosen[w] < 0) continue;
    agreeing.observations.push_back(witnesses[w].posture);
    agreeing.observations.back().sightings = witnesses[w].bodies[static_cast<std::size_t>(v.chosen[w])].sightings;
    for (const Sighting& s : agreeing.observations.back().sightings)
      agreeing.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
  }
  Unknowns start{{}, mount_from_sensor, {}};
  for (const auto& x : known.in_body) start.markers_in_tcp.push_back(x ? tcp_from_body * *x : Vector3::Zero());
  const Solution solution = solve(agreeing, start, {.most_iterations = 40});
  if (!solution.normal.in_front) return std::nullopt;
  return solution.unknowns;
}

Rigid tcp_from_body_of(const Unknowns& unknowns, const KnownMarkers& known) {
  std::vector<std::size_t> markers;
  for (std::size_t m = 0; m < known.in_body.size(); ++m)
    if (known.in_body[m]) markers.push_back(m);
  const auto count = static_cast<Eigen::Index>(markers.size());
  Eigen::Matrix3Xd in_tcp(3, count), in_body(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    in_tcp.col(i) = unknowns.markers_in_tcp[markers[static_cast<std::size_t>(i)]];
    in_body.col(i) = *known.in_body[markers[static_cast<std::size_t>(i)]];
  }
  return align_points(in_tcp, in_body, Eigen::VectorXd::Ones(count));
}

Vector3 center_of(const KnownMarkers& known) {
  Vector3 sum = Vector3::Zero();
  double count = 0;
  for (const auto& x : known.in_body)
    if (x) sum += *x, ++count;
  return count > 0 ? Vector3(sum / count) : sum;
}

struct Best {
  Vote vote;
  Rigid mount_from_sensor, tcp_from_body;
};

/// Of the mounts that two motions give, the one that the witnesses agree on best.
std::optional<Best> best_of_two(const std::vector<MountWitness>& witnesses, std::size_t reference,
                                const Vector3& center, const Gates& gates) {
  std::vector<Motion> motions = possible_motions(witnesses, reference);
  std::erase_if(motions, [](const Motion& m) { return !tells_an_axis(m); });
  if (motions.size() > most_generating) motions.resize(most_generating);
  std::optional<Best> best;
  std::size_t tried = 0;
  for (std::size_t i = 0; i < motions.size(); ++i)
    for (std::size_t j = i + 1; j < motions.size() && tried < most_pairs; ++j) {
      if (motions[i].witness == motions[j].witness) continue;
      const auto mount = mount_from_two(motions[i], motions[j]);
      if (!mount) continue;
      ++tried;
      const MountWitness& from = witnesses[reference];
      const Rigid tcp_from_body = inverse(mount_from_tcp(from)) * *mount * from.bodies[0].sensor_from_body;
      Vote v = vote(witnesses, *mount, tcp_from_body, center, gates);
      if (!best || v.cost < best->vote.cost) best = Best{std::move(v), *mount, tcp_from_body};
    }
  return best;
}

}  // namespace

std::optional<MountFound> search_mount(const Problem& problem, const std::vector<MountWitness>& witnesses,
                                       const KnownMarkers& known, const MatchOptions& options, std::size_t fewest) {
  std::vector<std::size_t> labelled;
  for (std::size_t w = 0; w < witnesses.size(); ++w)
    if (witnesses[w].is_labelled && !witnesses[w].bodies.empty()) labelled.push_back(w);
  if (labelled.empty()) return std::nullopt;
  if (labelled.size() >= 3) fewest = std::min<std::size_t>(fewest, 4);
  if (witnesses.size() < fewest) return std::nullopt;
  const Vector3 center = center_of(known);
  // Two motions of one triangle each give a rough mount only; what is fitted to all that agree is held to the gates.
  const Gates rough{3 * options.body_gate, 1.5 * options.turn_gate}, fine{options.body_gate, options.turn_gate};
  auto best = best_of_two(witnesses, labelled.front(), center, rough);
  if (!best) return std::nullopt;
  constexpr int rounds = 4;
  std::optional<Unknowns> unknowns;
  for (int round = 0; round < rounds; ++round) {
    if (best->vote.agreeing < std::min<std::size_t>(fewest, 4)) return std::nullopt;
    unknowns = fitted(problem, witnesses, best->vote, best->mount_from_sensor, best->tcp_from_body, known);
    if (!unknowns) return std::nullopt;
    best->mount_from_sensor = unknowns->mount_from_sensor;
    best->tcp_from_body = tcp_from_body_of(*unknowns, known);
    Vote again = vote(witnesses, best->mount_from_sensor, best->tcp_from_body, center, fine);
    const bool is_same = again.chosen == best->vote.chosen;
    best->vote = std::move(again);
    if (is_same) break;
  }
  const bool labels_agree =
      std::all_of(labelled.begin(), labelled.end(), [&](std::size_t w) { return best->vote.chosen[w] >= 0; });
  if (best->vote.agreeing < fewest || !labels_agree) return std::nullopt;
  return MountFound{std::move(*unknowns), best->vote.chosen, best->vote.agreeing};
}

int most_telling_witness(const std::vector<MountWitness>& witnesses) {
  int telling = -1;
  double farthest = -1;
  std::vector<Rigid> labelled;
  for (const MountWitness& w : witnesses)
    if (w.is_labelled) labelled.push_back(mount_from_tcp(w));
  for (std::size_t w = 0; w < witnesses.size(); ++w) {
    if (witnesses[w].is_labelled) continue;
    const Rigid here = mount_from_tcp(witnesses[w]);
    double nearest = 1e9;
    for (const Rigid& known : labelled)
      nearest = std::min(nearest, vector_from_rotation(known.rotation.transpose() * here.rotation).norm());
    if (nearest <= farthest) continue;
    farthest = nearest;
    telling = static_cast<int>(w);
  }
  return telling;
}

}  // namespace handsight
