// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "base/median.h"
#include "base/threads.h"
#include "vision/corners/corner_accuracy.h"
#include "vision/corners/corner_level.h"
#include "vision/corners/corner_mosaic.h"
#include "vision/corners/corner_noise.h"
#include "vision/corners/corner_odd_system.h"
#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_pyramid.h"

namespace handsight {
namespace {

constexpr int level_count = 3;       // the whole image, a half, a quarter
constexpr int least_size = 32;       // px
constexpr int coarse_places = 1000;  // where a coarser image's noise is measured
constexpr double same_px = 2;        // px: nearer ones are the same
constexpr double sharp = 2.4;        // px, of blur: what is less is fitted in this image, what is more in a coarser one
constexpr double most_last_move = 0.5;  // px
constexpr double most_sigma = 1.16;  // px, of what is fitted and is so uncertain after all that it is most likely none
constexpr std::size_t few_corners = 4;     // tell nothing of an image
constexpr std::size_t noise_corners = 12;  // that tell how alike neighbouring pixels' noise is
constexpr double telling_odds = 0;         // log-odds, of a corner that tells something of others

// A corner, and the image that it was fitted in at last.
struct Placed {
  Found found;
  int level = 0;
};

CornerModel as_finer(const CornerModel& model, int times) {
  const double scale = 1 << times;
  CornerModel finer = model;
  finer.position = in_whole(model.position, times);
  finer.blur *= scale, finer.shade /= scale;
  return finer;
}

// The corner fitted in the finest image that is sharp enough, if in any finer than that it was found in.
Placed refined(const std::vector<Level>& levels, const Found& found) {
  const int level = static_cast<int>(levels.size()) - 1;
  for (int finer = 0; finer < level; ++finer) {
    const CornerModel model = as_finer(found.fit.model, level - finer);
    if (model.blur > sharp || has_shadow(model)) continue;
    const auto again = known_look(levels[finer].sight, model);
    if (again) return {*again, finer};
  }
  return {found, level};
}

// Grey levels^2, of a pixel's noise.
struct Variances {
  double of_corners = 0;  // the middle one of what some corners tell; 0 where they are too few
  double there = 0;       // at corners or elsewhere, whichever is more
};

// By how much fewer pixels' variance changes when it is weighed against that of the image.
double pooled(const Variances& variances, double own, double weights) {
  return variances.of_corners > 0 ? pooling(own, weights, variances.of_corners) : 1;
}

double pooled(const Variances& variances, const CornerFit& fit, double ratio) {
  return pooled(variances, ratio * fit.noise * fit.noise, M_PI * fit.radius * fit.radius);
}

// The last step of one corner; by how much its covariance changes, but for what that of all does and what its own
// pixels' variance is made.
double take_last_step(OddSystem system, const Habits& habits, const Variances& variances, Found& found) {
  Corner& corner = found.corner;
  if (has_shadow(found.fit.model)) {
    corner.covariance *= correlation_factor(system, habits);
    return 0;
  }
  const double pool = system.is_smoothed ? 1 : pooled(variances, system.variance, system.weights);
  scale_variance(system, pool);
  const auto last = last_step(system, habits);
  if (!last || last->move.norm() > most_last_move) {
    corner.covariance *= std::max(1.0, pooled(variances, found.fit, 1));
    return 0;
  }
  if (last->is_needed) corner.position += last->move;
  const double model_uncertainty = model_uncertainty_of(found.fit.model, found.asymmetry, variances.there);
  corner.covariance = last->covariance * model_uncertainty;
  return model_uncertainty / found.model_uncertainty * last->covariance.trace() / found.fit.covariance.trace() / pool;
}

// Compression makes more noise at edges than elsewhere: what most corners show is no shadow's doing.
Variances variances_of(double noise, const std::vector<OddSystem>& systems) {
  if (systems.size() < few_corners) return {0, noise * noise};
  std::vector<double> variances(systems.size());
  std::transform(systems.begin(), systems.end(), variances.begin(), [](const OddSystem& s) { return s.variance; });
  const double usual = median(std::move(variances));
  return {usual, std::max(noise * noise, usual)};
}

using OddSystems = std::vector<std::optional<OddSystem>>;

// What system_of(found) tells of each; of a large image on several threads.
template <class SystemOf>
OddSystems odd_systems(const Image& image, const std::vector<Found*>& corners, const SystemOf& system_of) {
  constexpr std::size_t part_size = 64;
  OddSystems systems(corners.size());
  const std::size_t parts = (corners.size() + part_size - 1) / part_size;
  each_part(static_cast<int>(parts), is_worth_threads(image), [&](int part) {
    const std::size_t begin = static_cast<std::size_t>(part) * part_size;
    for (std::size_t i = begin; i < std::min(begin + part_size, corners.size()); ++i)
      systems[i] = system_of(*corners[i]);
  });
  return systems;
}

// The last step where colours were interpolated: all corners of the image tell its noise together.
void take_smoothed_steps(const Level& level, const Habits& habits, const Variances& variances,
                         const std::vector<Found*>& here) {
  const Image& image = level.sight.image;
  const OddSystems all = odd_systems(image, here, [&](const Found& found) {
    return has_shadow(found.fit.model) ? odd_system(image, found.fit) : smoothed_odd_system(image, found.fit);
  });
  std::vector<OddSystem> systems;
  std::vector<Found*> owners;
  double ratios = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    if (!all[i]) continue;
    ratios += all[i]->variance_ratio;
    systems.push_back(*all[i]), owners.push_back(here[i]);
  }
  const double ratio = ratios / static_cast<double>(std::max<std::size_t>(systems.size(), 1));
  for (std::size_t i = 0; i < systems.size(); ++i) {
    if (systems[i].is_smoothed) scale_variance(systems[i], ratio / systems[i].variance_ratio);
    take_last_step(systems[i], habits, variances, *owners[i]);
  }
}

// Puts those first that are likelier corners than not, and counts them; all where they are few. What is none shows
// bends and noise of its own, which no lens and no sensor made.
std::size_t tellers_first(std::vector<Found*>& corners) {
  const auto tells = [](const Found* found) { return found->suspect.log_odds > telling_odds; };
  const auto end = std::stable_partition(corners.begin(), corners.end(), tells);
  const auto count = static_cast<std::size_t>(end - corners.begin());
  return count < few_corners ? corners.size() : count;
}

// Some corners tell what all that were fitted in one image have in common, and whether any needs the last step; where
// none does only the covariances of the others change, as those of the some did.
void take_last_steps(const Level& level, int number, std::vector<Placed>& corners) {
  std::vector<Found*> here, owners;
  for (Placed& placed : corners)
    if (placed.level == number) here.push_back(&placed.found);
  const std::size_t telling = tellers_first(here);
  std::vector<OddSystem> systems;
  const auto add = [&](Found& found, const std::optional<OddSystem>& system) {
    if (system) systems.push_back(*system), owners.push_back(&found);
    return system.has_value();
  };
  const Image& image = level.sight.image;
  const std::size_t every = telling / noise_corners + 1;
  const auto is_first = [&](std::size_t i) { return i < telling && i % every == 0; };
  for (std::size_t i = 0; i < telling; i += every) add(*here[i], odd_system(image, here[i]->fit));
  const Habits of_some = learn_habits(systems);
  const Variances variances = variances_of(level.sight.noise, systems);
  if (of_some.is_mosaic) return take_smoothed_steps(level, of_some, variances, here);
  const bool all = are_bent(of_some) || are_glared(of_some) ||
                   std::any_of(systems.begin(), systems.end(), [](const OddSystem& s) { return is_plain(s); });
  const auto is_looked_at = [&](std::size_t i) { return all || is_first(i) || has_shadow(here[i]->fit.model); };
  std::vector<Found*> others;
  std::size_t telling_others = 0;
  for (std::size_t i = 0; i < here.size(); ++i)
    if (is_looked_at(i) && !is_first(i)) others.push_back(here[i]), telling_others += i < telling;
  const OddSystems of_others =
      odd_systems(image, others, [&](const Found& found) { return odd_system(image, found.fit, false); });
  std::size_t reported = systems.size();
  for (std::size_t i = 0; i < others.size(); ++i)
    if (add(*others[i], of_others[i])) scale_variance(systems.back(), of_some.variance), reported += i < telling_others;
  const Habits habits = learn_habits(std::span(systems).first(reported));
  double change = 0;
  int changed = 0;
  for (std::size_t i = 0; i < systems.size(); ++i) {
    const double own = take_last_step(systems[i], habits, variances, *owners[i]);
    change += own, changed += own > 0;
  }
  for (std::size_t i = 0; i < here.size() && changed > 0; ++i)
    if (!is_looked_at(i))
      here[i]->corner.covariance *= change / changed * pooled(variances, here[i]->fit, of_some.variance);
}

// Beside a shadow's edge a corner that is badly known is a corner still.
bool is_known(const Found& found) {
  return has_shadow(found.fit.model) || found.corner.covariance.trace() < 2 * most_sigma * most_sigma;
}

// What an image that was halved `times` times shows, as the whole one would.
Corner as_whole(const Corner& corner, int times) {
  const double scale = 1 << times;
  Corner whole = corner;
  whole.position = in_whole(corner.position, times);
  whole.covariance *= scale * scale;
  whole.strength /= scale * scale;
  return whole;
}

// Nearer ones are the same: of those the stronger is kept.
std::vector<Corner> strongest(const Image& image, std::vector<Corner> corners, int most) {
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.strength > b.strength; });
  Lattice lattice(image.width, image.height);
  std::vector<Corner> kept;
  for (const Corner& corner : corners) {
    if (lattice.has_near(corner.position, same_px)) continue;
    lattice.add({{}, corner.position, corner.edges});
    kept.push_back(corner);
    if (static_cast<int>(kept.size()) >= most) break;
  }
  return kept;
}

}  // namespace

