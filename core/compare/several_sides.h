// SPDX-License-Identifier: Apache-2.0
// Several sessions side by side for a comparison: each its own problem, and which columns of them are one. Internal to
// several_comparison.cpp.
#pragma once

#include "compare/shared_model.h"
#include "session/joined.h"

namespace handsight {

/// To what a number belongs, and so which sessions have it in common.
enum class Owner { robot, rig, body, session };
Owner find_owner(const Effect& effect);

struct SeveralSide : ComparedSide {
  int rig = 0, body = 0;              // sessions with the same number have the same
  int hand = 0;                       // ... the same joints, TCP and mount: curves of the joints' angles describe these
  std::vector<Eigen::Index> effects;  // of its effect columns: which of SeveralSides::effects each is
  std::vector<SharedCurve> curves;
  Eigen::Index first_curve = 0;  // of theirs among all curves' columns

  int number(Owner owner) const { return owner == Owner::rig ? rig : owner == Owner::body ? body : 0; }
};

/// One number of an effect that sessions have in common.
struct CommonEffect {
  std::string id;
  std::size_t parameter = 0;
  double size = 0;          // plausible
  bool is_lacking = false;  // not of the model as it was given
};

/// Where all unknowns stand.
struct SeveralState {
  std::vector<std::vector<Vector3>> markers;  // by body, m, TCP frame
  std::vector<Rigid> mounts;                  // by rig
  Eigen::VectorXd effects;                    // in their units
  Eigen::VectorXd curves;                     // in their prior sigmas
};

/// Columns of all: the markers of each body, the mounts that are estimated, effects, curves.
struct SeveralSides {
  std::vector<SeveralSide> sides;
  SeveralState start;
  std::vector<char> mount_is_estimated;  // by rig
  std::vector<CommonEffect> effects;
  Eigen::VectorXd effect_scales, curve_scales;  // sizes by the plausible ones
  std::vector<Matrix6> repeatability;           // by rig: of the body in the sensor's frame
  bool is_wide = false;                         // what the model may lack is among its effects and curves
  std::function<bool(double share)> progress;   // ComparisonProgress

  Eigen::Index first_marker(int body) const;
  Eigen::Index first_mount(int rig) const;
  Eigen::Index first_effect() const;
  Eigen::Index columns() const;
};

/// Sessions that were fitted by themselves. Members with the same rig="" have one mount, with the same body="" one
/// body.
SeveralSides several_sides(const std::vector<JoinedMember>& members, const std::vector<Fit>& fits);

/// The same with everything of the catalogue that may be there in all of them, at 0, and smooth curves.
SeveralSides widened(const SeveralSides& sides, Width width);

/// A column of one side as a column of all: one unit there is `times` units here.
struct ColumnPlace {
  Eigen::Index column = 0;
  double times = 1;
};
/// Of the shared columns of one side, in the order of change_rows.
std::vector<ColumnPlace> list_columns(const SeveralSides& sides, const SeveralSide& side);

/// The unknowns of one side.
SharedState read_state(const SeveralSide& side, const SeveralState& state);

/// Where the unknowns go by a step of the columns of all.
SeveralState moved_by(const SeveralSides& sides, const SeveralState& from, const Eigen::VectorXd& step);

/// Adds what is known of effects and curves beforehand.
void add_priors(const SeveralSides& sides, const SeveralState& state, ScatteredNormal& normal);

/// Sizes of what is lacking as the measurements have them. `normal`: with priors.
void learn_sizes(SeveralSides& sides, const SeveralState& state, const ScatteredNormal& normal);

}  // namespace handsight
