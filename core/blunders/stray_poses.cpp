// SPDX-License-Identifier: Apache-2.0
#include "blunders/stray_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "blunders/blunder_kinds.h"
#include "blunders/places.h"
#include "chain/chain.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/sure_fit.h"
#include "geometry/hand_eye_consensus.h"

namespace handsight {
namespace {

constexpr std::size_t fewest = 6;     // that agree
constexpr double most_apart = 0.1;    // rad: of poses that agree
constexpr double far_off = 5;         // times what those leave that agree
constexpr double most_of_rms = 0.35;  // without the strays, of the error before

/// The observations with poses: A and B of A X B (hand_eye_consensus).
struct Seen {
  std::vector<std::size_t> places;
  std::vector<Rigid> tcp_from_mount, sensor_from_target;
};

Seen seen_in(const Session& session) {
  Seen seen;
  const Chain chain = make_chain(session);
  for (std::size_t i = 0; i < session.observations.size(); ++i) {
    const Observation& o = session.observations[i];
    if (!is_used(o) || !o.target_pose) continue;
    const ChainEnds ends = chain_ends(chain, o.position);
    seen.places.push_back(i);
    seen.tcp_from_mount.push_back(inverse(ends.root_from_tcp) * ends.root_from_mount);
    seen.sensor_from_target.push_back(*o.target_pose);
  }
  return seen;
}

std::string place_of(const std::vector<std::int64_t>& ids) { return fmt::format("{}", fmt::join(ids, ",")); }

std::vector<std::int64_t> ids_in(const std::string& where) {
  std::vector<std::int64_t> ids;
  for (const std::string& word : words_of_list(where)) {
    const auto id = parse_integer(word);
    if (!id) throw InputError(message("stray_poses: {:?} is no list of observations such as 3,5,8.", where));
    ids.push_back(*id);
  }
  return ids;
}

Session without(Session session, const std::vector<std::int64_t>& ids) {
  for (Observation& o : session.observations) {
    if (std::find(ids.begin(), ids.end(), o.id) == ids.end()) continue;
    o.decision = Decision::excluded;
    o.reason = "its pose does not go with those of the others";
  }
  return session;
}

Message text_of(const std::string& where, const Session& session) {
  const auto used = std::count_if(session.observations.begin(), session.observations.end(),
                                  [](const Observation& o) { return is_used(o) && o.target_pose; });
  const std::vector<std::int64_t> ids = ids_in(where);
  return message(
      "The poses of {} of {} observations ({}) do not go with the others, which agree among themselves: as where a "
      "board is read from its other end, a tag's tilt flips, a tracker takes a body for turned, or something moved.",
      ids.size(), used, shortened(fmt::format("{}", fmt::join(ids, ", ")), 150));
}

/// What begins or ends at a moment and stays so is a slip or a device that was moved: `improve` names these.
bool is_since_a_moment(const std::vector<bool>& strays) {
  constexpr std::ptrdiff_t several = 3;
  const auto count = std::count(strays.begin(), strays.end(), true);
  const auto first = std::find(strays.begin(), strays.end(), true);
  const auto last = std::find(strays.rbegin(), strays.rend(), true).base();
  return count >= several && last - first == count && (first == strays.begin() || last == strays.end());
}

}  // namespace

std::vector<std::int64_t> stray_poses(const Session& session) {
  if (!session.pose_sensor || !session.parts.empty()) return {};
  const Seen seen = seen_in(session);
  const auto found = hand_eye_consensus(seen.tcp_from_mount, seen.sensor_from_target);
  if (!found || found->left > most_apart) return {};
  const std::size_t agreeing = found->count(), all = seen.places.size();
  if (agreeing < fewest || 2 * agreeing < all || agreeing == all) return {};
  const Rigid middle = [&] {
    for (std::size_t i = 0; i < all; ++i)
      if (found->agrees[i]) return seen.tcp_from_mount[i] * found->x * seen.sensor_from_target[i];
    return Rigid{};
  }();
  std::vector<std::int64_t> ids;
  std::vector<bool> strays(all, false);
  for (std::size_t i = 0; i < all; ++i) {
    const Rigid off = inverse(middle) * (seen.tcp_from_mount[i] * found->x * seen.sensor_from_target[i]);
    const double left = std::hypot(vector_from_rotation(off.rotation).norm(), off.translation.norm() / 0.3);
    if (found->agrees[i] || left < far_off * std::max(found->left, 0.005)) continue;
    ids.push_back(session.observations[seen.places[i]].id);
    strays[i] = true;
  }
  return is_since_a_moment(strays) ? std::vector<std::int64_t>() : ids;
}

std::optional<Blunder> find_stray_poses(const Session& session, double before) {
  const std::vector<std::int64_t> ids = stray_poses(session);
  if (ids.empty()) return std::nullopt;
  try {
    const Fit right = fit(without(session, ids), {.smallest_step = 1e-9});
    if (has_no_answer(right) || !(right.residual_rms < most_of_rms * before)) return std::nullopt;
    const std::string where = place_of(ids);
    const BlunderKind& kind = *find_blunder_kind("stray_poses");
    return Blunder{.id = kind.id,
                   .where = where,
                   .text = kind.text(where, session),
                   .fix = kind.fix(where, session),
                   .in_pixels = false,
                   .rms_before = before,
                   .rms_after = right.residual_rms,
                   .ln_bayes_factor = 6.0 * static_cast<double>(session.observations.size() - ids.size()) *
                                      std::log(before / std::max(right.residual_rms, 1e-9))};
  } catch (const InputError&) {  // too few are left
    return std::nullopt;
  }
}

std::vector<BlunderKind> stray_blunders() {
  BlunderKind k;
  k.id = "stray_poses";
  k.is_tried_alone = k.is_tried_in_pairs = false;  // found by consensus, not by trial
  k.places = [](const Session& s) {
    const std::vector<std::int64_t> ids = stray_poses(s);
    return ids.empty() ? std::vector<std::string>() : std::vector{place_of(ids)};
  };
  k.mend = [](const std::string& where, Session& s) { s = without(std::move(s), ids_in(where)); };
  k.text = text_of;
  k.fix = [](const std::string&, const Session& s) {
    return message("Leave these observations out of {}.", session_name(s));
  };
  return {k};
}

}  // namespace handsight
