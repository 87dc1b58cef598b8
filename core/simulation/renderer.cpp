// SPDX-License-Identifier: Apache-2.0
#include "simulation/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "simulation/hand.h"
#include "simulation/point_spread.h"
#include "simulation/random.h"
#include "simulation/trace.h"

namespace handsight {

namespace {

/// Offsets in a pixel from its centre: a lattice in which no two samples share a column, a row or (`count` being prime)
/// a diagonal, so that edges in these directions are met as finely as `count`, not as its square root.
std::vector<Vector2> sample_offsets(int count, int generator) {
  std::vector<Vector2> offsets;
  for (int i = 0; i < count; ++i)
    offsets.emplace_back((i + 0.5) / count - 0.5, ((i * generator) % count + 0.5) / count - 0.5);
  return offsets;
}

/// How the ray changes per pixel along u and v; zero where a neighbour has no ray.
std::pair<Vector2, Vector2> ray_slopes(const PixelRays& rays, int u, int v) {
  const int width = rays.camera.width, height = rays.camera.height;
  auto slope = [&](int du, int dv) -> Vector2 {
    const int u0 = std::max(0, u - du), u1 = std::min(width - 1, u + du);
    const int v0 = std::max(0, v - dv), v1 = std::min(height - 1, v + dv);
    const int steps = (u1 - u0) + (v1 - v0);
    if (steps == 0) return Vector2::Zero();
    const Vector2 change =
        (rays.rays[static_cast<std::size_t>(v1) * width + u1] - rays.rays[static_cast<std::size_t>(v0) * width + u0]) /
        steps;
    return std::isfinite(change.sum()) ? change : Vector2::Zero();
  };
  return {slope(1, 0), slope(0, 1)};
}

struct Range {
  double least, most;
};

/// The tangents from the origin to a circle at (across, depth): bounds of across / depth over the circle.
Range tangents(double across, double depth, double radius) {
  const double denominator = depth * depth - radius * radius;
  if (depth <= radius || denominator < 1e-9) return {-1e30, 1e30};
  const double spread = radius * std::sqrt(std::max(0.0, across * across + denominator));
  return {(across * depth - spread) / denominator, (across * depth + spread) / denominator};
}

/// Per tile, the items whose balls can be seen in it.
using TileLists = std::vector<std::vector<std::uint16_t>>;

TileLists items_in_tiles(const SceneView& view, const PixelRays& rays) {
  TileLists lists(rays.tile_bounds.size());
  for (std::size_t i = 0; i < view.items.size(); ++i) {
    const Vector3& c = view.items[i].sphere_center;
    const double radius = view.items[i].sphere_radius;
    if (c.z() + radius <= 0) continue;
    const Range x = tangents(c.x(), c.z(), radius), y = tangents(c.y(), c.z(), radius);
    for (std::size_t t = 0; t < lists.size(); ++t) {
      const auto& bounds = rays.tile_bounds[t];
      if (x.most >= bounds[0] && x.least <= bounds[1] && y.most >= bounds[2] && y.least <= bounds[3])
        lists[t].push_back(static_cast<std::uint16_t>(i));
    }
  }
  return lists;
}

/// What each pixel's centre shows.
struct Canvas {
  std::vector<float> grey;
  std::vector<std::uint32_t> keys;
};

/// Calls visit(u, v, items) for every pixel that has a ray, tile by tile.
template <class Visit>
void for_each_pixel(const PixelRays& rays, const TileLists& lists, Visit visit) {
  const int width = rays.camera.width, height = rays.camera.height;
  for (int t = 0; t < rays.tile_columns * rays.tile_rows; ++t) {
    const int u0 = t % rays.tile_columns * PixelRays::tile, v0 = t / rays.tile_columns * PixelRays::tile;
    for (int v = v0; v < std::min(height, v0 + PixelRays::tile); ++v)
      for (int u = u0; u < std::min(width, u0 + PixelRays::tile); ++u)
        if (!std::isnan(rays.rays[static_cast<std::size_t>(v) * width + u].x()))
          visit(u, v, std::span<const std::uint16_t>(lists[static_cast<std::size_t>(t)]));
  }
}

/// Do the pixel and its eight neighbours show one thing? A straight edge through the pixel always parts those nine.
bool is_uniform(const Canvas& canvas, int width, int height, int u, int v) {
  const std::uint32_t key = canvas.keys[static_cast<std::size_t>(v) * width + u];
  for (int y = std::max(0, v - 1); y <= std::min(height - 1, v + 1); ++y)
    for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x)
      if (canvas.keys[static_cast<std::size_t>(y) * width + x] != key) return false;
  return true;
}

bool is_on_marker(const SceneView& view, const Canvas& canvas, int width, int height, int u, int v) {
  for (int y = std::max(0, v - 1); y <= std::min(height - 1, v + 1); ++y)
    for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
      const auto item = static_cast<int>(canvas.keys[static_cast<std::size_t>(y) * width + x] >> 16) - 2;
      if (item >= 0 && view.items[static_cast<std::size_t>(item)].is_measured()) return true;
    }
  return false;
}

