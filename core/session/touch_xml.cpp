// SPDX-License-Identifier: Apache-2.0
#include "session/touch_xml.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/numbers.h"

namespace handsight {
namespace {

constexpr std::array<const char*, 5> kinds{"plane", "point", "line", "gauge", "length"};  // FixtureKind's

/// A frame whose z lies along this.
Matrix3 with_z_along(const Vector3& direction) {
  const Vector3 z = direction.normalized();
  Eigen::Index least = 0;
  z.cwiseAbs().minCoeff(&least);
  const Vector3 x = Vector3(Vector3::Unit(least)).cross(z).normalized();
  Matrix3 frame;
  frame << x, z.cross(x), z;
  return frame;
}

std::optional<Vector3> find_place(const XmlNode& node, const char* attribute) {
  const auto text = find_text(node, attribute);
  if (!text || text->empty()) return std::nullopt;
  return Vector3(required_numbers(node, attribute, 3, bounds::length).data());
}

std::optional<Vector3> find_direction(const XmlNode& node, const char* attribute) {
  auto direction = find_place(node, attribute);
  if (direction && direction->norm() < 1e-6)
    refuse(node, message("has {}=\"0 0 0\", expected a direction.", verbatim(attribute)));
  return direction;
}

/// Where a fixture's frame is; nothing where that is not said.
std::optional<Rigid> frame_of(const XmlNode& node, FixtureKind kind) {
  if (kind == FixtureKind::plane) {
    const auto normal = find_direction(node, "normal");
    const double offset = find_number(node, "offset", bounds::length).value_or(0);
    if (!normal) return std::nullopt;
    return Rigid{with_z_along(*normal), offset * normal->normalized()};
  }
  if (kind == FixtureKind::length) {
    const auto to = find_place(node, "to");
    return to ? std::optional(Rigid{Matrix3::Identity(), *to}) : std::nullopt;
  }
  const auto xyz = find_place(node, "xyz");
  if (kind == FixtureKind::point) return xyz ? std::optional(Rigid{Matrix3::Identity(), *xyz}) : std::nullopt;
  const auto axis = find_direction(node, kind == FixtureKind::line ? "direction" : "axis");
  if (!axis || (kind == FixtureKind::line && !xyz)) return std::nullopt;
  return Rigid{with_z_along(*axis), xyz.value_or(Vector3::Zero())};
}

void note_attributes(const XmlNode& node, FixtureKind kind, Ignored& ignored) {
  std::vector<std::string> known{"id", "mount", "estimate", "sigma", "place_sigma"};
  constexpr std::array<std::array<const char*, 2>, 5> own{
      {{"normal", "offset"}, {"xyz", "xyz"}, {"xyz", "direction"}, {"xyz", "axis"}, {"to", "to"}}};
  for (const char* attribute : own[static_cast<std::size_t>(kind)]) known.emplace_back(attribute);
  note_unknown(ignored, node, known, {});
}

void read_fixture(const XmlNode& node, FixtureKind kind, Session& session, Ignored& ignored) {
  note_attributes(node, kind, ignored);
  Fixture fixture{required_name(node, "id"), kind, find_positive(node, "sigma", bounds::sigma_point),
                  find_positive(node, "place_sigma", bounds::sigma_point)};
  for (const Fixture& other : session.fixtures)
    if (other.id == fixture.id)
      refuse(node, message("has id=\"{}\" a second time, expected each fixture once.", fixture.id));
  Mount mount;
  mount.link = find_name(node, "mount").value_or("");
  mount.estimate = find_choice(node, "estimate", {"no", "yes"}).value_or(0) == 1;
  const std::optional<Rigid> frame = frame_of(node, kind);
  mount.known = frame.has_value();
  if (frame) mount.mount_from_sensor = *frame;
  const bool can_be_found = kind == FixtureKind::plane || kind == FixtureKind::point;
  if (!frame && !(mount.estimate && can_be_found))
    refuse(node,
           "does not say where it is, expected its place; only planes and points with estimate=\"yes\" are found "
           "without.");
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

const char* fixture_tag(FixtureKind kind) { return kinds[static_cast<std::size_t>(kind)]; }

std::vector<Sighting> touch_sightings(const Fixture& fixture, int marker, double value) {
  Sighting s{.marker = marker, .point_sigma = fixture.sigma};
  s.point = Vector3::Zero();
  switch (fixture.kind) {
    case FixtureKind::point:
      return {s};
    case FixtureKind::plane:
    case FixtureKind::gauge:
      s.point->z() = value;
      s.along = Vector3(Vector3::UnitZ());
      return {s};
    case FixtureKind::length:
      s.point->x() = value;
      s.by_distance = true;
      return {s};
    case FixtureKind::line: {
      s.along = Vector3(Vector3::UnitX());
      Sighting across = s;
      across.along = Vector3(Vector3::UnitY());
      return {s, across};
    }
  }
  return {};
}

void read_touch(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"sigma"}, {"plane", "point", "line", "gauge", "length", "apart"});
  const auto sigma = find_positive(node, "sigma", bounds::sigma_point);
  for (const XmlNode& child : children(node))
    for (std::size_t k = 0; k < kinds.size(); ++k)
      if (child.tag() == kinds[k]) read_fixture(child, static_cast<FixtureKind>(k), session, ignored);
  if (session.fixtures.empty()) refuse(node, "holds no fixture, expected a plane, point, line, gauge or length.");
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
    if (!value && fixture.kind == FixtureKind::length)
      refuse(node, "has no value, expected the length that was read there.");
    const auto marker = find_integer(node, "marker", 0, session.marker_count - 1).value_or(0);
    into.sightings = touch_sightings(fixture, static_cast<int>(marker), value.value_or(0));
  }
}

namespace {

using tinyxml2::XMLElement;

void set_vector(XMLElement& element, const char* attribute, const Vector3& v) {
  element.SetAttribute(attribute, format_numbers({v.data(), 3}).c_str());
}

void write_place(XMLElement& element, FixtureKind kind, const Rigid& frame) {
  const Vector3 z = frame.rotation.col(2);
  switch (kind) {
    case FixtureKind::plane:
      set_vector(element, "normal", z);
      element.SetAttribute("offset", format_number(z.dot(frame.translation)).c_str());
      return;
    case FixtureKind::point:
      return set_vector(element, "xyz", frame.translation);
    case FixtureKind::length:
      return set_vector(element, "to", frame.translation);
    case FixtureKind::line:
    case FixtureKind::gauge:
      set_vector(element, "xyz", frame.translation);
      return set_vector(element, kind == FixtureKind::line ? "direction" : "axis", z);
  }
}

}  // namespace

void write_touch(XMLElement& root, const Session& session) {
  XMLElement& touch = *root.InsertNewChildElement("touch");
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Fixture& fixture = session.fixtures[f];
    const Mount& mount = f == 0 ? session.mount : session.other_mounts[f - 1];
    XMLElement& element = *touch.InsertNewChildElement(kinds[static_cast<std::size_t>(fixture.kind)]);
    element.SetAttribute("id", fixture.id.c_str());
    if (!mount.link.empty()) element.SetAttribute("mount", mount.link.c_str());
    if (mount.known) write_place(element, fixture.kind, mount.mount_from_sensor);
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
  if (fixture.kind != FixtureKind::point && fixture.kind != FixtureKind::line)
    touched.SetAttribute("value", format_number(s.by_distance ? s.point->x() : s.point->z()).c_str());
  touched.SetAttribute("marker", s.marker);
}

}  // namespace handsight
