// SPDX-License-Identifier: Apache-2.0
#include "certify/attained.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/error.h"
#include "certify/seen_hand.h"
#include "estimation/fit/fit.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/hand_end.h"
#include "estimation/report/regions.h"

namespace handsight {
namespace {

/// Is the term an error of what is measured with, not of the robot?
bool is_of_measurement(const EffectTerm& term) {
  static const std::set<std::string> ids{"camera_mount", "stereo_rig",  "rig",           "camera_intrinsics",
                                         "mount_drift",  "mount_slip",  "body_slip",     "lens_distortion",
                                         "marker_slip",  "target_bend", "tag_placement", "target_scale"};
  const Effect& effect = term_effect(term);
  if (!effect.definition) return ids.contains(term.id);
  return std::all_of(effect.definition->moves.begin(), effect.definition->moves.end(), [&](const DefinedMove& m) {
    return effect.scope == EffectScope::marker || m.site.starts_with("body_") || m.site.starts_with("mount_");
  });
}

FitOptions without_robot_effects(FitOptions options) {
  const auto moves_robot = [](const EffectTerm& t) { return !is_of_measurement(t); };
  std::erase_if(options.effects, moves_robot);
  std::erase_if(options.estimated, moves_robot);
  options.start.reset();
  return options;
}

/// The session with only these observations counted; all keep their places in time.
Session with_only(const Session& session, const std::vector<char>& counts) {
  Session part = session;
  for (std::size_t i = 0; i < part.observations.size(); ++i)
    if (!counts[i] && is_used(part.observations[i])) part.observations[i].decision = Decision::excluded;
  return part;
}

/// The hand of an observation in a fit's eyes: where its model has it, how far from there it was measured, and the
/// covariance of that measurement.
struct MeasuredHand {
  Rigid predicted, measured;
  bool shows_turn = true;
  Matrix3 noise = Matrix3::Zero();  // m^2, root axes
};

Rigid root_from_sensor(const ProblemObservation& o, const Unknowns& u) {
  return o.root_from_mount * find_mount(o, u) * o.sensor_motion;
}

/// By its markers' points alone, where they do not show a pose: shifted, not turned.
std::optional<MeasuredHand> shifted_hand(const Fit& fit, const ProblemObservation& o, bool of_mount) {
  const Unknowns& u = estimate(fit);
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u), sensor = root_from_sensor(o, u);
  Vector3 shift = Vector3::Zero();
  int points = 0;
  for (const Sighting& s : o.sightings) {
    if (!s.point || s.along) continue;
    shift += *s.point - sensor_from_tcp * marker_at(o, u, s.marker);
    ++points;
  }
  if (points == 0) return std::nullopt;
  MeasuredHand hand;
  hand.predicted = hand.measured = of_mount ? o.root_from_mount : o.root_from_tcp;
  hand.measured.translation += (of_mount ? -1.0 : 1.0) / points * (sensor.rotation * shift);
  hand.shows_turn = false;
  if (fit.noise) hand.noise = *fit.noise * *fit.noise / points * Matrix3::Identity();
  return hand;
}

std::optional<MeasuredHand> measured_hand(const Fit& fit, const Problem& images, const ProblemObservation& o,
                                          bool of_mount) {
  const Unknowns& u = estimate(fit);
  const auto deviation = tcp_deviation(images, o, u);
  if (!deviation) return shifted_hand(fit, o, of_mount);
  const double variance = fit.noise ? *fit.noise * *fit.noise : 0.0;
  MeasuredHand hand;
  Matrix6 covariance = variance * deviation->unit_covariance;
  if (!of_mount) {
    hand.predicted = o.root_from_tcp;
    hand.measured = o.root_from_tcp * deviation->tcp_from_tcp_est;
  } else {
    // The hand errs by E where the target seems to by D: E mount_from_tcp D = mount_from_tcp.
    const Rigid mount_from_tcp = inverse(o.root_from_mount) * o.root_from_tcp;
    hand.predicted = o.root_from_mount;
    hand.measured = o.root_from_mount * mount_from_tcp * inverse(deviation->tcp_from_tcp_est) * inverse(mount_from_tcp);
    const Matrix6 to_mount = adjoint(mount_from_tcp);
    covariance = to_mount * covariance * to_mount.transpose();
  }
  const Matrix3& r = hand.predicted.rotation;
  hand.noise = r * covariance.topLeftCorner<3, 3>() * r.transpose();
  return hand;
}

/// What a fit says of observations that it has not seen, by their index.
std::vector<std::optional<MeasuredHand>> hands_of(const Session& held, const Fit& fit, bool of_mount) {
  Problem images = make_problem(held, make_chain(held), fit.problem.terms);
  images.copy_slip_frames(fit.problem);
  if (!images.terms.empty()) place_observations(images);
  std::vector<std::optional<MeasuredHand>> all(held.observations.size());
  for (const ProblemObservation& o : images.observations)
    all[static_cast<std::size_t>(o.index)] = measured_hand(fit, images, o, of_mount);
  return all;
}

class Folds {
 public:
  Folds(const Session& session, const CertifiedModel& model)
      : session_(session), model_(model), chain_(make_chain(session)), of_mount_(hand_carries_sensor(chain_)) {
    hand_chain_ = of_mount_ ? chain_of_hand(chain_) : chain_;
    states_ = observation_states(session, hand_chain_);
    const Problem images = make_problem(session, chain_);
    const std::vector<int> first = first_of_same_pose(images);
    same_pose_.assign(session.observations.size(), -1);
    for (std::size_t rank = 0; rank < images.observations.size(); ++rank)
      same_pose_[static_cast<std::size_t>(images.observations[rank].index)] = first[rank];
    used_ = static_cast<int>(images.observations.size());
    for (const int pose : same_pose_)
      if (pose >= 0) folds_.insert(fold_of(pose));
  }

