// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/member_noise.h"

#include <algorithm>

#include "estimation/fit/fit.h"
#include "estimation/fit/fit_noise.h"

namespace handsight {
namespace {

std::optional<double> noise_alone(const Session& session) {
  const Fit alone = fit(session);
  return alone.noise_estimate ? std::optional(alone.noise_estimate->sigma) : alone.noise;
}

}  // namespace

void learn_noise(std::vector<JoinedMember>& members) {
  constexpr double alike = 1.25;
  if (members.size() < 2) return;
  const auto is_declared = [](const JoinedMember& m) { return declared_noise(m.session).has_value(); };
  if (std::all_of(members.begin(), members.end(), is_declared)) return;
  for (JoinedMember& m : members)
    if (!is_declared(m)) m.noise = noise_alone(m.session);
  const bool is_one_kind = std::all_of(members.begin(), members.end(), [&](const JoinedMember& m) {
    return m.session.is_tracker() == members.front().session.is_tracker() && m.noise;
  });
  if (!is_one_kind) return;
  const auto [least, most] = std::minmax_element(
      members.begin(), members.end(), [](const JoinedMember& a, const JoinedMember& b) { return *a.noise < *b.noise; });
  if (*most->noise > alike * *least->noise) return;
  for (JoinedMember& m : members) m.noise.reset();
}

}  // namespace handsight
