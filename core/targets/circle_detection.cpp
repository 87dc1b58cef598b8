// SPDX-License-Identifier: Apache-2.0
#include "targets/circle_detection.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

#include "base/error.h"
#include "print/circle_grid.h"
#include "targets/board_corners.h"
#include "targets/circle_fit.h"
#include "targets/homography.h"
#include "vision/corners/corner_noise.h"

namespace handsight {
namespace {

cv::Ptr<cv::SimpleBlobDetector> blob_detector(const cv::Size& size) {
  cv::SimpleBlobDetector::Params blobs;
  blobs.minArea = 20;
  blobs.maxArea = 0.05F * static_cast<float>(size.area());
  blobs.minDistBetweenBlobs = 4;
  blobs.minConvexity = 0.9F;
  blobs.minThreshold = 20, blobs.maxThreshold = 235;
  return cv::SimpleBlobDetector::create(blobs);
}

/// Parts of the image in which discs of one size stand as near to each other as in the grid, the fullest first.
std::vector<cv::Rect> parts_with_discs(const cv::Mat& grey, const std::vector<cv::KeyPoint>& discs,
                                       const Target& target) {
  const double step = (is_asymmetric(target) ? std::sqrt(2.0) : 1.0) * target.square;
  const auto is_near = [&](const cv::KeyPoint& a, const cv::KeyPoint& b) {
    const double larger = std::max(a.size, b.size), smaller = std::min(a.size, b.size);
    return larger < 1.6 * smaller && cv::norm(a.pt - b.pt) < 1.7 * larger * step / target.tag;
  };
  std::vector<std::pair<std::size_t, cv::Rect>> parts;
  std::vector<bool> is_taken(discs.size(), false);
  for (std::size_t first = 0; first < discs.size(); ++first) {
    std::vector<std::size_t> group;
    if (!is_taken[first]) group.push_back(first), is_taken[first] = true;
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t other = 0; other < discs.size(); ++other)
        if (!is_taken[other] && is_near(discs[group[i]], discs[other])) group.push_back(other), is_taken[other] = true;
    if (group.size() < static_cast<std::size_t>(point_count(target))) continue;
    cv::Rect2f box(discs[first].pt, cv::Size2f(1, 1));
    for (const std::size_t i : group)
      box |=
          cv::Rect2f(discs[i].pt - cv::Point2f(1, 1) * discs[i].size, cv::Size2f(2 * discs[i].size, 2 * discs[i].size));
    parts.emplace_back(group.size(), cv::Rect(box) & cv::Rect({0, 0}, grey.size()));
  }
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<cv::Rect> boxes;
  for (const auto& [count, box] : parts) boxes.push_back(box);
  return boxes;
}

std::vector<Vector2> found_by_opencv(const Image& image, const Target& target) {
  const cv::Mat grey(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data()));
  const auto blobs = blob_detector(grey.size());
  std::vector<cv::KeyPoint> discs;
  blobs->detect(grey, discs);
  std::vector<cv::Rect> parts = parts_with_discs(grey, discs, target);
  parts.emplace_back(cv::Point(0, 0), grey.size());
  const int layout = is_asymmetric(target) ? cv::CALIB_CB_ASYMMETRIC_GRID : cv::CALIB_CB_SYMMETRIC_GRID;
  for (const cv::Rect& part : parts)
    for (const int how : {0, static_cast<int>(cv::CALIB_CB_CLUSTERING)}) {
      std::vector<cv::Point2f> centres;
      if (!cv::findCirclesGrid(grey(part), {target.columns, target.rows}, centres, layout | how, blobs)) continue;
      std::vector<Vector2> points;
      for (const cv::Point2f& c : centres)
        points.emplace_back(c.x + static_cast<float>(part.x), c.y + static_cast<float>(part.y));
      return points;
    }
  return {};
}

/// Which point of the grid comes to lie where each was: turned and mirrored in all eight ways in which it fits itself.
std::vector<std::vector<std::size_t>> symmetries(const std::vector<TargetPoint>& points) {
  Vector2 middle = Vector2::Zero();
  for (const TargetPoint& p : points) middle += p.position.head<2>();
  middle /= static_cast<double>(points.size());
  std::vector<std::vector<std::size_t>> all;
  for (int way = 0; way < 8; ++way) {
    std::vector<std::size_t> moved;
    for (const TargetPoint& p : points) {
      Vector2 at = p.position.head<2>() - middle;
      if (way & 4) std::swap(at.x(), at.y());
      at += middle;
      if (way & 1) at.x() = 2 * middle.x() - at.x();
      if (way & 2) at.y() = 2 * middle.y() - at.y();
      const auto same = std::find_if(points.begin(), points.end(), [&](const TargetPoint& other) {
        return (other.position.head<2>() - at).norm() < 1e-6;
      });
      if (same == points.end()) break;
      moved.push_back(static_cast<std::size_t>(same - points.begin()));
    }
    if (moved.size() == points.size()) all.push_back(moved);
  }
  return all;
}

