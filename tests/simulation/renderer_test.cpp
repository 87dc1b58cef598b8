// SPDX-License-Identifier: Apache-2.0
#include "simulation/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "fixtures/drawn.h"
#include "simulation/hand.h"
#include "simulation/random.h"
#include "simulation/scene.h"

namespace handsight {
namespace {

Camera head_camera() {
  Camera camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = 521;
  camera.fy = 519;
  camera.skew = 0.4;
  camera.cx = 318;
  camera.cy = 243;
  camera.k1 = -0.22;
  camera.k2 = 0.08;
  camera.p1 = 0.0005;
  camera.p2 = -0.0003;
  return camera;
}

/// A camera at 1.2 m that looks along the root's x axis.
Rigid root_from_head_camera() {
  Rigid root_from_camera;
  root_from_camera.rotation << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  root_from_camera.translation = {0, 0, 1.2};
  return root_from_camera;
}

/// A hand in front of that camera, its back (+x of TCP) toward it, turned by `turn`.
Rigid hand_in_view(Random& random, double turn) {
  Rigid root_from_tcp;
  const Vector3 tilt = fixture::drawn_3([&] { return random.uniform(-turn, turn); });
  root_from_tcp.rotation = rotation_from_vector<double>(tilt) *
                           rotation_about<double>(Vector3::UnitX(), random.uniform(0, 2 * M_PI)) *
                           rotation_about<double>(Vector3::UnitZ(), M_PI);
  root_from_tcp.translation = {random.uniform(0.45, 0.7), random.uniform(-0.08, 0.08), random.uniform(1.12, 1.28)};
  return root_from_tcp;
}

Scene scene_with(const std::vector<MarkerPlate>& markers, std::uint64_t seed, int distractors = 24) {
  SceneOptions options;
  options.seed = seed;
  options.distractor_corners = distractors;
  options.workspace = {{0, 0, 1.2}, {0.57, 0, 1.2}, 0.2};
  return make_scene(markers, options);
}

/// A single label on nothing, evenly lit: what surrounds the corner is exactly point symmetric when seen from ahead.
Scene bare_marker(const MarkerPlate& marker) {
  Scene scene = scene_with({}, 1, 0);
  scene.markers = {marker};
  scene.light = Light();
  scene.light.ambient = 1;
  return scene;
}

/// The saddle of a quadratic fitted to the grey levels about `start`: no use of anything the renderer knows.
std::optional<Vector2> saddle_near(const Image& image, Vector2 place) {
  for (int iteration = 0; iteration < 10; ++iteration) {
    const int u0 = static_cast<int>(std::lround(place.x())), v0 = static_cast<int>(std::lround(place.y()));
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (int v = v0 - 4; v <= v0 + 4; ++v)
      for (int u = u0 - 4; u <= u0 + 4; ++u) {
        const double x = u - place.x(), y = v - place.y(), weight = std::exp(-(x * x + y * y) / 2);
        Eigen::Matrix<double, 6, 1> terms;
        terms << 1, x, y, x * x, x * y, y * y;
        normal += weight * terms * terms.transpose();
        right += weight * terms * static_cast<double>(image.row(v)[u]);
      }
    const Eigen::Matrix<double, 6, 1> c = normal.ldlt().solve(right);
    Eigen::Matrix2d hessian;
    hessian << 2 * c[3], c[4], c[4], 2 * c[5];
    if (hessian.determinant() >= 0) return std::nullopt;
    const Vector2 step = -hessian.inverse() * c.segment<2>(1);
    place += step;
    if (step.norm() > 3) return std::nullopt;
    if (step.norm() < 1e-5) return place;
  }
  return place;
}

TEST(Renderer, CornersAreWhereProjectSays) {
  const Camera camera = head_camera();
  const PixelRays rays = pixel_rays(camera);
  const Rigid root_from_camera = root_from_head_camera();
  Vector2 sum = Vector2::Zero(), absolute = Vector2::Zero();
  int count = 0;
  for (std::uint64_t seed = 0; seed < 22; ++seed) {
    Random random(seed);
    const std::vector<MarkerPlate> markers = lay_out_markers(6, 0.013, seed);
    const Scene scene = scene_with(markers, seed);
    const Rigid root_from_tcp = hand_in_view(random, 0.5);
    const Image image = render(scene, rays, root_from_camera, root_from_tcp, {0.7, 0.0, 1});
    for (int m = 0; m < 6; ++m) {
      if (!marker_is_seen(scene, camera, root_from_camera, root_from_tcp, m, 55)) continue;
      const Vector2 truth = project(
          camera, Vector3(inverse(root_from_camera) * (root_from_tcp * markers[static_cast<std::size_t>(m)].center)));
      const std::optional<Vector2> found = saddle_near(image, truth);
      ASSERT_TRUE(found.has_value()) << "seed " << seed << " marker " << m;
      sum += *found - truth;
      absolute += (*found - truth).cwiseAbs();
      ++count;
    }
  }
  ASSERT_GT(count, 80);
  // The saddle itself errs by about 0.01 px a corner (perspective, uneven light, 8 bits).
  EXPECT_LT(absolute.x() / count, 0.012);
  EXPECT_LT(absolute.y() / count, 0.012);
  EXPECT_NEAR(sum.x() / count, 0, 0.004);
  EXPECT_NEAR(sum.y() / count, 0, 0.004);
}

/// The corner found by fitting what an ideal camera sees of two crossing edges at a right angle, one along `angle` in
/// the image: mean + half contrast * erf(a) erf(b), blurred by `sigma` (px).
Vector2 ideal_corner(const Image& image, Vector2 place, double angle, double sigma) {
  const Vector2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  for (int iteration = 0; iteration < 20; ++iteration) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    auto column = [&](const Vector2& pixel) {
      const double a = along.dot(pixel - place), b = across.dot(pixel - place), root = std::sqrt(2.0) * sigma;
      const double slope = 2 / (std::sqrt(M_PI) * root);
      const double by_a = slope * std::exp(-a * a / (root * root)) * std::erf(b / root);
      const double by_b = slope * std::exp(-b * b / (root * root)) * std::erf(a / root);
      // The contrast is in the model as a factor of the last two: linear enough near the truth.
      return Eigen::Vector4d(1, std::erf(a / root) * std::erf(b / root), -by_a, -by_b);
    };
    for (int v = static_cast<int>(place.y()) - 6; v <= static_cast<int>(place.y()) + 7; ++v)
      for (int u = static_cast<int>(place.x()) - 6; u <= static_cast<int>(place.x()) + 7; ++u) {
        const Eigen::Vector4d c = column(Vector2(u, v));
        normal += c * c.transpose();
        right += c * static_cast<double>(image.row(v)[u]);
      }
    const Eigen::Vector4d solved = normal.ldlt().solve(right);
    const Vector2 step = (solved[2] * along + solved[3] * across) / solved[1];
    place += step;
    if (step.norm() < 1e-6) break;
  }
  return place;
}

TEST(Renderer, SymmetricCornersAreExact) {
  Camera camera = head_camera();
  camera.fx = camera.fy = 520;
  camera.skew = camera.k1 = camera.k2 = camera.p1 = camera.p2 = 0;
  const PixelRays rays = pixel_rays(camera);
  Random random(3);
  Vector2 sum = Vector2::Zero();
  double squares = 0;
  constexpr int trials = 44;
  for (int trial = 0; trial < trials; ++trial) {
    MarkerPlate marker;
    marker.cell = 0.02;
    marker.normal = -Vector3::UnitX();
    const double angle = trial < 16 ? M_PI / 4 * trial : random.uniform(0, M_PI);  // along the pixels too
    marker.up = Vector3(0, -std::cos(angle), -std::sin(angle));                    // image u is -y, v is -z
    Rigid root_from_tcp;
    root_from_tcp.translation = {0.5, random.uniform(-0.05, 0.05), 1.2 + random.uniform(-0.05, 0.05)};
    const Image image = render(bare_marker(marker), rays, root_from_head_camera(), root_from_tcp, {0.8, 0.0, 1});
    const Vector2 truth = project(camera, Vector3(inverse(root_from_head_camera()) * root_from_tcp.translation));
    // The pixel's square counts as a Gaussian of variance 1/12.
    const Vector2 found = ideal_corner(image, truth + Vector2(0.2, -0.1), angle, std::sqrt(0.64 + 1.0 / 12));
    // Where edges run along the pixels, every row has the same samples and the same rounding to grey levels.
    EXPECT_LT((found - truth).norm(), 0.015) << "at " << angle;
    sum += found - truth;
    squares += (found - truth).squaredNorm();
  }
  EXPECT_LT((sum / trials).norm(), 0.0015);
  EXPECT_LT(std::sqrt(squares / trials), 0.005);
}

TEST(Renderer, BlurHasItsSigma) {
  Camera camera = head_camera();
  camera.skew = camera.k1 = camera.k2 = camera.p1 = camera.p2 = 0;
  MarkerPlate marker;
  marker.cell = 0.2;
  marker.normal = -Vector3::UnitX();
  marker.up = Vector3::UnitY();
  marker.black = 20;
  marker.white = 240;
  Rigid root_from_tcp;
  root_from_tcp.translation = {1, 0, 1.25};
  for (const double sigma : {0.0, 0.4, 0.7, 1.5}) {
    const Image image = render(bare_marker(marker), camera, root_from_head_camera(), root_from_tcp, {sigma, 0.0, 1});
    double weight = 0, first = 0, second = 0;  // moments of the edge's slope along a row
    for (int u = 290; u < 346; ++u) {
      const double slope = image.row(280)[u + 1] - image.row(280)[u];
      weight += slope;
      first += slope * (u + 0.5);
      second += slope * (u + 0.5) * (u + 0.5);
    }
    ASSERT_NEAR(std::abs(weight), 220, 1.1);
    const double mean = first / weight, variance = second / weight - mean * mean;
    // The pixel's square and that of the difference add 1/12 each; with no blur at all the edge halves one pixel: 1/4.
    EXPECT_NEAR(mean, 318, 0.01);
    EXPECT_NEAR(variance, sigma == 0 ? 0.25 : sigma * sigma + 1.0 / 6, 0.02 + 0.015 * sigma * sigma);
  }
}

TEST(Renderer, NoiseHasItsSigmaAndItsSeed) {
  const PixelRays rays = pixel_rays(head_camera());
  const Scene scene = scene_with(lay_out_markers(3, 0.012, 1), 1);
  Random random(1);
  const Rigid root_from_tcp = hand_in_view(random, 0.3);
  auto image = [&](double noise, std::uint64_t seed) {
    return render(scene, rays, root_from_head_camera(), root_from_tcp, {0.7, noise, seed});
  };
  const Image still = image(0, 1), first = image(2, 1), again = image(2, 1), second = image(2, 2);
  EXPECT_EQ(first.pixels, again.pixels);
  EXPECT_NE(first.pixels, second.pixels);
  double sum = 0, squares = 0, products = 0;
  for (std::size_t i = 0; i < still.pixels.size(); ++i) {
    const double a = first.pixels[i] - still.pixels[i], b = second.pixels[i] - still.pixels[i];
    sum += a;
    squares += a * a;
    products += a * b;
  }
  const auto count = static_cast<double>(still.pixels.size());
  EXPECT_NEAR(sum / count, 0, 0.02);
  EXPECT_NEAR(std::sqrt(squares / count), std::sqrt(4 + 2.0 / 12), 0.05);  // both images are rounded
  EXPECT_NEAR(products / count, 1.0 / 12, 0.05);                           // what they share is the rounding of `still`
}

TEST(Renderer, LeavesPixelsWithoutARayBlack) {
  Camera camera = head_camera();
  camera.k1 = -0.9;  // folds back inside the image
  camera.k2 = 0;
  Rigid root_from_tcp;
  root_from_tcp.translation = {0.6, 0, 1.2};
  const Scene scene = scene_with(lay_out_markers(3, 0.012, 1), 1);
  const Image image = render(scene, camera, root_from_head_camera(), root_from_tcp, {0, 0, 1});
  EXPECT_EQ(image.row(0)[0], 0);
  EXPECT_GT(image.row(240)[320], 0);
}

TEST(Renderer, SaysWhichMarkersAreSeen) {
  const Camera camera = head_camera();
  const Rigid root_from_camera = root_from_head_camera();
  Rigid root_from_tcp;  // the back of the hand toward the camera
  root_from_tcp.rotation = rotation_about<double>(Vector3::UnitZ(), M_PI);
  root_from_tcp.translation = {0.6, 0, 1.15};
  Scene scene = scene_with(lay_out_markers(3, 0.012, 5), 5);
  auto seen = [&](const Rigid& pose) {
    int count = 0;
    for (int m = 0; m < 3; ++m) count += marker_is_seen(scene, camera, root_from_camera, pose, m, 50);
    return count;
  };
  EXPECT_EQ(seen(root_from_tcp), 3);
  const auto turned = [&](double angle) {
    Rigid pose = root_from_tcp;
    pose.rotation = rotation_about<double>(Vector3::UnitZ(), angle) * pose.rotation;
    return pose;
  };
  EXPECT_EQ(seen(turned(M_PI)), 0);  // hidden by the palm
  EXPECT_EQ(seen(turned(1.3)), 0);   // too slanted
  Rigid outside = root_from_tcp;
  outside.translation.y() += 0.5;
  EXPECT_EQ(seen(outside), 0);
  Rigid behind = root_from_tcp;
  behind.translation.x() = -0.6;
  EXPECT_EQ(seen(behind), 0);
  Solid cover;  // between camera and hand
  cover.frame_from_solid.translation = {0.3, 0, 1.2};
  cover.half_size = {0.01, 0.2, 0.2};
  scene.solids.push_back(cover);
  EXPECT_EQ(seen(root_from_tcp), 0);
}

TEST(Renderer, PaintsWhatItCallsSeenAndNothingElse) {
  const Camera camera = head_camera();
  const PixelRays rays = pixel_rays(camera);
  Random random(8);
  Rigid root_from_tcp = hand_in_view(random, 0.1);
  const std::vector<MarkerPlate> markers = lay_out_markers(3, 0.014, 4);
  Scene scene = scene_with(markers, 4);
  scene.light = Light();
  scene.light.ambient = 1;
  auto contrast = [&](const Rigid& pose) {
    const Image image = render(scene, rays, root_from_head_camera(), pose, {0.5, 0, 1});
    const Vector2 at = project(camera, Vector3(inverse(root_from_head_camera()) * (pose * markers[0].center)));
    int least = 255, most = 0;
    for (int v = -4; v <= 4; ++v)
      for (int u = -4; u <= 4; ++u) {
        const int grey = image.row(static_cast<int>(at.y()) + v)[static_cast<int>(at.x()) + u];
        least = std::min(least, grey);
        most = std::max(most, grey);
      }
    return most - least;
  };
  EXPECT_NEAR(contrast(root_from_tcp), markers[0].white - markers[0].black, 3);
  root_from_tcp.rotation = rotation_about<double>(Vector3::UnitZ(), M_PI) * root_from_tcp.rotation;
  EXPECT_LT(contrast(root_from_tcp), 60);  // the palm from its other side
}

}  // namespace
}  // namespace handsight
