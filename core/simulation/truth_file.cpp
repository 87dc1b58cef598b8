// SPDX-License-Identifier: Apache-2.0
#include <tinyxml2.h>

#include "base/files.h"
#include "base/numbers.h"
#include "chain/body_frame.h"
#include "effects/units.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

std::string three(const Vector3& v) { return format_numbers(std::vector<double>{v.x(), v.y(), v.z()}); }

std::string rows(const Matrix4& m) {
  std::vector<double> numbers;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) numbers.push_back(m(r, c));
  return format_numbers(numbers);
}

void add_motion(tinyxml2::XMLElement& parent, const char* name, const Rigid& motion) {
  tinyxml2::XMLElement* element = parent.InsertNewChildElement(name);
  element->SetAttribute("xyz", three(motion.translation).c_str());
  element->SetAttribute("rpy", three(rpy_from_rotation(motion.rotation)).c_str());
  element->InsertNewChildElement("matrix")->SetText(rows(matrix_from_rigid(motion)).c_str());
}

void add_effects(tinyxml2::XMLElement& parent, const SimulatedSession& simulated) {
  tinyxml2::XMLElement* effects = parent.InsertNewChildElement("effects");
  for (const EffectTerm& term : simulated.effects) {
    const Effect* effect = &term_effect(term);
    tinyxml2::XMLElement* element = effects->InsertNewChildElement("effect");
    element->SetAttribute("id", term.id.c_str());
    for (std::size_t p = 0; p < term.values.size(); ++p) {
      tinyxml2::XMLElement* parameter = element->InsertNewChildElement("parameter");
      if (term.place >= 0)
        parameter->SetAttribute("of", effect->scope == EffectScope::marker
                                          ? std::to_string(term.place).c_str()
                                          : place_name(*effect, term.place, simulated.session.robot).c_str());
      parameter->SetAttribute("name", effect->parameters[p].name.c_str());
      parameter->SetAttribute("value", format_number(term.values[p]).c_str());
      parameter->SetAttribute("unit", unit_at(*effect, p, term.place, simulated.session.robot).c_str());
    }
  }
}

void add_curves(tinyxml2::XMLElement& parent, const SimulatedSession& simulated, const SimulationOptions& options) {
  for (const Curve& curve : options.curves) {
    tinyxml2::XMLElement* element = parent.InsertNewChildElement("curve");
    element->SetAttribute("of", simulated.session.robot.joints[static_cast<std::size_t>(curve.joint)].name.c_str());
    element->SetAttribute("deviation", curve_formula(curve).c_str());
  }
}

void add_wrong_corners(tinyxml2::XMLElement& parent, const SimulatedSession& simulated) {
  for (const WrongCorner& wrong : simulated.wrong_corners) {
    tinyxml2::XMLElement* element = parent.InsertNewChildElement("wrong_corner");
    element->SetAttribute("observation", wrong.id);
    element->SetAttribute("marker", wrong.marker);
    element->SetAttribute("seen_by", simulated.session.rig->at(wrong.camera).name.c_str());
    element->SetAttribute("off", format_numbers(std::vector<double>{wrong.off.x(), wrong.off.y()}).c_str());
  }
}

const char* kind_name(Disturbance::Kind kind) {
  switch (kind) {
    case Disturbance::Kind::joint:
      return "joint";
    case Disturbance::Kind::marker:
      return "marker";
    case Disturbance::Kind::right_image:
      return "right_image";
  }
  return "";
}

}  // namespace

void write_truth(const SimulatedSession& simulated, const SimulationOptions& options,
                 const std::filesystem::path& file) {
  tinyxml2::XMLDocument document;
  document.InsertEndChild(document.NewDeclaration());
  tinyxml2::XMLElement* root = document.NewElement("handsight_truth");
  document.InsertEndChild(root);
  root->SetAttribute("version", "1");
  root->SetAttribute("seed", std::to_string(options.seed).c_str());
  root->SetAttribute(simulated.session.is_tracker() ? "noise_m" : "noise_pixel",
                     format_number(simulated.noise).c_str());
  const std::vector<Vector3>& seen = simulated.session.shape && simulated.session.shape->piece_count() == 1
                                         ? simulated.session.shape->markers
                                         : simulated.markers_in_tcp;
  const std::vector<std::optional<Vector3>> markers(seen.begin(), seen.end());
  add_motion(*root, "tcp_from_body", body_frame(choose_sides(markers), simulated.markers_in_tcp).tcp_from_body);
  add_motion(*root, "mount_from_sensor", simulated.mount_from_sensor);
  for (std::size_t f = 0; f < simulated.session.fixtures.size(); ++f) {
    const Session& of = simulated.session;
    add_motion(*root, "mount_from_fixture", (f == 0 ? of.mount : of.other_mounts[f - 1]).mount_from_sensor);
    root->LastChildElement()->SetAttribute("id", of.fixtures[f].id.c_str());
  }
  tinyxml2::XMLElement* list = root->InsertNewChildElement("markers_in_tcp");
  for (std::size_t m = 0; m < simulated.markers_in_tcp.size(); ++m) {
    tinyxml2::XMLElement* marker = list->InsertNewChildElement("marker");
    marker->SetAttribute("index", static_cast<unsigned>(m));
    marker->SetAttribute("xyz", three(simulated.markers_in_tcp[m]).c_str());
  }
  if (!options.shift_in_sensor.isZero())
    root->InsertNewChildElement("shift_in_sensor")->SetAttribute("xyz", three(options.shift_in_sensor).c_str());
  add_effects(*root, simulated);
  for (const EffectTerm& term : simulated.effects)
    if (term.own && term.own->definition)
      write_effect_definition(*root->InsertNewChildElement("effect_definition"), *term.own->definition);
  add_curves(*root, simulated, options);
  add_wrong_corners(*root, simulated);
  for (const Disturbance& d : options.disturbances) {
    tinyxml2::XMLElement* element = root->InsertNewChildElement("disturbance");
    element->SetAttribute("observation", static_cast<std::int64_t>(d.id));
    element->SetAttribute("kind", kind_name(d.kind));
    element->SetAttribute("of", d.kind == Disturbance::Kind::marker ? std::to_string(d.index).c_str() : d.name.c_str());
    element->SetAttribute("size", format_number(d.size).c_str());
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  replace_file(file, printer.CStr());
}

}  // namespace handsight
