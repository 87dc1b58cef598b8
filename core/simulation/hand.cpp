// SPDX-License-Identifier: Apache-2.0
#include "simulation/hand.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "simulation/random.h"

namespace handsight {

namespace {

Vector3 mean_normal(const std::vector<MarkerPlate>& markers) {
  Vector3 sum = Vector3::Zero();
  for (const MarkerPlate& marker : markers) sum += marker.normal.normalized();
  return sum.norm() > 0.2 * static_cast<double>(markers.size()) ? Vector3(sum.normalized()) : markers[0].normal;
}

Vector3 turned_in_plane(const Vector3& normal, double angle) {
  return rotation_about(normal, angle) * normal.unitOrthogonal();
}

Solid box(const Matrix3& axes, const Vector3& center, const Vector3& half_size, double grey) {
  Solid solid;
  solid.frame_from_solid = {axes, center};
  solid.half_size = half_size;
  solid.grey = grey;
  return solid;
}

Solid capsule(const Vector3& from, const Vector3& to, double radius, double grey) {
  Solid solid;
  solid.kind = SolidKind::capsule;
  const Vector3 along = to - from;
  solid.frame_from_solid = {axes_from(along, along.unitOrthogonal()), (from + to) / 2};
  solid.half_size = {radius, radius, along.norm() / 2};
  solid.grey = grey;
  return solid;
}

/// The palm's axes (x toward the fingers, z out of the markers' plane), its ends along x and y and its top.
struct Palm {
  Matrix3 axes;
  double front = -1e9, rear = 1e9, left = -1e9, right = 1e9, top = 1e9;  // m, TCP origin at 0
  double thickness = 0.04;

