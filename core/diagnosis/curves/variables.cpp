// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/curves/variables.h"

#include <fmt/format.h>

#include "diagnosis/curves/place_formulas.h"
#include "effects/own_effect.h"

namespace handsight {
namespace {

template <class Value>
void add(VariableKind kind, int joint, const Message& name, const std::string& unit, double least,
         const Problem& problem, Value&& value, std::vector<Variable>& list, const std::string& formula = "") {
  Variable v{kind, joint, name, unit, Eigen::VectorXd(static_cast<Eigen::Index>(problem.observations.size())), formula};
  for (std::size_t i = 0; i < problem.observations.size(); ++i)
    v.values[static_cast<Eigen::Index>(i)] = value(problem.observations[i]);
  if (v.range() > least) list.push_back(std::move(v));
}

/// The middle of the markers that an observation saw, in the sensor's frame.
Vector3 middle(const Problem& problem, const Unknowns& u, const ProblemObservation& o) {
  Vector3 sum = Vector3::Zero();
  for (const Sighting& s : o.sightings) sum += marker_at(o, u, s.marker);
  return sensor_from_tcp_at(o, u) * Vector3(sum / static_cast<double>(o.sightings.size()));
}

/// The last of the list, where it is of this kind, may be written so.
void write_as(VariableKind kind, PlaceFormula formula, std::vector<Variable>& list) {
  if (list.empty() || list.back().kind != kind) return;
  list.back().formula = std::move(formula.text);
  list.back().written_values = std::move(formula.values);
}

}  // namespace

Variable as_written(const Variable& v) {
  Variable written = v;
  if (v.written_values.size() > 0) written.values = v.written_values;
  return written;
}

std::vector<Variable> list_variables(const Problem& problem, const Unknowns& u) {
  std::vector<Variable> list;
  const Robot& robot = problem.source->chain.robot;
  const auto at = [&](const ProblemObservation& o) -> const ObservationState& {
    return problem.source->states[static_cast<std::size_t>(o.index)];
  };
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (!joint.moves()) continue;
    const auto i = static_cast<Eigen::Index>(j);
    const bool slides = joint.kind == JointKind::prismatic;
    add(
        VariableKind::angle, static_cast<int>(j),
        slides ? message("position of {}", joint.name) : message("angle of {}", joint.name), slides ? "m" : "rad",
        slides ? 0.02 : 0.1, problem, [&](const auto& o) { return at(o).sensor[i]; }, list,
        "q_" + formula_name(joint.name));
    add(
        VariableKind::torque, static_cast<int>(j), message("gravity torque at {}", joint.name), slides ? "N" : "N m",
        0.05, problem, [&](const auto& o) { return o.motion.torques[i]; }, list, "tau_" + formula_name(joint.name));
    if (!joint.is_mimic())
      add(
          VariableKind::approach, static_cast<int>(j), message("direction in which {} last moved", joint.name), "sign",
          0.5, problem, [&](const auto& o) { return at(o).approach[i]; }, list);
  }
  add(
      VariableKind::time, -1, "time", "s", 1e-6, problem, [&](const auto& o) { return at(o).elapsed; }, list, "time");
  add(
      VariableKind::order, -1, "order of the observations", "number", 0.5, problem,
      [&](const auto& o) { return static_cast<double>(at(o).order); }, list);
  const Eigen::Matrix3Xd places = tcp_places(problem);
  if (problem.rig) {
    add(
        VariableKind::image_u, -1, "image column", "px", 1, problem,
        [&](const auto& o) { return project(problem.rig->at(0).camera, middle(problem, u, o)).x(); }, list);
    write_as(VariableKind::image_u, image_formula(problem, places, u.mount_from_sensor, 0), list);
    add(
        VariableKind::image_v, -1, "image row", "px", 1, problem,
        [&](const auto& o) { return project(problem.rig->at(0).camera, middle(problem, u, o)).y(); }, list);
    write_as(VariableKind::image_v, image_formula(problem, places, u.mount_from_sensor, 1), list);
  }
  add(
      VariableKind::depth, -1, "distance from the sensor", "m", 1e-3, problem,
      [&](const auto& o) { return problem.rig ? middle(problem, u, o).z() : middle(problem, u, o).norm(); }, list);
  write_as(VariableKind::depth, distance_formula(problem, places, u.mount_from_sensor), list);
  return list;
}

}  // namespace handsight
