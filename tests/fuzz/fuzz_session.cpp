// SPDX-License-Identifier: Apache-2.0
// A session text is read or refused with a sentence; what was read is written and read again, the same.
#include <algorithm>
#include <optional>

#include "fuzz.h"
#include "robot/urdf.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

const Robot& robot() {
  static const Robot arm = parse_urdf(R"(<robot name="arm"><link name="a"/><link name="b"/><link name="c"/>
    <joint name="j1" type="revolute"><parent link="a"/><child link="b"/></joint>
    <joint name="j2" type="revolute"><parent link="b"/><child link="c"/><mimic joint="j1"/></joint></robot>)",
                                      "arm.urdf", nullptr);
  return arm;
}

bool same_points(const Sighting& a, const Sighting& b) {
  return std::equal(
      a.in_cameras.begin(), a.in_cameras.end(), b.in_cameras.begin(), b.in_cameras.end(),
      [](const CameraPoint& s, const CameraPoint& t) { return s.camera == t.camera && s.pixel == t.pixel; });
}

void demand_same(const Session& a, const Session& b, const std::string& text) {
  demand(a.title == b.title && a.tcp == b.tcp && a.robot_file == b.robot_file && a.joints == b.joints,
         "names read back", text);
  demand(a.observations.size() == b.observations.size(), "observations read back", text);
  for (std::size_t i = 0; i < a.observations.size(); ++i) {
    const Observation &x = a.observations[i], &y = b.observations[i];
    demand(x.id == y.id && x.time == y.time && x.position == y.position, "an observation reads back", text);
    demand(x.decision == y.decision && x.reason == y.reason, "a decision reads back", text);
    demand(x.sightings.size() == y.sightings.size(), "markers read back", text);
    for (std::size_t m = 0; m < x.sightings.size(); ++m) {
      const Sighting &s = x.sightings[m], &t = y.sightings[m];
      demand(s.marker == t.marker && same_points(s, t) && s.point == t.point && s.by == t.by, "a marker reads back",
             text);
    }
  }
}

/// What labelling and online calibration change.
void label(Session& session) {
  Observation& first = session.observations.front();
  first.decision = first.decision == Decision::none ? Decision::excluded : Decision::none;
  first.reason = {};
  Observation& last = session.observations.back();
  Sighting sighting = seen_at(session.marker_count - 1, Vector2(1.5, 1e-300), {}, MarkedBy::hand);
  if (session.is_tracker())
    sighting = {.marker = session.marker_count - 1, .point = Vector3(-0.0, 2, 3), .by = MarkedBy::tracker};
  last.sightings.assign(1, sighting);
}

void demand_round_trips(Session session) {
  const std::string same = session_text(session);
  demand_same(session, parse_session(same, "session.xml"), same);
  label(session);
  const std::string updated = session_text(session);
  demand_same(session, parse_session(updated, "session.xml"), updated);
  session.source.reset();
  const std::string from_scratch = session_text(session);
  demand_same(session, parse_session(from_scratch, "session.xml"), from_scratch);
}

}  // namespace
}  // namespace handsight

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::optional<handsight::Session> session;
  try {
    session = handsight::parse_session(std::string(reinterpret_cast<const char*>(data), size), "session.xml");
    handsight::bind_robot(*session, handsight::robot());
  } catch (const handsight::InputError& error) {
    handsight::demand_sentence(error);
  }
  if (session) handsight::demand_round_trips(std::move(*session));
  return 0;
}
