// SPDX-License-Identifier: Apache-2.0
// The formulas of ISO 9283 on numbers that were worked out by hand.
#include "certify/iso9283.h"

#include <gtest/gtest.h>

#include <cmath>

namespace handsight {
namespace {

Rigid at(double x, double y, double z, double turn_about_z = 0) {
  return {Eigen::AngleAxisd(turn_about_z, Vector3::UnitZ()).toRotationMatrix(), Vector3(x, y, z)};
}

/// Commanded (1000, 500, 200) mm. Attained four times:
///   1000.1 500.0 200.2, 1000.3 500.0 200.2, 1000.2 500.1 200.2, 1000.2 499.9 200.2
/// Barycentre (1000.2, 500.0, 200.2): AP = sqrt(0.04 + 0 + 0.04) = 0.28284 mm. Each is 0.1 mm from the barycentre: mean
/// distance 0.1, deviation 0: RP = 0.1 mm.
TEST(Iso9283, PoseAccuracyAndRepeatabilityByHand) {
  const Rigid commanded = at(1, 0.5, 0.2);
  const PoseFigures f = pose_figures(commanded, {at(1.0001, 0.5, 0.2002), at(1.0003, 0.5, 0.2002),
                                                 at(1.0002, 0.5001, 0.2002), at(1.0002, 0.4999, 0.2002)});
  EXPECT_EQ(f.cycles, 4);
  EXPECT_NEAR(f.ap, 1e-3 * 0.282842712474619, 1e-12);
  EXPECT_NEAR(f.ap_xyz.x(), 2e-4, 1e-12);
  EXPECT_NEAR(f.ap_xyz.y(), 0, 1e-12);
  EXPECT_NEAR(f.ap_xyz.z(), 2e-4, 1e-12);
  EXPECT_NEAR(*f.rp, 1e-4, 1e-12);
}

/// Distances from the barycentre 0.1, 0.1, 0.3, 0.3 mm: mean 0.2, deviation sqrt(0.04 / 3) = 0.115470; RP = 0.2 +
/// 3 * 0.115470 = 0.546410 mm. Turns about z of 1, 3, 2, 2 mrad: mean 2 mrad = AP_c; deviation sqrt(2 / 3) = 0.816497
/// mrad; RP_c = 2.449490 mrad.
TEST(Iso9283, RepeatabilityTakesThreeDeviationsMoreThanTheMean) {
  const Rigid commanded = at(0, 0, 0);
  const PoseFigures f = pose_figures(
      commanded, {at(1e-4, 0, 0, 1e-3), at(-1e-4, 0, 0, 3e-3), at(0, 3e-4, 0, 2e-3), at(0, -3e-4, 0, 2e-3)});
  EXPECT_NEAR(f.ap, 0, 1e-15);
  EXPECT_NEAR(*f.rp, 1e-3 * 0.546410161513775, 1e-12);
  EXPECT_NEAR(f.ap_abc.z(), 2e-3, 1e-12);
  EXPECT_NEAR((*f.rp_abc)[2], 1e-3 * 2.449489742783178, 1e-11);
  EXPECT_NEAR((*f.rp_abc)[0], 0, 1e-12);
}

/// Commanded 300 mm apart along x. Attained distances 300.1, 300.3, 300.2 mm: AD = 0.2 mm, RD = 3 * 0.1 = 0.3 mm.
TEST(Iso9283, DistanceAccuracyByHand) {
  const DistanceFigures f = distance_figures(at(0, 0, 0), {at(0, 0, 0), at(-1e-4, 0, 0), at(0, 0, 0), at(5, 5, 5)},
                                             at(0.3, 0, 0), {at(0.3001, 0, 0), at(0.3002, 0, 0), at(0.3002, 0, 0)});
  EXPECT_EQ(f.cycles, 3);
  EXPECT_NEAR(f.commanded, 0.3, 1e-15);
  EXPECT_NEAR(f.ad, 2e-4, 1e-12);
  EXPECT_NEAR(*f.rd, 3e-4, 1e-12);
}

/// Barycentres from x (0.1, 0, 0), from y (0, 0.1, 0), from z (0, 0, 0) mm: the farthest two are 0.141421 mm apart.
/// Mean turns about z 1, -1 and 0 mrad: 2 mrad.
TEST(Iso9283, MultiDirectionalVariationByHand) {
  const DirectionFigures f = direction_figures(
      at(0, 0, 0), {{at(2e-4, 0, 0, 1e-3), at(0, 0, 0, 1e-3)}, {at(0, 1e-4, 0, -1e-3)}, {at(0, 0, 0)}});
  EXPECT_NEAR(f.vap, 1e-4 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(f.vap_abc.z(), 2e-3, 1e-12);
}

TEST(Iso9283, OneCycleHasNoRepeatability) {
  EXPECT_FALSE(pose_figures(at(0, 0, 0), {at(1e-3, 0, 0)}).rp);
  EXPECT_FALSE(distance_figures(at(0, 0, 0), {at(0, 0, 0)}, at(1, 0, 0), {at(1, 0, 0)}).rd);
}

}  // namespace
}  // namespace handsight
