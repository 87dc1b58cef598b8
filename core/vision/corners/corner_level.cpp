// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_level.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/threads.h"
#include "vision/corners/corner_predicted.h"
#include "vision/corners/corner_pyramid.h"
#include "vision/corners/corner_shadow_rounds.h"

namespace handsight {
namespace {

// More saddles near that are none than are corners: few enough to look again, and to look elsewhere too.
constexpr double few_points = 4, few_to_centre = 1;

// Log-odds that a corner without a neighbour on a board must have, where it is found in a coarser image only: what is
// out of focus behind makes many that look like it.
constexpr double least_alone = -1;

// What was found, each as a corner and as a suspect.
struct Finds {
  std::vector<Found> all;
  std::vector<FittedSaddle> suspects;  // the same again, as they are weighed
  void add(const Found& found, const CornerCandidate& candidate) {
    all.push_back(found), suspects.push_back(found.suspect), suspects.back().candidate = candidate;
  }
  void replace(std::size_t i, const Found& found) {
    const CornerCandidate candidate = suspects[i].candidate;
    all[i] = found, suspects[i] = found.suspect, suspects[i].candidate = candidate;
  }
};

struct Left {
  const CornerCandidate* candidate;
  bool was_fitted, is_open;
};

// Of a large image parts are looked at on several threads, and put together in their order.
constexpr int part_size = 512;
bool is_large(const CornerSight& sight) { return is_worth_threads(sight.image); }

// What look(i) finds for i below `count`, with its number.
struct Numbered {
  std::size_t number;
  Found found;
};
// How many all parts hold together.
template <class Parts, class SizeOf>
std::size_t total_size(const Parts& parts, const SizeOf& measure_size) {
  std::size_t size = 0;
  for (const auto& part : parts) size += measure_size(part);
  return size;
}

template <class Look>
std::vector<Numbered> all_found(const CornerSight& sight, std::size_t count, const Look& look) {
  const std::size_t part = is_large(sight) ? part_size : std::max<std::size_t>(count, 1);
  std::vector<std::vector<Numbered>> parts((count + part - 1) / part);
  each_part(static_cast<int>(parts.size()), is_large(sight), [&](int p) {
    const std::size_t begin = static_cast<std::size_t>(p) * part;
    for (std::size_t i = begin; i < std::min(begin + part, count); ++i)
      if (const auto found = look(i)) parts[static_cast<std::size_t>(p)].push_back({i, *found});
  });
  if (parts.empty()) return {};
  const std::size_t size = total_size(parts, [](const std::vector<Numbered>& some) { return some.size(); });
  std::vector<Numbered> all = std::move(parts.front());
  all.reserve(size);
  for (std::size_t p = 1; p < parts.size(); ++p) all.insert(all.end(), parts[p].begin(), parts[p].end());
  return all;
}

// Looks long at what the first look left, and at what it found but believes to be none: a shadow spoils a fit too.
void look_again(const CornerSight& sight, const SaddleField& field, const std::vector<Left>& left, Finds& finds) {
  const auto is_worth_it = [&](const CornerCandidate& candidate) { return field.others(candidate) <= few_points; };
  const auto beside_shadow = all_found(sight, finds.suspects.size(), [&](std::size_t i) -> std::optional<Found> {
    const FittedSaddle& suspect = finds.suspects[i];
    if (suspect.log_odds > least_log_odds || !is_worth_it(suspect.candidate)) return std::nullopt;
    return shadow_look(sight, suspect.candidate);
  });
  const auto later = all_found(sight, left.size(), [&](std::size_t i) -> std::optional<Found> {
    const double others = field.others(*left[i].candidate);
    if (others > few_points) return std::nullopt;
    return long_look(sight, *left[i].candidate, {left[i].was_fitted, others <= few_to_centre});
  });
  for (const Numbered& numbered : beside_shadow)
    if (numbered.found.suspect.own > finds.suspects[numbered.number].own)
      finds.replace(numbered.number, numbered.found);
  for (const Numbered& numbered : later) finds.add(numbered.found, *left[numbered.number].candidate);
}

// What the first looks found and left.
struct FirstLooks {
  Finds finds;
  std::vector<Left> left;
  bool is_empty() const { return finds.suspects.empty() && left.empty(); }
  void append(const FirstLooks& more) {
    finds.all.insert(finds.all.end(), more.finds.all.begin(), more.finds.all.end());
    finds.suspects.insert(finds.suspects.end(), more.finds.suspects.begin(), more.finds.suspects.end());
    left.insert(left.end(), more.left.begin(), more.left.end());
  }
};

template <class IsAsked>
FirstLooks first_looks(const Level& level, const IsAsked& is_asked) {
  const std::vector<CornerCandidate>& candidates = level.candidates;
  const std::size_t part = is_large(level.sight) ? part_size : std::max<std::size_t>(candidates.size(), 1);
  std::vector<FirstLooks> parts((candidates.size() + part - 1) / part);
  each_part(static_cast<int>(parts.size()), is_large(level.sight), [&](int p) {
    FirstLooks& looks = parts[static_cast<std::size_t>(p)];
    const std::size_t begin = static_cast<std::size_t>(p) * part, end = std::min(begin + part, candidates.size());
    for (std::size_t i = begin; i < end; ++i) {
      if (!candidates[i].ring || !is_asked(candidates[i])) continue;
      const Look look = quick_look(level.sight, candidates[i]);
      if (look.found)
        looks.finds.add(*look.found, candidates[i]);
      else if (look.is_postponed)
        looks.left.push_back({&candidates[i], look.was_fitted, look.is_open});
    }
  });
  if (parts.empty()) return {};
  const std::size_t found = total_size(parts, [](const FirstLooks& some) { return some.finds.all.size(); });
  const std::size_t left = total_size(parts, [](const FirstLooks& some) { return some.left.size(); });
  FirstLooks looks = std::move(parts.front());
  looks.finds.all.reserve(found), looks.finds.suspects.reserve(found), looks.left.reserve(left);
  for (std::size_t p = 1; p < parts.size(); ++p) looks.append(parts[p]);
  return looks;
}

// Looks longer at those that are left; keeps what is likelier a corner than not among the others.
void take_likely(FirstLooks& looks, SaddleField& field, Level& level) {
  if (looks.is_empty()) return;
  const auto set_open = [&](double probability) {
    for (const Left& rest : looks.left)
      if (rest.is_open) field.set_probability(field.at(rest.candidate->position), probability);
  };
  Finds& finds = looks.finds;
  set_open(0.5);
  weigh(finds.suspects, field);
  look_again(level.sight, field, looks.left, finds);
  set_open(0);
  weigh(finds.suspects, field);
  for (std::size_t i = 0; i < finds.all.size(); ++i)
    if (finds.suspects[i].log_odds > least_log_odds) {
      level.found.push_back(finds.all[i]);
      level.found.back().suspect.log_odds = finds.suspects[i].log_odds;
      add_if_seen(finds.all[i].fit, level.shadows);
    }
}

// A corner that has no neighbour on a board, as a marker's, must be the likelier one by itself. Numbers of the lattice
// begin at `first` with those of this level.
void mark_alone(const Lattice& lattice, int first, Level& level) {
  for (std::size_t i = 0; i < level.found.size(); ++i) {
    Found& found = level.found[i];
    if (found.suspect.log_odds > least_alone) continue;
    const auto near = lattice.neighbours(first + static_cast<int>(i));
    found.is_alone = std::all_of(near.begin(), near.end(), [](int n) { return n < 0; });
  }
}

// How deep the saddles of the finer image are, place by place of the coarser one.
class FinerSaddles {
 public:
  FinerSaddles(int width, int height, const std::vector<CornerCandidate>& finer)
      : across_(width / cell_size + 3), deepest_(static_cast<std::size_t>(across_) * (height / cell_size + 3), 0) {
    for (const CornerCandidate& candidate : finer) {
      float& deepest = deepest_[number(in_halved(candidate.position, 1))];
      deepest = std::max(deepest, candidate.saddle);
    }
  }
  // What is sharper in the finer image was seen there.
  bool tell_against(const CornerCandidate& candidate) const {
    const float* const middle = &deepest_[number(candidate.position)];
    float deepest = 0;
    for (const int row : {-across_, 0, across_})
      for (const int column : {-1, 0, 1}) deepest = std::max(deepest, middle[row + column]);
    return deepest > sharper_share * candidate.saddle;
  }

