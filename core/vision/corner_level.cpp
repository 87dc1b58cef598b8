// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_level.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/threads.h"
#include "vision/corner_pyramid.h"
#include "vision/corner_structure.h"

namespace handsight {
namespace {

constexpr double kSame = 2;       // px: nearer ones are the same
constexpr double kBlurred = 1.5;  // px, of a corner that may have neighbours too blurred for this image
// More saddles near that are none than are corners: few enough to look again, and to look elsewhere too.
constexpr double kFew = 4, kFewToCentre = 1;

constexpr double kShadowReach = 64;   // px, to a corner that tells where a shadow's edge runs
constexpr double kNearShadow = 12;    // px, from a corner that may be lost beside it
constexpr double kThroughCorner = 4;  // px, of a shadow's edge that spoils a fit in even light most

// Log-odds that a corner without a neighbour on a board must have, where it is found in a coarser image only: what is
// out of focus behind makes many that look like it.
constexpr double kLeastAlone = -1;

// What was found, each as a corner and as a suspect.
struct Finds {
  std::vector<Found> all;
  std::vector<Suspect> suspects;  // the same again, as they are weighed
  void add(const Found& found, const Candidate& candidate) {
    all.push_back(found), suspects.push_back(found.suspect), suspects.back().candidate = candidate;
  }
  void replace(std::size_t i, const Found& found) {
    const Candidate candidate = suspects[i].candidate;
    all[i] = found, suspects[i] = found.suspect, suspects[i].candidate = candidate;
  }
};

struct Left {
  const Candidate* candidate;
  bool was_fitted, is_open;
};

// Of a large image parts are looked at on several threads, and put together in their order.
constexpr int kPart = 512;
bool is_large(const Sight& sight) { return is_worth_threads(sight.image); }

// What look(i) finds for i below `count`, with its number.
struct Numbered {
  std::size_t number;
  Found found;
};
// How many all parts hold together.
template <class Parts, class SizeOf>
std::size_t total_size(const Parts& parts, const SizeOf& size_of) {
  std::size_t size = 0;
  for (const auto& part : parts) size += size_of(part);
  return size;
}

template <class Look>
std::vector<Numbered> all_found(const Sight& sight, std::size_t count, const Look& look) {
  const std::size_t part = is_large(sight) ? kPart : std::max<std::size_t>(count, 1);
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
void look_again(const Sight& sight, const SaddleField& field, const std::vector<Left>& left, Finds& finds) {
  const auto is_worth_it = [&](const Candidate& candidate) { return field.others(candidate) <= kFew; };
  const auto beside_shadow = all_found(sight, finds.suspects.size(), [&](std::size_t i) -> std::optional<Found> {
    const Suspect& suspect = finds.suspects[i];
    if (suspect.log_odds > kLeastLogOdds || !is_worth_it(suspect.candidate)) return std::nullopt;
    return shadow_look(sight, suspect.candidate);
  });
  const auto later = all_found(sight, left.size(), [&](std::size_t i) -> std::optional<Found> {
    const double others = field.others(*left[i].candidate);
    if (others > kFew) return std::nullopt;
    return long_look(sight, *left[i].candidate, {left[i].was_fitted, others <= kFewToCentre});
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
  const std::vector<Candidate>& candidates = level.candidates;
  const std::size_t part = is_large(level.sight) ? kPart : std::max<std::size_t>(candidates.size(), 1);
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
    if (finds.suspects[i].log_odds > kLeastLogOdds) {
      level.found.push_back(finds.all[i]);
      level.found.back().suspect.log_odds = finds.suspects[i].log_odds;
      if (has_shadow(finds.all[i].fit.model)) level.shaded.push_back(finds.all[i].fit.model);
    }
}

double reach_of(const Foretold& foretold) { return std::clamp(0.25 * foretold.spacing, 1.5, 6.0); }

// Beyond a board's rim mostly nothing looks like a corner: there the small look, which knows what to look for, must do.
bool may_be_there(const Sight& sight, const SaddleField& field, const Foretold& foretold) {
  if (field.has_near(foretold.position, reach_of(foretold))) return true;
  const Eigen::Vector2i pixel = (foretold.position.array() + 0.5).floor().cast<int>();
  const auto inside = [](int at, int size) { return at >= 3 && at + 3 < size; };
  return inside(pixel.x(), sight.image.width) && inside(pixel.y(), sight.image.height) &&
         may_be_cross(sight.image, pixel, sight.options.min_contrast, sight.noise);
}

// What a foretold corner looks like beside the shadow's edge that a corner near was seen beside, if any runs there.
std::optional<CornerModel> expected_in_shadow(const Lattice& lattice, const Foretold& foretold, const Level& level) {
  CornerModel expected = lattice.expected(foretold);
  const CornerModel* nearest = nullptr;
  double least = kShadowReach;
  for (const CornerModel& shaded : level.shaded) {
    const double far = (shaded.position - expected.position).norm();
    const ShadowEdge seen = seen_from(shaded.shadow, expected.position - shaded.position);
    if (far < least && std::abs(seen.distance) < kNearShadow) least = far, nearest = &shaded;
  }
  if (!nearest) return std::nullopt;
  const double light = light_at(nearest->shadow, lattice.position(foretold.witness) - nearest->position);
  expected.level /= light, expected.half_contrast /= light;
  expected.shadow = seen_from(nearest->shadow, expected.position - nearest->position);
  return expected;
}

// What stands where it was foretold, if it is a corner of the same board.
bool take_if_there(Lattice& lattice, const SaddleField& field, const Foretold& foretold, Level& level) {
  const auto suits = [&](const CrossStructure& cross, const Eigen::Vector2d& position) {
    Suspect seen;
    seen.position = position, seen.edges = cross.edges, seen.half_contrast = cross.half_contrast;
    return lattice.may_suit(foretold.witness, seen);
  };
  const auto is_right = [&](const std::optional<Found>& found) {
    return found && lattice.suits(foretold.witness, found->suspect);
  };
  std::optional<Found> found;
  if (may_be_there(level.sight, field, foretold))
    found = foretold_look(level.sight, foretold.position, reach_of(foretold), suits);
  if (!is_right(found)) found = small_look(level.sight, lattice.expected(foretold));
  if (!is_right(found) && !level.shaded.empty()) {
    const auto expected = expected_in_shadow(lattice, foretold, level);
    found = expected ? shaded_look(level.sight, *expected) : std::nullopt;
  }
  if (!is_right(found)) return false;
  if (lattice.has_near(found->suspect.position, kSame)) return true;
  lattice.add(found->suspect), level.found.push_back(*found);
  if (has_shadow(found->fit.model)) level.shaded.push_back(found->fit.model);
  return true;
}

// What a sharp corner foretells is sharp too: where no saddle is near it is in no coarser image.
void leave(const Foretold& foretold, const SaddleField& field, Level& level) {
  if (foretold.blur > kBlurred || field.has_near(foretold.position, reach_of(foretold)))
    level.missing.push_back(foretold);
}

// Takes what the corners from number `first` on foretell, until nothing more comes. What is new may be the neighbour
// that others lacked to foretell on its other side.
void take_foretold(Lattice& lattice, const SaddleField& field, int first, Level& level) {
  const auto take_all_of = [&](int number) {
    for (const Foretold& foretold : lattice.foretold_by(number)) {
      if (lattice.has_near(foretold.position, reach_of(foretold))) continue;
      if (!take_if_there(lattice, field, foretold, level)) leave(foretold, field, level);
    }
  };
  const int known = lattice.size();
  for (int number = first; number < lattice.size(); ++number) {
    take_all_of(number);
    if (number < known) continue;
    for (const int neighbour : lattice.neighbours(number))
      if (neighbour >= first && neighbour < number) take_all_of(neighbour);
  }
}

// A corner between two neighbours, as one of them foretells it.
std::optional<Foretold> foretold_between(const Lattice& lattice, int number, double blur) {
  const std::array<int, 4> near = lattice.neighbours(number);
  for (const int place : {0, 2}) {
    if (near[place] < 0 || near[place + 1] < 0) continue;
    const Eigen::Vector2d &one = lattice.position(near[place]), &other = lattice.position(near[place + 1]);
    return Foretold{0.5 * (one + other), 0.5 * (one - other).norm(), near[place], blur};
  }
  return std::nullopt;
}

// Corners that were taken in even light although a shadow's edge runs through them: with it they lie elsewhere. Numbers
// of the lattice begin at `first` with those of this level.
void look_again_in_shadow(const Lattice& lattice, int first, Level& level) {
  if (level.shaded.empty()) return;
  for (std::size_t i = 0; i < level.found.size(); ++i) {
    Found& found = level.found[i];
    if (has_shadow(found.fit.model)) continue;
    const auto foretold = foretold_between(lattice, first + static_cast<int>(i), found.fit.model.blur);
    const auto expected = foretold ? expected_in_shadow(lattice, *foretold, level) : std::nullopt;
    if (!expected || std::abs(expected->shadow.distance) > kThroughCorner) continue;
    const auto again = shaded_look(level.sight, *expected);
    if (!again || again->fit.noise > found.fit.noise || !lattice.suits(foretold->witness, again->suspect)) continue;
    const double log_odds = found.suspect.log_odds;
    found = *again, found.suspect.log_odds = log_odds;
  }
}

// A corner that has no neighbour on a board, as a marker's, must be the likelier one by itself. Numbers of the lattice
// begin at `first` with those of this level.
void mark_alone(const Lattice& lattice, int first, Level& level) {
  for (std::size_t i = 0; i < level.found.size(); ++i) {
    Found& found = level.found[i];
    if (found.suspect.log_odds > kLeastAlone) continue;
    const auto near = lattice.neighbours(first + static_cast<int>(i));
    found.is_alone = std::all_of(near.begin(), near.end(), [](int n) { return n < 0; });
  }
}

// How deep the saddles of the finer image are, place by place of the coarser one.
class FinerSaddles {
 public:
  FinerSaddles(int width, int height, const std::vector<Candidate>& finer)
      : across_(width / kCell + 3), deepest_(static_cast<std::size_t>(across_) * (height / kCell + 3), 0) {
    for (const Candidate& candidate : finer) {
      float& deepest = deepest_[number(in_halved(candidate.position, 1))];
      deepest = std::max(deepest, candidate.saddle);
    }
  }
  // What is sharper in the finer image was seen there.
  bool tell_against(const Candidate& candidate) const {
    const float* const middle = &deepest_[number(candidate.position)];
    float deepest = 0;
    for (const int row : {-across_, 0, across_})
      for (const int column : {-1, 0, 1}) deepest = std::max(deepest, middle[row + column]);
    return deepest > kSharper * candidate.saddle;
  }

 private:
  static constexpr int kCell = 4;          // px
  static constexpr float kSharper = 0.4f;  // of a corner that is blurred by 2 px in the finer image
  std::size_t number(const Eigen::Vector2d& position) const {
    return static_cast<std::size_t>((static_cast<int>(position.y()) / kCell + 1) * across_ +
                                    static_cast<int>(position.x()) / kCell + 1);
  }
  int across_;
  std::vector<float> deepest_;
};

}  // namespace

void find_corners(Level& level, Image& half) {
  const Sight& sight = level.sight;
  level.candidates = saddle_candidates(sight.image, sight.options.min_contrast, sight.noise, &half);
  FirstLooks looks = first_looks(level, [](const Candidate&) { return true; });
  SaddleField field(sight.image.width, sight.image.height, level.candidates);
  take_likely(looks, field, level);
  Lattice lattice(sight.image.width, sight.image.height);
  for (const Found& found : level.found) lattice.add(found.suspect);
  take_foretold(lattice, field, 0, level);
  look_again_in_shadow(lattice, 0, level);
}

void find_blurred_corners(const Level& finer, const std::vector<Suspect>& known, const std::vector<Foretold>& missing,
                          Level& level, Image* half) {
  const Sight& sight = level.sight;
  level.candidates = saddle_candidates(sight.image, sight.options.min_contrast, sight.noise, half);
  const FinerSaddles sharper(sight.image.width, sight.image.height, finer.candidates);
  FirstLooks looks = first_looks(level, [&](const Candidate& candidate) { return !sharper.tell_against(candidate); });
  if (looks.is_empty() && missing.empty()) return;
  SaddleField field(sight.image.width, sight.image.height, level.candidates);
  for (const Suspect& suspect : known) field.set_probability(field.at(suspect.position), 1);
  take_likely(looks, field, level);
  if (level.found.empty() && missing.empty()) return;
  Lattice lattice(sight.image.width, sight.image.height);
  for (const Suspect& suspect : known) lattice.add(suspect);
  const int first = lattice.size();
  for (const Found& found : level.found) lattice.add(found.suspect);
  for (const Foretold& foretold : missing)
    if (field.has_near(foretold.position, reach_of(foretold)) &&
        !lattice.has_near(foretold.position, reach_of(foretold)) && !take_if_there(lattice, field, foretold, level))
      leave(foretold, field, level);
  take_foretold(lattice, field, first, level);
  look_again_in_shadow(lattice, first, level);
  mark_alone(lattice, first, level);
}

}  // namespace handsight
