// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/board_report.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "camera_calibration/bent_board.h"

namespace handsight {
namespace {

/// The points that some image shows, as described and as estimated, by column.
struct Pairs {
  Eigen::Matrix3Xd described, found;
};

Pairs pairs_of(const BoardImages& images, const std::vector<Vector3>& points) {
  std::vector<bool> is_seen(images.points.size(), false);
  for (const BoardImage& image : images.images)
    for (const TargetPixel& seen : image.points) is_seen[static_cast<std::size_t>(seen.number)] = true;
  const auto count = std::count(is_seen.begin(), is_seen.end(), true);
  Pairs pairs{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_seen[i]) continue;
    pairs.described.col(at) = images.points[i];
    pairs.found.col(at++) = points[i];
  }
  return pairs;
}

/// m: how the points found lie beside others, moved and scaled onto them.
Eigen::VectorXd distances(const Eigen::Matrix3Xd& found, const Eigen::Matrix3Xd& wanted) {
  const Eigen::Matrix4d laid = Eigen::umeyama(found, wanted, true);
  return (((laid.topLeftCorner<3, 3>() * found).colwise() + laid.topRightCorner<3, 1>()) - wanted).colwise().norm();
}

double rms(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(values.size(), 1)));
}

/// The curvatures (1/m) that the heights of points have, by least squares beside a plane.
Vector3 curvatures(const Pairs& pairs) {
  const Vector3 middle = pairs.described.rowwise().mean();
  Eigen::MatrixXd rows(pairs.found.cols(), 6);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Vector2 x = (pairs.described.col(i) - middle).head<2>();
    rows.row(i) << 1, x.x(), x.y(), 0.5 * x.x() * x.x(), 0.5 * x.y() * x.y(), x.x() * x.y();
  }
  const Eigen::VectorXd heights = pairs.found.row(2).transpose();
  return Eigen::VectorXd(rows.colPivHouseholderQr().solve(heights)).tail<3>();
}

Vector2 extents(const Eigen::Matrix3Xd& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).head<2>();
}

Message mm(double metres) {
  return message("{:.{}f} mm", 1e3 * metres, std::abs(metres) < 1e-3 ? 2 : std::abs(metres) < 1e-2 ? 1 : 0);
}

double bow_along(double curvature, double length) { return std::abs(curvature) * length * length / 8; }

/// The way in which it is bent most, in words.
Message bow_text(const Vector3& bend, const Vector2& extent) {
  const double x = bow_along(bend.x(), extent.x()), y = bow_along(bend.y(), extent.y());
  const double most = std::max(x, y);
  const double askew = std::abs(bend.z()) * extent.x() * extent.y() / 4;
  return message("{} over {} along {} (curvatures in 1/m: {:.3f} along x, {:.3f} along y{})", mm(most),
                 mm(x >= y ? extent.x() : extent.y()), x >= y ? 'x' : 'y', bend.x(), bend.y(),
                 askew > 0.3 * most ? message(", {:.3f} askew", bend.z()) : Message());
}

bool is_grid(const Target& target) { return target.kind == TargetKind::aprilgrid; }

/// The target with the gap between tags that fits points found anywhere best.
std::optional<Target> with_other_spacing(const Target& target, const std::vector<Vector3>& points) {
  if (!is_grid(target)) return std::nullopt;
  // Tags apart as their centres are, and as large as their sides: by least squares, each along its own axis.
  const std::vector<PlacedTag> tags = placed_tags(target);
  std::vector<Vector3> centres, nominal;
  double side = 0;
  for (std::size_t tag = 0; tag < tags.size(); ++tag) {
    Vector3 centre = Vector3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      centre += points[4 * tag + i] / 4;
      side += (points[4 * tag + i] - points[4 * tag + (i + 1) % 4]).norm() / (4 * static_cast<double>(tags.size()));
    }
    centres.push_back(centre);
    nominal.emplace_back(tags[tag].top_left.x(), tags[tag].top_left.y(), 0);
  }
  const Vector3 middle = find_middle(centres), expected = find_middle(nominal);
  double found = 0, described = 0;
  for (std::size_t i = 0; i < centres.size(); ++i)
    found += (centres[i] - middle).squaredNorm(), described += (nominal[i] - expected).squaredNorm();
  if (!(described > 0 && side > 0)) return std::nullopt;
  Target other = target;
  other.spacing = (1 + target.spacing) * std::sqrt(found / described) * (target.tag / side) - 1;
  return other.spacing > 0.01 ? std::optional(other) : std::nullopt;
}

std::vector<Vector3> list_places(const Target& target) {
  std::vector<Vector3> places;
  for (const TargetPoint& point : target_points(target)) places.push_back(point.position);
  return places;
}

