// SPDX-License-Identifier: Apache-2.0
// trial_targets COUNT SEED KIND [alone]: boards and tags rendered under tilt, blur, noise, covers and cut by
// the border: how many of the points in view are found, how many have a wrong number, how exact they are; and the same
// for OpenCV's detectors on the same images. KIND: chessboard, charuco, charuco_old, aprilgrid, tags,
// apriltags.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <optional>
#include <string>

#include "fixtures/target_images.h"
#include "targets/target_detection.h"
#ifdef HANDSIGHT_APRILTAG
extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
}
#endif

namespace {

using namespace handsight;
using namespace handsight::fixtures;
using Clock = std::chrono::steady_clock;

struct Scene {
  TargetView view;
  std::vector<Rigid> pieces;
  bool is_hard = false;  // motion or glare: only wrong numbers count
};

double uniform(std::mt19937_64& random, double from, double to) {
  return std::uniform_real_distribution(from, to)(random);
}

Target target_of(const std::string& kind) {
  Target t;
  if (kind == "chessboard") return {.kind = TargetKind::chessboard, .columns = 9, .rows = 6, .square = 0.025};
  if (kind == "charuco")
    t = {.kind = TargetKind::charuco,
         .columns = 8,
         .rows = 6,
         .square = 0.03,
         .tag = 0.022,
         .dictionary = "DICT_5X5_100"};
  if (kind == "charuco_old")
    t = {.kind = TargetKind::charuco,
         .columns = 7,
         .rows = 6,
         .square = 0.03,
         .tag = 0.022,
         .dictionary = "DICT_4X4_50",
         .old_layout = true};
  if (kind == "aprilgrid")
    t = {.kind = TargetKind::aprilgrid,
         .columns = 6,
         .rows = 4,
         .tag = 0.03,
         .spacing = 0.3,
         .dictionary = "tag36h11",
         .border = 2};
  if (kind == "tags") t = {.kind = TargetKind::tags, .tag = 0.05, .dictionary = "DICT_5X5_100", .ids = {3, 7, 9, 40}};
  if (kind == "apriltags") t = {.kind = TargetKind::tags, .tag = 0.05, .dictionary = "tag36h11", .ids = {3, 7, 9, 40}};
  return t;
}

double module_of(const Target& t) {
  if (t.kind == TargetKind::chessboard) return t.square / 3;  // squares of 12 px
  return t.tag / (find_dictionary(t.dictionary)->bits + 2 * t.border);
}

Camera camera() {
  return {.width = 640,
          .height = 480,
          .fx = 620,
          .fy = 622,
          .cx = 322,
          .cy = 236,
          .k1 = -0.18,
          .k2 = 0.06,
          .p1 = 4e-4,
          .p2 = -3e-4};
}

Rigid placed(std::mt19937_64& random, const Vector2& centre_in_target, double module, double least_module,
             const Camera& c, double spread) {
  const double tilt = uniform(random, 0, 60) * M_PI / 180, about = uniform(random, 0, 2 * M_PI),
               roll = uniform(random, -M_PI, M_PI);
  Rigid r;
  r.rotation = rotation_from_vector<double>(Vector3(std::cos(about), std::sin(about), 0) * tilt) *
               rotation_from_vector<double>(Vector3(0, 0, roll));
  // The module is shortened by the tilt: at least about so many px at the centre.
  const double size = least_module * std::exp(uniform(random, 0.0, 1.0));
  const double depth = c.fx * module / size * (0.35 + 0.65 * std::cos(tilt));
  const Vector2 pixel(c.cx + spread * uniform(random, -0.5, 0.5) * c.width,
                      c.cy + spread * uniform(random, -0.5, 0.5) * c.height);
  const Vector3 centre(depth * (pixel.x() - c.cx) / c.fx, depth * (pixel.y() - c.cy) / c.fy, depth);
  r.translation = centre - r.rotation * Vector3(centre_in_target.x(), centre_in_target.y(), 0);
  return r;
}

std::vector<Vector2> blob(std::mt19937_64& random, const Vector2& centre, double radius) {
  std::vector<Vector2> polygon;
  const int count = 3 + static_cast<int>(random() % 3);
  const double first = uniform(random, 0, 6);
  for (int i = 0; i < count; ++i)
    polygon.push_back(centre +
                      radius * Vector2(std::cos(first + 2 * M_PI * i / count), std::sin(first + 2 * M_PI * i / count)));
  return polygon;
}

Scene scene_of(const Target& target, std::mt19937_64& random, double least_module) {
  Scene s;
  TargetView& v = s.view;
  v.camera = camera();
  v.blur = uniform(random, 0.4, 2.0);
  v.noise = uniform(random, 0, 8);
  v.black = uniform(random, 15, 60);
  v.white = uniform(random, 140, 230);
  v.slope_x = uniform(random, -0.3, 0.3), v.slope_y = uniform(random, -0.3, 0.3);
  v.seed = random();
  for (int i = 0; i < 6; ++i) {
    v.clutter.push_back(blob(random, {uniform(random, 0, 640), uniform(random, 0, 480)}, uniform(random, 10, 120)));
    v.clutter_greys.push_back(uniform(random, 10, 240));
  }
  const PrintedPattern pattern = pattern_of(target);
  const Vector2 centre = pattern.outline.top_left + 0.5 * pattern.outline.size;
  const int how = static_cast<int>(random() % 4);  // whole or nearly, partly outside, half covered, hard
  const bool must_be_whole = target.kind == TargetKind::chessboard;
  v.camera_from_target =
      placed(random, centre, module_of(target), least_module, v.camera, how == 1 && !must_be_whole ? 1.0 : 0.3);
  if (target.kind == TargetKind::tags)
    for (std::size_t i = 0; i < target.ids.size(); ++i)
      s.pieces.push_back(placed(random, centre, module_of(target), least_module, v.camera, 0.9));
  if (how == 2 && !must_be_whole) {
    const double angle = uniform(random, 0, 2 * M_PI);
    const Vector2 normal(std::cos(angle), std::sin(angle)), side(-normal.y(), normal.x()),
        at(320 + uniform(random, -60, 60), 240 + uniform(random, -60, 60));
    v.covers.push_back(
        {at - 900 * side, at + 900 * side, at + 900 * side + 900 * normal, at - 900 * side + 900 * normal});
    v.cover_greys.push_back(uniform(random, 20, 220));
  }
  if (how == 3) {
    s.is_hard = true;
    if (random() % 2)
      v.motion = uniform(random, 0.5, 4), v.motion_angle = uniform(random, 0, M_PI);
    else
      v.glare = Vector2(uniform(random, 100, 540), uniform(random, 100, 380)), v.glare_radius = uniform(random, 10, 80);
  }
  return s;
}

/// Inside one of the convex covers, or nearer to it than the margin.
bool is_covered(const TargetView& v, const Vector2& pixel, double margin) {
  for (const auto& polygon : v.covers) {
    const Vector2 p = polygon[1] - polygon[0], q = polygon[2] - polygon[0];
    const double sign = p.x() * q.y() - p.y() * q.x() > 0 ? 1 : -1;
    double inside = 1e300;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2 a = polygon[i], d = (polygon[(i + 1) % polygon.size()] - a).normalized();
      inside = std::min(inside, sign * (d.x() * (pixel - a).y() - d.y() * (pixel - a).x()));
    }
    if (inside > -margin) return true;
  }
  return false;
}

