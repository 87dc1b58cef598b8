// SPDX-License-Identifier: Apache-2.0
// The weights by which the detector tells corners from texture: logistic regression on rendered corners and texture.
// Usage: trial_corner_odds [SEED]; prints the weights found, and how many of each set they tell rightly.
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cstdlib>

#include "vision/corners/corner_likelihood.h"
#include "vision/corners/corner_model.h"
#include "vision/corners/corner_noise.h"
#include "vision/corners/corner_structure.h"
#include "vision/corners/corner_truth.h"

namespace handsight {
namespace {

using namespace corner_images;
using Row = Eigen::Matrix<double, 8, 1>;  // the signs, the others, the board

struct Example {
  Row signs;
  bool is_corner = false;
};

// What the detector's first look fits in one image, each among the others as they are settled.
std::vector<Example> examples(const Image& image, const std::vector<Eigen::Vector2d>& corners) {
  const double noise = image_noise(image);
  const auto candidates = saddle_candidates(image, 20, noise);
  std::vector<FittedSaddle> suspects;
  std::vector<CornerSigns> signs;
  for (const CornerCandidate& candidate : candidates) {
    if (!candidate.stationary) continue;
    if (may_be_cross(image, candidate.position.array().round().cast<int>(), 20, noise) != Lighting::even) continue;
    const auto cross = cross_structure(image, candidate.position, 20);
    const auto fit = cross ? fit_corner(image, candidate.position, *cross, noise) : std::nullopt;
    if (!fit) continue;
    signs.push_back(find_signs(*fit, noise));
    const double own = corner_log_odds(signs.back());
    suspects.push_back({candidate, fit->model.position, fit->model.edges, fit->model.half_contrast, own, own});
  }
  SaddleField field(image.width, image.height, candidates);
  weigh(suspects, field);
  const std::vector<double> board = board_signs(suspects);
  std::vector<Example> all;
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    Example example;
    example.signs << Eigen::Map<const Eigen::Matrix<double, 6, 1>>(signs[i].data()),
        std::clamp(field.others(suspects[i].candidate), -2.0, 4.0), board[i];
    for (const Eigen::Vector2d& corner : corners) example.is_corner |= (corner - suspects[i].position).norm() < 2;
    all.push_back(example);
  }
  return all;
}

// White noise that a Gaussian has smoothed, of 1 to 5 px; `in_patches`: cut to black and white with soft borders.
Image grain(bool in_patches, std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double sigma = uniform(1, 5), amplitude = uniform(15, 50), noise = uniform(2, 8);
  std::normal_distribution<float> normal(0, 1);
  cv::Mat grey(120, 120, CV_32F);
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u) grey.at<float>(v, u) = normal(random);
  cv::GaussianBlur(grey, grey, {0, 0}, sigma);
  cv::Scalar mean, deviation;
  cv::meanStdDev(grey, mean, deviation);
  grey *= amplitude / deviation[0];
  if (in_patches) {
    grey = cv::min(cv::max(grey, -0.3 * amplitude), 0.3 * amplitude) * 2.5;
    cv::GaussianBlur(grey, grey, {0, 0}, 0.8);
  }
  Image image(65, 65);
  for (int v = 0; v < 65; ++v)
    for (int u = 0; u < 65; ++u) {
      const double value = 127 + grey.at<float>(v + 27, u + 27) + noise * normal(random);
      image.row(v)[u] = static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
    }
  return image;
}

// Newton's method; a faint prior keeps it finite where the sets can be distinguished without fault.
Row regression(const std::vector<Example>& all) {
  Row weights = Row::Zero();
  for (int i = 0; i < 30; ++i) {
    Eigen::Matrix<double, 8, 8> hessian = 1e-3 * Eigen::Matrix<double, 8, 8>::Identity();
    Row gradient = -1e-3 * weights;
    for (const Example& example : all) {
      const double p = 1 / (1 + std::exp(-weights.dot(example.signs)));
      gradient += (example.is_corner - p) * example.signs;
      hessian += p * (1 - p) * example.signs * example.signs.transpose();
    }
    const Row step = hessian.llt().solve(gradient);
    weights += step;
    if (step.norm() < 1e-6) break;
  }
  return weights;
}

void report(const std::string& name, const std::vector<Example>& all, const Row& weights) {
  int corners = 0, kept = 0, others = 0, taken = 0;
  for (const Example& example : all) {
    const bool yes = weights.dot(example.signs) > least_log_odds;
    (example.is_corner ? corners : others) += 1;
    (example.is_corner ? kept : taken) += yes;
  }
  fmt::print("{:<28} {} of {} corners kept, {} of {} others taken\n", name, kept, corners, taken, others);
}

}  // namespace
}  // namespace handsight

int main(int count, char** words) {
  using namespace handsight;
  std::mt19937 random(count > 1 ? static_cast<unsigned>(std::atoi(words[1])) : 21);
  std::vector<std::pair<std::string, std::vector<Example>>> sets;
  const auto add = [&](const std::string& name, const std::vector<Example>& more) {
    if (sets.empty() || sets.back().first != name) sets.push_back({name, {}});
    sets.back().second.insert(sets.back().second.end(), more.begin(), more.end());
  };
  struct Kind {
    const char* name;
    int count;
    Variety variety;
  };
  for (const Kind& kind : {Kind{"markers", 2000, {}}, Kind{"large markers", 600, {.cell = {20, 30}}},
                           Kind{"boards", 600, {.cell = {10, 20}, .board = true}},
                           Kind{"boards of small cells", 600, {.cell = {7, 9}, .board = true}},
                           Kind{"beside a shadow", 600, {.shade = {0.4, 0.8}}}})
    for (int i = 0; i < kind.count; ++i) {
      const Sample sample = draw(kind.variety, random);
      std::vector<Example> all = examples(sample.image, {sample.view.corner});
      // A board's other corners are corners as well, of which the truth is not at hand; a marker's own edges are no
      // texture.
      std::erase_if(all, [](const Example& example) { return !example.is_corner; });
      add(kind.name, all);
    }
  for (int i = 0; i < 300; ++i) {
    const double blur = std::uniform_real_distribution<double>(0.7, 2)(random);
    const double noise = std::uniform_real_distribution<double>(2, 8)(random);
    add("smooth texture", examples(render(65, 65, nothing("texture", random), blur, noise, random), {}));
  }
  for (int i = 0; i < 200; ++i) add("grain", examples(grain(i % 2, random), {}));
  for (int i = 0; i < 12; ++i) {
    std::vector<Eigen::Vector2d> corners;
    const Image image = busy_scene(54, i % 2 ? 8 : 4, random, &corners);
    add("markers on texture", examples(image, corners));
  }
  std::vector<Example> all;
  for (const auto& [name, examples] : sets) all.insert(all.end(), examples.begin(), examples.end());
  const Row weights = regression(all);
  fmt::print(
      "weights: constant {:.2f}, radius {:.2f} / px, blur {:.2f} / px, log sigma {:.2f}, log excess {:.2f}, log "
      "sine {:.2f}, others {:.2f}, board {:.2f}\n",
      weights(0), weights(1), weights(2), weights(3), weights(4), weights(5), weights(6), weights(7));
  for (const auto& [name, examples] : sets) report(name, examples, weights);
}
