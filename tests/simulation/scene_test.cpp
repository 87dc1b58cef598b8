// SPDX-License-Identifier: Apache-2.0
#include "simulation/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation/random.h"
#include "simulation/trace.h"

namespace handsight {
namespace {

int chess_corners(const Scene& scene) {
  int count = 0;
  for (const Plate& plate : scene.plates)
    if (plate.pattern == SurfacePattern::chess) count += (plate.columns - 1) * (plate.rows - 1);
  return count;
}

TEST(Scene, HasAsManyDistractorCornersAsAsked) {
  for (const int wanted : {0, 1, 7, 30, 60}) {
    SceneOptions options;
    options.seed = static_cast<std::uint64_t>(wanted) + 3;
    options.distractor_corners = wanted;
    EXPECT_EQ(chess_corners(make_scene(lay_out_markers(3, 0.012, 1), options)), wanted);
  }
}

TEST(Scene, NothingStandsBetweenCameraAndHand) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    SceneOptions options;
    options.seed = seed;
    options.workspace = {random.gaussian3(), random.gaussian3(), random.uniform(0.1, 0.4)};
    const Scene scene = make_scene({}, options);
    const SceneView view = make_view(scene, {Matrix3::Identity(), options.workspace.camera}, Rigid());
    for (int i = 0; i < 200; ++i) {
      const Vector3 way = random.gaussian3().normalized();
      const Vector3 place = options.workspace.hand + options.workspace.reach * random.uniform() * way;
      const Hit hit = trace(view, place - options.workspace.camera);
      ASSERT_NE(hit.item, Hit::nothing);
      EXPECT_GT(hit.depth, 1.0) << "seed " << seed;
    }
  }
}

TEST(Scene, SameSeedSameScene) {
  const SceneOptions options;
  const Scene a = make_scene(lay_out_markers(3, 0.012, 1), options),
              b = make_scene(lay_out_markers(3, 0.012, 1), options);
  EXPECT_EQ(a.texture.values, b.texture.values);
  ASSERT_EQ(a.plates.size(), b.plates.size());
  for (std::size_t i = 0; i < a.plates.size(); ++i)
    EXPECT_EQ(a.plates[i].frame_from_plate.translation, b.plates[i].frame_from_plate.translation);
}

TEST(Scene, TextureHasNoEdges) {
  const Texture texture = make_texture(7);
  double largest = 0, sum = 0;
  for (int y = 0; y < Texture::size; ++y)
    for (int x = 0; x < Texture::size; ++x) {
      sum += texture.at(x, y);
      largest = std::max({largest, std::abs(texture.at(x + 1, y) - texture.at(x, y)),
                          std::abs(texture.at(x, y + 1) - texture.at(x, y))});
    }
  EXPECT_NEAR(sum / (Texture::size * Texture::size), 0, 1e-6);
  EXPECT_LT(largest, 0.2);  // of amplitudes of 26 grey levels and less: 5 a texel
  EXPECT_EQ(texture.at(-3.25, 5.5), texture.at(Texture::size - 3.25, Texture::size + 5.5));
}

TEST(Layout, MarkersAreApartAndFaceTheSameWay) {
  for (const int count : {1, 2, 3, 4, 6, 12, 64})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Vector3 back = Random(seed).gaussian3().normalized();
      const std::vector<MarkerPlate> markers = lay_out_markers(count, 0.012, seed, back, back.unitOrthogonal());
      ASSERT_EQ(markers.size(), static_cast<std::size_t>(count));
      for (std::size_t i = 0; i < markers.size(); ++i) {
        EXPECT_LT(std::acos(std::min(1.0, markers[i].normal.dot(back))), 16 * M_PI / 180);
        EXPECT_LT(markers[i].center.norm(), 0.4);
        for (std::size_t k = 0; k < i; ++k) {
          const double apart = (markers[i].center - markers[k].center).norm();
          EXPECT_GT(apart, count <= 6 ? 0.04 : std::sqrt(2.0) * 2 * half_side(markers[i]));
          if (count <= 3) {
            EXPECT_LT(apart, 0.09);
          }
        }
      }
    }
}

TEST(Layout, ThreeMarkersAreNotOnALine) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<MarkerPlate> m = lay_out_markers(3, 0.012, seed);
    const double area = (m[1].center - m[0].center).cross(m[2].center - m[0].center).norm() / 2;
    EXPECT_GT(area, 0.5 * 0.04 * 0.035);
  }
}

TEST(Layout, LabelsAtGivenPlacesDoNotOverlap) {
  const std::vector<MarkerPlate> markers =
      marker_plates({{0, 0, 0.02}, {0.03, 0, 0.02}, {0, 0.04, 0.02}}, Vector3::UnitZ(), 0.014, 1);
  ASSERT_EQ(markers.size(), 3u);
  EXPECT_EQ(markers[1].center, Vector3(0.03, 0, 0.02));
  EXPECT_LT(std::sqrt(2.0) * 2 * half_side(markers[0]), 0.03);
  EXPECT_NEAR(markers[0].up.dot(markers[0].normal), 0, 1e-12);
}

/// Straight down from 0.2 m above a marker's cell: what is met?
Hit seen_from_above(const Scene& scene, const MarkerPlate& marker) {
  const Vector3 eye = marker.center + 0.2 * marker.normal + 0.003 * marker.up;
  return trace(make_view(scene, {Matrix3::Identity(), eye}, Rigid()), -marker.normal);
}

TEST(Hand, CarriesEveryMarkerOnAPedestalThatReachesIt) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Vector3 up = random.gaussian3().normalized(), normal = random.gaussian3().normalized();
    const std::vector<MarkerPlate> markers = lay_out_markers(4, 0.012, seed, normal, up);
    Scene scene = make_scene(markers, SceneOptions());
    scene.solids.clear();
    scene.room_lower.setConstant(-5);
    scene.room_upper.setConstant(5);
    Scene bare = scene;  // only the hand is left
    bare.markers.clear();
    for (std::size_t m = 0; m < markers.size(); ++m) {
      const Hit label = seen_from_above(scene, markers[m]);
      EXPECT_EQ(label.item, static_cast<int>(m));
      EXPECT_NEAR(label.depth, 0.2, 1e-9);
      const double to_palm = seen_from_above(bare, markers[m]).depth - 0.2;
      EXPECT_GT(to_palm, 0.007);
      EXPECT_LT(to_palm, scene.markers[m].pedestal);
    }
  }
}

TEST(Hand, ALabelThatSlippedIsStillSeen) {
  const std::vector<MarkerPlate> markers = lay_out_markers(3, 0.012, 2);
  Scene scene = make_scene(markers, SceneOptions());
  scene.solids.clear();
  for (const double slip : {-0.006, -0.002, 0.002, 0.006}) {
    scene.markers[1].center = markers[1].center + slip * markers[1].normal;
    EXPECT_EQ(seen_from_above(scene, scene.markers[1]).item, 1);
  }
}

}  // namespace
}  // namespace handsight
