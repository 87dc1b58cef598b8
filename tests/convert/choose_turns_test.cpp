// SPDX-License-Identifier: Apache-2.0
// Over chance recordings: a reading that is chosen is the right one, and where motions tell it, it is chosen.
#include "convert/choose_turns.h"

#include <gmock/gmock.h>

#include <numbers>
#include <random>

#include "base/error.h"

namespace handsight {
namespace {

constexpr double pi = std::numbers::pi;

/// The numbers of a rotation, rad; written without the code under test.
std::vector<double> list_numbers(const Matrix3& m, AngleKind kind) {
  const auto list = [](const Vector3& v) { return std::vector<double>{v.x(), v.y(), v.z()}; };
  switch (kind) {
    case AngleKind::rotation_vector:
      return list(vector_from_rotation(m));
    case AngleKind::rpy: {
      const Vector3 v = m.eulerAngles(2, 1, 0);
      return {v.z(), v.y(), v.x()};
    }
    case AngleKind::zyx:
      return list(m.eulerAngles(2, 1, 0));
    case AngleKind::zyz:
      return list(m.eulerAngles(2, 1, 2));
    default:
      return list(m.eulerAngles(0, 1, 2));
  }
}

struct Recording {
  std::vector<Rigid> flange, target;
  bool eye_in_hand = true;
};

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}
  int upto(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  Vector3 vector(double size) { return {size * normal_(random_), size * normal_(random_), size * normal_(random_)}; }
  Rigid motion(double turn, double shift) { return {rotation_from_vector<double>(vector(turn)), vector(shift)}; }

  /// A robot that points down or anywhere and turns by `turn`; noise of the sensor in mm and mrad.
  Recording recording(int count, double turn, double noise) {
    Recording r;
    r.eye_in_hand = upto(2) == 0;
    const Rigid on_flange = motion(1, 0.06),
                fixed{rotation_from_vector<double>(vector(1)), Vector3(0.6, 0, 0.1) + vector(0.2)};
    const Matrix3 usual = upto(3) > 0 ? rotation_from_rpy({pi, 0, 0}) : rotation_from_vector<double>(vector(1));
    for (int i = 0; i < count; ++i) {
      const Rigid flange{rotation_from_rpy({0, 0, turn * normal_(random_)}) * usual * motion(turn, 0).rotation,
                         Vector3(0.5, 0, 0.5) + vector(0.12)};
      const Rigid seen = r.eye_in_hand ? inverse(flange * on_flange) * fixed : inverse(fixed) * flange * on_flange;
      r.flange.push_back(flange);
      r.target.push_back(motion(1e-3 * noise, 1e-3 * noise) * seen);
    }
    return r;
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

const std::vector<AngleKind> all_kinds{AngleKind::rotation_vector, AngleKind::rpy, AngleKind::zyx,
                                       AngleKind::moving_xyz, AngleKind::zyz};

NamedPoses open_poses(const std::vector<Rigid>& poses, AngleKind kind, bool degrees) {
  NamedPoses named{"flange.csv", "", {.poses = poses}};
  double largest = 0;
  for (const Rigid& p : poses) {
    std::vector<double> n = list_numbers(p.rotation, kind);
    for (double& x : n) x *= degrees ? 180 / pi : 1, largest = std::max(largest, std::abs(x));
    named.turns.numbers.push_back(n);
  }
  named.turns.columns = "the last three columns";
  named.turns.readings = list_readings(all_kinds, "", false, false, largest);
  read_turns(named.turns, named.turns.readings[0], named.series);
  return named;
}

enum class Outcome { right, wrong, asked };

Outcome make_outcome(const Recording& r, AngleKind kind, bool degrees, bool both) {
  NamedPoses flange = open_poses(r.flange, kind, degrees), target{"target.csv", "", {.poses = r.target}};
  if (both) target = open_poses(r.target, kind, degrees);
  std::vector<Message> notes;
  try {
    choose_turns(flange, target, r.eye_in_hand, notes);
  } catch (const InputError&) {
    return Outcome::asked;
  }
  for (std::size_t i = 0; i < r.flange.size(); ++i)
    if ((flange.series.poses[i].rotation - r.flange[i].rotation).norm() > 0.01 ||
        (target.series.poses[i].rotation - r.target[i].rotation).norm() > 0.01)
      return Outcome::wrong;
  return Outcome::right;
}

TEST(ChooseTurns, NeverWrongAndSeldomAskedOverChanceRecordings) {
  Chance chance(11);
  int right = 0, wrong = 0, asked = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const int count = 8 + 4 * chance.upto(5);
    const double turn = std::vector<double>{0.2, 0.4, 0.8}[static_cast<std::size_t>(chance.upto(3))];
    const Recording r = chance.recording(count, turn, chance.upto(2) ? 0.5 : 3);
    const Outcome o =
        make_outcome(r, all_kinds[static_cast<std::size_t>(chance.upto(5))], chance.upto(2) == 0, chance.upto(3) == 0);
    right += o == Outcome::right;
    wrong += o == Outcome::wrong;
    asked += o == Outcome::asked;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(right, 140) << asked << " asked";
}

TEST(ChooseTurns, OfFewPosesItAsksRatherThanErr) {
  Chance chance(12);
  int wrong = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Recording r = chance.recording(4 + chance.upto(3), 0.3, 2);
    wrong += make_outcome(r, all_kinds[static_cast<std::size_t>(chance.upto(5))], false, chance.upto(3) == 0) ==
             Outcome::wrong;
  }
  EXPECT_LE(wrong, 1);
}

TEST(ChooseTurns, AnEighthOfTheRowsMayBeWrong) {
  Chance chance(13);
  int right = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Recording r = chance.recording(24, 0.4, 0.5);
    for (const std::size_t i : {3, 11, 17}) r.target[i] = chance.motion(1, 0.3);
    right += make_outcome(r, all_kinds[static_cast<std::size_t>(chance.upto(5))], false, false) == Outcome::right;
  }
  EXPECT_GE(right, 38);
}

}  // namespace
}  // namespace handsight