/// By how much the columns stand farther apart than the rows, as a share of what is described.
double stretch_along_x(const Pairs& pairs) {
  const Eigen::Matrix3Xd d = pairs.described.colwise() - pairs.described.rowwise().mean().eval(),
                         f = pairs.found.colwise() - pairs.found.rowwise().mean().eval();
  const double x = d.row(0).dot(f.row(0)) / d.row(0).squaredNorm(), y = d.row(1).dot(f.row(1)) / d.row(1).squaredNorm();
  return x / y - 1;
}

void say_what_fits(const Target& target, const BoardImages& images, const Pairs& pairs, BoardReport& report) {
  constexpr double much = 0.5, hardly_noticed = 5e-4;
  if (const auto other = with_other_spacing(target, report.points)) {
    BoardImages as_other = images;
    as_other.points = list_places(*other);
    const Pairs to_other = pairs_of(as_other, report.points);
    const double left = rms(distances(to_other.found, to_other.described));
    if (left < much * report.off_rms && std::abs(other->spacing - target.spacing) > 0.01 * target.spacing) {
      report.warnings.push_back(
          message("The tags stand as spacing={:.3g} has them (gaps of {} between tags of {}), not spacing={:g} as "
                  "described; with that the points are {} off.",
                  other->spacing, mm(other->spacing * target.tag), mm(target.tag), target.spacing, mm(left)));
      return;
    }
  }
  if (pairs.found.cols() < 6 || extents(pairs.described).minCoeff() <= 0) return;
  const double stretch = stretch_along_x(pairs);
  if (std::abs(stretch) > hardly_noticed && std::abs(stretch) * extents(pairs.described).minCoeff() > report.off_rms)
    report.warnings.push_back(
        message("Beside its rows its columns stand {:.2f} % {} than described, as printers do it that feed paper "
                "unevenly.",
                100 * std::abs(stretch), stretch > 0 ? "farther apart" : "closer together"));
}

const TriedShape* find(const CameraCalibration& calibration, BoardShape shape) {
  for (const TriedShape& tried : calibration.shapes)
    if (tried.shape == shape) return &tried;
  return nullptr;
}

void say_it_is_flat(const CameraCalibration& calibration, const Pairs& pairs, BoardReport& report) {
  const TriedShape* bent = find(calibration, BoardShape::bent);
  if (!bent || !bent->bend_sigmas) return;
  const Vector2 extent = extents(pairs.described);
  double most = 0;
  for (const int axis : {0, 1})
    most = std::max(most, bow_along(std::abs(bent->bend[axis]) + 2 * (*bent->bend_sigmas)[axis], extent[axis]));
  report.sentences.push_back(
      message("The board is as described as far as these images tell: bent by less than {}.", mm(most)));
}

}  // namespace

BoardReport board_report(const BoardImages& images, const CameraCalibration& calibration, const Target& target) {
  BoardReport report;
  const BundleResult& bundle = calibration.bundle;
  report.shape = bundle.shape;
  const bool is_one = target.kind != TargetKind::tags;
  const Pairs pairs = pairs_of(images, bundle.target_points.empty() ? images.points : bundle.target_points);
  if (report.shape == BoardShape::held) {
    if (is_one && pairs.found.cols() > 3) say_it_is_flat(calibration, pairs, report);
  } else {
    report.points = bundle.target_points;
    const Eigen::VectorXd off = is_one ? distances(pairs.found, pairs.described)
                                       : Eigen::VectorXd((pairs.found - pairs.described).colwise().norm());
    report.off_rms = rms(off), report.off_most = off.maxCoeff();
    if (is_one && pairs.found.cols() >= 9)
      report.bend = report.shape == BoardShape::bent ? bundle.bend : curvatures(pairs);
    const Vector2 extent = extents(pairs.described);
    report.bow = std::max(bow_along(report.bend.x(), extent.x()), bow_along(report.bend.y(), extent.y()));
    const bool is_bow_worth_a_word = report.bow > report.off_rms;
    const bool is_asked_for = target.sigma != std::optional<double>(0);
    if (report.shape == BoardShape::bent || is_bow_worth_a_word)
      report.warnings.push_back(message("The board is not flat: it is bent by {}.", bow_text(report.bend, extent)));
    if (report.shape != BoardShape::bent)
      (is_asked_for ? report.sentences : report.warnings)
          .push_back(message("Its points lie {} from where they are described (rms), one of them {}{}.",
                             mm(report.off_rms), mm(report.off_most),
                             is_asked_for ? "" : ": they were estimated with the cameras"));
    if (report.shape == BoardShape::free && is_one) say_what_fits(target, images, pairs, report);
    if (report.shape == BoardShape::within && report.off_rms > 2 * std::sqrt(3.0) * *target.sigma)
      report.warnings.push_back(message(
          "That is more than sigma={:g} m allows; say sigma=free, or look at what the target is.", *target.sigma));
  }
  report.sentences.push_back(
      report.shape == BoardShape::within
          ? message("How large it is images cannot tell: it is known to the {} of its description alone.",
                    mm(*target.sigma))
          : "How large it is images cannot tell: its size as a whole is taken as described, and so are all lengths.");
  return report;
}

}  // namespace handsight
