// SPDX-License-Identifier: Apache-2.0
// trial_targets COUNT SEED KIND [alone]: boards and tags rendered under tilt, blur, noise, covers and cut by
// the border: how many of the points in view are found, how many have a wrong number, how exact they are; and the same
// for OpenCV's detectors on the same images. KIND: chessboard, charuco, charuco_old, aprilgrid, tags, apriltags or all.
// [--markdown]
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>

#include "fixtures/target_images.h"
#include "targets/target_detection.h"
#include "trials/other_detectors.h"
#include "trials/table.h"
#include "trials/target_scenes.h"

namespace {

using namespace handsight;
using namespace handsight::fixtures;
using handsight::trials::Table;
using handsight::trials::TableCell;
using handsight::trials::TableColumn;
using handsight::trials::TableOutput;
using Clock = std::chrono::steady_clock;

Points ours(const Image& image, const PreparedTarget& target, std::vector<double>* z2, const Truth& truth) {
  Points points;
  for (const TargetPixel& p : detect_target(image, target).points) {
    points.emplace_back(p.number, p.pixel);
    const Vector2 e = p.pixel - truth.pixels[static_cast<std::size_t>(p.number)];
    if (e.norm() < 2) z2->push_back(e.dot(p.covariance.inverse() * e) / 2);
  }
  return points;
}

/// One detector's results over all images.
struct Recall {
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

void add(Recall& score, const Points& points, const Truth& truth, bool counts) {
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

void add_common(Recall& score, const Recall& ours) {
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

std::vector<Recall> scores_of(const PreparedTarget& target, bool alone) {
  std::vector<Recall> scores(1);
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

struct Kind {
  const char* name;
  const char* title;
};
constexpr Kind kinds[] = {{"chessboard", "chessboard"},           {"charuco", "ChArUco, new layout"},
                          {"charuco_old", "ChArUco, old layout"}, {"aprilgrid", "Kalibr's grid"},
                          {"tags", "single tags, DICT_5X5_100"},  {"apriltags", "single tags, tag36h11"}};

/// The columns of ours alone, and beside others.
Table table_of(bool alone, const TableOutput& output) {
  std::vector<TableColumn> columns{{.heading = "kind", .width = 26}};
  if (!alone) columns.push_back({.heading = "detector", .width = 16});
  columns.insert(columns.end(), {{"in view"}, {"found", 2, "%"}, {"wrong numbers"}});
  if (alone) columns.push_back({"2.5 px off and more, moved and glared images too"});
  columns.push_back({"rms px", 3});
  if (alone) columns.push_back({"squared error / covariance", 2});
  if (!alone) columns.insert(columns.end(), {{"centred", 3}, {"ratio", 3}});
  columns.push_back({.heading = "ms"});
  return {columns, output};
}

/// ms: two figures.
std::string ms_text(double ms) { return fmt::format("{:.{}f}", ms, ms < 10 ? 1 : 0); }

void print(Table& table, const Kind& kind, const std::vector<Recall>& scores, int count, std::vector<double> z2) {
  const bool alone = scores.size() == 1;
  const double mean_z2 =
      std::accumulate(z2.begin(), z2.end(), 0.0) / static_cast<double>(std::max<std::size_t>(z2.size(), 1));
  for (const Recall& s : scores) {
    const long common = std::max(s.common, 1L);
    const double found = 100.0 * static_cast<double>(s.found) / static_cast<double>(std::max(s.in_view, 1L));
    const double rms = std::sqrt(s.squares / static_cast<double>(common)), own = centred(s.squares, s.sum, common);
    const TableCell ratio =
        &s != &scores[0] && s.common > 0 ? TableCell(centred(s.our_squares, s.our_sum, common) / own) : TableCell();
    const std::string ms = ms_text(1e3 * s.seconds / count);
    if (alone)
      table.print({kind.title, s.in_view, found, s.wrong, s.far, rms, mean_z2, ms});
    else
      table.print({kind.title, s.name, s.in_view, found, s.wrong, rms, own, ratio, ms});
    fmt::print(
        "  {}: nothing in {} of {} images, wrong in {}, {} points 2.5 px off and more, mean error {:.3f} {:.3f} px\n",
        s.name, s.nothing, s.images, s.wrong_images, s.far, s.sum.x() / static_cast<double>(common),
        s.sum.y() / static_cast<double>(common));
  }
  if (z2.empty()) return;
  std::sort(z2.begin(), z2.end());
  fmt::print("  squared error over covariance: mean {:.2f}, median {:.2f} (1 and 0.69 are right)\n", mean_z2,
             z2[z2.size() / 2]);
}

void run(Table& table, const Kind& kind, int count, std::uint64_t seed, bool alone) {
  constexpr double least_module = 4;  // px
  const PreparedTarget target = prepare(target_of(kind.name));
  const auto rays = fine_rays(camera());
  std::vector<Recall> scores = scores_of(target, alone);
  std::vector<double> z2;
  for (int i = 0; i < count; ++i) {
    std::mt19937_64 random(seed * 1000003 + static_cast<std::uint64_t>(i));
    const Scene scene = scene_of(target.target, random, least_module);
    const Image image = make_image(target.target, scene.view, rays, scene.pieces);
    const Truth truth = load_truth(target, scene, least_module);
    scores[0].detect = [&](const Image& seen) { return ours(seen, target, &z2, truth); };
    for (Recall& score : scores) {
      const auto start = Clock::now();
      Points points = score.detect(image);
      score.seconds += seconds_since(start);
      if (target.target.kind == TargetKind::chessboard && &score != &scores[0]) turn_to_truth(points, truth);
      add(score, points, truth, counts_for_recall(target.target, scene, truth));
      add_common(score, scores[0]);
    }
  }
  print(table, kind, scores, count, z2);
}

}  // namespace

int main(int argc, char** argv) {
  const TableOutput output = handsight::trials::take_table_output(argc, argv);
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  const std::string kind = argc > 3 ? argv[3] : "charuco";
  const bool alone = argc > 4 && std::string(argv[4]) == "alone";
  Table table = table_of(alone, output);
  for (const Kind& k : kinds)
    if (kind == k.name || kind == "all") run(table, k, count, seed, alone);
}
