// SPDX-License-Identifier: Apache-2.0
#include "blunders/pairing_order.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "blunders/blunder_kinds.h"
#include "blunders/places.h"
#include "blunders/seen_points.h"
#include "blunders/trials.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/sure_fit.h"
#include "geometry/pose_matching.h"

namespace handsight {
namespace {

constexpr std::size_t fewest = 8, most = 200;  // observations
constexpr double most_of_rms = 0.35;           // in the right order, of the error before
constexpr double far_likelier = 10;            // ln Bayes factor
constexpr double nearly_all = 0.8;             // of what is seen has its place by motions
constexpr double as_good = 4;                  // times the mean square of an order that nobody would make

/// For each observation in turn the place of the one whose robot belongs to it; none where that is not known.
using Order = std::vector<std::optional<std::size_t>>;

/// Numbers from `first` on as a program lists them that takes them for text.
std::vector<std::size_t> sorted_as_text(std::size_t count, std::size_t first) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return std::to_string(a + first) < std::to_string(b + first); });
  return places;
}

bool is_in_turn(const Order& order) {
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] && *order[i] != i) return false;
  return true;
}

/// By what programs do: the images sorted as text, the robot's lines so, and either backwards.
std::vector<Order> list_usual_orders(std::size_t count) {
  std::vector<Order> orders;
  for (const std::size_t first : {0, 1}) {
    const std::vector<std::size_t> as_text = sorted_as_text(count, first);
    Order of_images(count), of_robot(count);
    for (std::size_t i = 0; i < count; ++i) of_images[i] = as_text[i], of_robot[as_text[i]] = i;
    orders.push_back(std::move(of_images));
    orders.push_back(std::move(of_robot));
  }
  Order backwards(count);
  for (std::size_t i = 0; i < count; ++i) backwards[i] = count - 1 - i;
  orders.push_back(std::move(backwards));
  std::erase_if(orders, is_in_turn);
  return orders;
}

/// Where one body lies in what two sights show of it; nothing of fewer than three points.
std::optional<Rigid> motion_of_body(const HandSight& from, const HandSight& to) {
  std::vector<std::pair<Vector3, Vector3>> both;
  for (const SightedPoint& p : from.points)
    for (const SightedPoint& q : to.points)
      if (p.number == q.number) both.emplace_back(p.in_sensor, q.in_sensor);
  if (both.size() < 3) return std::nullopt;
  Eigen::Matrix3Xd before(3, static_cast<Eigen::Index>(both.size())), after = before;
  for (Eigen::Index i = 0; i < before.cols(); ++i)
    before.col(i) = both[static_cast<std::size_t>(i)].first, after.col(i) = both[static_cast<std::size_t>(i)].second;
  return align_points(after, before, Eigen::VectorXd::Ones(before.cols()));
}

/// The order that motions tell: of poses, or of bodies of three points and more.
std::optional<Order> find_by_motions(const std::vector<HandSight>& sights) {
  const auto fullest = std::max_element(sights.begin(), sights.end(), [](const HandSight& a, const HandSight& b) {
    return a.points.size() < b.points.size();
  });
  std::vector<Rigid> tcp_from_mount, sensor_from_body;
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    tcp_from_mount.push_back(inverse(sights[i].mount_from_tcp));
    if (const auto moved = motion_of_body(*fullest, sights[i])) sensor_from_body.push_back(*moved), seen.push_back(i);
  }
  const auto matched = match_poses(tcp_from_mount, sensor_from_body);
  if (!matched || static_cast<double>(matched->count()) < nearly_all * static_cast<double>(seen.size()))
    return std::nullopt;
  Order order(sights.size());
  for (std::size_t k = 0; k < seen.size(); ++k) order[seen[k]] = matched->of_b[k];
  return order;
}