  Vector3 at(double x, double y, double z) const { return axes * Vector3(x, y, z); }
};

Palm palm_under(const std::vector<MarkerPlate>& markers, const Vector3& fingers) {
  Palm palm;
  const Vector3 normal = mean_normal(markers);
  palm.axes = axes_from(normal, fingers);
  for (const MarkerPlate& marker : markers) {
    if (marker.normal.dot(normal) < 0.3) continue;  // on another side of the hand
    const Vector3 center = palm.axes.transpose() * marker.center;
    const double reach = half_side(marker) + 0.005;
    palm.front = std::max(palm.front, center.x() + reach);
    palm.rear = std::min(palm.rear, center.x() - reach);
    palm.left = std::max(palm.left, center.y() + reach);
    palm.right = std::min(palm.right, center.y() - reach);
    const double tilt = std::sqrt(std::max(0.0, 1 - std::pow(marker.normal.dot(normal), 2)));
    palm.top = std::min(palm.top, center.z() - tilt * 1.5 * half_side(marker) - 0.008);
  }
  auto widen = [](double& upper, double& lower, double least) {
    const double missing = std::max(0.0, least - (upper - lower)) / 2;
    upper += missing;
    lower -= missing;
  };
  widen(palm.front, palm.rear, 0.095);
  widen(palm.left, palm.right, 0.085);
  return palm;
}

void add_palm(const Palm& p, std::vector<Solid>& hand) {
  const double radius = p.thickness / 2, middle = p.top - radius;
  const double x = (p.front + p.rear) / 2, y = (p.left + p.right) / 2;
  hand.push_back(box(p.axes, p.at(x, y, middle), {(p.front - p.rear) / 2, (p.left - p.right) / 2, radius}, 118));
  hand.push_back(capsule(p.at(p.rear, p.left, middle), p.at(p.front, p.left, middle), radius, 112));
  hand.push_back(capsule(p.at(p.rear, p.right, middle), p.at(p.front, p.right, middle), radius, 112));
  hand.push_back(capsule(p.at(p.front, p.right, middle), p.at(p.front, p.left, middle), radius, 106));
  hand.push_back(capsule(p.at(p.rear, p.right, middle), p.at(p.rear, p.left, middle), radius, 112));
}

/// Four fingers of three curled segments, and a thumb.
void add_fingers(const Palm& p, std::vector<Solid>& hand) {
  const double width = p.left - p.right, radius = std::min(0.014, 0.13 * width), middle = p.top - p.thickness / 2;
  const double curl[] = {0.12, 0.45, 0.95}, length[] = {0.042, 0.03, 0.024};
  for (int finger = 0; finger < 4; ++finger) {
    const double y = p.right + width * (finger + 0.5) / 4;
    const double size = finger == 0 ? 0.85 : finger == 2 ? 1.08 : 1.0;
    Vector3 knuckle(p.front + 0.006, y, middle);
    for (int segment = 0; segment < 3; ++segment) {
      const Vector3 step(std::cos(curl[segment]), 0.03 * (finger - 1.5), -std::sin(curl[segment]));
      const Vector3 next = knuckle + length[segment] * size * step;
      hand.push_back(capsule(p.axes * knuckle, p.axes * next, radius * (1 - 0.1 * segment), segment == 1 ? 96 : 122));
      knuckle = next;
    }
  }
  const double x = p.rear + 0.35 * (p.front - p.rear);
  const Vector3 base(x, p.left + 0.008, middle - 0.005), joint = base + Vector3(0.028, 0.026, -0.008);
  hand.push_back(capsule(p.axes * base, p.axes * joint, radius * 1.15, 116));
  hand.push_back(capsule(p.axes * joint, p.axes * (joint + Vector3(0.032, 0.006, -0.008)), radius, 100));
}

Plate print(const Palm& p, const Vector3& place, SurfacePattern pattern, int columns, int rows, double cell) {
  Plate plate;
  plate.frame_from_plate = {p.axes, p.axes * place};
  plate.half_size = Vector2(columns + 0.6, rows + 0.6) * cell / 2;
  plate.pattern = pattern;
  plate.columns = columns;
  plate.rows = rows;
  plate.cell = cell;
  plate.dark = 62;
  plate.light = 168;
  return plate;
}

void add_forearm(const Palm& p, Hand& hand) {
  const double y = (p.left + p.right) / 2, middle = p.top - p.thickness / 2;
  const double wrist = p.rear - 0.02;
  hand.solids.push_back(box(p.axes, p.at(wrist - 0.012, y, middle), {0.012, 0.034, 0.017}, 74));
  hand.solids.push_back(box(p.axes, p.at(wrist - 0.036, y, middle), {0.016, 0.04, 0.024}, 150));
  hand.solids.push_back(
      capsule(p.at(wrist - 0.085, y, middle - 0.006), p.at(wrist - 0.42, y, middle - 0.02), 0.042, 178));
  hand.solids.push_back(capsule(p.at(wrist - 0.44, y, middle - 0.01), p.at(wrist - 0.6, y, middle - 0.42), 0.055, 105));
  hand.solids.push_back(box(p.axes, p.at(wrist - 0.15, y, middle + 0.03), {0.035, 0.022, 0.012}, 140));
  hand.plates.push_back(print(p, {wrist - 0.036, y, middle + 0.0245}, SurfacePattern::lines, 1, 4, 0.007));
  hand.plates.push_back(print(p, {wrist - 0.15, y, middle + 0.0425}, SurfacePattern::dots, 6, 3, 0.0095));
}

/// How deep the block under a label must be to reach into the palm.
double pedestal_depth(const MarkerPlate& marker, const Palm& palm) {
  const double lean = marker.normal.dot(palm.axes.col(2));
  const double height = palm.axes.col(2).dot(marker.center) - palm.top;
  return lean < 0.3 ? 0.02 : std::max(0.006, height / lean + 0.004);
}

}  // namespace

Matrix3 axes_from(const Vector3& normal, const Vector3& along) {
  Matrix3 axes;
  axes.col(2) = normal.normalized();
  Vector3 x = along - along.dot(axes.col(2)) * axes.col(2);
  if (x.norm() < 1e-3 * along.norm() || x.norm() < 1e-12) x = axes.col(2).unitOrthogonal();
  axes.col(0) = x.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

Rigid tcp_from_plate(const MarkerPlate& marker) { return {axes_from(marker.normal, marker.up), marker.center}; }

Hand build_hand(const std::vector<MarkerPlate>& markers, const Vector3& fingers) {
  check(!markers.empty(), "a hand needs a marker to be built under");
  const Palm palm = palm_under(markers, fingers);
  Hand hand;
  add_palm(palm, hand.solids);
  add_fingers(palm, hand.solids);
  add_forearm(palm, hand);
  for (const MarkerPlate& marker : markers) {
    hand.pedestals.push_back(pedestal_depth(marker, palm));
    if (marker.normal.dot(palm.axes.col(2)) >= 0.3) continue;
    const Vector3 middle =
        palm.at((palm.front + palm.rear) / 2, (palm.left + palm.right) / 2, palm.top - palm.thickness / 2);
    hand.solids.push_back(capsule(middle, marker.center - 0.012 * marker.normal, 0.01, 90));
  }
  return hand;
}

std::vector<MarkerPlate> marker_plates(const std::vector<Vector3>& centers, const Vector3& normal, double cell,
                                       std::uint64_t seed) {
  Random random(seed);
  // Labels are turned at random: where their circumcircles do not touch, they do not cover each other.
  for (std::size_t i = 0; i < centers.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) cell = std::min(cell, (centers[i] - centers[k]).norm() / 3.8);
  std::vector<MarkerPlate> markers;
  for (const Vector3& center : centers) {
    MarkerPlate marker;
    marker.center = center;
    marker.normal = normal.normalized();
    marker.up = turned_in_plane(marker.normal, random.uniform(0, 2 * M_PI));
    marker.cell = cell;
    marker.margin = cell / 3;
    markers.push_back(marker);
  }
  return markers;
}

std::vector<MarkerPlate> lay_out_markers(int count, double cell, std::uint64_t seed, const Vector3& back,
                                         const Vector3& fingers) {
  check(count >= 1 && count <= 64, "{} markers, but 1 to 64 can be laid out", count);
  Random random(seed);
  const Matrix3 axes = axes_from(back, fingers);
  const double label = 2 * (cell + cell / 3);
  const double nearest = std::max(count <= 6 ? 0.04 : 0.0, 1.45 * label);
  // Cells of a grid in random order, each marker somewhere inside its own: no pair comes nearer than `nearest`.
  const int columns = count <= 3 ? 2 : static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  const int rows = count <= 3 ? 2 : (count + columns - 1) / columns;
  const double slack = 0.008 / std::max(1, columns - 1), pitch = nearest + slack;
  std::vector<int> order(static_cast<std::size_t>(columns) * rows);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[random.integer(static_cast<int>(i) + 1)]);
  std::vector<Vector3> centers;
  for (int i = 0; i < count; ++i) {
    const int column = order[i] % columns, row = order[i] / columns;
    const double x = (row - (rows - 1) / 2.0) * pitch + random.uniform(-slack, slack) / 2;
    const double y = (column - (columns - 1) / 2.0) * pitch + random.uniform(-slack, slack) / 2;
    centers.push_back(axes * Vector3(x + 0.055, y, 0.03 + random.uniform(0, 0.01)));
  }
  std::vector<MarkerPlate> markers = marker_plates(centers, axes.col(2), cell, random.word());
  const double lean = count <= 6 ? 0.2 : 0.1;
  for (MarkerPlate& marker : markers) {
    const double about_y = random.uniform(-lean, lean), about_x = random.uniform(-lean, lean);  // in this order
    const Vector3 tilt(about_x, about_y, 0);
    marker.normal = axes * rotation_from_vector<double>(tilt).col(2);
    marker.up = axes_from(marker.normal, marker.up).col(0);
  }
  return markers;
}

}  // namespace handsight