Canvas paint_centres(const SceneView& view, const PixelRays& rays, const TileLists& lists) {
  const int width = rays.camera.width;
  Canvas canvas;
  canvas.grey.assign(rays.rays.size(), 0.0f);
  canvas.keys.assign(rays.rays.size(), 0);
  for_each_pixel(rays, lists, [&](int u, int v, std::span<const std::uint16_t> items) {
    const std::size_t pixel = static_cast<std::size_t>(v) * width + u;
    const Vector3 direction(rays.rays[pixel].x(), rays.rays[pixel].y(), 1);
    const Hit hit = trace(view, direction, items);
    canvas.keys[pixel] = hit.key();
    canvas.grey[pixel] = static_cast<float>(grey_at(view, direction, hit));
  });
  return canvas;
}

/// The samples of a pixel and how the light of each is shared among the pixels around.
struct Samples {
  std::vector<Vector2> offsets;
  std::vector<std::vector<float>> along_u, along_v;

  Samples(int count, int generator, const PointSpread& spread) : offsets(sample_offsets(count, generator)) {
    for (const Vector2& offset : offsets) {
      along_u.push_back(shares_at(spread, offset.x()));
      along_v.push_back(shares_at(spread, offset.y()));
    }
  }
};

/// Adds a sample's light to the pixels around (u, v).
void splat(std::vector<float>& grey, int width, int height, int u, int v, double light, const Samples& samples,
           std::size_t sample) {
  const std::vector<float>&along_u = samples.along_u[sample], &along_v = samples.along_v[sample];
  const int radius = static_cast<int>(along_u.size()) / 2;
  const int first = std::max(-radius, -u), last = std::min(radius, width - 1 - u);
  for (int y = std::max(-radius, -v); y <= std::min(radius, height - 1 - v); ++y) {
    float* row = grey.data() + static_cast<std::size_t>(v + y) * width + u;
    const float share = static_cast<float>(light) * along_v[radius + y];
    for (int x = first; x <= last; ++x) row[x] += share * along_u[radius + x];
  }
}

/// The image that falls on the sensor: pixels that show one thing are taken as evenly lit, the others sample by sample.
std::vector<float> expose(const SceneView& view, const PixelRays& rays, const PointSpread& spread) {
  const int width = rays.camera.width, height = rays.camera.height;
  const TileLists lists = items_in_tiles(view, rays);
  const Canvas canvas = paint_centres(view, rays, lists);
  std::vector<float> even = canvas.grey;
  std::vector<char> uneven(even.size(), 0);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const std::size_t pixel = static_cast<std::size_t>(v) * width + u;
      if (std::isnan(rays.rays[pixel].x()) || is_uniform(canvas, width, height, u, v)) continue;
      uneven[pixel] = 1;
      even[pixel] = 0;
    }
  std::vector<float> grey = spread_pixels(even, width, height, spread);
  const Samples coarse(17, 4, spread), fine(89, 34, spread);
  for_each_pixel(rays, lists, [&](int u, int v, std::span<const std::uint16_t> items) {
    const std::size_t pixel = static_cast<std::size_t>(v) * width + u;
    if (!uneven[pixel]) return;
    const Samples& samples = is_on_marker(view, canvas, width, height, u, v) ? fine : coarse;
    const auto [by_u, by_v] = ray_slopes(rays, u, v);
    const double share = 1.0 / static_cast<double>(samples.offsets.size());
    for (std::size_t s = 0; s < samples.offsets.size(); ++s) {
      const Vector2 ray = rays.rays[pixel] + samples.offsets[s].x() * by_u + samples.offsets[s].y() * by_v;
      const Vector3 direction(ray.x(), ray.y(), 1);
      splat(grey, width, height, u, v, share * grey_at(view, direction, trace(view, direction, items)), samples, s);
    }
  });
  const std::vector<float> along_u = spread_ones(width, spread), along_v = spread_ones(height, spread);
  for (int v = 0; v < height; ++v)  // no light from outside the image: what is inside stands for it
    for (int u = 0; u < width; ++u) grey[static_cast<std::size_t>(v) * width + u] /= along_u[u] * along_v[v];
  return grey;
}

std::uint8_t quantised(double grey) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(grey + 0.5), 0.0, 255.0));
}

