// SPDX-License-Identifier: Apache-2.0
// A board or tags described many times too large or too small: a length typed in another unit, a sheet that was scaled.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/median.h"
#include "blunders/blunder_kinds.h"
#include "blunders/places.h"
#include "blunders/seen_points.h"
#include "blunders/target_size.h"
#include "chain/sighting.h"
#include "estimation/start/shape_start.h"

namespace handsight {
namespace {

constexpr double smallest_factor = 1.2;    // less is a print's, and an effect tells it (target_size.h)
constexpr double like_millimetres = 0.03;  // of a thousand: length_unit says it better
constexpr double most = 1e5;

const char* name_of_length(const Target& target) { return has_squares(target) ? "square" : "tag"; }

/// r.m.s. distance of points from their middle.
double extent(const std::vector<Vector3>& points) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& x : points) middle += x / static_cast<double>(points.size());
  double squares = 0;
  for (const Vector3& x : points) squares += (x - middle).squaredNorm();
  return std::sqrt(squares / static_cast<double>(points.size()));
}

/// How many times as large as described two cameras see the pieces of a target.
std::optional<double> seen_by_two(const Session& session) {
  constexpr std::size_t fewest = 4;
  std::vector<double> factors;
  for (const Observation& o : session.observations) {
    if (!is_used(o)) continue;
    for (const std::vector<Sighting>& piece : by_piece(*session.shape, o.sightings)) {
      std::vector<Vector3> seen, described;
      for (const Sighting& s : piece)
        if (const auto point = triangulate(*session.rig, s)) {
          seen.push_back(point->point);
          described.push_back(session.shape->markers[static_cast<std::size_t>(s.marker)]);
        }
      if (seen.size() >= fewest) factors.push_back(extent(seen) / extent(described));
    }
  }
  if (factors.empty()) return std::nullopt;
  return median(std::move(factors));
}

/// How many times as large as described a target is by the robot's motions: to one camera all that it sees is then as
/// much farther off.
class SizesByMotion {
 public:
  explicit SizesByMotion(const Session& session) {
    constexpr double usual = 0.05;  // m: to a described speck every place is as good as another
    Session as_usual = session;
    described_ = usual / described_length(*session.target);
    set_target(as_usual, scaled(*session.target, described_));
    const Session points = as_point_session(with_few_markers(as_usual));
    sights_ = list_sights(points);
    point_count_ = points.marker_count;
    if (!points.mount.estimate && points.mount.known) known_ = points.mount.mount_from_sensor;
  }

  std::optional<double> best() const {
    constexpr double step = 0.14;  // of the logarithm
    constexpr int halvings = 11;   // of the step: to less than a thousandth
    const int steps = static_cast<int>(std::log(most) / step);
    double at = 0, least = left_at(0);
    if (!std::isfinite(least)) return std::nullopt;
    const auto consider = [&](double ln) {
      if (const double left = left_at(ln); left < least) at = ln, least = left;
    };
    for (int i = -steps; i <= steps; ++i) consider(step * i);
    for (int i = 1; i <= halvings; ++i) {
      const double from = at, by = step * std::pow(0.5, i);
      consider(from + by);
      consider(from - by);
    }
    return described_ * std::exp(at);
  }

 private:
  double left_at(double ln_factor) const {
    std::vector<HandSight> sights = sights_;
    for (HandSight& sight : sights)
      for (SightedPoint& point : sight.points) point.in_sensor *= std::exp(ln_factor);
    const auto found = hand_eye(sights, point_count_, known_);
    return found ? found->mean_square : std::numeric_limits<double>::infinity();
  }

  double described_ = 1;  // how many times as large as described the target of the sights is
  std::vector<HandSight> sights_;
  int point_count_ = 0;
  std::optional<Rigid> known_;
};

std::vector<std::string> sizes(const Session& session) {
  if (!session.rig || !session.target || !session.shape || !(described_length(*session.target) > 0)) return {};
  const auto factor = session.rig->count() > 1 ? seen_by_two(session) : SizesByMotion(session).best();
  if (!factor || !(*factor > 1 / most && *factor < most)) return {};
  const bool is_print = std::abs(std::log(*factor)) < std::log(smallest_factor);
  if (is_print || std::abs(1e3 * *factor - 1) < like_millimetres) return {};
  return {fmt::format("{:.3g}", *factor * described_length(*session.target))};
}

BlunderKind target_size() {
  BlunderKind k;
  k.id = "target_size";
  k.of_images = true;
  k.numbers = 1;
  k.places = sizes;
  k.mend = [](const std::string& where, Session& s) {
    const double length = number_in(where, "target_size");
    if (!s.target) throw InputError("target_size: the session has no <target>.");
    if (!(length > 0))
      throw InputError(message("target_size: {:?} is no length in m; expected one above 0, like 0.02.", where));
    set_target(s, scaled(*s.target, length / described_length(*s.target)));
  };
  k.text = [](const std::string& where, const Session& s) {
    const double length = number_in(where, "target_size");
    return message("The target is not as large as <target> says: its {} are about {:.3g} mm, not {:.6g} mm.",
                   has_squares(*s.target) ? "squares" : "tags", 1e3 * length, 1e3 * described_length(*s.target));
  };
  k.fix = [](const std::string& where, const Session& s) {
    return message("Measure it, and write {}=\"{}\" (m), or what you measured, into <target> of {}.",
                   name_of_length(*s.target), where, session_name(s));
  };
  return k;
}

}  // namespace

std::vector<BlunderKind> size_blunders() { return {target_size()}; }

}  // namespace handsight