/// What goes with its robot already, or with the one so many places on, is not out of order.
bool is_shifted(const Order& order) {
  std::vector<std::ptrdiff_t> shifts;
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i]) shifts.push_back(static_cast<std::ptrdiff_t>(*order[i]) - static_cast<std::ptrdiff_t>(i));
  const auto times = [&](std::ptrdiff_t shift) { return std::count(shifts.begin(), shifts.end(), shift); };
  return std::any_of(shifts.begin(), shifts.end(), [&](std::ptrdiff_t shift) {
    return static_cast<double>(times(shift)) > nearly_all * static_cast<double>(shifts.size());
  });
}

/// Of the used observations, each of which shows something.
std::optional<double> left_in_order(const std::vector<HandSight>& sights, const Order& order, int points,
                                    const std::optional<Rigid>& mount) {
  std::vector<HandSight> ordered;
  for (std::size_t i = 0; i < sights.size(); ++i)
    if (order[i]) ordered.push_back({sights[*order[i]].mount_from_tcp, sights[i].points});
  const auto found = hand_eye(ordered, points, mount);
  return found ? std::optional(found->mean_square) : std::nullopt;
}

std::vector<std::size_t> used_places(const Session& session) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < session.observations.size(); ++i)
    if (is_used(session.observations[i]) && !session.observations[i].sightings.empty()) used.push_back(i);
  return used;
}

/// The order in which robot and sights go together best; nothing where they do not far better than as they are.
std::optional<Order> find_order(const Session& session, const std::vector<std::size_t>& used) {
  const Session points = as_point_session(with_few_markers(session));
  const std::vector<HandSight> sights = list_sights(points);
  if (sights.size() != used.size()) return std::nullopt;  // a body that no pose was found of
  const auto mount =
      !points.mount.estimate && points.mount.known ? std::optional(points.mount.mount_from_sensor) : std::nullopt;
  Order as_it_is(sights.size());
  for (std::size_t i = 0; i < sights.size(); ++i) as_it_is[i] = i;
  const auto before = left_in_order(sights, as_it_is, points.marker_count, mount);
  if (!before) return std::nullopt;
  double least = most_of_rms * most_of_rms * *before;
  std::optional<Order> best;
  if (auto order = find_by_motions(sights); order && !is_shifted(*order))
    if (const auto left = left_in_order(sights, *order, points.marker_count, mount); left && *left < least)
      best = std::move(order), least = as_good * *left;
  for (Order& order : list_usual_orders(sights.size()))
    if (const auto left = left_in_order(sights, order, points.marker_count, mount); left && *left < least)
      best = std::move(order), least = *left;
  return best;
}

/// "0,10,11,1": for each observation the one whose robot belongs to it, "-" where none does.
std::string place_of(const Session& session, const std::vector<std::size_t>& used, const Order& order) {
  std::vector<std::string> ids;
  for (const auto& place : order) ids.push_back(place ? std::to_string(session.observations[used[*place]].id) : "-");
  return fmt::format("{}", fmt::join(ids, ","));
}

/// The other way round.
Order order_in(const std::string& where, const Session& session, const std::vector<std::size_t>& used) {
  Order order;
  for (const std::string& word : words_of_list(where)) {
    order.emplace_back();
    if (word == "-") continue;
    const auto id = parse_integer(word);
    const auto found =
        std::find_if(used.begin(), used.end(), [&](std::size_t i) { return id && session.observations[i].id == *id; });
    if (found == used.end())
      throw InputError(message("pairing_order: {:?} is no list of the observations that show something.", where));
    order.back() = static_cast<std::size_t>(found - used.begin());
  }
  if (order.size() != used.size())
    throw InputError(
        message("pairing_order: {} observations are named where {} show something.", order.size(), used.size()));
  return order;
}

void put_in_order(const std::string& where, Session& session) {
  const std::vector<std::size_t> used = used_places(session);
  const Order order = order_in(where, session, used);
  const std::vector<Observation> before = session.observations;
  for (std::size_t i = 0; i < order.size(); ++i) {
    Observation& o = session.observations[used[i]];
    if (!order[i]) {
      o.decision = Decision::excluded;
      o.reason = "which of the robot's readings belongs to it is not known";
      continue;
    }
    const Observation& robot = before[used[*order[i]]];
    o.position = robot.position, o.velocity = robot.velocity, o.torque = robot.torque;
  }
}

