// SPDX-License-Identifier: Apache-2.0
// What is written can be read: improve on random robots and on sessions of real ones, then the calibration written,
// read, predicted from, corrected with and exported in every kind. trial_written COUNT [FIRST_SEED] [SESSION ...];
// without sessions those of ../shared/real.
#include <fmt/format.h>

#include <cstdlib>

#include "base/files.h"
#include "detection/target_finding.h"
#include "estimation/start/target_symmetry.h"
#include "fixtures/robot_texts.h"
#include "fixtures/trial_sessions.h"
#include "fixtures/written_calibrations.h"

namespace handsight::trials {
namespace {

int failed = 0;

void run(const std::string& name, const Session& session, const std::string& urdf) {
  try {
    const Improvement m = improve(session);
    const std::string trouble =
        fixture::trouble_with_file_of(session, urdf, m.last.model.fit, m.last.report, m.last.model_options,
                                      m.inclusion_probabilities.model_uncertainty);
    failed += !trouble.empty();
    fmt::print("{}: {} steps, {} numbers in doubt; {}\n", name, m.steps.size(),
               m.inclusion_probabilities.model_uncertainty.covariance.cols(), trouble.empty() ? "good" : trouble);
  } catch (const InputError& error) {
    fmt::print("{}: nothing to write: {}\n", name, error.what());
  }
  std::fflush(stdout);
}

void run_random(std::uint64_t seed) {
  const Session like = robot_session(3, seed);
  std::mt19937_64 random(seed * 9176 + 5);
  SimulationOptions o = simulation(seed, 3);
  for (int i = 0; i < 2; ++i)
    for (const EffectTerm& t : random_terms(catalogue()[random() % catalogue().size()], make_chain(like), random))
      o.effects.push_back(t);
  try {
    run(fmt::format("seed {}", seed), simulate_session(like, o).session, fixture::urdf_text(like.robot));
  } catch (const InputError& error) {
    fmt::print("seed {}: not simulated: {}\n", seed, error.what());
  }
}

void run_real(const std::filesystem::path& folder) {
  Session session = read_session(folder);
  if (session.target) {
    find_targets(session, [](std::size_t, std::size_t) {});
    undo_target_symmetry(session);
  }
  run(folder.filename().string(), session, read_file(folder / session.robot_file));
}

}  // namespace
}  // namespace handsight::trials

int main(int count, char** arguments) {
  using namespace handsight::trials;
  const std::uint64_t sessions = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 100;
  const std::uint64_t first = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  std::vector<std::filesystem::path> folders(arguments + std::min(count, 3), arguments + count);
  if (folders.empty() && std::filesystem::exists(HANDSIGHT_SHARED_DIR "/real"))
    for (const auto& entry : std::filesystem::directory_iterator(HANDSIGHT_SHARED_DIR "/real"))
      if (entry.is_directory()) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  for (const auto& folder : folders) run_real(folder);
  for (std::uint64_t seed = first; seed < first + sessions; ++seed) run_random(seed);
  fmt::print("{} failed\n", failed);
  return failed > 0;
}