/// The grid's points by number, numbered as a sheet is that one looks at from its front: of those that fit, the one
/// whose rows run most to the right.
std::vector<Vector2> numbered(const std::vector<Vector2>& centres, const PreparedTarget& target) {
  std::vector<Vector2> best;
  double most_right = -1e300;
  const auto columns = static_cast<std::size_t>(target.target.columns);
  for (const auto& moved : symmetries(target.points)) {
    std::vector<Vector2> points(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i) points[moved[i]] = centres[i];
    const Vector2 right = points[columns - 1] - points[0];
    const std::size_t rows =
        static_cast<std::size_t>(target.target.rows - 1) / 2 * 2;  // to a row that begins as the first
    const Vector2 down = points[std::max<std::size_t>(rows, 1) * columns] - points[0];
    if (right.x() * down.y() - right.y() * down.x() <= 0) continue;  // seen from behind
    if (right.normalized().x() > most_right) best = points, most_right = right.normalized().x();
  }
  return best;
}

/// How far the centre of the circle's ellipse is from where the circle's middle is seen, by a map of the plane.
std::optional<Vector2> centre_off_middle(const PlaneMap& map, const Vector2& middle, double radius) {
  constexpr int sides = 48;
  const auto at = mapped(map, middle);
  if (!at) return std::nullopt;
  std::vector<Tangent> tangents;
  double size = 0;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    const Vector2 out(std::cos(angle), std::sin(angle)), along(-out.y(), out.x());
    const Vector2 place = middle + radius * out;
    const auto here = mapped(map, place);
    const auto slope = mapped_slope(map, place, 1e-3 * radius);
    if (!here || !slope) return std::nullopt;
    const Vector2 edge = (*slope * along).normalized();
    tangents.push_back({*here, Vector2(-edge.y(), edge.x()), 1});
    size += (*here - *at).norm() / sides;
  }
  const auto ellipse = fit_ellipse(tangents, *at, size);
  return ellipse ? std::optional<Vector2>(ellipse->centre - *at) : std::nullopt;
}

/// Fitted ellipses, by number; nothing where one is none.
std::vector<FittedEllipse> fitted(const Image& image, const PreparedTarget& target, const PlaneMap& map) {
  std::vector<FittedEllipse> ellipses;
  const double noise = image_noise(image);
  for (const TargetPoint& point : target.points) {
    const auto at = mapped(map, point.position.head<2>());
    const auto slope = mapped_slope(map, point.position.head<2>(), 0.25 * target.target.tag);
    if (!at || !slope) return {};
    const Eigen::Matrix2d shape = std::pow(0.5 * target.target.tag, 2) * (*slope * slope->transpose());
    const auto ellipse = ellipse_in(image, *at, shape, noise);
    if (!ellipse) return {};
    ellipses.push_back(*ellipse);
  }
  return ellipses;
}

std::optional<PlaneMap> make_column_map(const PreparedTarget& target, const std::vector<Vector2>& pixels,
                                        const Image& image) {
  std::vector<PlacePixel> pairs;
  for (std::size_t i = 0; i < pixels.size(); ++i) pairs.push_back({target.points[i].position.head<2>(), pixels[i]});
  return fit_plane_map(pairs, image.width, image.height);
}

/// The middles of circles by what their ellipses are.
std::vector<TargetPixel> middles(const Image& image, const PreparedTarget& target,
                                 const std::vector<FittedEllipse>& ellipses) {
  constexpr double share = 0.03;  // of the correction: how far the map of the plane may be wrong about it
  std::vector<Vector2> pixels, off(ellipses.size(), Vector2::Zero());
  for (int round = 0; round < 2; ++round) {
    pixels.clear();
    for (std::size_t i = 0; i < ellipses.size(); ++i) pixels.emplace_back(ellipses[i].centre - off[i]);
    const auto map = make_column_map(target, pixels, image);
    for (std::size_t i = 0; map && i < ellipses.size(); ++i)
      off[i] = centre_off_middle(*map, target.points[i].position.head<2>(), 0.5 * target.target.tag).value_or(off[i]);
  }
  std::vector<TargetPixel> points;
  for (std::size_t i = 0; i < ellipses.size(); ++i)
    points.push_back({static_cast<int>(i), ellipses[i].centre - off[i],
                      ellipses[i].covariance + share * share * off[i].squaredNorm() * Eigen::Matrix2d::Identity()});
  return points;
}

}  // namespace

TargetSighting detect_circles(const Image& image, const PreparedTarget& target) {
  const Target& t = target.target;
  TargetSighting sighting;
  sighting.reason = message("its {} x {} circles do not show as a whole grid", t.columns, t.rows);
  const std::vector<Vector2> centres = found_by_opencv(image, t);
  if (centres.empty()) return sighting;
  const std::vector<Vector2> pixels = numbered(centres, target);
  const auto map = pixels.empty() ? std::nullopt : make_column_map(target, pixels, image);
  const auto ellipses = map ? fitted(image, target, *map) : std::vector<FittedEllipse>{};
  if (ellipses.empty()) return sighting;
  sighting.points = middles(image, target, ellipses);
  drop_far_points(sighting, target.points, image.width, image.height);
  if (sighting.points.size() < target.points.size())
    sighting.points.clear();
  else
    sighting.reason = {};
  return sighting;
}

}  // namespace handsight
