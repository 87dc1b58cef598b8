// SPDX-License-Identifier: Apache-2.0
#include "ways/comparison.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.h"
#include "base/text.h"
#include "diagnosis/clean_model.h"
#include "diagnosis/weighing.h"
#include "effects/own_effect.h"
#include "ways/change_fit.h"

namespace handsight {
namespace {

constexpr double ln_20 = 2.995732273553991;

void require_alike(const Session& a, const Session& b) {
  const auto refuse_pair = [](const std::string& what) {
    throw InputError("The two cannot be compared: " + what +
                     "; name two sessions of one robot, sensor and marker body.");
  };
  if (a.is_tracker() != b.is_tracker()) refuse_pair("one has cameras, the other a tracker");
  if (a.rig && camera_names(*a.rig) != camera_names(*b.rig)) refuse_pair("their cameras have other names");
  if (a.marker_count != b.marker_count)
    refuse_pair(fmt::format("one has {} markers, the other {}", a.marker_count, b.marker_count));
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

/// The same numbers to the last bit, as one calibration gives them.
bool are_alike(const Rig& a, const Rig& b) {
  for (int c = 0; c < a.count(); ++c) {
    if (!(a.at(c).camera_from_first.translation - b.at(c).camera_from_first.translation).isZero(0)) return false;
    for (const CameraNumber& n : camera_numbers(a.at(c).camera))
      if (a.at(c).camera.*n.value != b.at(c).camera.*n.value) return false;
  }
  return true;
}

double weight_of(const Fit& f) { return 1 / weighing(f).noise; }

void add_number(std::vector<NumberChange>& all, std::string name, const char* unit, double before, double after,
                double variance) {
  all.push_back({std::move(name), unit, before, after, std::sqrt(std::max(0.0, variance))});
}

/// The six numbers of a motion, as what is between the two.
void add_motion(std::vector<NumberChange>& all, const std::string& name, const Rigid& a, const Rigid& b,
                const Matrix6& covariance) {
  const Vector3 turn = vector_from_rotation(b.rotation * a.rotation.transpose());
  for (int i = 0; i < 3; ++i)
    add_number(all, name + " " + motion_axes[i], "m", a.translation[i], b.translation[i], covariance(i, i));
  for (int i = 0; i < 3; ++i)
    add_number(all, name + " " + motion_axes[i + 3], "rad", 0, turn[i], covariance(i + 3, i + 3));
}

void add_effects(std::vector<NumberChange>& all, const Robot& robot, const std::vector<EffectTerm>& a,
                 const Eigen::VectorXd& variance_a, const std::vector<EffectTerm>& b,
                 const Eigen::VectorXd& variance_b) {
  Eigen::Index first_a = 0;
  for (const EffectTerm& t : a) {
    Eigen::Index first_b = 0;
    for (const EffectTerm& o : b) {
      if (o.id == t.id && o.joint == t.joint)
        for (std::size_t p = 0; p < t.values.size(); ++p) {
          const Effect& e = effect_of(t);
          const std::string where = place_name(e, t.joint, robot);
          const auto i = static_cast<Eigen::Index>(p);
          if (!e.parameters[p].is_choice)
            add_number(all, fmt::format("{}{}: {}", t.id, where.empty() ? "" : " of " + where, e.parameters[p].name),
                       e.parameters[p].unit.c_str(), t.values[p], o.values[p],
                       variance_a[first_a + i] + variance_b[first_b + i]);
        }
      first_b += static_cast<Eigen::Index>(o.values.size());
    }
    first_a += static_cast<Eigen::Index>(t.values.size());
  }
}

std::vector<NumberChange> numbers_of(const Session& session, const Fit& a, const Fit& b) {
  std::vector<NumberChange> all;
  add_motion(all, "tcp_from_body", a.tcp_from_body, b.tcp_from_body, a.covariance + b.covariance);
  if (session.mount.estimate) {
    const auto block = [](const Fit& f) -> Matrix6 {
      return f.parameter_covariance.block<6, 6>(f.problem.mount_column(), f.problem.mount_column());
    };
    add_motion(all, "mount_from_sensor", estimate(a).mount_from_sensor, estimate(b).mount_from_sensor,
               block(a) + block(b));
  }
  const auto variances = [](const Fit& f) -> Eigen::VectorXd {
    return f.model_covariance.diagonal().tail(f.model_covariance.cols() - 6);
  };
  add_effects(all, session.robot, terms_of(a), variances(a), terms_of(b), variances(b));
  return all;
}

const char* rest_text(const std::string& id) {
  if (id == "camera_mount" || id == "stereo_rig" || id == "lens") return "arm and hand are as they were";
  if (id == "body_slip" || id == "marker_slip") return "arm and cameras are as they were";
  return "cameras and markers are as they were";
}

/// What the change's own size is: the first of a unit with the same name.
ChangeUnit unit_of(const Change& c) { return {c.id, c.terms, c.where.empty() ? "" : c.where.front()}; }

void judge(const ComparedSides& sides, Comparison& c) {
  const RankedChanges first = ranked_changes(sides, {});
  c.changes = first.changes;
  c.threshold = first.threshold;
  c.model_fits = first.scatter.isZero(0);
  const bool is_tracker = !sides.after.problem.rig.has_value();
  if (c.changes.empty() || c.changes.front().ln_bayes_factor < c.threshold) {
    c.verdict = ComparisonVerdict::unchanged;
    c.sentence = "Nothing has changed that these poses show: cameras, hand and arm are as they were.";
    return;
  }
  const Change& best = c.changes.front();
  for (std::size_t i = 1; i < c.changes.size(); ++i)
    if (c.changes[i].ln_bayes_factor > best.ln_bayes_factor - ln_20) c.cannot_be_told_from.push_back(c.changes[i].id);
  ComparedSides with_scatter = sides;
  with_scatter.scatter = first.scatter;
  const RankedChanges second = ranked_changes(with_scatter, best.terms);
  const bool several = !second.changes.empty() && second.changes.front().ln_bayes_factor >= c.threshold + ln_20;
  c.verdict = several ? ComparisonVerdict::several : ComparisonVerdict::changed;
  c.sentence = change_text(unit_of(best), best.terms, best.sigma, is_tracker);
  if (several)
    c.sentence += fmt::format("; and more than one thing has changed: {} too, or something that is not in the list.",
                              second.changes.front().id);
  else if (!c.cannot_be_told_from.empty())
    c.sentence +=
        fmt::format("; or it is {}, which these poses do not tell apart.", fmt::join(c.cannot_be_told_from, " or "));
  else
    c.sentence += fmt::format("; {}.", rest_text(best.id));
}

/// How far the best change moves the body against the robot's root, over these poses.
void measure_hand(const Chain& chain, const std::vector<Eigen::VectorXd>& poses, const std::vector<EffectTerm>& effects,
                  const Rigid& tcp_from_body, Comparison& c) {
  if (poses.empty()) return;
  std::vector<EffectTerm> changed = effects;
  if (c.verdict != ComparisonVerdict::unchanged)
    changed.insert(changed.end(), c.changes.front().terms.begin(), c.changes.front().terms.end());
  double sum = 0, largest = 0;
  for (const Eigen::VectorXd& pose : poses) {
    const Circumstances here = circumstances_at(chain, pose);
    const auto body = [&](const std::vector<EffectTerm>& terms) -> Vector3 {
      const Sites sites = moved_sites(here, terms);
      return (observed_ends(here, sites).ends.root_from_tcp * tcp_from_body * small_motion<double>(sites.body))
          .translation;
    };
    const double way = (body(changed) - body(effects)).norm();
    sum += way;
    largest = std::max(largest, way);
  }
  c.hand_mean_m = sum / static_cast<double>(poses.size());
  c.hand_max_m = largest;
}

std::vector<Eigen::VectorXd> used_positions(const Session& s) {
  std::vector<Eigen::VectorXd> all;
  for (const Observation& o : s.observations)
    if (is_used(o)) all.push_back(o.position);
  return all;
}

/// The inverse of a covariance; what has none in it is held.
Eigen::MatrixXd precision_of(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd sizes = covariance.diagonal().cwiseMax(1e-18).cwiseSqrt();
  Eigen::MatrixXd scaled = sizes.cwiseInverse().asDiagonal() * covariance * sizes.cwiseInverse().asDiagonal();
  scaled.diagonal().array() += 1e-9;
  const Eigen::MatrixXd inverse = scaled.ldlt().solve(Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols()));
  return sizes.cwiseInverse().asDiagonal() * inverse * sizes.cwiseInverse().asDiagonal();
}

}  // namespace

Comparison compare(const Session& first, const Session& second, const std::vector<EffectTerm>& effects) {
  require_alike(first, second);
  Session a = first, b = second;
  share_mount(a, b);
  FitOptions options;
  options.estimated = effects;
  const CleanFit clean_a = clean_model(a, options), clean_b = clean_model(b, options);
  Comparison c;
  for (const auto* clean : {&clean_a, &clean_b})
    if (!clean->wrong.empty())
      c.notes.push_back(fmt::format("{} single wrong points of the {} session are left out.", clean->wrong.size(),
                                    clean == &clean_a ? "first" : "second"));
  if (a.rig && b.rig && !are_alike(*a.rig, *b.rig))
    c.notes.push_back("The sessions name other calibrations of the cameras; each is measured by its own.");
  ComparedSides sides;
  sides.before = ComparedSide{clean_a.fit.problem, weight_of(clean_a.fit)};
  sides.after = {clean_b.fit.problem, weight_of(clean_b.fit)};
  sides.start = estimate(clean_a.fit);
  c.numbers = numbers_of(a, clean_a.fit, clean_b.fit);
  judge(sides, c);
  if (!c.model_fits)
    c.notes.push_back(
        "The model misses what both sessions measured: what it lacks in both may be told as a change. Improve it first "
        "and "
        "name its effects with --effects.");
  std::vector<Eigen::VectorXd> poses = used_positions(a);
  for (const Eigen::VectorXd& q : used_positions(b)) poses.push_back(q);
  measure_hand(chain_of(a), poses, terms_of(clean_a.fit), clean_a.fit.tcp_from_body, c);
  return c;
}

Comparison compare(const CalibratedRobot& before, const Session& after) {
  Session session = after;
  session.marker_count = std::max(session.marker_count, static_cast<int>(before.calibration.markers.size()));
  if (session.tcp != before.tcp || session.mount.link != before.mount || session.joints != before.joint_names)
    throw InputError(
        "The session's TCP, mount or joints are not those of the calibration; name a session of the same robot.");
  if (static_cast<int>(before.calibration.markers.size()) < session.marker_count)
    throw InputError(
        fmt::format("The session has {} markers, the calibration {}; name a session with the same marker body.",
                    session.marker_count, before.calibration.markers.size()));
  if (!before.model.mount_from_sensor && session.mount.estimate && !session.mount.known)
    throw InputError("Neither the calibration nor the session says where the sensor sits: a few poses cannot tell it.");
  const bool mount_is_estimated = before.calibration.mount_from_sensor.has_value();
  session.mount.estimate = mount_is_estimated;
  if (before.model.mount_from_sensor) session.mount.mount_from_sensor = *before.model.mount_from_sensor;
  const Chain chain = chain_of(session);
  ComparedSides sides;
  sides.after.problem = make_problem(session, chain, {}, before.model.effects);
  sides.after.weight =
      1 / (session.is_tracker() ? session.sigma_point.value_or(before.calibration.fit.noise_m.value_or(2e-4))
                                : session.sigma_pixel.value_or(before.calibration.fit.noise_pixel.value_or(0.2)));
  for (const Vector3& m : before.calibration.markers)
    sides.start.markers_in_tcp.push_back(before.model.tcp_from_body * m);
  sides.start.mount_from_sensor = session.mount.mount_from_sensor;
  sides.start.effects = effect_values(sides.after.problem);
  // Columns: xi, mount, effects in plausible sizes; choices have none.
  const Problem& p = sides.after.problem;
  std::vector<Eigen::Index> kept{0, 1, 2, 3, 4, 5};
  Eigen::Index number = 6;
  for (const EffectTerm& t : before.model.effects)
    for (std::size_t i = 0; i < t.values.size(); ++i, ++number)
      if (!effect_of(t).parameters[i].is_choice) kept.push_back(number);
  Eigen::MatrixXd covariance = before.model.covariance(kept, kept);
  for (Eigen::Index e = 0; e < p.effect_count(); ++e) {
    const double size = p.columns_of_effects[static_cast<std::size_t>(e)].sigma;
    covariance.row(6 + e) /= size;
    covariance.col(6 + e) /= size;
  }
  const Eigen::Index mount = mount_is_estimated ? 6 : 0, count = covariance.rows() + mount;
  Eigen::MatrixXd known = Eigen::MatrixXd::Zero(count, count);
  known.topLeftCorner(6, 6) = covariance.topLeftCorner(6, 6);
  if (mount > 0) known.block(6, 6, 6, 6) = before.calibration.mount_from_sensor->covariance;
  const Eigen::Index numbers = covariance.rows() - 6;
  known.bottomRightCorner(numbers, numbers) = covariance.bottomRightCorner(numbers, numbers);
  known.topRightCorner(6, numbers) = covariance.topRightCorner(6, numbers);
  known.bottomLeftCorner(numbers, 6) = covariance.bottomLeftCorner(numbers, 6);
  sides.known = precision_of(known);
  // The scatter is told in the TCP's axes, at its origin; here it is that of the body against the sensor.
  if (!p.observations.empty() && !before.model.scatter.covariance.isZero(0)) {
    const Matrix6 there = adjoint(sensor_from_tcp_at(p.observations.front(), sides.start.mount_from_sensor));
    sides.scatter = there * before.model.scatter.covariance * there.transpose();
  }
  Comparison c;
  if (p.observations.empty())
    throw InputError("The session has no observation with markers that can be used; label some poses.");
  judge(sides, c);
  measure_hand(chain, used_positions(session), before.model.effects, before.model.tcp_from_body, c);
  return c;
}

Comparison compare(const CalibratedRobot& before, const CalibratedRobot& after) {
  if (before.tcp != after.tcp || before.joint_names != after.joint_names)
    throw InputError("The calibrations are of other links or joints; name two of one robot.");
  Comparison c;
  add_motion(c.numbers, "tcp_from_body", before.model.tcp_from_body, after.model.tcp_from_body,
             before.calibration.tcp_from_body.covariance + after.calibration.tcp_from_body.covariance);
  if (before.calibration.mount_from_sensor && after.calibration.mount_from_sensor)
    add_motion(c.numbers, "mount_from_sensor", before.calibration.mount_from_sensor->motion,
               after.calibration.mount_from_sensor->motion,
               before.calibration.mount_from_sensor->covariance + after.calibration.mount_from_sensor->covariance);
  const auto variances = [](const CalibratedRobot& r) -> Eigen::VectorXd {
    return r.model.covariance.diagonal().tail(r.model.covariance.cols() - 6);
  };
  add_effects(c.numbers, before.chain.robot, before.model.effects, variances(before), after.model.effects,
              variances(after));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-0.8, 0.8);
  double sum = 0, largest = 0;
  constexpr int poses = 200;
  for (int i = 0; i < poses; ++i) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(before.chain.joints.size()));
    for (std::size_t j = 0; j < before.chain.joints.size(); ++j) {
      const Joint& joint = before.chain.robot.joints[static_cast<std::size_t>(before.chain.joints[j])];
      const double low = std::max(joint.lower, -3.0), high = std::min(joint.upper, 3.0);
      q[static_cast<Eigen::Index>(j)] = 0.5 * (low + high) + 0.5 * (high - low) * uniform(random);
    }
    const auto body = [&](const CalibratedRobot& r) {
      return predict_tcp(r.chain, q, r.model).root_from_body_est.translation;
    };
    const double way = (body(after) - body(before)).norm();
    sum += way / poses;
    largest = std::max(largest, way);
  }
  c.hand_mean_m = sum;
  c.hand_max_m = largest;
  double most = 0;
  for (const NumberChange& n : c.numbers) {
    if (std::abs(n.in_sigmas()) <= most) continue;
    most = std::abs(n.in_sigmas());
    c.sentence = fmt::format(
        "Most of all {} has changed, by {:.1f} of its sigma; the marker body is {:.2f} mm from where it "
        "was (mean over {} poses).",
        n.name, most, 1e3 * sum, poses);
  }
  // Of many numbers the largest is beyond 3.5 sigma once in a hundred times by chance.
  c.verdict = most > 4 ? ComparisonVerdict::changed : ComparisonVerdict::unchanged;
  if (c.verdict == ComparisonVerdict::unchanged)
    c.sentence = fmt::format(
        "No number differs by more than {:.1f} of its sigma; the marker body is {:.2f} mm from where it "
        "was (mean over {} poses).",
        most, 1e3 * sum, poses);
  c.notes.push_back("Two calibrations tell which numbers differ, not why; compare the sessions for what changed.");
  return c;
}

}  // namespace handsight
