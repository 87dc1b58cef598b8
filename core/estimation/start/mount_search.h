// SPDX-License-Identifier: Apache-2.0
// Where the cameras sit, from observations of which few are labelled: the markers' sides say what each of the others
// may show, and the mount is what several of them agree on.
#pragma once

#include <optional>
#include <vector>

#include "estimation/problem/problem.h"
#include "vision/markers/known_markers.h"

namespace handsight {

/// One way to see the markers in an observation.
struct SeenBody {
  std::vector<Sighting> sightings;
  Rigid sensor_from_body;
  double sigma = 0, turn_sigma = 0;  // m, rad: how well that is known
};

/// What one observation has to say.
struct MountWitness {
  ProblemObservation posture;    // both ends of its chain
  std::vector<SeenBody> bodies;  // what it may show, the likeliest first; one where it is labelled
  bool is_labelled = false;
};

struct MountFound {
  Unknowns start;           // mount and markers from the witnesses that agree
  std::vector<int> chosen;  // per witness: which of its bodies agrees, -1: none
  std::size_t agreeing = 0;
};

/// Witnesses that have to agree: two motions of the hand determine a mount, one more could agree by chance.
inline constexpr std::size_t fewest_mount_witnesses = 5;

/// The mount on which most witnesses agree, the labelled ones among them, by the relative motions of hand and body:
/// both turn by the same angle, and two turns about different axes leave one mount (Park and Martin 1994). It is then
/// fitted to all that agree. Nothing where fewer than `fewest` agree (fewer than four where three or more are
/// labelled), or where no labelled one is among the witnesses. `problem` gives rig and marker count.
std::optional<MountFound> search_mount(const Problem& problem, const std::vector<MountWitness>& witnesses,
                                       const KnownMarkers& known, const MatchOptions& options,
                                       std::size_t fewest = fewest_mount_witnesses);

/// Of the witnesses that are not labelled, the one whose hand is turned farthest from those that are, about another
/// axis: the one to label next. -1 where all are.
int most_telling_witness(const std::vector<MountWitness>& witnesses);

}  // namespace handsight