struct Truth {
  std::vector<Vector2> pixels;
  std::vector<bool> in_view;
  int tags_in_view = 0;
};

bool is_seen(const Scene& s, const Rigid& r, const Vector3& x, double margin, Vector2* at = nullptr) {
  const Vector3 p = r * x;
  if (!(p.z() > 0.01) || !is_visible(s.view.camera, p, margin)) return false;
  const Vector2 pixel = project(s.view.camera, p);
  if (at) *at = pixel;
  return !is_covered(s.view, pixel, margin);
}

bool is_hidden_by_later(const Scene& s, const Target& t, std::size_t piece, const Vector2& pixel, double margin) {
  for (std::size_t other = piece + 1; other < s.pieces.size(); ++other) {
    const Rigid& r = s.pieces[other];
    Matrix3 m;
    m << r.rotation.leftCols<2>(), r.translation;
    const auto ray = undistort(s.view.camera, pixel);
    if (!ray) continue;
    const Vector3 x = m.inverse() * ray->homogeneous();
    const double slack = margin * r.translation.z() / s.view.camera.fx * 2;
    if (x.z() > 0 && std::abs(x.x() / x.z()) < 0.63 * t.tag + slack && std::abs(x.y() / x.z()) < 0.63 * t.tag + slack)
      return true;
  }
  return false;
}

