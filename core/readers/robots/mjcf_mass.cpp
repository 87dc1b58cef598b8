// SPDX-License-Identifier: Apache-2.0
#include "readers/robots/mjcf_mass.h"

#include <algorithm>
#include <numbers>

#include "base/error.h"

namespace handsight::mjcf {
namespace {

constexpr double pi = std::numbers::pi;

/// m^3; 0 of what has none, or none that is known.
double volume_of(const MassShape& s) {
  const double a = s.size.x(), b = s.size.y(), c = s.size.z();
  if (s.kind == "sphere") return 4.0 / 3 * pi * a * a * a;
  if (s.kind == "capsule") return pi * a * a * (2 * b) + 4.0 / 3 * pi * a * a * a;
  if (s.kind == "cylinder") return pi * a * a * (2 * b);
  if (s.kind == "ellipsoid") return 4.0 / 3 * pi * a * b * c;
  if (s.kind == "box") return 8 * a * b * c;
  return 0;
}

/// The ends of a long shape in place of its place and length.
void set_from_to(const Element& geom, MassShape& s) {
  const auto ends = geom.numbers("fromto", 6);
  if (!ends) return;
  const Vector3 from(ends->data()), to(ends->data() + 3);
  const Vector3 along = from - to;
  const double length = along.norm();
  if (!(length > 1e-12)) refuse(geom.node, "has fromto without a length, expected two places.");
  s.place = {Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), along).toRotationMatrix(), 0.5 * (from + to)};
  if (s.kind == "box" || s.kind == "ellipsoid")
    s.size = {s.size.x(), s.size.x(), 0.5 * length};
  else
    s.size.y() = 0.5 * length;
}

}  // namespace

MassShape make_shape(const Element& geom) {
  MassShape s;
  s.kind = geom.text("type").value_or(geom.text("mesh") ? "mesh" : "sphere");
  s.place = locate(geom);
  if (const auto size = geom.numbers("size", 3, 1)) std::copy(size->begin(), size->end(), s.size.data());
  if (s.kind != "sphere") set_from_to(geom, s);
  return s;
}

Mass read_mass(const Element& body, const std::vector<Element>& geoms) {
  const auto inertial = find_child(body.node, "inertial");
  if (inertial && !body.model.from_geoms.value_or(false)) {
    const Element e{body.model, *inertial, body.around};
    const double mass = e.number("mass", 0);
    if (!bounds::mass.hold(mass)) refuse(e.node, message("has a mass of {:g} kg.", mass));
    return {mass, e.vector("pos", Vector3::Zero())};
  }
  Mass all;
  if (body.model.from_geoms == false) return all;
  Vector3 moment = Vector3::Zero();
  for (const Element& geom : geoms) {
    const MassShape s = make_shape(geom);
    const double mass = geom.number("mass", volume_of(s) * geom.number("density", 1000));
    if (!bounds::mass.hold(mass)) refuse(geom.node, message("has a mass of {:g} kg.", mass));
    all.kilograms += mass;
    moment += mass * s.place.translation;
  }
  if (all.kilograms > 0) all.center = moment / all.kilograms;
  return all;
}

}  // namespace handsight::mjcf
