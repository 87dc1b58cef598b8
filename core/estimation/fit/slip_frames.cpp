// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/slip_frames.h"

#include <algorithm>
#include <optional>

#include "estimation/fit/fit_parts.h"
#include "estimation/fit/objectives.h"

namespace handsight {
namespace {

bool all_are_seen(const Problem& problem) {
  return std::all_of(problem.marker_is_seen.begin(), problem.marker_is_seen.end(), [](char seen) { return seen != 0; });
}

/// Does a term move the body or its markers on the hand, in the body's own frame?
bool is_slip(const EffectTerm& term, const Chain& chain) {
  const Effect& effect = term_effect(term);
  if (effect.scope == EffectScope::marker) return true;
  if (effect.definition) {
    const std::vector<DefinedMove>& moves = effect.definition->moves;
    return std::any_of(moves.begin(), moves.end(), [](const DefinedMove& m) { return m.site.starts_with("body_"); });
  }
  const auto joints = static_cast<Eigen::Index>(chain.joints.size());
  EffectTerm one = term;
  std::fill(one.values.begin(), one.values.end(), 1.0);
  const Sites sites = moved_sites(states_at(chain, Eigen::VectorXd::Zero(joints)), {one});
  return !sites.body.isZero(0) ||
         std::any_of(sites.markers.begin(), sites.markers.end(), [](const Vector3& m) { return !m.isZero(0); });
}

/// How a frame comes to where the markers have it. What moves markers by s times their distance from the body's origin
/// turns back by s what the frame was turned by, so that a frame that just follows runs away from s = 1 on: a target
/// twice as large as described. The factor of a step is the one that would have brought the last two to the same end
/// (the secant of Irons and Tuck 1969).
class TurnOfFrame {
 public:
  /// The next frame, from one to where the markers have it.
  Rigid next(const Rigid& frame, const Rigid& found) {
    const Vector3 turn = vector_from_rotation(found.rotation * frame.rotation.transpose());
    if (last_) {
      const Vector3 change = turn - *last_;
      const double squares = change.squaredNorm();
      if (squares > 0) factor_ = std::clamp(-factor_ * last_->dot(change) / squares, least, most);
    }
    last_ = turn;
    return {rotation_from_vector<double>(Vector3(factor_ * turn)) * frame.rotation, found.translation};
  }

 private:
  static constexpr double least = 0.2, most = 2;  // of targets five times as large as described, and half as large
  double factor_ = 1;
  std::optional<Vector3> last_;
};

}  // namespace

BodySides make_sides(const FitOptions& options, const Problem& problem, const Unknowns& unknowns) {
  if (options.sides) return *options.sides;
  // As the shape is described: the estimate of a regular one would change its mind between equal sides.
  if (problem.shape && problem.shape->piece_count() == 1 && (problem.shape->sigma || all_are_seen(problem)))
    return choose_sides({problem.shape->markers.begin(), problem.shape->markers.end()});
  return sides_of_body(problem, unknowns.markers_in_tcp, 0);
}

bool has_slip(const Problem& problem) {
  return std::any_of(problem.terms.begin(), problem.terms.end(),
                     [&](const EffectTerm& t) { return is_slip(t, problem.source->chain); });
}

void start_slip_frames(const FitOptions& options, const Unknowns& start, Problem& images) {
  const BodySides sides = make_sides(options, images, start);
  if (!sides.markers.empty()) images.tcp_from_slip = body_frame(sides, start.markers_in_tcp).tcp_from_body;
  set_slip_frames(images, start.markers_in_tcp);
}

void settle_slip_frames(const Session& session, const FitOptions& options, Problem& images, Fit& fit) {
  constexpr int most_passes = 5;
  if (!has_slip(images)) return;
  const bool is_quick = options.least_gain > 0;
  const double still = is_quick ? 1e-6 : 1e-10;  // m, rad
  TurnOfFrame turn;
  // Of a fit that does not come to its end no frame is worth waiting for.
  const auto has_ended = [&] { return fit.solution.converged && !fit.solution.stopped; };
  for (int pass = 0; pass < most_passes && has_ended(); ++pass) {
    const Unknowns& u = fit.solution.unknowns;
    const BodySides sides = make_sides(options, fit.problem, u);
    if (sides.markers.empty()) return;
    const Matrix3 start = options.start_tcp_from_body ? options.start_tcp_from_body->rotation : Matrix3::Identity();
    const Rigid found = body_frame(sides, u.markers_in_tcp, start).tcp_from_body;
    const bool others_moved = set_slip_frames(images, u.markers_in_tcp);
    if (small_motion_between(images.tcp_from_slip, found).norm() < still && !others_moved) return;
    images.tcp_from_slip = turn.next(images.tcp_from_slip, found);
    fit.problem.copy_slip_frames(images);
    set_effects(fit.problem, u.effects);
    if (&images != &fit.problem) set_effects(images, u.effects);
    minimise(session, images, Unknowns(u), options, images.noise, fit);
  }
}

}  // namespace handsight