  AttainedPoses run(const std::function<bool(double)>& goes_on) {
    if (used_ < 10 || folds_.size() < 2)
      throw InputError(message(
          "A certificate needs ten used observations in different poses, so that some can be held out; the session has "
          "{}. Record more.",
          used_));
    AttainedPoses result;
    for (const int fold : folds_) {
      if (goes_on && !goes_on(static_cast<double>(result.folds) / static_cast<double>(folds_.size()))) break;
      take_fold(fold, result);
      ++result.folds;
    }
    std::sort(result.all.begin(), result.all.end(), [&](const AttainedPose& a, const AttainedPose& b) {
      return session_.observations[static_cast<std::size_t>(a.index)].time <
                 session_.observations[static_cast<std::size_t>(b.index)].time ||
             (session_.observations[static_cast<std::size_t>(a.index)].time ==
                  session_.observations[static_cast<std::size_t>(b.index)].time &&
              a.id < b.id);
    });
    return result;
  }

 private:
  PredictionModel prediction(const Fit& fit) const {
    if (model_.of_file) return *model_.of_file;
    if (of_mount_)
      if (auto of_hand = model_of_hand(fit, model_.model_uncertainty)) return *of_hand;
    return prediction_model(fit, model_.model_uncertainty);
  }

  void take_fold(int fold, AttainedPoses& result) const {
    std::vector<char> trains(session_.observations.size()), held(trains.size());
    for (std::size_t i = 0; i < trains.size(); ++i) {
      held[i] = same_pose_[i] >= 0 && fold_of(same_pose_[i]) == fold;
      trains[i] = same_pose_[i] >= 0 && !held[i];
    }
    const Session training = with_only(session_, trains), test = with_only(session_, held);
    const Fit model = fit(training, model_.options), plain = fit(training, without_robot_effects(model_.options));
    const auto after = hands_of(test, model, of_mount_), before = hands_of(test, plain, of_mount_);
    const PredictionModel promised = prediction(model);
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (!held[i]) continue;
      if (before[i] && after[i])
        result.all.push_back(find_instant_pose(i, *before[i], *after[i], promised));
      else
        ++result.shown_nothing;
    }
  }

  AttainedPose find_instant_pose(std::size_t i, const MeasuredHand& before, const MeasuredHand& after,
                                 const PredictionModel& promised) const {
    AttainedPose p;
    p.id = session_.observations[i].id;
    p.index = static_cast<int>(i);
    p.same_pose = same_pose_[i];
    p.shows_turn = before.shows_turn && after.shows_turn;
    const SeenHand hand = seen_hand(states_[i], promised);
    p.commanded = hand.nominal;
    p.before = moved(p.commanded, before);
    p.after = moved(p.commanded, after);
    p.covariance = hand.covariance + after.noise;
    return p;
  }

  /// The commanded pose with the error that was measured: what is corrected is commanded so that the model is there.
  static Rigid moved(const Rigid& commanded, const MeasuredHand& hand) {
    return {hand.measured.rotation * hand.predicted.rotation.transpose() * commanded.rotation,
            commanded.translation + hand.measured.translation - hand.predicted.translation};
  }

  const Session& session_;
  const CertifiedModel& model_;
  Chain chain_, hand_chain_;
  bool of_mount_;
  std::vector<ObservationState> states_;
  std::vector<int> same_pose_;  // by observation; -1: not used
  std::set<int> folds_;
  int used_ = 0;
};

}  // namespace

AttainedPoses attained_poses(const Session& session, const CertifiedModel& model,
                             const std::function<bool(double done)>& goes_on) {
  return Folds(session, model).run(goes_on);
}

}  // namespace handsight
