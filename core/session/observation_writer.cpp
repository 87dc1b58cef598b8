// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <span>

#include "base/error.h"
#include "base/message_xml.h"
#include "base/numbers.h"
#include "robot/xml_rigid.h"
#include "session/observation_xml.h"
#include "session/touch_xml.h"

namespace handsight {

namespace {

using tinyxml2::XMLElement;

const char* word(MarkedBy by) {
  switch (by) {
    case MarkedBy::hand:
      return "hand";
    case MarkedBy::tracker:
      return "tracker";
    case MarkedBy::import:
      return "import";
  }
  throw BrokenPromise("a marker that was marked by nobody");
}

const char* word(Decision decision) {
  switch (decision) {
    case Decision::accepted:
      return "accepted";
    case Decision::rejected:
      return "rejected";
    case Decision::excluded:
      return "excluded";
    case Decision::none:
      break;
  }
  throw BrokenPromise("a decision to be written that was not taken");
}

/// Sets numbers; leaves an attribute alone that says them already, in whatever spelling.
template <class Vector>
void set_numbers(XMLElement& element, const char* attribute, const std::optional<Vector>& vector) {
  if (!vector) return element.DeleteAttribute(attribute);
  const std::span<const double> numbers(vector->data(), static_cast<std::size_t>(vector->size()));
  if (const char* written = element.Attribute(attribute)) {
    const auto before = parse_numbers(written);
    if (before && format_numbers(*before) == format_numbers(numbers)) return;  // as text: 0 is not -0
  }
  element.SetAttribute(attribute, format_numbers(numbers).c_str());
}

void set_text(XMLElement& element, const char* attribute, const char* text) {
  if (!element.Attribute(attribute, text)) element.SetAttribute(attribute, text);
}

std::optional<Vector3> list_numbers(const std::optional<PixelSigma>& sigma) {
  return sigma ? std::optional(Vector3(sigma->u, sigma->v, sigma->uv)) : std::nullopt;
}

std::optional<Eigen::VectorXd> list_numbers(const std::optional<double>& sigma) {
  return sigma ? std::optional<Eigen::VectorXd>(Eigen::VectorXd::Constant(1, *sigma)) : std::nullopt;
}

void update_marker(XMLElement& element, const Session& session, const Sighting& sighting) {
  if (element.IntAttribute("index", -1) != sighting.marker) element.SetAttribute("index", sighting.marker);
  // Only what belongs to the kind of session is touched.
  if (sighting.point) {
    set_numbers(element, "point", sighting.point);
    set_numbers(element, "sigma", list_numbers(sighting.point_sigma));
  } else {
    const int cameras = session.rig ? session.rig->count() : 0;
    for (int c = 0; c < cameras; ++c) {
      const CameraPoint* const seen = seen_by(sighting, c);
      set_numbers(element, session.rig->at(c).name.c_str(), seen ? std::optional(seen->pixel) : std::nullopt);
    }
    for (int c = 0; c < cameras; ++c) {  // after the points, whether these were there before or not
      const CameraPoint* const seen = seen_by(sighting, c);
      set_numbers(element, (session.rig->at(c).name + "_sigma").c_str(),
                  list_numbers(seen ? seen->sigma : std::nullopt));
    }
  }
  if (element.Attribute("by") || sighting.by != MarkedBy::import) set_text(element, "by", word(sighting.by));
}

void update_markers(XMLElement& element, const Session& session, const Observation& observation) {
  std::map<int, XMLElement*> present;
  for (auto* marker = element.FirstChildElement("marker"); marker; marker = marker->NextSiblingElement("marker"))
    present[marker->IntAttribute("index", -1)] = marker;
  XMLElement* last = nullptr;
  for (const Sighting& sighting : observation.sightings) {
    const auto found = present.find(sighting.marker);
    XMLElement* marker = found != present.end() ? found->second : element.GetDocument()->NewElement("marker");
    if (found != present.end())
      present.erase(found);
    else if (last)
      element.InsertAfterChild(last, marker);
    else if (XMLElement* decision = element.FirstChildElement("decision"); decision && decision->PreviousSibling())
      element.InsertAfterChild(decision->PreviousSibling(), marker);
    else
      element.InsertEndChild(marker);
    update_marker(*marker, session, sighting);
    last = marker;
  }
  for (const auto& [index, gone] : present) element.DeleteChild(gone);
}

/// The parts of a reason beside its text; what else stands there stays.
void update_parts(XMLElement& decision, const Message& reason) {
  for (const char* tag : {"form", "sequence"})
    while (XMLElement* before = decision.FirstChildElement(tag)) decision.DeleteChild(before);
  if (has_parts(reason)) write_message(decision, reason);
}

void update_decision(XMLElement& element, const Observation& observation) {
  XMLElement* decision = element.FirstChildElement("decision");
  if (observation.decision == Decision::none) {
    if (decision) element.DeleteChild(decision);
    return;
  }
  if (!decision) decision = element.InsertNewChildElement("decision");
  set_text(*decision, "state", word(observation.decision));
  if (!observation.reason.empty() || decision->Attribute("reason"))
    set_text(*decision, "reason", observation.reason.english().c_str());
  update_parts(*decision, observation.reason);
}

void write_vector(XMLElement& parent, const char* tag, const Eigen::VectorXd& numbers) {
  if (numbers.size() == 0) return;
  const std::string text = format_numbers({numbers.data(), static_cast<std::size_t>(numbers.size())});
  parent.InsertNewChildElement(tag)->SetText(text.c_str());
}

}  // namespace

void write_observation(XMLElement& parent, const Session& session, const Observation& observation) {
  XMLElement& element = *parent.InsertNewChildElement("observation");
  element.SetAttribute("id", std::to_string(observation.id).c_str());
  element.SetAttribute("time", format_number(observation.time).c_str());
  if (session.robot.is_of_poses)
    write_pose(*element.InsertNewChildElement("flange_pose"), base_from_flange(observation.position));
  else
    write_vector(element, "position", observation.position);
  if (observation.target_pose) write_pose(*element.InsertNewChildElement("target_pose"), *observation.target_pose);
  write_vector(element, "velocity", observation.velocity);
  write_vector(element, "torque", observation.torque);
  if (has_images(observation) && session.rig) {
    XMLElement& images = *element.InsertNewChildElement("images");
    for (int c = 0; c < session.rig->count(); ++c)
      if (const std::string& image = observation.images[static_cast<std::size_t>(c)]; !image.empty())
        images.SetAttribute(session.rig->at(c).name.c_str(), image.c_str());
  }
  if (session.is_touch()) write_touched(element, session, observation);
  for (const Sighting& sighting : observation.sightings) {
    if (session.pose_sensor || session.is_touch()) break;  // they stand for the target's pose
    XMLElement& marker = *element.InsertNewChildElement("marker");
    update_marker(marker, session, sighting);
    set_text(marker, "by", word(sighting.by));
  }
  update_decision(element, observation);
}

void update_observation(XMLElement& element, const Session& session, const Observation& observation) {
  if (!session.pose_sensor && !session.is_touch()) update_markers(element, session, observation);
  update_decision(element, observation);
}

}  // namespace handsight
