// SPDX-License-Identifier: Apache-2.0
// The detector before a camera with all the habits of real ones (tests/vision/corners/corner_camera.h): recall, errors
// and whether the covariance is right, set by set; recall as curves over blur, cell size, tilt and contrast; false
// corners. Usage: trial_detector_sets [SEED[,SEED...] [PART [FOLDER]]] [--markdown]: of several seeds the sets' recall
// and normalised squared error, all else of the first; PART is sets, curves, large, false, oracle or all; FOLDER
// holds photographs without boards, in which every corner counts as a false one. PART oracle: of the sets whose recall
// falls short, which share of what is in scope a perfect program could tell (tests/vision/corners/corner_oracle.h).
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "trials/table.h"
#include "vision/corners/corner_camera.h"
#include "vision/corners/corner_detector.h"
#include "vision/corners/corner_oracle.h"
#include "vision/corners/corner_truth.h"

namespace handsight {
namespace {

using namespace corner_images;

constexpr double scope_px = 0.1;       // px an axis: what could be known better counts
constexpr double same_px = 2;          // px
constexpr double visible_share = 0.4;  // of the contrast, of what is clipped white

struct Score {
  int in_scope = 0, found = 0, far = 0, false_ones = 0, at_rim = 0, theirs_lost = 0;
  double squares = 0, worst = 0, normalised = 0, their_squares = 0, our_squares_there = 0, megapixels = 0;
  double recall() const { return static_cast<double>(found) / std::max(in_scope, 1); }
};

using Filter = bool (*)(const TrueCorner&);
bool all_of_them(const TrueCorner&) { return true; }

bool is_in_scope(const TrueCorner& truth) {
  return truth.bound <= scope_px && truth.smallest_cell >= 4 && truth.visible >= visible_share;
}

// By how far off the shadow's edge is. Of what is darkest in it less contrast is left than the detector is asked for.
bool is_shaded(const TrueCorner& c, double nearest, double farthest) {
  return c.shadow_distance > nearest && c.shadow_distance <= farthest && c.contrast >= DetectorOptions{}.min_contrast;
}
struct Shadows {
  const char* name;
  Filter filter;
};
constexpr Shadows shadows[]{
    {"shadow's edge 4-12 px off", [](const TrueCorner& c) { return is_shaded(c, 4, 12); }},
    {"shadow's edge 1.5-4 px off", [](const TrueCorner& c) { return is_shaded(c, 1.5, 4); }},
    {"shadow's edge under 1.5 px", [](const TrueCorner& c) { return is_shaded(c, -1, 1.5); }},
};

void add(const Picture& picture, const std::vector<Corner>& corners, Filter filter, bool with_opencv, Score& score) {
  std::vector<bool> used(corners.size(), false);
  for (const TrueCorner& truth : picture.corners) {
    int best = -1;
    double nearest = std::max(same_px, 0.7 * picture.blur);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double distance = (corners[i].position - truth.position).norm();
      if (distance < nearest) nearest = distance, best = static_cast<int>(i);
    }
    if (best >= 0) used[best] = true;
    if (!is_in_scope(truth) || !filter(truth)) continue;
    ++score.in_scope;
    if (best < 0) continue;
    const Eigen::Vector2d error = corners[best].position - truth.position;
    const double normalised = error.dot(corners[best].covariance.inverse() * error);
    ++score.found, score.squares += error.squaredNorm(), score.worst = std::max(score.worst, error.norm());
    score.normalised += normalised, score.far += normalised > 18.4;
    if (!with_opencv) continue;
    const double theirs = (opencv_corner(picture.image, truth.position.array().round()) - truth.position).norm();
    if (theirs < 1)
      score.their_squares += theirs * theirs, score.our_squares_there += error.squaredNorm();
    else
      ++score.theirs_lost;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto near = [&](const Eigen::Vector2d& rim) { return (rim - corners[i].position).norm() < 4 + picture.blur; };
    const auto right_at = [&](const Eigen::Vector2d& rim) { return (rim - corners[i].position).norm() < 2; };
    score.at_rim += !used[i] && std::any_of(picture.at_rim.begin(), picture.at_rim.end(), right_at);
    score.false_ones += !used[i] && std::none_of(picture.at_rim.begin(), picture.at_rim.end(), near);
  }
  score.megapixels += 1e-6 * picture.image.width * picture.image.height;
}

void print(const std::string& name, const Score& s) {
  fmt::print(
      "{:<34} {:6} in scope, recall {:.4f} ({:4} lost); rms {:.4f} worst {:.3f} px; normalised error^2 {:.2f}, > 18.4 "
      "{:.2f} %; to cornerSubPix {:.2f}; {} false in {:.1f} MP, {} at the rim\n",
      name, s.in_scope, s.recall(), s.in_scope - s.found, std::sqrt(s.squares / std::max(s.found, 1)), s.worst,
      s.normalised / std::max(s.found, 1), 100.0 * s.far / std::max(s.found, 1),
      s.their_squares > 0 ? std::sqrt(s.our_squares_there / s.their_squares) : 0.0, s.false_ones, s.megapixels,
      s.at_rim);
  std::fflush(stdout);
}

Score score_of(const Conditions& conditions, int pictures, unsigned seed, Filter filter = all_of_them,
               bool with_opencv = true) {
  std::mt19937 random(seed);
  Score score;
  for (int i = 0; i < pictures; ++i) {
    const Picture picture = take(conditions, random);
    add(picture, detect_corners(picture.image), filter, with_opencv, score);
  }
  return score;
}

/// 1 is not said of what is less.
std::string recall_text(const Score& s) {
  const bool is_nearly_one = s.found < s.in_scope && s.recall() >= 0.9995;
  return fmt::format("{:.{}f}", s.recall(), is_nearly_one ? 4 : 3);
}

trials::Table table_of_sets(const std::vector<unsigned>& seeds, const trials::TableOutput& output) {
  std::vector<trials::TableColumn> columns{{.heading = "set", .width = 34}};
  for (const unsigned seed : seeds) columns.push_back({.heading = fmt::format("recall, seed {}", seed), .width = 16});
  columns.push_back({fmt::format("rms / worst, seed {}, px", seeds[0])});
  for (const unsigned seed : seeds) columns.push_back({fmt::format("normalised squared error, seed {}", seed), 2});
  columns.push_back({fmt::format("ratio to cornerSubPix, seed {}", seeds[0]), 2});
  return {columns, output};
}

/// A score for each seed; only the first has OpenCV's.
void print(trials::Table& table, const std::string& name, const std::vector<Score>& scores) {
  const auto root = [](double squares, int count) { return std::sqrt(squares / std::max(count, 1)); };
  const Score& first = scores[0];
  std::vector<trials::TableCell> row{name};
  for (const Score& s : scores)
    row.emplace_back(&s == &first ? fmt::format("{} of {}", recall_text(s), s.in_scope) : recall_text(s));
  row.emplace_back(fmt::format("{:.3f} / {:.2f}", root(first.squares, first.found), first.worst));
  for (const Score& s : scores) row.emplace_back(s.normalised / std::max(s.found, 1));
  row.emplace_back(first.their_squares > 0 ? std::sqrt(first.our_squares_there / first.their_squares) : NAN);
  table.print(row);
  fmt::print("  {} lost, squared error > 18.4 {:.2f} %, {} false in {:.1f} MP, {} at the rim\n",
             first.in_scope - first.found, 100.0 * first.far / std::max(first.found, 1), first.false_ones,
             first.megapixels, first.at_rim);
}

void sets(const std::vector<unsigned>& seeds, const trials::TableOutput& output) {
  trials::Table table = table_of_sets(seeds, output);
  const auto set = [&](const std::string& name, int pictures, const Conditions& conditions,
                       Filter filter = all_of_them) {
    std::vector<Score> scores;
    for (const unsigned seed : seeds) scores.push_back(score_of(conditions, pictures, seed, filter, scores.empty()));
    print(table, name, scores);
  };
  set("even light", 20, {});
  set("before things", 20, {.ground = Ground::things});
  set("tilt 60-70 deg", 30, {.cell = {14, 30}, .tilt = {M_PI / 3, 7 * M_PI / 18}});
  set("gamma 1.8-2.4", 20, {.gamma = {1.8, 2.4}});
  set("gamma, tilt 50-65 deg", 20, {.cell = {14, 30}, .tilt = {0.87, 1.13}, .gamma = {1.8, 2.4}});
  set("JPEG 60-95", 20, {.quality = {60, 95}});
  set("Bayer, bilinear", 20, {.mosaic = Mosaic::bilinear});
  set("Bayer, edge aware", 20, {.mosaic = Mosaic::edge_aware});
  // What a colour filter hides is common to a board: one picture is one draw.
  set("Bayer, frontal, little noise", 80,
      {.tilt = {0, 0.1}, .blur = {0.3, 0.7}, .noise = {0.2, 0.5}, .mosaic = Mosaic::bilinear});
  set("Bayer, gamma, JPEG, sharpening", 20,
      {.gamma = {1.8, 2.4}, .sharpening = {0.3, 1}, .quality = {75, 97}, .mosaic = Mosaic::edge_aware});
  set("sharpening 0.5-2", 20, {.sharpening = {0.5, 2}});
  set("halos of 2-3 px", 20, {.cell = {20, 34}, .blur = {1.2, 2}, .sharpening = {1.5, 3}, .halo = {2, 3}});
  set("light uneven", 20, {.gradient = {0, 0.004}});
  set("glare", 30, {.contrast = {40, 120}, .glare = {50, 150}});
  set("white clipped", 20, {.contrast = {80, 200}, .exposure = {1.3, 2.2}});
  const Conditions shadow{.shade = {0.25, 0.7}};
  for (const Shadows& near : shadows) set(near.name, 40, shadow, near.filter);
  // Shadows of far and of round things.
  const Filter any = [](const TrueCorner& c) { return is_shaded(c, -1, 12); };
  set("soft shadow, 2-10 px, to 12 px off", 40, {.shade = {0.25, 0.7}, .penumbra = {2, 10}}, any);
  set("curved shadow, 1/60-1/400 px", 40, {.shade = {0.25, 0.7}, .shade_bend = {0.0025, 0.0167}}, any);
  set("sharp, blur 0.2-0.4", 20, {.blur = {0.2, 0.4}});
  set("blur 2-3.5", 20, {.cell = {16, 34}, .blur = {2, 3.5}});
  set("blur 3.5-8", 12, {.width = 640, .height = 480, .cell = {34, 60}, .tilt = {0, 0.7}, .blur = {3.5, 8}});
  set("cells 6-9", 20, {.cell = {6, 9}, .tilt = {0, 0.7}, .blur = {0.4, 1.1}});
  set("contrast 20-40", 20, {.contrast = {25, 40}, .noise = {0.5, 2}});
  set("strong distortion", 20, {.distortion = {-.35, .35}});
  set("270 x 180", 30, {.width = 270, .height = 180, .ground = Ground::things});
  set("640 x 480, before things", 10, {.width = 640, .height = 480, .ground = Ground::things});
}

// Of the corners in scope, those that an observer who knows everything tells from their best rivals; those whose
// position is known to 0.3 px, which the detector asks of itself, with everything else unknown; and how many of the
// lost ones are both.
void ask(const std::string& name, int pictures, unsigned seed, Conditions conditions, Filter filter = all_of_them) {
  constexpr double most_sigma = 0.3;  // px
  std::mt19937 random(seed);
  conditions.with_exact = true;
  int all = 0, reported = 0, known = 0, both = 0, found = 0, lost_both = 0, lost_reported = 0;
  double least = 1e9;
  for (int i = 0; i < pictures; ++i) {
    const Picture picture = take(conditions, random);
    const std::vector<Corner> corners = detect_corners(picture.image);
    for (const TrueCorner& truth : picture.corners) {
      if (!is_in_scope(truth) || !filter(truth)) continue;
      const double same = std::max(same_px, 0.7 * picture.blur);
      const bool is_found = std::any_of(corners.begin(), corners.end(),
                                        [&](const Corner& c) { return (c.position - truth.position).norm() < same; });
      const OracleVerdict verdict = ask_oracle(picture, truth);
      const bool is_known = verdict.sigma < most_sigma;
      ++all, reported += verdict.is_reported, known += is_known, both += verdict.is_reported && is_known,
          found += is_found;
      lost_reported += !is_found && verdict.is_reported, lost_both += !is_found && verdict.is_reported && is_known;
      least = std::min(least, verdict.apart);
    }
  }
  const auto share = [&](int count) { return static_cast<double>(count) / std::max(all, 1); };
  fmt::print(
      "{:<34} {:6} in scope; oracle tells {:.4f}, at least {:.1f} sigma apart; position known to 0.3 px {:.4f}; both "
      "{:.4f}; detector {:.4f}: of {} lost the oracle tells {}, {} of them with a known position\n",
      name, all, share(reported), least, share(known), share(both), share(found), all - found, lost_reported,
      lost_both);
  std::fflush(stdout);
}

void oracle(unsigned seed) {
  ask("tilt 60-70 deg", 30, seed, {.cell = {14, 30}, .tilt = {M_PI / 3, 7 * M_PI / 18}});
  ask("gamma, tilt 50-65 deg", 20, seed, {.cell = {14, 30}, .tilt = {0.87, 1.13}, .gamma = {1.8, 2.4}});
  const Conditions shadow{.shade = {0.25, 0.7}};
  for (const Shadows& near : shadows) ask(near.name, 40, seed, shadow, near.filter);
  ask("blur 2-3.5", 20, seed, {.cell = {16, 34}, .blur = {2, 3.5}});
  ask("blur 3.5-8", 12, seed, {.width = 640, .height = 480, .cell = {34, 60}, .tilt = {0, 0.7}, .blur = {3.5, 8}});
  ask("cells of 4 px", 8, seed, {.cell = {4, 4}, .tilt = {0, 0.5}, .blur = {0.5, 1}});
  ask("cells of 4.5 px", 8, seed, {.cell = {4.5, 4.5}, .tilt = {0, 0.5}, .blur = {0.5, 1}});
}

void curve(const std::string& name, const std::vector<double>& at, int pictures, unsigned seed,
           const std::function<Conditions(double)>& conditions) {
  std::string line = fmt::format("recall by {:<24}", name), sizes = fmt::format("{:<34}", "  in scope");
  for (const double x : at) {
    const Score s = score_of(conditions(x), pictures, seed, all_of_them, false);
    line += fmt::format(" {:g}: {:.3f} ", x, s.recall()), sizes += fmt::format(" {:>10}", s.in_scope);
  }
  fmt::print("{}\n{}\n", line, sizes);
  std::fflush(stdout);
}

void curves(unsigned seed) {
  curve("blur, px (cells 5 blurs + 8)", {0.2, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8}, 5, seed, [](double x) {
    const double cell = 8 + 5 * x;
    return Conditions{.width = 480, .height = 360, .cell = {cell, cell}, .tilt = {0, 0.6}, .blur = {x, x}};
  });
  curve("cell, px (blur 0.5-1)", {4, 5, 6, 7, 8, 10, 14, 20, 40}, 8, seed, [](double x) {
    return Conditions{.cell = {x, x}, .tilt = {0, 0.5}, .blur = {0.5, 1}};
  });
  curve("tilt, degrees (cells 14-30)", {0, 20, 40, 50, 60, 65, 70, 75}, 8, seed, [](double x) {
    return Conditions{.cell = {14, 30}, .tilt = {x * M_PI / 180, x * M_PI / 180}};
  });
  curve("contrast, grey levels (noise 1-2)", {10, 15, 20, 25, 30, 40, 80, 160, 220}, 8, seed, [](double x) {
    return Conditions{.contrast = {x, x}, .noise = {1, 2}};
  });
}

template <class Work>
double milliseconds(int times, const Work& work) {  // of the clock, the least: others may share the machine
  double least = 1e9;
  for (int i = 0; i < times; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    least =
        std::min(least, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  return least;
}

void large(unsigned seed) {
  const auto one = [&](const std::string& name, const Conditions& conditions) {
    std::mt19937 random(seed);
    const Picture picture = take(conditions, random);
    const std::vector<Corner> corners = detect_corners(picture.image, {.max_corners = 4000});
    Score score;
    add(picture, corners, all_of_them, false, score);
    print(name, score);
    fmt::print("{:<34} {:.2f} ms, {} reported\n", "", milliseconds(7, [&] { detect_corners(picture.image); }),
               corners.size());
  };
  const Conditions twelve{
      .width = 4000, .height = 3000, .cell = {90, 110}, .tilt = {0, 0.5}, .blur = {0.8, 1.4}, .noise = {1, 3}};
  Conditions c = twelve;
  one("12 MP, plain ground", c);
  c.ground = Ground::things;
  one("12 MP, before things", c);
  c.ground = Ground::texture;
  one("12 MP, before texture", c);
  c = twelve, c.ground = Ground::things, c.blur = {3, 4};
  one("12 MP, blur 3-4", c);
  c = twelve, c.ground = Ground::texture, c.contrast = {45, 55};
  one("12 MP, before stronger texture", c);
  c = twelve, c.ground = Ground::things, c.sharpening = {2, 3}, c.halo = {2, 3}, c.quality = {80, 90},
  c.blur = {1.5, 2};
  one("12 MP, action camera", c);
  c = twelve, c.cell = {60, 70}, c.distortion = {-.3, -.2}, c.ground = Ground::things;
  one("12 MP, bent, cells 60-70", c);
  c = twelve, c.width = 7300, c.height = 5500, c.blur = {1.2, 2}, c.cell = {150, 180};
  one("40 MP", c);
}

std::string without_truth(const Image& image, int& reported, double& megapixels) {
  const auto corners = detect_corners(image);
  reported += static_cast<int>(corners.size()), megapixels += 1e-6 * image.width * image.height;
  return {};
}

void false_corners(unsigned seed, const std::string& folder) {
  for (const auto& [name, ground] : {std::pair{"things", Ground::things}, std::pair{"texture", Ground::texture}}) {
    std::mt19937 random(seed + 7);
    int reported = 0;
    double megapixels = 0;
    for (int i = 0; i < 16; ++i)
      without_truth(take({.width = 640,
                          .height = 480,
                          .blur = {0.5, 2},
                          .noise = {0.5, 4},
                          .quality = {70, 100},
                          .ground = ground,
                          .with_board = false},
                         random)
                        .image,
                    reported, megapixels);
    fmt::print("false corners, {:<12} {} in {:.1f} MP, {:.2f} a megapixel\n", name, reported, megapixels,
               reported / megapixels);
  }
  if (folder.empty()) return;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int all = 0;
  double megapixels = 0;
  for (const auto& file : files) {
    const cv::Mat mat = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (mat.empty()) continue;
    const int before = all;
    without_truth(as_image(mat), all, megapixels);
    fmt::print("  {} {} x {}: {}\n", file.filename().string(), mat.cols, mat.rows, all - before);
  }
  fmt::print("false corners, photographs: {} in {:.1f} MP, {:.2f} a megapixel\n", all, megapixels, all / megapixels);
}

}  // namespace
}  // namespace handsight

int main(int count, char** words) {
  const handsight::trials::TableOutput output = handsight::trials::take_table_output(count, words);
  std::vector<unsigned> seeds;
  std::istringstream given(count > 1 ? words[1] : "11");
  for (std::string one; std::getline(given, one, ',');) seeds.push_back(static_cast<unsigned>(std::atoi(one.c_str())));
  const unsigned seed = seeds.empty() ? 11 : seeds[0];
  const std::string part = count > 2 ? words[2] : "all", folder = count > 3 ? words[3] : "";
  const auto asked = [&](const char* name) { return part == name || part == "all"; };
  if (asked("sets")) handsight::sets(seeds, output);
  if (asked("curves")) handsight::curves(seed);
  if (asked("large")) handsight::large(seed);
  if (asked("oracle")) handsight::oracle(seed);
  if (asked("false")) handsight::false_corners(seed, folder);
}
