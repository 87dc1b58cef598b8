// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison.h"

#include "base/error.h"
#include "base/text.h"
#include "compare/change_verdict.h"
#include "compare/number_changes.h"
#include "compare/touch_numbers.h"
#include "diagnosis/ranking/outlier_rejection.h"

namespace handsight {
namespace {

void require_alike(const Session& a, const Session& b) {
  const auto refuse_pair = [](const Message& what) {
    throw InputError(
        message("The two cannot be compared: {}; name two sessions of one robot, sensor and marker body.", what));
  };
  for (const Session* s : {&a, &b})
    if (!s->parts.empty() && !s->is_touch())
      refuse_pair("one of them is several sessions, which `handsight-cli compare COLLECTION` compares with each other");
  if (a.is_tracker() != b.is_tracker()) refuse_pair("one has cameras, the other a tracker");
  if (a.rig && camera_names(*a.rig) != camera_names(*b.rig)) refuse_pair("their cameras have other names");
  if (a.marker_count != b.marker_count)
    refuse_pair(message("one has {} markers, the other {}", a.marker_count, b.marker_count));
  if (a.tcp != b.tcp || a.mount.link != b.mount.link) refuse_pair("TCP or mount are other links");
  if (a.joints != b.joints) refuse_pair("their joints are others, or in another order");
  if (a.robot.joints.size() != b.robot.joints.size()) refuse_pair("their robots are others");
  for (std::size_t j = 0; j < a.robot.joints.size(); ++j)
    if (a.robot.joints[j].name != b.robot.joints[j].name) refuse_pair("their robots are others");
}

/// The mount part of every fit of both, or of none: where one session only guesses it, the other's is a guess too.
void share_mount(Session& a, Session& b) {
  if (a.mount.estimate == b.mount.estimate) return;
  Session& known = a.mount.estimate ? b : a;
  known.mount.estimate = true;
}

/// What is no answer cannot have changed.
void require_answer(const CleanFit& clean, const char* which) {
  if (clean.fit.converged()) return;
  throw InputError(
      message("The two cannot be compared: the fit of the {} session finds no answer; run `handsight-cli fit` on it, "
              "exclude the observations that it says stand out, and compare again.",
              which));
}

/// The same numbers to the last bit, as one calibration gives them.
bool are_alike(const Rig& a, const Rig& b) {
  for (int c = 0; c < a.count(); ++c) {
    if (!(a.at(c).camera_from_first.translation - b.at(c).camera_from_first.translation).isZero(0)) return false;
    for (const CameraNumber& n : camera_numbers(a.at(c).camera))
      if (a.at(c).camera.*n.value != b.at(c).camera.*n.value) return false;
  }
  return true;
}

std::vector<NumberChange> list_numbers(const Session& session, const Session& second, const Fit& a, const Fit& b) {
  std::vector<NumberChange> all;
  const bool are_touches = session.is_touch() && second.is_touch();
  if (are_touches)
    all = list_touch_numbers(session, second, a, b);
  else
    add_motion(all, "tcp_from_body", a.tcp_from_body, b.tcp_from_body, a.covariance + b.covariance);
  if (session.mount.estimate && !are_touches) {
    const auto block = [](const Fit& f) -> Matrix6 {
      return f.parameter_covariance.block<6, 6>(f.problem.mount_column(), f.problem.mount_column());
    };
    add_motion(all, "mount_from_sensor", estimate(a).mount_from_sensor, estimate(b).mount_from_sensor,
               block(a) + block(b));
  }
  const auto variances = [](const Fit& f) -> Eigen::VectorXd {
    return f.model_covariance.diagonal().tail(f.model_covariance.cols() - 6);
  };
  add_effects(all, session.robot, list_terms(a), variances(a), list_terms(b), variances(b));
  return all;
}

}  // namespace

Comparison compare(const Session& first, const Session& second, const std::vector<EffectTerm>& effects,
                   const ComparisonProgress& progress) {
  require_alike(first, second);
  Session a = first, b = second;
  share_mount(a, b);
  FitOptions options;
  options.estimated = effects;
  if (progress) options.on_iteration = [&](int, double, const Unknowns&) { return progress(0); };
  const CleanFit clean_a = fit_without_outliers(a, options);
  keep_going(progress, 0.35);
  const CleanFit clean_b = fit_without_outliers(b, options);
  keep_going(progress, 0.7);
  require_answer(clean_a, "first");
  require_answer(clean_b, "second");
  Comparison c;
  for (const auto* clean : {&clean_a, &clean_b}) {
    if (!clean->lone.empty())
      c.notes.push_back(message("Of the {} session: {}", clean == &clean_a ? "first" : "second",
                                lone_text(clean->lone, a.is_tracker())));
    if (!clean->wrong.empty())
      c.notes.push_back(message("{} single wrong points of the {} session are left out.", clean->wrong.size(),
                                clean == &clean_a ? "first" : "second"));
  }
  if (a.rig && b.rig && !are_alike(*a.rig, *b.rig))
    c.notes.push_back("The sessions name other calibrations of the cameras; each is measured by its own.");
  ComparedSides sides;
  sides.before = make_side(clean_a.fit);
  sides.after = make_side(clean_b.fit);
  sides.start = estimate(clean_a.fit);
  sides.progress = progress;
  c.numbers = list_numbers(a, b, clean_a.fit, clean_b.fit);
  judge(sides, c);
  if (!c.model_fits)
    c.notes.emplace_back(
        "The model misses what both sessions measured. What the catalogue has and smooth curves of the joints' angles, "
        "the same in both, were fitted beside the change; a change that looks like them is not seen.");
  std::vector<Eigen::VectorXd> poses = used_positions(a);
  for (const Eigen::VectorXd& q : used_positions(b)) poses.push_back(q);
  measure_hand(make_chain(a), poses, list_terms(clean_a.fit), clean_a.fit.tcp_from_body, c);
  return c;
}

}  // namespace handsight
