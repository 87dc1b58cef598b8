// SPDX-License-Identifier: Apache-2.0
#include "detection/target_finding.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "session/session_xml.h"
#include "targets/target_detection.h"
#include "targets/target_guess.h"
#include "vision/image/image_file.h"
#include "vision/markers/corner_pairs.h"

namespace handsight {
namespace {

/// What every corner is known no better than, whatever its image says (px).
PixelSigma sigma_of(const TargetPixel& seen) {
  const double floor = PairOptions{}.corner_floor;
  return pixel_sigma(seen.covariance + floor * floor * Eigen::Matrix2d::Identity());
}

bool is_to_be_searched(const Observation& o) {
  return o.sightings.empty() && has_images(o) && o.decision != Decision::excluded && o.decision != Decision::rejected;
}

/// Some images of these observations, spread over all of them.
std::vector<Image> some_images(const Session& session, const std::vector<const Observation*>& observations) {
  constexpr std::size_t most = 4;
  std::vector<Image> images;
  const std::size_t step = std::max<std::size_t>(1, observations.size() / most);
  for (std::size_t i = 0; i < observations.size() && images.size() < most; i += step)
    for (int c = 0; c < session.rig->count(); ++c) {
      const std::string& file = observations[i]->images[static_cast<std::size_t>(c)];
      if (file.empty()) continue;
      try {
        images.push_back(read_image(folder(session) / file, session.rig->at(c).camera, file));
        break;
      } catch (const InputError&) {  // has been told
      }
    }
  return images;
}

int dropped_tags_in(const std::vector<Image>& images, const Target& target) {
  const PreparedTarget prepared = prepare(target);
  int dropped = 0;
  for (const Image& image : images) {
    const TargetSighting seen = detect_target(image, prepared);
    dropped += seen.points.empty() ? static_cast<int>(target.columns * target.rows) : seen.dropped_tags;
  }
  return dropped;
}

/// A ChArUco board of the other layout has most of its tags where this one has them, a square aside: it is found, and
/// its tags of one column do not agree. Empty where the layout is right.
Message other_layout_text(const std::vector<Image>& images, const Target& described) {
  if (described.kind != TargetKind::charuco) return {};
  Target other = described;
  other.old_layout = !described.old_layout;
  if (2 * dropped_tags_in(images, other) >= dropped_tags_in(images, described)) return {};
  return message(
      "All tags agree with the other layout: write layout=\"{}\" into <target>; as described the board's places are a "
      "square aside.",
      std::string(other.old_layout ? "old" : "new"));
}

Message repeated_text(const std::map<int, int>& repeated) {
  std::vector<std::string> numbers;
  int observations = 0;
  for (const auto& [number, count] : repeated) {
    numbers.push_back(std::to_string(number));
    observations = std::max(observations, count);
  }
  return message(
      "Images show the tag {} several times (in {} observation{}); which of them is meant nothing tells, "
      "and it is left out there.",
      fmt::join(numbers, ", "), observations, observations == 1 ? "" : "s");
}

}  // namespace

TargetFinder::TargetFinder(const Session& session) : folder_(folder(session)) {
  check(session.target && session.rig, "a search for a target that the session has not");
  rig_ = *session.rig;
  target_ = std::make_shared<const PreparedTarget>(prepare(*session.target));
}

TargetFinding TargetFinder::find(const Observation& observation) const {
  TargetFinding finding;
  std::map<int, Sighting> by_number;
  for (int c = 0; c < rig_.count(); ++c) {
    const std::string& file = observation.images[static_cast<std::size_t>(c)];
    if (file.empty()) continue;
    Image image;
    try {
      image = read_image(folder_ / file, rig_.at(c).camera, file);
    } catch (const InputError& error) {
      finding.unreadable.push_back(error.sentence());
      continue;
    }
    ++finding.images;
    const TargetSighting seen = detect_target(image, *target_);
    finding.dropped_points += seen.dropped_points;
    finding.dropped_tags += seen.dropped_tags;
    finding.repeated.insert(finding.repeated.end(), seen.repeated.begin(), seen.repeated.end());
    for (const TargetPixel& point : seen.points) {
      Sighting& sighting = by_number[point.number];
      sighting.marker = point.number;
      sighting.by = MarkedBy::tracker;
      see(sighting, c, point.pixel, sigma_of(point));
    }
    if (seen.points.empty() && finding.reason.empty())
      finding.reason = rig_.count() == 1 ? seen.reason : message("{}: {}", rig_.at(c).name, seen.reason);
  }
  for (auto& [number, sighting] : by_number) finding.sightings.push_back(std::move(sighting));
  if (!finding.sightings.empty()) finding.reason = {};
  if (finding.images == 0)
    finding.reason = finding.unreadable.empty() ? Message("it has no image") : finding.unreadable.front();
  return finding;
}

TargetSearch find_targets(Session& session, const std::function<void(std::size_t, std::size_t)>& progress) {
  TargetSearch search;
  if (!session.target || !session.rig) return search;
  std::size_t all = 0, done = 0;
  for (const Observation& o : session.observations) all += is_to_be_searched(o) ? 1 : 0;
  if (all == 0) return search;
  const TargetFinder finder(session);
  int unreadable = 0, without = 0;
  Message first_unreadable, first_without;
  std::map<int, int> repeated;  // observations by number of the tag
  std::vector<const Observation*> not_found, with_dropped;
  for (Observation& o : session.observations) {
    if (!is_to_be_searched(o)) continue;
    TargetFinding finding = finder.find(o);
    ++search.looked_at;
    search.dropped_points += finding.dropped_points;
    search.dropped_tags += finding.dropped_tags;
    unreadable += finding.unreadable.empty() ? 0 : 1;
    if (!finding.unreadable.empty() && first_unreadable.empty()) first_unreadable = finding.unreadable.front();
    if (finding.sightings.empty() && finding.unreadable.empty() && without++ == 0)
      first_without = message("{}: {}", o.id, finding.reason);
    for (const int number : finding.repeated) ++repeated[number];
    if (finding.sightings.empty() && finding.unreadable.empty()) not_found.push_back(&o);
    if (!finding.sightings.empty() && finding.dropped_tags > 0) with_dropped.push_back(&o);
    search.found += finding.sightings.empty() ? 0 : 1;
    o.sightings = std::move(finding.sightings);
    if (progress) progress(++done, all);
  }
  search.notes.push_back(message("The {} is found in {} of {} observations with images.",
                                 describe_target(*session.target), search.found, search.looked_at));
  if (without > 0)
    search.notes.push_back(message("It is not found in {} observations, first in {}.", without, first_without));
  if (3 * search.found < search.looked_at && !not_found.empty())
    search.in_its_place =
        guess_target(some_images(session, not_found), *session.target, TargetWording::attributes).text;
  if (!search.in_its_place.empty()) search.notes.push_back(search.in_its_place);
  if (!repeated.empty()) search.notes.push_back(repeated_text(repeated));
  if (search.dropped_points + search.dropped_tags > 0)
    search.notes.push_back(message("{} points and {} tags did not agree with the rest of the target and are left out.",
                                   search.dropped_points, search.dropped_tags));
  if (2 * with_dropped.size() > static_cast<std::size_t>(search.found))
    if (const Message text = other_layout_text(some_images(session, with_dropped), *session.target); !text.empty())
      search.notes.push_back(text);
  if (unreadable > 0)
    search.notes.push_back(
        message("Images of {} observations cannot be read, first: {}", unreadable, first_unreadable));
  return search;
}

}  // namespace handsight