std::vector<Corner> detect_corners(const Image& image, const DetectorOptions& options) {
  // Each half of the one before; the first is not used. They stay for the next image, which mostly is as large.
  thread_local std::array<Image, level_count> images;
  std::vector<Level> levels;
  levels.reserve(level_count);
  std::vector<Placed> placed;
  std::vector<FittedSaddle> known;  // where they lie in the present image
  for (int n = 0; n < level_count; ++n) {
    const Image& here = n > 0 ? images[n] : image;
    if (n > 0 && std::min(here.width, here.height) < least_size) break;
    const double noise = n > 0 ? image_noise(here, coarse_places) : image_noise(here);
    levels.push_back({{here, options, noise, n > 0}, {}, {}, {}, {}});
    Level& level = levels.back();
    if (n == 0) {
      find_corners(level, images[1]);
    } else {
      std::vector<PredictedCorner> missing = levels[n - 1].missing;
      for (PredictedCorner& predicted : missing)
        predicted.position = in_halved(predicted.position, 1), predicted.spacing *= 0.5, predicted.blur *= 0.5;
      find_blurred_corners(levels[n - 1], known, missing, level, n + 1 < level_count ? &images[n + 1] : nullptr);
    }
    for (const Found& found : level.found) {
      known.push_back(found.suspect);
      if (!found.is_alone) placed.push_back(refined(levels, found));
    }
    for (FittedSaddle& suspect : known) suspect.position = in_halved(suspect.position, 1), suspect.blur *= 0.5;
  }
  for (int n = 0; n < static_cast<int>(levels.size()); ++n) take_last_steps(levels[n], n, placed);
  std::vector<Corner> corners;
  for (const Placed& corner : placed)
    if (is_known(corner.found)) corners.push_back(as_whole(corner.found.corner, corner.level));
  return strongest(image, std::move(corners), options.max_corners);
}

std::optional<Corner> refine_corner(const Image& image, const Eigen::Vector2d& start, const DetectorOptions& options) {
  const bool inside = start.x() >= 0 && start.y() >= 0 && start.x() < image.width && start.y() < image.height;
  if (!inside) return std::nullopt;  // not a number is not inside either
  const Level level{{image, options, image_noise(image)}, {}, {}, {}, {}};
  const auto found = sure_look(level.sight, start, 1.5 * options.sigma, 6);
  if (!found) return std::nullopt;
  std::vector<Placed> one{{*found, 0}};
  take_last_steps(level, 0, one);
  return one.front().found.corner;
}

}  // namespace handsight