/// Is it one that programs make, and which: sorted as text, or backwards.
struct UsualOrder {
  bool is_as_text = false, is_backwards = false;
};

UsualOrder find_usual(const Order& order) {
  const std::vector<Order> usual = list_usual_orders(order.size());
  if (!usual.empty() && order == usual.back()) return {.is_backwards = true};
  return {.is_as_text = std::find(usual.begin(), usual.end(), order) != usual.end()};
}

Message text_of(const std::string& where, const Session& session) {
  const Order order = order_in(where, session, used_places(session));
  const UsualOrder usual = find_usual(order);
  if (usual.is_backwards)
    return "What was seen and where the robot stood are in opposite orders: the first belongs to the last.";
  if (usual.is_as_text)
    return "What was seen and where the robot stood are in different orders: one of the two was sorted as text, so "
           "that "
           "10 comes before 2.";
  return message(
      "What was seen and where the robot stood are in different orders: the motions between them say for {} of {} {} "
      "which belongs to which.",
      std::count_if(order.begin(), order.end(), [](const auto& o) { return o.has_value(); }), order.size(),
      session.rig ? "images" : "measurements");
}

Message fix_of(const std::string& where, const Session& session) {
  const UsualOrder usual = find_usual(order_in(where, session, used_places(session)));
  if (usual.is_backwards) return "Turn one of the two tables or lists of files round and convert again.";
  if (usual.is_as_text)
    return "Sort both by number (or name the files 001, 002 ... 010, so that text and number agree) and convert again.";
  return message(
      "In {} pair what was seen with the robot's readings of these observations, in turn: {}; or sort both by one "
      "number "
      "and convert again.",
      session_name(session), shortened(where, 200));
}

std::optional<std::string> find_place(const Session& session) {
  const std::vector<std::size_t> used = used_places(session);
  if (!session.parts.empty() || used.size() < fewest || used.size() > most) return std::nullopt;
  const auto found = find_order(session, used);
  return found ? std::optional(place_of(session, used, *found)) : std::nullopt;
}

}  // namespace

std::optional<Blunder> find_pairing_order(const Session& session, double before) {
  const auto where = find_place(session);
  if (!where) return std::nullopt;
  const BlunderKind& kind = *find_blunder_kind("pairing_order");
  try {
    Session right = session;
    kind.mend(*where, right);
    const Fit f = fit(right, {.smallest_step = 1e-9});
    const std::size_t count = f.problem.observations.size();
    const int rows = std::min(6, static_cast<int>(static_cast<std::size_t>(f.rows) / std::max<std::size_t>(count, 1)));
    const double ln = ln_likelier(before * before, f.residual_rms * f.residual_rms, count, rows, 0) -
                      std::lgamma(static_cast<double>(count) + 1);  // of so many orders this one
    if (has_no_answer(f) || !(f.residual_rms < most_of_rms * before) || ln < far_likelier) return std::nullopt;
    return Blunder{.id = kind.id,
                   .where = *where,
                   .text = kind.text(*where, session),
                   .fix = kind.fix(*where, session),
                   .in_pixels = !session.is_tracker(),
                   .rms_before = before,
                   .rms_after = f.residual_rms,
                   .ln_bayes_factor = ln};
  } catch (const InputError&) {  // too few are left
    return std::nullopt;
  }
}

std::vector<BlunderKind> order_blunders() {
  BlunderKind k;
  k.id = "pairing_order";
  k.is_tried_alone = k.is_tried_in_pairs = false;  // of the whole session, where trials see a part
  k.places = [](const Session& s) {
    const auto where = find_place(s);
    return where ? std::vector{*where} : std::vector<std::string>();
  };
  k.mend = put_in_order;
  k.text = text_of;
  k.fix = fix_of;
  return {k};
}

}  // namespace handsight