Truth truth_of(const PreparedTarget& target, const Scene& s, double least_module) {
  Truth truth;
  const Target& t = target.target;
  const double module = module_of(t);
  for (const TargetPoint& point : target.points) {
    const Rigid& r = s.pieces.empty() ? s.view.camera_from_target : s.pieces[static_cast<std::size_t>(point.piece)];
    Vector2 pixel(-1e9, -1e9);
    bool seen = is_seen(s, r, point.position, 8, &pixel);
    if ((r * point.position).z() > 0.01) pixel = project(s.view.camera, Vector3(r * point.position));
    // The smallest size of a module here.
    Eigen::Matrix2d slope;
    for (int i = 0; i < 2; ++i)
      slope.col(i) = project(s.view.camera, Vector3(r * (point.position + module * Vector3::Unit(i)))) - pixel;
    seen = seen && slope.jacobiSvd().singularValues()(1) >= least_module;
    truth.pixels.push_back(pixel);
    truth.in_view.push_back(seen);
  }
  std::vector<bool> whole;
  for (const PlacedTag& tag : target.tags) {
    const Rigid& r = s.pieces.empty() ? s.view.camera_from_target : s.pieces[static_cast<std::size_t>(tag.piece)];
    bool seen = true;
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 4; ++j) {
        const Vector2 place = tag.top_left + t.tag * Vector2(-0.1 + 0.3 * i, -0.1 + 0.3 * j);
        Vector2 pixel;
        seen = seen && is_seen(s, r, Vector3(place.x(), place.y(), 0), 3, &pixel) &&
               !is_hidden_by_later(s, t, static_cast<std::size_t>(tag.piece), pixel, 3);
      }
    whole.push_back(seen);
    truth.tags_in_view += seen;
  }
  for (std::size_t i = 0; t.kind == TargetKind::tags && i < truth.in_view.size(); i += 4) {
    const bool all =
        whole[i / 4] && truth.in_view[i] && truth.in_view[i + 1] && truth.in_view[i + 2] && truth.in_view[i + 3];
    for (std::size_t k = 0; k < 4; ++k) truth.in_view[i + k] = all;
  }
  return truth;
}

using Points = std::vector<std::pair<int, Vector2>>;

Points ours(const Image& image, const PreparedTarget& target, std::vector<double>* z2, const Truth& truth) {
  Points points;
  for (const TargetPixel& p : detect_target(image, target).points) {
    points.emplace_back(p.number, p.pixel);
    const Vector2 e = p.pixel - truth.pixels[static_cast<std::size_t>(p.number)];
    if (e.norm() < 2) z2->push_back(e.dot(p.covariance.inverse() * e) / 2);
  }
  return points;
}

/// OpenCV's: findChessboardCorners and cornerSubPix; detectMarkers, interpolateCornersCharuco; detectMarkers refined.
Points opencv(const Image& image, const PreparedTarget& target, int refinement) {
  const Target& t = target.target;
  const cv::Mat grey(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data()));
  Points points;
  if (t.kind == TargetKind::chessboard) {
    std::vector<cv::Point2f> corners;
    if (!cv::findChessboardCorners(grey, {t.columns, t.rows}, corners)) return points;
    cv::cornerSubPix(grey, corners, {5, 5}, {-1, -1}, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001});
    for (std::size_t i = 0; i < corners.size(); ++i)
      points.emplace_back(static_cast<int>(i), Vector2(corners[i].x, corners[i].y));
    return points;
  }
  const bool is_apriltag = t.dictionary.starts_with("tag");
  const int index = is_apriltag                     ? cv::aruco::DICT_APRILTAG_36h11
                    : t.dictionary == "DICT_4X4_50" ? cv::aruco::DICT_4X4_50
                                                    : cv::aruco::DICT_5X5_100;
  const auto dictionary = cv::aruco::getPredefinedDictionary(index);
  auto parameters = cv::aruco::DetectorParameters::create();
  parameters->markerBorderBits = t.border;
  if (t.kind != TargetKind::charuco) parameters->cornerRefinementMethod = refinement;
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners;
  cv::aruco::detectMarkers(grey, dictionary, corners, ids, parameters);
  if (t.kind == TargetKind::charuco) {
    if (ids.empty() || t.old_layout) return points;
    const auto board = cv::aruco::CharucoBoard::create(t.columns, t.rows, static_cast<float>(t.square),
                                                       static_cast<float>(t.tag), dictionary);
    std::vector<cv::Point2f> found;
    std::vector<int> numbers;
    cv::aruco::interpolateCornersCharuco(corners, ids, grey, board, found, numbers);
    for (std::size_t i = 0; i < found.size(); ++i) points.emplace_back(numbers[i], Vector2(found[i].x, found[i].y));
    return points;
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t tag = 0; tag < target.tags.size(); ++tag)
      if (target.tags[tag].id == ids[i])
        for (std::size_t k = 0; k < 4; ++k) {
          const cv::Point2f p = corners[i][is_apriltag ? (k + 2) % 4 : k];
          points.emplace_back(static_cast<int>(4 * tag + k), Vector2(p.x, p.y));
        }
  return points;
}

