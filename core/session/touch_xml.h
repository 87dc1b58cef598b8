// SPDX-License-Identifier: Apache-2.0
// Sessions of touches in and out: <touch> with its fixtures, <touched> in each observation. A fixture is a part of the
// session with a mount of its own, whose frame takes the sensor's place; what was read there are sightings of the tip.
#pragma once

#include "base/xml.h"
#include "session/session.h"

namespace handsight {

/// Reads <touch>: <plane id normal offset>, <point id xyz>, <line id xyz direction>, <gauge id axis xyz>,
/// <length id to>, each with mount (a link; absent: the root), estimate, sigma (m, of one reading there) and
/// place_sigma (m, of its place where it is estimated and not only guessed), and <apart of from by sigma>. Where a
/// fixture stands may be left out where it is estimated and is no gauge or length.
void read_touch(const XmlNode& node, Session& session, Ignored& ignored);

/// Reads <touched fixture value marker>: one a fixture of an observation. Lengths need a value; a point and a line have
/// none.
void read_touched(const XmlNode& observation, const Session& session, Observation& into, Ignored& ignored);

/// "plane", "point", "line", "gauge" or "length": the tag of such a fixture.
const char* fixture_tag(FixtureKind kind);

/// What a touch of a fixture by that marker measures, in the fixture's frame; `value` where the fixture reads one.
std::vector<Sighting> touch_sightings(const Fixture& fixture, int marker, double value);

void write_touch(tinyxml2::XMLElement& root, const Session& session);
void write_touched(tinyxml2::XMLElement& element, const Session& session, const Observation& observation);

}  // namespace handsight
