// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_likelihood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace handsight {
namespace {

std::vector<CornerCandidate> scattered(int count, int width, int height, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<CornerCandidate> candidates;
  for (int i = 0; i < count; ++i)
    candidates.push_back({{unit(random) * (width - 1), unit(random) * (height - 1)},
                          static_cast<float>(1 + 9 * unit(random)),
                          unit(random) < 0.7});
  return candidates;
}

TEST(SaddleField, CountsWhatIsNearAndAsDeepWhateverTheImagesSize) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const auto& [width, height, count] : {std::array{65, 65, 3}, std::array{30, 30, 2}, std::array{640, 480, 400}}) {
    const auto candidates = scattered(count, width, height, random);
    SaddleField field(width, height, candidates);
    std::vector<double> probability(candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const bool alone = std::none_of(candidates.begin(), candidates.end(), [&](const CornerCandidate& other) {
        return &other != &candidates[i] && (other.position - candidates[i].position).norm() < 2;
      });
      if (!alone) continue;
      probability[i] = unit(random);
      field.set_probability(field.at(candidates[i].position), probability[i]);
    }
    for (const CornerCandidate& own : candidates) {
      double others = 0;
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const double distance = (candidates[i].position - own.position).norm();
        if (candidates[i].stationary && distance >= 2 && distance < 40 && candidates[i].saddle >= 0.25f * own.saddle)
          others += 1 - 2 * probability[i];
      }
      EXPECT_NEAR(field.others(own), others, 1e-4);
    }
  }
}

// Saddles `pitch` px apart, all of which say as much of themselves as they leave open.
std::vector<FittedSaddle> crowd(double own, double pitch = 20) {
  std::vector<FittedSaddle> all;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const Eigen::Vector2d at(20 + pitch * i, 20 + pitch * j);
      all.push_back({{at, 5, true}, at, {}, 0, own, own});
    }
  return all;
}

std::vector<CornerCandidate> list_candidates(const std::vector<FittedSaddle>& suspects) {
  std::vector<CornerCandidate> candidates;
  for (const FittedSaddle& suspect : suspects) candidates.push_back(suspect.candidate);
  return candidates;
}

TEST(Weigh, CornersOfABoardSpeakForEachOther) {
  std::vector<FittedSaddle> board = crowd(0.5);
  SaddleField field(140, 140, list_candidates(board));
  weigh(board, field);
  for (const FittedSaddle& suspect : board) EXPECT_GT(suspect.log_odds, 1);
}

TEST(Weigh, AmongSaddlesThatAreNoneACornerMustShowMore) {
  std::vector<FittedSaddle> texture = crowd(-6);
  texture[12].own = texture[12].log_odds = 2;  // the one in the middle
  SaddleField field(140, 140, list_candidates(texture));
  weigh(texture, field);
  EXPECT_LT(texture[12].log_odds, least_log_odds);
  texture[12].own = texture[12].log_odds = 8;
  weigh(texture, field);
  EXPECT_GT(texture[12].log_odds, least_log_odds);
}

TEST(BoardSigns, SeeManyWithEdgesAndContrastsAlike) {
  std::vector<FittedSaddle> board = crowd(0, 15);
  for (FittedSaddle& suspect : board) suspect.edges = {0.3, 1.7}, suspect.half_contrast = 50;
  const auto of = [](const std::vector<FittedSaddle>& suspects) { return board_signs(suspects)[suspects.size() / 2]; };
  EXPECT_DOUBLE_EQ(of(board), 1);  // 20 neighbours within 40 px
  auto changed = board;            // the other colours' corners, of which the edges come the other way round
  for (std::size_t i = 0; i < board.size(); i += 2)
    changed[i].edges = {1.7 + M_PI, 0.3}, changed[i].half_contrast = -60;
  EXPECT_DOUBLE_EQ(of(changed), 1);
  EXPECT_EQ(of({board.begin() + 8, board.begin() + 16}), 0) << "seven may be chance";
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, M_PI);
  for (FittedSaddle& suspect : changed) suspect.edges = {angle(random), angle(random)};
  EXPECT_EQ(of(changed), 0);
  changed = board;
  for (std::size_t i = 0; i < board.size(); ++i) changed[i].half_contrast = i == 12 ? 50 : 20;
  EXPECT_EQ(of(changed), 0);
}

TEST(BoardSigns, CountAllThatAreNearWhereverTheyLie) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(0, 300);
  std::vector<FittedSaddle> all(250);
  for (FittedSaddle& suspect : all)
    suspect.position = {place(random), place(random)}, suspect.edges = {0.3, 1.7}, suspect.half_contrast = 50;
  const std::vector<double> signs = board_signs(all);
  bool some = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto near = std::count_if(all.begin(), all.end(), [&](const FittedSaddle& other) {
      const double distance = (other.position - all[i].position).norm();
      return distance >= 2 && distance < 40;
    });
    const double expected = std::clamp((static_cast<double>(near) - 8) / 6, 0.0, 1.0);
    EXPECT_DOUBLE_EQ(signs[i], expected);
    some |= expected > 0 && expected < 1;
  }
  EXPECT_TRUE(some);
}

TEST(Weigh, ABoardsCornersNeedNotAllBeFound) {
  std::vector<FittedSaddle> board = crowd(1, 15);
  std::vector<CornerCandidate> candidates = list_candidates(board);
  for (const FittedSaddle& suspect : board)  // as many again that no fit took
    candidates.push_back({suspect.position + Eigen::Vector2d(7, 7), 5, true});
  SaddleField field(140, 140, candidates);
  auto texture = board;
  weigh(texture, field);
  EXPECT_LT(texture[12].log_odds, least_log_odds);
  for (FittedSaddle& suspect : board) suspect.edges = {0.3, 1.7}, suspect.half_contrast = 50;
  weigh(board, field);
  EXPECT_GT(board[12].log_odds, least_log_odds);
}

TEST(CornerLogOdds, RiseWithTheDiscAndFallWithBlurSigmaSkewAndWhatTheModelLeaves) {
  CornerFit fit;
  fit.model.half_contrast = -50, fit.model.blur = 1.5, fit.radius = 7, fit.noise = 5, fit.model.edges = {0.3, 1.8};
  fit.covariance = 0.01 * Eigen::Matrix2d::Identity();
  const double own = corner_log_odds(find_signs(fit, 3));
  const auto changed = [&](const auto& change) {
    CornerFit other = fit;
    change(other);
    return corner_log_odds(find_signs(other, 3));
  };
  EXPECT_GT(changed([](CornerFit& f) { f.radius = 9; }), own);
  EXPECT_LT(changed([](CornerFit& f) { f.model.blur = 2; }), own);
  EXPECT_LT(changed([](CornerFit& f) { f.covariance *= 4; }), own);
  EXPECT_LT(changed([](CornerFit& f) { f.noise = 10; }), own);
  EXPECT_LT(changed([](CornerFit& f) { f.model.edges[0] = 0.8; }), own);
  EXPECT_TRUE(std::isfinite(changed([](CornerFit& f) { f.noise = 1; })));  // less than the image's
}

}  // namespace
}  // namespace handsight
