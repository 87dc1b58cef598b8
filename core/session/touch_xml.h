// SPDX-License-Identifier: Apache-2.0
// Sessions of touches in and out: <touch> with its fixtures, <touched> in each observation. A fixture is a part of the
// session with a mount of its own, whose frame takes the sensor's place; what was read there are sightings of the tip.
#pragma once

#include "base/xml.h"
#include "session/session.h"

namespace handsight {

/// Reads <touch>: an element for each fixture with the tag of its kind and what says where it is (FixtureKind), with
/// mount (a link; absent: the root), estimate, sigma (m, of one reading there) and place_sigma (m, of its place where
/// it is estimated and not only guessed), and <apart of from by sigma>. Where a fixture stands may be left out where it
/// is estimated and its kind is found by touches alone.
void read_touch(const XmlNode& node, Session& session, Ignored& ignored);

/// Reads <touched fixture value marker>: one a fixture of an observation. Whether it has a value its kind says.
void read_touched(const XmlNode& observation, const Session& session, Observation& into, Ignored& ignored);

/// What a touch of a fixture by that marker measures, in the fixture's frame; `value` where the fixture reads one.
std::vector<Sighting> touch_sightings(const Fixture& fixture, int marker, double value);

/// The value (m) of a touch; 0 of one that reads nothing.
double touch_value(const Sighting& touch);

void write_touch(tinyxml2::XMLElement& root, const Session& session);
void write_touched(tinyxml2::XMLElement& element, const Session& session, const Observation& observation);

}  // namespace handsight
