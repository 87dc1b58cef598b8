// SPDX-License-Identifier: Apache-2.0
#include "certify/limits.h"

#include <gtest/gtest.h>

#include <random>

#include "base/sha256.h"

namespace handsight {
namespace {

TEST(LengthLimit, IsTheQuantileOfTheLength) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (const Vector3& sigmas : {Vector3(1, 1, 1), Vector3(3, 1, 0.2), Vector3(5, 0.1, 0.1), Vector3(2, 2, 0)}) {
    const Matrix3 turned = rotation_from_rpy({0.3, -0.5, 1.1});
    const double limit = length_limit(turned * sigmas.cwiseAbs2().asDiagonal() * turned.transpose(), 0.95);
    int inside = 0;
    constexpr int draws = 100000;
    for (int i = 0; i < draws; ++i) {
      const double x = normal(random), y = normal(random), z = normal(random);
      inside += sigmas.cwiseProduct(Vector3(x, y, z)).norm() <= limit;
    }
    EXPECT_NEAR(inside / double(draws), 0.95, 0.006) << sigmas.transpose();
  }
  EXPECT_EQ(length_limit(Matrix3::Zero(), 0.95), 0);
}

/// The table of Clopper and Pearson's intervals: 15 of 20: 0.509 to 0.913; 0 of 10: 0 to 0.308; 10 of 10: 0.692 to 1.
TEST(ClopperPearson, AgreesWithTheTable) {
  const ShareInterval some = clopper_pearson(15, 20, 0.95), none = clopper_pearson(0, 10, 0.95),
                      all = clopper_pearson(10, 10, 0.95);
  EXPECT_NEAR(some.low, 0.5090, 1e-4);
  EXPECT_NEAR(some.high, 0.9134, 1e-4);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 0.3085, 1e-4);
  EXPECT_NEAR(all.low, 0.6915, 1e-4);
  EXPECT_EQ(all.high, 1);
}

/// The examples of FIPS 180-4, and one of more than a block that ends in the padding's block.
TEST(Sha256, AgreesWithTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace handsight