 private:
  static constexpr int cell_size = 4;           // px
  static constexpr float sharper_share = 0.4f;  // of a corner that is blurred by 2 px in the finer image
  std::size_t number(const Eigen::Vector2d& position) const {
    return static_cast<std::size_t>((static_cast<int>(position.y()) / cell_size + 1) * across_ +
                                    static_cast<int>(position.x()) / cell_size + 1);
  }
  int across_;
  std::vector<float> deepest_;
};

}  // namespace

void find_corners(Level& level, Image& half) {
  const CornerSight& sight = level.sight;
  level.candidates = saddle_candidates(sight.image, sight.options.min_contrast, sight.noise, &half);
  FirstLooks looks = first_looks(level, [](const CornerCandidate&) { return true; });
  SaddleField field(sight.image.width, sight.image.height, level.candidates);
  take_likely(looks, field, level);
  Lattice lattice(sight.image.width, sight.image.height);
  for (const Found& found : level.found) lattice.add(found.suspect);
  take_predicted(lattice, field, 0, level);
  settle_shadows(lattice, field, 0, level);
  keep_for_coarser(lattice, field, level.missing);
}

void find_blurred_corners(const Level& finer, const std::vector<FittedSaddle>& known,
                          const std::vector<PredictedCorner>& missing, Level& level, Image* half) {
  const CornerSight& sight = level.sight;
  level.candidates = saddle_candidates(sight.image, sight.options.min_contrast, sight.noise, half);
  const FinerSaddles sharper(sight.image.width, sight.image.height, finer.candidates);
  FirstLooks looks =
      first_looks(level, [&](const CornerCandidate& candidate) { return !sharper.tell_against(candidate); });
  if (looks.is_empty() && missing.empty()) return;
  SaddleField field(sight.image.width, sight.image.height, level.candidates);
  for (const FittedSaddle& suspect : known) field.set_probability(field.at(suspect.position), 1);
  take_likely(looks, field, level);
  if (level.found.empty() && missing.empty()) return;
  Lattice lattice(sight.image.width, sight.image.height);
  for (const FittedSaddle& suspect : known) lattice.add(suspect);
  const int first = lattice.size();
  for (const Found& found : level.found) lattice.add(found.suspect);
  for (const PredictedCorner& predicted : missing)
    if (field.has_near(predicted.position, reach_of(predicted)) &&
        !lattice.has_near(predicted.position, reach_of(predicted)) && !take_if_there(lattice, field, predicted, level))
      level.missing.push_back(predicted);
  take_predicted(lattice, field, first, level);
  settle_shadows(lattice, field, first, level);
  keep_for_coarser(lattice, field, level.missing);
  mark_alone(lattice, first, level);
}

}  // namespace handsight