#ifdef HANDSIGHT_APRILTAG
Points apriltag(const Image& image, const PreparedTarget& target) {
  static apriltag_detector_t* detector = nullptr;
  if (!detector) {
    auto* family = tag36h11_create();
    const int more = target.target.border - 1;
    family->width_at_border += 2 * more, family->total_width += 2 * more;
    for (std::uint32_t i = 0; i < family->nbits; ++i) family->bit_x[i] += more, family->bit_y[i] += more;
    detector = apriltag_detector_create();
    detector->quad_decimate = 1;
    apriltag_detector_add_family(detector, family);
  }
  image_u8_t raw{image.width, image.height, image.width, const_cast<std::uint8_t*>(image.pixels.data())};
  zarray_t* found = apriltag_detector_detect(detector, &raw);
  Points points;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* d;
    zarray_get(found, i, &d);
    for (std::size_t tag = 0; tag < target.tags.size(); ++tag)
      if (target.tags[tag].id == d->id)  // counter-clockwise from the lower left; pixel corners are integers
        for (int k = 0; k < 4; ++k)
          points.emplace_back(static_cast<int>(4 * tag) + (3 - k), Vector2(d->p[k][0] - 0.5, d->p[k][1] - 0.5));
  }
  apriltag_detections_destroy(found);
  return points;
}
#endif

/// One detector's results over all images.
struct Score {
  std::string name;
  std::function<Points(const Image&)> detect;
  long in_view = 0, found = 0, wrong = 0, wrong_images = 0, far = 0, nothing = 0, images = 0, common = 0;
  double seconds = 0;
  Vector2 sum = Vector2::Zero(), our_sum = Vector2::Zero();  // of errors of points that both have found
  double squares = 0, our_squares = 0;
  std::vector<std::optional<Vector2>> errors{};  // of the current image
};

/// Nearer to another point of the target than to its own, or where no point is at all. (Blurred by motion a point may
/// be some px off and still itself.)
bool is_anothers(const Vector2& pixel, std::size_t own, const Truth& truth) {
  const double error = (pixel - truth.pixels[own]).norm();
  const auto is_nearer = [&](const Vector2& other) { return (pixel - other).norm() < 0.5 * error; };
  return error > 8 || (error > 2.5 && std::any_of(truth.pixels.begin(), truth.pixels.end(), is_nearer));
}

void add(Score& score, const Points& points, const Truth& truth, bool counts) {
  score.errors.assign(truth.pixels.size(), std::nullopt);
  const long wrong_before = score.wrong;
  for (const auto& [number, pixel] : points) {
    const auto n = static_cast<std::size_t>(number);
    const Vector2 error = pixel - truth.pixels[n];
    if (is_anothers(pixel, n, truth))
      ++score.wrong;
    else if (error.norm() > 2.5)
      ++score.far;
    else if (truth.in_view[n] && counts)
      score.errors[n] = error;
  }
  score.wrong_images += score.wrong > wrong_before;
  if (!counts) return;
  const auto view = std::count(truth.in_view.begin(), truth.in_view.end(), true);
  const auto got = std::count_if(score.errors.begin(), score.errors.end(), [](const auto& e) { return e.has_value(); });
  ++score.images;
  score.in_view += view, score.found += got;
  score.nothing += view > 0 && got == 0;
}

void add_common(Score& score, const Score& ours) {
  for (std::size_t n = 0; n < score.errors.size(); ++n) {
    if (!score.errors[n] || !ours.errors[n]) continue;
    ++score.common;
    score.sum += *score.errors[n], score.our_sum += *ours.errors[n];
    score.squares += score.errors[n]->squaredNorm(), score.our_squares += ours.errors[n]->squaredNorm();
  }
}

/// OpenCV may begin a chessboard at the other end: it does not look at the colours. Counted as it fits better.
void turn_to_truth(Points& points, const Truth& truth) {
  if (points.size() != truth.pixels.size()) return;
  double forth = 0, back = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    forth += (points[n].second - truth.pixels[n]).norm();
    back += (points[points.size() - 1 - n].second - truth.pixels[n]).norm();
  }
  if (back < forth)
    for (auto& [number, pixel] : points) number = static_cast<int>(points.size()) - 1 - number;
}

