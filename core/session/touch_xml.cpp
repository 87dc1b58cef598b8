// SPDX-License-Identifier: Apache-2.0
#include "session/touch_xml.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "session/fixtures/find_fixture.h"

namespace handsight {
namespace {

void note_attributes(const XmlNode& node, const FixtureKind& kind, Ignored& ignored) {
  std::vector<std::string> known{"id", "mount", "estimate", "sigma", "place_sigma"};
  known.insert(known.end(), kind.attributes.begin(), kind.attributes.end());
  note_unknown(ignored, node, known, {});
}

/// "planes and points", of the kinds that are found by touches alone.
Message found_without_place() {
  std::vector<std::string> tags = fixture_tags([](const FixtureKind& kind) { return kind.frame_through != nullptr; });
  for (std::string& tag : tags) tag += 's';
  return joined(verbatim(tags), ", ", " and ");
}

void read_fixture(const XmlNode& node, const FixtureKind& kind, Session& session, Ignored& ignored) {
  note_attributes(node, kind, ignored);
  Fixture fixture{required_name(node, "id"), &kind, find_positive(node, "sigma", bounds::sigma_point),
                  find_positive(node, "place_sigma", bounds::sigma_point)};
  for (const Fixture& other : session.fixtures)
    if (other.id == fixture.id)
      refuse(node, message("has id=\"{}\" a second time, expected each fixture once.", fixture.id));
  Mount mount;
  mount.link = find_name(node, "mount").value_or("");
  mount.estimate = find_choice(node, "estimate", {"no", "yes"}).value_or(0) == 1;
  const std::optional<Rigid> frame = kind.read_frame(node);
  mount.known = frame.has_value();
  if (frame) mount.mount_from_sensor = *frame;
  if (!frame && !(mount.estimate && kind.frame_through))
    refuse(node,
           message("does not say where it is, expected its place; only {} with estimate=\"yes\" are found without.",
                   found_without_place()));
  if (fixture.place_sigma && !(frame && mount.estimate))
    refuse(node,
           "has a place_sigma, expected one only where a place is said and estimate=\"yes\"; a place that is held has "
           "none.");
  SessionPart part;
  part.fixture = static_cast<int>(session.fixtures.size());
  part.title = fixture.id;
  part.tcp = session.tcp;
  part.mount = static_cast<int>(session.fixtures.size());
  if (session.fixtures.empty())
    session.mount = mount;
  else
    session.other_mounts.push_back(mount);
  session.parts.push_back(std::move(part));
  session.fixtures.push_back(std::move(fixture));
}

int fixture_named(const XmlNode& node, const char* attribute, const Session& session) {
  const std::string id = required_name(node, attribute);
  std::string known;
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    if (session.fixtures[f].id == id) return static_cast<int>(f);
    known += (known.empty() ? "" : ", ") + session.fixtures[f].id;
  }
  refuse(node, message("has {}=\"{}\", expected one of the fixtures: {}.", verbatim(attribute), id, known));
}

void read_apart(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"of", "from", "by", "sigma"}, {});
  KnownDistance d{fixture_named(node, "of", session), fixture_named(node, "from", session),
                  required_positive(node, "by", bounds::length), required_positive(node, "sigma", bounds::sigma_point)};
  if (d.of == d.from) refuse(node, "is from a fixture to itself, expected two of them.");
  session.distances.push_back(d);
}

}  // namespace

std::vector<Sighting> touch_sightings(const Fixture& fixture, int marker, double value) {
  Sighting all{.marker = marker, .point_sigma = fixture.sigma};
  all.point = Vector3::Zero();
  if (measures_place(*fixture.kind)) return {all};
  const double read = fixture.kind->value == TouchValue::none ? 0 : value;
  std::vector<Sighting> sightings;
  for (const TouchNumber& number : fixture.kind->numbers) {
    Sighting& s = sightings.emplace_back(all);
    s.reading = number.reading;
    if (!s.reading) s.along = Vector3(Vector3::Unit(number.axis));
    (*s.point)[number.axis] = sightings.size() == 1 ? read : 0;
  }
  return sightings;
}

