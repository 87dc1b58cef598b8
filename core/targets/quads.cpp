// SPDX-License-Identifier: Apache-2.0
#include "targets/quads.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace handsight {
namespace {

using Contour = std::vector<cv::Point>;

double side_length(const Contour& corners, std::size_t i) {
  const cv::Point d = corners[(i + 1) % 4] - corners[i];
  return std::hypot(d.x, d.y);
}

/// Four corners, convex, no side much shorter than the others.
bool is_quad(const Contour& corners, double least_side) {
  if (corners.size() != 4 || !cv::isContourConvex(corners)) return false;
  double shortest = 1e300, longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    shortest = std::min(shortest, side_length(corners, i));
    longest = std::max(longest, side_length(corners, i));
  }
  return shortest >= least_side && shortest > 0.15 * longest;
}

struct Line {
  Vector2 point = Vector2::Zero(), direction = Vector2::UnitX();
};

/// The straight line through the contour's points from `begin` to `end` (indices that go round), its ends left out.
Line line_along(const Contour& contour, std::size_t begin, std::size_t end) {
  const std::size_t count = (end + contour.size() - begin) % contour.size();
  const std::size_t skip = count / 8 + 1;
  Vector2 mean = Vector2::Zero();
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
  double taken = 0;
  for (std::size_t i = skip; i + skip <= count; ++i, ++taken) {
    const cv::Point& p = contour[(begin + i) % contour.size()];
    const Vector2 x(p.x, p.y);
    mean += x;
    moments += x * x.transpose();
  }
  mean /= taken;
  moments = moments / taken - mean * mean.transpose();
  const double angle = 0.5 * std::atan2(2 * moments(0, 1), moments(0, 0) - moments(1, 1));
  return {mean, Vector2(std::cos(angle), std::sin(angle))};
}

Vector2 crossing(const Line& a, const Line& b) {
  const double sine = a.direction.x() * b.direction.y() - a.direction.y() * b.direction.x();
  const Vector2 between = b.point - a.point;
  return a.point + a.direction * ((between.x() * b.direction.y() - between.y() * b.direction.x()) / sine);
}

std::array<std::size_t, 4> list_places(const Contour& corners, const Contour& contour) {
  std::array<std::size_t, 4> places{};
  for (std::size_t i = 0; i < 4; ++i)
    places[i] = static_cast<std::size_t>(std::find(contour.begin(), contour.end(), corners[i]) - contour.begin());
  return places;
}

/// Lines through the dark pixels at the rim, moved outward by half a pixel: that is where the rim is.
Quad with_lines(const Contour& corners, const Contour& contour) {
  Quad quad;
  for (std::size_t i = 0; i < 4; ++i) quad[i] = {corners[i].x, corners[i].y};
  const auto places = list_places(corners, contour);
  const Vector2 centre = (quad[0] + quad[1] + quad[2] + quad[3]) / 4;
  std::array<Line, 4> lines;
  for (std::size_t i = 0; i < 4; ++i) {
    lines[i] = line_along(contour, places[i], places[(i + 1) % 4]);
    const Vector2 normal(-lines[i].direction.y(), lines[i].direction.x());
    lines[i].point += 0.5 * (normal.dot(lines[i].point - centre) > 0 ? 1 : -1) * normal;
  }
  Quad fitted;
  for (std::size_t i = 0; i < 4; ++i) fitted[i] = crossing(lines[(i + 3) % 4], lines[i]);
  for (std::size_t i = 0; i < 4; ++i)
    if (!((fitted[i] - quad[i]).norm() < 3)) return quad;  // no straight sides, or none that cross
  return fitted;
}

Quad clockwise(Quad quad) {
  const Vector2 a = quad[1] - quad[0], b = quad[2] - quad[0];
  if (a.x() * b.y() - a.y() * b.x() < 0) std::swap(quad[1], quad[3]);
  return quad;
}

void add_quads(std::vector<Quad>& quads, const cv::Mat& dark, double least_side) {
  std::vector<Contour> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(dark, contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const auto perimeter = static_cast<double>(contours[i].size());
    if (hierarchy[i][3] >= 0 || perimeter < 3.5 * least_side) continue;  // a hole: bright inside
    Contour corners;
    cv::approxPolyDP(contours[i], corners, 0.035 * perimeter, true);
    if (is_quad(corners, least_side)) quads.push_back(clockwise(with_lines(corners, contours[i])));
  }
}

}  // namespace

std::vector<Quad> find_quads(const Image& image, double least_side) {
  std::vector<Quad> quads;
  if (image.width < 8 || image.height < 8) return quads;
  const cv::Mat grey(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data()));
  cv::Mat mean, dark;
  const int longest = std::max(image.width, image.height);
  for (const int window : {9, 19, 39, 79}) {
    if (window > longest) break;
    cv::boxFilter(grey, mean, CV_8U, {window, window}, {-1, -1}, true, cv::BORDER_REPLICATE);
    for (const int below : {4, 16}) {
      cv::Mat level = mean - below;  // saturates at black
      cv::compare(grey, level, dark, cv::CMP_LT);
      add_quads(quads, dark, least_side);
    }
  }
  // In an image without any blur squares that touch at a corner hang together; blurred, the corner is as bright as
  // dark.
  cv::Mat blurred;
  cv::GaussianBlur(grey, blurred, {0, 0}, 1.5);
  for (const int window : {39, 79, 159}) {
    if (window > longest) break;
    cv::boxFilter(grey, mean, CV_8U, {window, window}, {-1, -1}, true, cv::BORDER_REPLICATE);
    cv::Mat level = mean - 16;
    cv::compare(blurred, level, dark, cv::CMP_LT);
    add_quads(quads, dark, least_side);
  }
  return quads;
}

std::vector<Quad> find_quads_in_small(const Image& image, int factor, double least_side) {
  Image small(image.width / factor, image.height / factor);
  const cv::Mat grey(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data()));
  cv::Mat into(small.height, small.width, CV_8U, small.pixels.data());
  cv::resize(grey({0, 0, small.width * factor, small.height * factor}), into, into.size(), 0, 0, cv::INTER_AREA);
  std::vector<Quad> quads = find_quads(small, least_side);
  for (Quad& quad : quads)
    for (Vector2& corner : quad) corner = factor * (corner + Vector2::Constant(0.5)) - Vector2::Constant(0.5);
  return quads;
}

}  // namespace handsight