bool counts_for_recall(const Target& target, const Scene& scene, const Truth& truth) {
  if (scene.is_hard) return false;
  if (target.kind == TargetKind::chessboard)
    return std::find(truth.in_view.begin(), truth.in_view.end(), false) == truth.in_view.end();
  return target.kind == TargetKind::tags || truth.tags_in_view >= 2;
}

std::vector<Score> scores_of(const PreparedTarget& target, bool alone) {
  std::vector<Score> scores(1);
  scores[0].name = "ours";
  const auto add_theirs = [&](const char* name, std::function<Points(const Image&)> detect) {
    scores.emplace_back();
    scores.back().name = name;
    scores.back().detect = std::move(detect);
  };
  if (alone) return scores;
  const auto with = [&](int refinement) {
    return [&target, refinement](const Image& i) { return opencv(i, target, refinement); };
  };
  const bool has_tags = target.target.kind == TargetKind::tags || target.target.kind == TargetKind::aprilgrid;
  add_theirs(has_tags ? "ArUco, subpix" : "OpenCV", with(cv::aruco::CORNER_REFINE_SUBPIX));
  if (has_tags) add_theirs("ArUco, contour", with(cv::aruco::CORNER_REFINE_CONTOUR));
  if (has_tags) add_theirs("ArUco, apriltag", with(cv::aruco::CORNER_REFINE_APRILTAG));
#ifdef HANDSIGHT_APRILTAG
  if (target.target.dictionary == "tag36h11")
    add_theirs("libapriltag", [&target](const Image& image) { return apriltag(image, target); });
#endif
  return scores;
}

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// px: root of the mean squared length, a constant part (another idea of where pixels are) left out.
double centred(double squares, const Vector2& sum, long count) {
  return std::sqrt(std::max(squares / count - (sum / count).squaredNorm(), 0.0));
}

void print(const std::vector<Score>& scores, int count) {
  fmt::print("{:<16} {:>8} {:>8} {:>8} {:>8} {:>12} {:>8} {:>8} {:>9} {:>15} {:>12} {:>7}\n", "", "in view", "found",
             "recall", "nothing", "wrong/images", "> 2.5 px", "rms px", "centred", "mean error px", "ours/theirs",
             "ms");
  for (const Score& s : scores) {
    const long common = std::max(s.common, 1L);
    fmt::print(
        "{:<16} {:>8} {:>8} {:>7.2f}% {:>8} {:>7}/{:<4} {:>8} {:>8.4f} {:>9.4f} {:>7.3f} {:>7.3f} {:>12.3f} {:>7.1f}\n",
        s.name, s.in_view, s.found, 100.0 * s.found / std::max(s.in_view, 1L), s.nothing, s.wrong, s.wrong_images,
        s.far, std::sqrt(s.squares / common), centred(s.squares, s.sum, common), s.sum.x() / common, s.sum.y() / common,
        centred(s.our_squares, s.our_sum, common) / std::max(centred(s.squares, s.sum, common), 1e-12),
        1e3 * s.seconds / count);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  const std::string kind = argc > 3 ? argv[3] : "charuco";
  const bool alone = argc > 4 && std::string(argv[4]) == "alone";
  constexpr double least_module = 4;  // px
  const PreparedTarget target = prepare(target_of(kind));
  const auto rays = fine_rays(camera());
  std::vector<Score> scores = scores_of(target, alone);
  std::vector<double> z2;
  for (int i = 0; i < count; ++i) {
    std::mt19937_64 random(seed * 1000003 + static_cast<std::uint64_t>(i));
    const Scene scene = scene_of(target.target, random, least_module);
    const Image image = image_of(target.target, scene.view, rays, scene.pieces);
    const Truth truth = truth_of(target, scene, least_module);
    scores[0].detect = [&](const Image& seen) { return ours(seen, target, &z2, truth); };
    for (Score& score : scores) {
      const auto start = Clock::now();
      Points points = score.detect(image);
      score.seconds += seconds_since(start);
      if (target.target.kind == TargetKind::chessboard && &score != &scores[0]) turn_to_truth(points, truth);
      add(score, points, truth, counts_for_recall(target.target, scene, truth));
      add_common(score, scores[0]);
    }
  }
  fmt::print("{}: {} images, {} count for recall\n", kind, count, scores[0].images);
  print(scores, count);
  std::sort(z2.begin(), z2.end());
  const double mean =
      std::accumulate(z2.begin(), z2.end(), 0.0) / static_cast<double>(std::max<std::size_t>(z2.size(), 1));
  if (!z2.empty())
    fmt::print("squared error over covariance: mean {:.2f}, median {:.2f} (1 and 0.69 are right)\n", mean,
               z2[z2.size() / 2]);
}