double touch_value(const Sighting& touch) {
  if (touch.reading) return touch.point->x();
  return touch.along ? touch.along->dot(*touch.point) : 0;
}

void read_touch(const XmlNode& node, Session& session, Ignored& ignored) {
  std::vector<std::string> known = fixture_tags();
  known.emplace_back("apart");
  note_unknown(ignored, node, {"sigma"}, known);
  const auto sigma = find_positive(node, "sigma", bounds::sigma_point);
  for (const XmlNode& child : children(node))
    if (const FixtureKind* kind = find_fixture_kind(child.tag())) read_fixture(child, *kind, session, ignored);
  if (session.fixtures.empty())
    refuse(node, message("holds no fixture, expected a {}.", joined(verbatim(fixture_tags()), ", ", " or ")));
  for (Fixture& f : session.fixtures)
    if (!f.sigma) f.sigma = sigma;
  for (const XmlNode& child : children(node, "apart")) read_apart(child, session, ignored);
  const bool all_reported = std::all_of(session.fixtures.begin(), session.fixtures.end(),
                                        [](const Fixture& f) { return f.sigma.has_value(); });
  if (all_reported) session.sigma_point = session.fixtures.front().sigma;
}

void read_touched(const XmlNode& observation, const Session& session, Observation& into, Ignored& ignored) {
  const std::vector<XmlNode> all = children(observation, "touched");
  if (all.size() > 1) refuse(all[1], "is a second touch in one observation, expected one: the robot stands once.");
  for (const XmlNode& node : all) {
    note_unknown(ignored, node, {"fixture", "value", "marker"}, {});
    into.part = fixture_named(node, "fixture", session);
    const Fixture& fixture = session.fixtures[static_cast<std::size_t>(into.part)];
    const auto value = find_number(node, "value", bounds::length);
    if (!value && fixture.kind->value == TouchValue::whole)
      refuse(node, "has no value, expected the length that was read there.");
    const auto marker = find_integer(node, "marker", 0, session.marker_count - 1).value_or(0);
    into.sightings = touch_sightings(fixture, static_cast<int>(marker), value.value_or(0));
  }
}

using tinyxml2::XMLElement;

void write_touch(XMLElement& root, const Session& session) {
  XMLElement& touch = *root.InsertNewChildElement("touch");
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Fixture& fixture = session.fixtures[f];
    const Mount& mount = f == 0 ? session.mount : session.other_mounts[f - 1];
    XMLElement& element = *touch.InsertNewChildElement(fixture.kind->tag);
    element.SetAttribute("id", fixture.id.c_str());
    if (!mount.link.empty()) element.SetAttribute("mount", mount.link.c_str());
    if (mount.known) fixture.kind->write_frame(element, mount.mount_from_sensor);
    element.SetAttribute("estimate", mount.estimate ? "yes" : "no");
    if (fixture.sigma) element.SetAttribute("sigma", format_number(*fixture.sigma).c_str());
    if (fixture.place_sigma) element.SetAttribute("place_sigma", format_number(*fixture.place_sigma).c_str());
  }
  for (const KnownDistance& d : session.distances) {
    XMLElement& apart = *touch.InsertNewChildElement("apart");
    apart.SetAttribute("of", session.fixtures[static_cast<std::size_t>(d.of)].id.c_str());
    apart.SetAttribute("from", session.fixtures[static_cast<std::size_t>(d.from)].id.c_str());
    apart.SetAttribute("by", format_number(d.by).c_str());
    apart.SetAttribute("sigma", format_number(d.sigma).c_str());
  }
}

void write_touched(XMLElement& element, const Session& session, const Observation& observation) {
  if (observation.sightings.empty()) return;
  const Fixture& fixture = session.fixtures[static_cast<std::size_t>(observation.part)];
  const Sighting& s = observation.sightings.front();
  XMLElement& touched = *element.InsertNewChildElement("touched");
  touched.SetAttribute("fixture", fixture.id.c_str());
  if (fixture.kind->value != TouchValue::none) touched.SetAttribute("value", format_number(touch_value(s)).c_str());
  touched.SetAttribute("marker", s.marker);
}

}  // namespace handsight
