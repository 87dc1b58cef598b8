// SPDX-License-Identifier: Apache-2.0
#include "session/sample.h"

#include "session/by_time.h"
#include "session/without_observations.h"

namespace handsight {
namespace {

Session part(const Session& session, const std::vector<int>& order, const std::vector<char>& is_taken) {
  Session some = without_observations(session);
  const auto at = [&](std::size_t k) -> const Observation& {
    return session.observations[static_cast<std::size_t>(order[k])];
  };
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (!is_taken[static_cast<std::size_t>(order[k])]) continue;
    Observation o = at(k);
    if (!o.whole) {
      auto whole = std::make_shared<PlaceInWhole>();
      whole->order = static_cast<int>(k);
      whole->start = at(0).time;
      whole->end = at(order.size() - 1).time;
      if (k > 0) whole->position_before = at(k - 1).position;
      o.whole = std::move(whole);
    }
    some.observations.push_back(std::move(o));
  }
  return some;
}

}  // namespace

Session take_part(const Session& session, const std::vector<int>& observations) {
  std::vector<char> is_taken(session.observations.size(), 0);
  for (const int i : observations) is_taken[static_cast<std::size_t>(i)] = 1;
  return part(session, by_time(session), is_taken);
}

std::optional<Sample> take_sample(const Session& session, int most, int size) {
  const std::vector<int> order = by_time(session);
  std::vector<int> used;
  for (const int i : order)
    if (is_used(session.observations[static_cast<std::size_t>(i)])) used.push_back(i);
  const auto count = static_cast<long long>(used.size());
  if (count <= most || size < 2 || size > most) return std::nullopt;
  Sample sample;
  std::vector<char> is_taken(session.observations.size(), 0);
  for (int i = 0; i < size; ++i)
    is_taken[static_cast<std::size_t>(used[static_cast<std::size_t>(i * (count - 1) / (size - 1))])] = 1;
  for (const int i : used) (is_taken[static_cast<std::size_t>(i)] ? sample.taken : sample.left_out).push_back(i);
  sample.session = part(session, order, is_taken);
  return sample;
}

}  // namespace handsight
