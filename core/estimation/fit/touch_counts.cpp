// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/touch_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace handsight {
namespace {

/// Observations that count and hold a touch.
std::vector<const Observation*> list_touches(const Session& session, const std::vector<char>& counts) {
  std::vector<const Observation*> list;
  for (std::size_t i = 0; i < session.observations.size(); ++i)
    if (counts[i] && !session.observations[i].sightings.empty()) list.push_back(&session.observations[i]);
  return list;
}

std::vector<char> used_observations(const Session& session) {
  std::vector<char> used;
  for (const Observation& o : session.observations) used.push_back(is_used(o));
  return used;
}

int count_tips(const std::vector<const Observation*>& touches) {
  std::set<int> markers;
  for (const Observation* o : touches) markers.insert(o->sightings.front().marker);
  return static_cast<int>(markers.size());
}

std::vector<int> count_by_fixture(const Session& session, const std::vector<const Observation*>& touches) {
  std::vector<int> counts(session.fixtures.size(), 0);
  for (const Observation* o : touches) ++counts[static_cast<std::size_t>(o->part)];
  return counts;
}

/// Numbers of its place that have to follow from touches.
int asked_of(const Session& session, std::size_t fixture) {
  const Fixture& f = session.fixtures[fixture];
  const bool is_known = !find_mount(session, static_cast<int>(fixture)).estimate || f.place_sigma;
  return is_known ? 0 : static_cast<int>(list_numbers(*f.kind).size());
}

int numbers_of_touch(const FixtureKind& kind) { return static_cast<int>(kind.numbers.size()); }

/// What so many touches tell of the tip beside the fixture's place. Two of a socket leave a turn about one axis.
int told_of_tip(const FixtureKind& kind, int touches, int asked) {
  const int left = touches * numbers_of_touch(kind) - asked;
  return std::max(0, measures_place(kind) && touches == 2 && asked > 0 ? left - 1 : left);
}

}  // namespace

std::vector<Eigen::Index> list_numbers(const FixtureKind& kind) {
  switch (kind.place) {
    case FixturePlace::height:
      return {2, 3, 4};
    case FixturePlace::axis:
      return {0, 1, 3, 4};
    case FixturePlace::origin:
      return {0, 1, 2};
  }
  return {};
}

LackingTouches count_lacking(const Session& session, const std::vector<char>& counts) {
  const std::vector<const Observation*> list = list_touches(session, counts);
  const std::vector<int> touches = count_by_fixture(session, list);
  LackingTouches lacking{{}, 3 * count_tips(list)};
  for (std::size_t f = 0; f < touches.size(); ++f) {
    const FixtureKind& kind = *session.fixtures[f].kind;
    const int each = numbers_of_touch(kind), asked = asked_of(session, f);
    lacking.of_fixture.push_back(std::max(0, (asked - touches[f] * each + each - 1) / each));
    lacking.numbers_of_tip -= told_of_tip(kind, touches[f] + lacking.of_fixture.back(), asked);
  }
  for (const KnownDistance& d : session.distances)
    lacking.numbers_of_tip -=
        touches[static_cast<std::size_t>(d.of)] > 0 && touches[static_cast<std::size_t>(d.from)] > 0;
  lacking.numbers_of_tip = std::max(0, lacking.numbers_of_tip);
  return lacking;
}

std::vector<int> touches_lacking(const Session& session) {
  const std::vector<char> used = used_observations(session);
  const std::vector<int> touches = count_by_fixture(session, list_touches(session, used));
  const LackingTouches counted = count_lacking(session, used);
  std::vector<int> lacking = counted.of_fixture;
  std::size_t best = touches.size();  // the one that tells most of the tip
  for (std::size_t f = 0; f < touches.size(); ++f) {
    if (touches[f] == 0) lacking[f] = 0;
    const int each = numbers_of_touch(*session.fixtures[f].kind);
    const bool tells_more = best == touches.size() || each > numbers_of_touch(*session.fixtures[best].kind);
    if (touches[f] > 0 && tells_more) best = f;
  }
  if (best == touches.size()) return lacking;
  const int each = numbers_of_touch(*session.fixtures[best].kind);
  lacking[best] += (counted.numbers_of_tip + each - 1) / each;
  return lacking;
}

std::optional<Message> touches_lacking_text(const Session& session) {
  std::vector<std::string> wanted;
  const std::vector<int> lacking = touches_lacking(session);
  for (std::size_t f = 0; f < lacking.size(); ++f)
    if (lacking[f] > 0) wanted.push_back(fmt::format("{} (+{})", session.fixtures[f].id, lacking[f]));
  if (wanted.empty()) return std::nullopt;
  return message(
      "To find where tip and fixtures are takes at least so many touches more, each with the hand turned "
      "otherwise: {}.",
      joined(verbatim(wanted), ", ", " and "));
}

std::optional<Message> untouched_text(const Session& session) {
  const std::vector<int> touches = count_by_fixture(session, list_touches(session, used_observations(session)));
  if (std::all_of(touches.begin(), touches.end(), [](int count) { return count == 0; })) return std::nullopt;
  const auto is_open = [&](int f) {
    return touches[static_cast<std::size_t>(f)] == 0 && asked_of(session, static_cast<std::size_t>(f)) > 0;
  };
  for (const KnownDistance& d : session.distances)
    for (const int end : {d.of, d.from})
      if (is_open(end)) {
        const auto id = [&](int f) { return session.fixtures[static_cast<std::size_t>(f)].id; };
        return message(
            "{}: the distance of {} from {} tells nothing, as nothing touches {} and where it stands is a guess; touch "
            "it, say how well its place is known (place_sigma), or leave the <apart> out.",
            session.file.filename().string(), id(d.of), id(d.from), id(end));
      }
  for (std::size_t f = 0; f < touches.size(); ++f)
    if (is_open(static_cast<int>(f)) && !find_mount(session, static_cast<int>(f)).known)
      return message(
          "{}: nothing says where the fixture {} is, and nothing touches it; touch it, say where it is, or "
          "leave it out.",
          session.file.filename().string(), session.fixtures[f].id);
  return std::nullopt;
}

}  // namespace handsight
