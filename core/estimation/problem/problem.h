// SPDX-License-Identifier: Apache-2.0
// What a fit works on: the used observations in order of time, with both ends of their chains as the effects move
// them, and its unknowns: the markers' positions in the TCP frame, the mount and the effects.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "camera/camera_knowledge.h"
#include "effects/effect.h"

namespace handsight {

/// One number of an effect that a fit may move. Its prior is a normal distribution about 0.
struct EffectColumn {
  std::size_t term = 0;       // into Problem::terms
  std::size_t parameter = 0;  // of the effect
  double sigma = 0;           // the prior sigma
  double width = 1;           // of the prior, in prior sigmas (estimation/fit/prior_widths.h)

  double prior_sigma() const { return sigma * width; }
};

/// Directions of effects' columns of one observation, in markers' order; empty where none is.
struct EffectMotion {
  Eigen::Matrix<double, 6, Eigen::Dynamic> tcp_by_effect;     // of the TCP against the mount's link, root frame
  Eigen::Matrix<double, 6, Eigen::Dynamic> sensor_by_effect;  // of the sensor in its own frame; empty: none moves it
  struct MarkerColumn {
    int marker;
    Eigen::Index column;
    Vector3 direction;  // in the TCP frame
  };
  std::vector<MarkerColumn> markers;
  Eigen::Matrix<double, 6, Eigen::Dynamic>
      tcp_by_value;         // ... by the value of every joint of Chain::joints, root frame
  Eigen::VectorXd torques;  // N m (N), of gravity, per joint of the robot
};

struct ProblemObservation {
  int index = 0;  // into Session::observations
  int mount = 0;  // of the session's mounts (chain/chain.h): 0 but in a joined session
  Rigid root_from_tcp;
  Rigid root_from_mount;
  std::vector<Sighting> sightings;
  std::vector<Matrix3> point_covariances;  // per sighting, only where points stand in for images: per unit px^2, m^2
  std::vector<double> weights;             // per sighting; empty: all 1
  bool springs_hold = true;                // false: the springs are too soft for the load
  Rigid sensor_motion;                     // mount_from_sensor * sensor_motion is where the sensor sits
  bool sensor_moves = false;               // sensor_motion is not the identity
  std::vector<Vector3> marker_shifts;      // per marker, m, TCP frame; empty: none
  EffectMotion motion;
  Deflection deflection;  // of the springs; where the next equilibrium starts
};

/// The whole chain of an observation for a mount of the sensor.
inline Rigid sensor_from_tcp_at(const ProblemObservation& o, const Rigid& mount_from_sensor) {
  return inverse(o.root_from_mount * mount_from_sensor * o.sensor_motion) * o.root_from_tcp;
}

/// How far a robot is wrong about its flange, anew in every observation: one standard deviation of each coordinate of
/// its place (m), and of each of the three small turns (rad) in the flange's frame; of a robot with joints, of each
/// joint instead (rad; solvers/flange_error.h).
struct FlangeError {
  double place = 0, turn = 0;

  bool is_any() const { return place > 0 || turn > 0; }
};

/// What the places of the observations follow from; shared by all copies and parts of a problem.
struct ProblemSource {
  Chain chain;
  std::vector<ObservationState> states;  // per observation of the session
  OwnEffects own_effects;                // of the session, beside the catalogue
};

/// How large the robot is as the effects have it, against its description (robot_scale.h).
struct RobotScale {
  std::shared_ptr<const ProblemSource> postures;  // all over the joints' range
  double described = 0;                           // size without effects, m
  double change = 0;                              // ln of the size by that
  Eigen::VectorXd by_effect;                      // of `change`, by the effects' columns
};

/// Two mounts' origins, on one link, are this far apart.
struct MountDistance {
  int of = 0, from = 0;
  double by = 0, sigma = 0;  // m
};

/// A place on a mount's link where the mount's frame has a coordinate of 0: what is known of where a fixture stands.
struct MountPlace {
  int mount = 0;
  Vector3 point, along;  // m, on the link; a unit direction of the mount's frame
  double sigma = 0;      // m
};

struct Problem {
  std::vector<ProblemObservation> observations;
  std::optional<Rig> rig;  // absent: sightings are points
  int marker_count = 0;
  bool mount_is_estimated = false;
  std::vector<char> other_mounts_estimated;  // of a joined session: of the mounts 1, 2 ...
  std::vector<MountDistance> mount_distances;
  std::vector<MountPlace> mount_places;
  std::vector<char> marker_is_seen;  // per marker, in any used observation

  std::shared_ptr<const ProblemSource> source;
  std::vector<EffectTerm> terms;  // the model's effects at their present values
  std::vector<EffectColumn> columns_of_effects;
  Rigid tcp_from_slip;                    // the frame in which slips of the body and its markers are measured
  std::vector<Rigid> other_slip_frames;   // of a joined session: the same of bodies 1, 2 ...; empty: all as the first
  bool with_motions = false;              // EffectMotion is filled even where no effect is estimated
  double noise = 1;                       // px or m: what the priors of the effects are weighed against
  bool noise_is_guessed = false;          // nothing tells it
  FlangeError flange_error;               // part of what is measured (solvers/flange_error.h)
  Eigen::MatrixXd cameras_by_effect;      // rows: the rig's numbers as in camera/rig.h; empty: none
  std::optional<RobotScale> robot_scale;  // only where nothing but the robot tells how long a metre is

