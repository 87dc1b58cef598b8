// SPDX-License-Identifier: Apache-2.0
// What is written can be read: calibrations of random robots, with any model, objective and loss, and what is made of
// them.
#include "fixtures/written_calibrations.h"

#include <gtest/gtest.h>

#include "fixtures/random_robot.h"
#include "fixtures/robot_texts.h"
#include "robot/urdf.h"

namespace handsight {
namespace {

/// A few effects at any of their places, to estimate; all numbers start at 0.
std::vector<EffectTerm> drawn_terms(const Chain& chain, int observations, std::mt19937_64& random) {
  std::vector<EffectTerm> terms;
  const std::size_t count = 1 + random() % 4;
  while (terms.size() < count) {
    const Effect& effect = catalogue()[random() % catalogue().size()];
    const std::vector<int> places = effect_places(effect, chain);
    if (places.empty()) continue;
    EffectTerm term = term_of(effect, places[random() % places.size()]);
    for (std::size_t p = 0; p < term.values.size(); ++p)
      if (effect.parameters[p].is_choice)
        term.values[p] = effect.parameters[p].choices.empty()
                             ? static_cast<double>(random() % static_cast<unsigned>(observations))
                             : effect.parameters[p].choices[random() % effect.parameters[p].choices.size()];
    terms.push_back(term);
  }
  return terms;
}

/// With what the same effects really are: half a prior sigma each.
std::vector<EffectTerm> hidden(std::vector<EffectTerm> terms, std::mt19937_64& random) {
  for (EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!term_effect(t).parameters[p].is_choice)
        t.values[p] = (random() % 2 ? 0.5 : -0.5) * term_effect(t).parameters[p].sigma;
  return terms;
}

FitOptions drawn_options(const Chain& chain, int observations, std::mt19937_64& random) {
  FitOptions options;
  options.most_iterations = 20;
  const auto draw = random() % 6;
  if (draw == 0) options.objective = Objective::camera;
  if (draw == 1) options.objective = Objective::angle_axis;
  options.fix_markers = random() % 4 == 0;
  if (random() % 3 == 0) options.loss = Loss::huber;
  if (options.objective == Objective::image) options.estimated = drawn_terms(chain, observations, random);
  return options;
}

std::string list_names(const FitOptions& options) {
  std::string names;
  for (const EffectTerm& t : options.estimated) names += fmt::format(" {}@{}", t.id, t.place);
  return names;
}

/// One session of the robot, fitted with a model drawn for it; nothing where the effects hide too many of the poses.
std::optional<std::string> trouble_of_a_draw(const Session& like, const std::string& urdf, std::uint64_t seed,
                                             std::mt19937_64& random) {
  SimulationOptions simulation;
  simulation.observations = 12;
  simulation.seed = seed;
  simulation.farthest = 3;
  simulation.declare_noise = random() % 2 == 0;
  const FitOptions options = drawn_options(make_chain(like), simulation.observations, random);
  simulation.effects = hidden(options.estimated, random);
  // Half of them lack something that makes the covariance one of the observations' scatter.
  if (random() % 2)
    simulation.effects.push_back(
        {"joint_offset", effect_places(*find_effect("joint_offset"), make_chain(like))[1], {5e-3}});
  Session session;
  try {
    session = simulate_session(like, simulation).session;
  } catch (const InputError&) {
    return std::nullopt;
  }
  session.mount.estimate = random() % 3 > 0;
  const std::string trouble = fixture::trouble_with_file_of(session, urdf, fit(session, options), {}, options);
  return trouble.empty() ? trouble : trouble + list_names(options);
}

TEST(WrittenCalibrations, OfRandomRobotsAreReadPredictedCorrectedAndExported) {
  int written = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    std::mt19937_64 random(seed);
    const Session like = fixture::seen_random_session(seed);
    const std::string urdf = fixture::urdf_text(like.robot);
    for (int draw = 0; draw < 3; ++draw) {
      const auto trouble = trouble_of_a_draw(like, urdf, seed, random);
      if (!trouble) continue;
      ++written;
      EXPECT_EQ(*trouble, "") << "seed " << seed << ", draw " << draw;
    }
  }
  EXPECT_GT(written, 250);
}

}  // namespace
}  // namespace handsight
