// SPDX-License-Identifier: Apache-2.0
// The <observation> element of a session. Internal to session_*.cpp.
#pragma once

#include "base/xml.h"
#include "session/session.h"

namespace handsight {

/// Reads one observation of a session whose joints, markers and device are known.
Observation read_observation(const XmlNode& node, const Session& session, Ignored& ignored);

/// Appends a whole observation to `parent`.
void write_observation(tinyxml2::XMLElement& parent, const Session& session, const Observation& observation);

/// Brings markers and decision of an element to those of the observation; all else stays, and so does the
/// spelling of numbers that are the same.
void update_observation(tinyxml2::XMLElement& element, const Session& session, const Observation& observation);

}  // namespace handsight