  std::shared_ptr<const CameraKnowledge> camera_images;  // what images of a board say of the rig; null: nothing

  std::optional<KnownShape> shape;  // of the markers; its sigma is a prior on how they lie to each other

  bool has_shape_prior() const { return shape && shape->sigma; }

  const Rig* rig_or_null() const { return rig ? &*rig : nullptr; }
  Eigen::Index mount_column() const { return 3 * marker_count; }
  Eigen::Index effect_column() const { return mount_column() + mount_columns(); }
  /// 6 for every mount that is estimated.
  Eigen::Index mount_columns() const {
    Eigen::Index columns = mount_is_estimated ? 6 : 0;
    for (const char is_estimated : other_mounts_estimated) columns += is_estimated ? 6 : 0;
    return columns;
  }
  /// Where the six columns of a mount begin; -1 where it is held.
  Eigen::Index column_of_mount(int mount) const {
    const auto is_free = [&](int i) {
      return i == 0 ? mount_is_estimated : other_mounts_estimated[static_cast<std::size_t>(i - 1)] != 0;
    };
    if (!is_free(mount)) return -1;
    Eigen::Index column = mount_column();
    for (int i = 0; i < mount; ++i) column += is_free(i) ? 6 : 0;
    return column;
  }
  const Rigid& slip_frame(int body) const {
    return body == 0 || other_slip_frames.empty() ? tcp_from_slip
                                                  : other_slip_frames[static_cast<std::size_t>(body - 1)];
  }
  void copy_slip_frames(const Problem& other) {
    tcp_from_slip = other.tcp_from_slip;
    other_slip_frames = other.other_slip_frames;
  }
  int mount_count() const { return 1 + static_cast<int>(other_mounts_estimated.size()); }
  Eigen::Index effect_count() const { return static_cast<Eigen::Index>(columns_of_effects.size()); }
  /// Columns of the normal equations: 3 a marker, 6 for every mount that is estimated, the effects' numbers.
  Eigen::Index columns() const { return effect_column() + effect_count(); }
};

/// The used observations of a session in order of time (then id), whatever the order in memory. `held` effects move
/// the chain at their values; `estimated` ones start at theirs, and their numbers, but for those that
/// are held one by one, become columns.
Problem make_problem(const Session& session, const Chain& chain, const std::vector<EffectTerm>& held = {},
                     const std::vector<EffectTerm>& estimated = {});

/// Problem::marker_is_seen by what the shape says: a marker has a place as soon as a point of its piece is seen.
void place_unseen(Problem& problem);

/// The values of the problem's effect columns.
Eigen::VectorXd effect_values(const Problem& problem);

/// Gives the effects these values, without moving the observations there.
void set_effect_values(Problem& problem, const Eigen::VectorXd& values);

/// Moves all observations to where the effects have these values (and finds the derivatives there).
void set_effects(Problem& problem, const Eigen::VectorXd& values);

/// The same, but the derivatives stay those of where the observations were: for small moves, at a fifth of the time.
void follow_effects(Problem& problem, const Eigen::VectorXd& values);

/// Holds all effects where they are: no columns are left.
void hold_effects(Problem& problem);

/// Moves them again after terms, columns or the slip's frame were changed.
void place_observations(Problem& problem);

/// The problem with EffectMotion filled: how joints move the TCP, torques.
Problem with_motions(const Problem& problem);

/// The same with every marker that two cameras or more saw as a triangulated point, for the 3D objective (thesis
/// 4.41). Markers seen by one camera only cannot take part: `left_out` counts them.
Problem as_points(const Problem& problem, int& left_out);

/// The unknowns: markers in the TCP frame (m), the mount, and the effects' numbers.
struct Unknowns {
  std::vector<Vector3> markers_in_tcp;
  Rigid mount_from_sensor;
  Eigen::VectorXd effects;
  std::vector<Rigid> other_mounts = {};  // of a joined session: mount_from_sensor of its mounts 1, 2 ...

  const Rigid& mount(int i) const { return i == 0 ? mount_from_sensor : other_mounts[static_cast<std::size_t>(i - 1)]; }
  Rigid& mount(int i) { return i == 0 ? mount_from_sensor : other_mounts[static_cast<std::size_t>(i - 1)]; }
};

/// mount_from_sensor of what watched in an observation.
inline const Rigid& find_mount(const ProblemObservation& o, const Unknowns& u) { return u.mount(o.mount); }

/// The whole chain of an observation at these unknowns.
inline Rigid sensor_from_tcp_at(const ProblemObservation& o, const Unknowns& u) {
  return sensor_from_tcp_at(o, find_mount(o, u));
}

/// Where a marker sits in one observation (m, TCP frame): slips included.
inline Vector3 marker_at(const ProblemObservation& o, const Unknowns& u, int marker) {
  const auto m = static_cast<std::size_t>(marker);
  return o.marker_shifts.empty() ? u.markers_in_tcp[m] : Vector3(u.markers_in_tcp[m] + o.marker_shifts[m]);
}

/// All of them.
inline std::vector<Vector3> markers_at(const ProblemObservation& o, const Unknowns& u) {
  std::vector<Vector3> markers = u.markers_in_tcp;
  for (std::size_t m = 0; m < o.marker_shifts.size(); ++m) markers[m] += o.marker_shifts[m];
  return markers;
}

}  // namespace handsight