Image read_out(const std::vector<float>& grey, int width, int height, const ImageEffects& effects) {
  Image image(width, height);
  Random random(effects.seed);
  for (std::size_t i = 0; i < grey.size(); i += 2) {
    double noise[2] = {0, 0};
    if (effects.noise_grey > 0) {  // both numbers of Box and Muller's pair
      const double length = effects.noise_grey * std::sqrt(-2 * std::log(1 - random.uniform()));
      const double angle = 2 * M_PI * random.uniform();
      noise[0] = length * std::cos(angle);
      noise[1] = length * std::sin(angle);
    }
    image.pixels[i] = quantised(grey[i] + noise[0]);
    if (i + 1 < grey.size()) image.pixels[i + 1] = quantised(grey[i + 1] + noise[1]);
  }
  return image;
}

}  // namespace

PixelRays pixel_rays(const Camera& camera) {
  check(camera.width > 0 && camera.height > 0, "a camera of {} x {} px", camera.width, camera.height);
  PixelRays rays;
  rays.camera = camera;
  rays.rays.reserve(static_cast<std::size_t>(camera.width) * camera.height);
  const Vector2 none = Vector2::Constant(std::numeric_limits<double>::quiet_NaN());
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) rays.rays.push_back(undistort(camera, Vector2(u, v)).value_or(none));
  rays.tile_columns = (camera.width + PixelRays::tile - 1) / PixelRays::tile;
  rays.tile_rows = (camera.height + PixelRays::tile - 1) / PixelRays::tile;
  for (int t = 0; t < rays.tile_columns * rays.tile_rows; ++t) {
    std::array<double, 4> bounds{1e30, -1e30, 1e30, -1e30};
    const int u0 = t % rays.tile_columns * PixelRays::tile, v0 = t / rays.tile_columns * PixelRays::tile;
    for (int v = v0 - 1; v <= v0 + PixelRays::tile; ++v)
      for (int u = u0 - 1; u <= u0 + PixelRays::tile; ++u) {
        const int x = std::clamp(u, 0, camera.width - 1), y = std::clamp(v, 0, camera.height - 1);
        const Vector2& ray = rays.rays[static_cast<std::size_t>(y) * camera.width + x];
        if (std::isnan(ray.x())) continue;
        bounds = {std::min(bounds[0], ray.x()), std::max(bounds[1], ray.x()), std::min(bounds[2], ray.y()),
                  std::max(bounds[3], ray.y())};
      }
    // Samples reach half a pixel past the image's last pixels.
    const double pad_x = 1 / std::abs(camera.fx), pad_y = 1 / std::abs(camera.fy);
    rays.tile_bounds.push_back({bounds[0] - pad_x, bounds[1] + pad_x, bounds[2] - pad_y, bounds[3] + pad_y});
  }
  return rays;
}

Image render(const Scene& scene, const PixelRays& rays, const Rigid& root_from_camera, const Rigid& root_from_tcp,
             const ImageEffects& effects) {
  const SceneView view = make_view(scene, root_from_camera, root_from_tcp);
  const std::vector<float> grey = expose(view, rays, point_spread(effects.blur_px));
  return read_out(grey, rays.camera.width, rays.camera.height, effects);
}

Image render(const Scene& scene, const Camera& camera, const Rigid& root_from_camera, const Rigid& root_from_tcp,
             const ImageEffects& effects) {
  return render(scene, pixel_rays(camera), root_from_camera, root_from_tcp, effects);
}

bool marker_is_seen(const Scene& scene, const Camera& camera, const Rigid& root_from_camera, const Rigid& root_from_tcp,
                    int marker, double most_turned_deg, double margin_px) {
  check(marker >= 0 && marker < static_cast<int>(scene.markers.size()), "marker {} of {}", marker,
        scene.markers.size());
  const MarkerPlate& plate = scene.markers[static_cast<std::size_t>(marker)];
  const Rigid camera_from_plate = inverse(root_from_camera) * root_from_tcp * tcp_from_plate(plate);
  const Vector3& center = camera_from_plate.translation;
  const double facing = -camera_from_plate.rotation.col(2).dot(center.normalized());
  if (facing < std::cos(most_turned_deg * M_PI / 180)) return false;
  std::vector<Vector3> places;
  const double reach = 0.95 * plate.cell;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {reach, reach}, {reach, -reach}, {-reach, reach}, {-reach, -reach}})
    places.push_back(camera_from_plate * Vector3(x, y, 0));
  for (const Vector3& place : places)
    if (!is_visible(camera, place, margin_px)) return false;
  const SceneView view = make_view(scene, root_from_camera, root_from_tcp);
  for (const Vector3& place : places) {
    const Hit hit = trace(view, place / place.z());
    if (hit.item < 0 || view.items[static_cast<std::size_t>(hit.item)].marker != marker) return false;
  }
  return true;
}

}  // namespace handsight
