// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/prediction.h"

#include <Eigen/Eigenvalues>

#include "base/numbers.h"
#include "effects/own_effect.h"
#include "effects/rig_effects.h"
#include "effects/term_numbers.h"
#include "estimation/report/fit_report.h"
#include "estimation/solvers/covariance_factor.h"

namespace handsight {
namespace {

/// The nearest matrix without negative eigenvalues: a difference of two estimated covariances may have some, however
/// exactly it is made, so that no factor is there to begin with. Made of a factor, its rounding adds none again.
Matrix6 without_negative(const Matrix6& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(symmetric);
  return covariance_from(eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal());
}

Rigid root_from_tcp_with(const ObservationState& c, const std::vector<EffectTerm>& effects) {
  return observed_ends(c, moved_sites(c, effects)).ends.root_from_tcp;
}

}  // namespace

namespace {

/// A deviation of the TCP as one observation measured it, and the covariance of that measurement.
struct MeasuredDeviation {
  Vector6 value;
  Matrix6 noise;
};

using ToFrame = std::function<Matrix6(const ProblemObservation&)>;

std::vector<MeasuredDeviation> measured_deviations(const Fit& fit, const ToFrame& to_frame) {
  std::vector<MeasuredDeviation> all;
  const double variance = fit.noise ? *fit.noise * *fit.noise : 0.0;
  for (const ProblemObservation& o : fit.problem.observations) {
    const auto deviation = tcp_deviation(fit.problem, o, estimate(fit));
    if (!deviation) continue;
    MeasuredDeviation& m = all.emplace_back();
    m.value << deviation->tcp_from_tcp_est.translation, vector_from_rotation(deviation->tcp_from_tcp_est.rotation);
    m.noise = variance * deviation->unit_covariance;
    if (!to_frame) continue;
    const Matrix6 there = to_frame(o);
    m.value = there * m.value;
    m.noise = there * m.noise * there.transpose();
  }
  return all;
}

/// The covariance of deviations that were measured with noise of their own, by expectation and maximisation from the
/// moments: the observations that know a direction well tell most about it.
Matrix6 covariance_behind(const std::vector<MeasuredDeviation>& all) {
  constexpr int rounds = 30;
  constexpr std::size_t most = 200;  // more would not change what is used of it
  const std::size_t stride = (all.size() + most - 1) / most;
  Matrix6 measured = Matrix6::Zero(), noise = Matrix6::Zero();
  for (const MeasuredDeviation& m : all) {
    measured += m.value * m.value.transpose() / static_cast<double>(all.size());
    noise += m.noise / static_cast<double>(all.size());
  }
  if (!(noise.trace() > 0)) return measured;  // the noise is not known
  Matrix6 covariance = without_negative(measured - noise) + 1e-2 * Matrix6(measured.diagonal().asDiagonal());
  for (int round = 0; round < rounds; ++round) {
    Matrix6 next = Matrix6::Zero();
    double count = 0;
    for (std::size_t i = 0; i < all.size(); i += stride, ++count) {
      const Eigen::LDLT<Matrix6> sum(covariance + all[i].noise);
      const Vector6 expected = covariance * sum.solve(all[i].value);
      next += expected * expected.transpose() + covariance - covariance * sum.solve(covariance);
    }
    covariance = without_negative((next + next.transpose()) / (2 * count));
  }
  return covariance;
}

}  // namespace

TcpRepeatability tcp_repeatability(const Fit& fit) { return tcp_repeatability(fit, nullptr); }

TcpRepeatability tcp_repeatability(const Fit& fit, const ToFrame& to_frame) {
  const std::vector<MeasuredDeviation> all = measured_deviations(fit, to_frame);
  TcpRepeatability repeatability{.observations = static_cast<int>(all.size())};
  const bool agrees = fit.covariance_kind == CovarianceKind::noise;
  if (repeatability.observations >= 3 && !agrees) repeatability.covariance = covariance_behind(all);
  return repeatability;
}

namespace {

/// The covariance given that places and rotations of which nothing is known are as they are; false where a rotation is
/// among them.
bool without_unknown_motions(Eigen::MatrixXd& covariance) {
  constexpr double nothing_known = 1;  // rad^2, m^2
  bool all_known = true;
  for (const int first : {3, 0}) {
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(Matrix3(covariance.block<3, 3>(first, first)));
    for (int i = 0; i < 3; ++i) {
      if (eigen.eigenvalues()[i] < nothing_known) continue;
      const Eigen::VectorXd together = covariance.middleCols<3>(first) * eigen.eigenvectors().col(i);
      covariance -= together * together.transpose() / eigen.eigenvalues()[i];
      all_known = all_known && first == 0;
    }
  }
  return all_known;
}

}  // namespace

PredictionModel prediction_model(const Fit& fit, const ModelUncertainty& model_uncertainty) {
  PredictionModel model{list_terms(fit), tcp_repeatability(fit), fit.model_covariance, fit.tcp_from_body,
                        estimate(fit).mount_from_sensor};
  model.model_uncertainty = model_uncertainty;
  model.rotation_is_observed = without_unknown_motions(model.covariance);
  return model;
}

namespace {

/// The name of a camera before that of one of its numbers: "side" of "side_fx". Nothing where it is none.
std::optional<std::string> camera_before_number(const std::string& name) {
  for (const CameraNumber& number : camera_numbers({}))
    if (const std::string end = std::string("_") + number.name; name.size() > end.size() && name.ends_with(end))
      return name.substr(0, name.size() - end.size());
  return std::nullopt;
}

/// A rig with the names of the cameras that a calibration speaks of: so many that its effects are what they were.
Rig rig_named_in(const Calibration& calibration) {
  std::vector<std::string> names;
  const auto add = [&](const std::optional<std::string>& name) {
    if (name && std::find(names.begin(), names.end(), *name) == names.end()) names.push_back(*name);
  };
  const auto rig_is = [](const CalibrationEffect& e) { return e.id == "rig"; };
  bool has_rig = std::any_of(calibration.effects.begin(), calibration.effects.end(), rig_is), has_single = has_rig;
  if (has_rig) names.push_back("first camera");
  for (const CalibrationEffect& e : calibration.effects)
    for (const CalibrationParameter& p : e.parameters) {
      if (e.id != "camera_intrinsics" && e.id != "lens_distortion" && e.id != "rig") continue;
      has_single = has_single || !p.of.empty();
      add(p.of.empty() ? camera_before_number(p.name) : std::optional(p.of));
    }
  for (const EffectDefinition& d : calibration.definitions)
    for (const DefinedMove& m : d.moves) add(camera_before_number(m.site));
  if (names.empty()) return make_rig(StereoRig{});
  if (has_single && names.size() == 2) names.push_back("another camera");
  if (!has_single && names.size() == 1) names.push_back(names.front() == "right" ? "left" : "right");
  Rig rig;
  for (std::string& name : names)
    if (rig.count() < max_cameras) rig.cameras.push_back(RigCamera{std::move(name), Camera(), Rigid()});
  if (find_camera(rig, "left") == 1 && rig.count() == 2) std::swap(rig.cameras[0].name, rig.cameras[1].name);
  return rig;
}

/// Terms that a file tells, and where each of its parameters stands among their numbers.
struct ReadTerms {
  std::vector<EffectTerm> terms;
  std::vector<NumberPlace> parameters;
  std::vector<double> variances;  // of the parameters

  /// Places of the parameters in a list of numbers that begins with `before`, the terms' own at `offset`.
  std::vector<Eigen::Index> after(std::vector<Eigen::Index> before, Eigen::Index offset) const {
    const std::vector<Eigen::Index> first = first_numbers(terms, offset);
    for (const NumberPlace& n : parameters) before.push_back(first[n.term] + static_cast<Eigen::Index>(n.parameter));
    return before;
  }
  Eigen::Index count() const { return first_numbers(terms).back(); }
};

ReadTerms read_terms(const std::vector<CalibrationEffect>& effects, const Robot& robot, const OwnEffects& own) {
  ReadTerms r;
  for (const CalibrationEffect& e : effects) {
    std::vector<EffectTerm> terms;  // what another element says of the same place are terms of their own
    for (const CalibrationParameter& p : e.parameters) {
      NumberPlace number = add_effect_number(e.id, p.of, p.name, p.value, robot, terms, own);
      number.term += r.terms.size();
      r.parameters.push_back(number);
      r.variances.push_back(std::pow(p.sigma.value_or(0), 2));
    }
    r.terms.insert(r.terms.end(), terms.begin(), terms.end());
  }
  return r;
}

/// A covariance in the order of a file as one in the order of a model with so many numbers.
Eigen::MatrixXd reordered(const Eigen::MatrixXd& of_file, const std::vector<Eigen::Index>& locate, Eigen::Index count) {
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
  covariance(locate, locate) = of_file;
  return covariance;
}

}  // namespace

PredictionModel prediction_model(const Calibration& calibration, const Robot& robot) {
  PredictionModel model;
  const Rig rig = rig_named_in(calibration);
  OwnEffects own = rig_effects(rig);
  for (const EffectDefinition& d : calibration.definitions) own.push_back(own_effect(d, robot, rig));
  const ReadTerms read = read_terms(calibration.effects, robot, own);
  model.effects = read.terms;
  model.tcp_from_body = calibration.tcp_from_body.motion;
  if (calibration.mount_from_sensor) model.mount_from_sensor = calibration.mount_from_sensor->motion;
  if (calibration.tcp_repeatability) model.repeatability = {*calibration.tcp_repeatability, calibration.fit.used};

  const std::vector<Eigen::Index> locate = read.after({0, 1, 2, 3, 4, 5}, 6);
  const auto count = static_cast<Eigen::Index>(locate.size());
  Eigen::MatrixXd of_file = Eigen::MatrixXd::Zero(count, count);
  of_file.topLeftCorner<6, 6>() = calibration.tcp_from_body.covariance;
  of_file.diagonal().tail(count - 6) =
      Eigen::Map<const Eigen::VectorXd>(read.variances.data(), static_cast<Eigen::Index>(read.variances.size()));
  if (calibration.model_covariance) of_file = *calibration.model_covariance;
  model.covariance = reordered(of_file, locate, 6 + read.count());
  if (calibration.model_uncertainty) {
    const ReadTerms others = read_terms(calibration.model_uncertainty->others, robot, own);
    model.model_uncertainty.others = others.terms;
    model.model_uncertainty.covariance =
        reordered(calibration.model_uncertainty->covariance, others.after(locate, 6 + read.count()),
                  6 + read.count() + others.count());
  }
  model.rotation_is_observed = without_unknown_motions(model.covariance);
  return model;
}

namespace {

/// Of xi, the model's numbers and those of what else may be there; both covariances together.
Eigen::MatrixXd whole_covariance(const PredictionModel& model) {
  if (!model.model_uncertainty.is_any()) return model.covariance;
  Eigen::MatrixXd whole = model.model_uncertainty.covariance;
  whole.topLeftCorner(model.covariance.rows(), model.covariance.cols()) += model.covariance;
  return whole;
}

/// The motion of the TCP (position m, rotation rad, root axes) for one sigma of each number of the effects, and of
/// those that may be there too: 6 x n. The secant over a sigma, which the solver of the springs cannot disturb.
Eigen::MatrixXd tcp_by_sigma(const ObservationState& c, const PredictionModel& model, const Eigen::VectorXd& sigmas) {
  Eigen::MatrixXd by_sigma = Eigen::MatrixXd::Zero(6, sigmas.size() - 6);
  std::vector<EffectTerm> terms = model.effects;
  terms.insert(terms.end(), model.model_uncertainty.others.begin(), model.model_uncertainty.others.end());
  Eigen::Index number = -1;
  for (EffectTerm& term : terms)
    for (double& value : term.values) {
      ++number;
      const double sigma = sigmas[6 + number], before = value;
      if (!(sigma > 0)) continue;
      value = before + sigma;
      const Rigid above = root_from_tcp_with(c, terms);
      value = before - sigma;
      const Rigid below = root_from_tcp_with(c, terms);
      value = before;
      by_sigma.col(number) << (above.translation - below.translation) / 2,
          vector_from_rotation(above.rotation * below.rotation.transpose()) / 2;
    }
  return by_sigma;
}

}  // namespace

TcpPrediction predict_tcp(const Chain& chain, const Eigen::VectorXd& position, const PredictionModel& model) {
  return predict_tcp(states_at(chain, position), model);
}

TcpPrediction predict_tcp(const ObservationState& c, const PredictionModel& model) {
  TcpPrediction p;
  p.root_from_tcp = root_from_tcp_with(c, {});
  const Sites sites = moved_sites(c, model.effects);
  const ObservedEnds moved = observed_ends(c, sites);
  p.root_from_tcp_est = moved.ends.root_from_tcp;
  p.root_from_body_est = p.root_from_tcp_est * model.tcp_from_body * small_motion<double>(sites.body);
  if (model.mount_from_sensor)
    p.root_from_sensor_est = moved.ends.root_from_mount * *model.mount_from_sensor * moved.mount_motion;
  Matrix6 turned = Matrix6::Zero();
  turned.topLeftCorner<3, 3>() = turned.bottomRightCorner<3, 3>() = p.root_from_tcp_est.rotation;
  // With root_from_body = root_from_tcp exp(xi) tcp_from_body, an error of xi moves TCPest as the TCP's own would.
  const Eigen::MatrixXd whole = whole_covariance(model);
  const Eigen::VectorXd sigmas = whole.diagonal().cwiseMax(0).cwiseSqrt();
  Eigen::MatrixXd by_model(6, whole.cols());
  by_model.leftCols<6>() = turned;
  by_model.rightCols(by_model.cols() - 6) = tcp_by_sigma(c, model, sigmas);
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(whole.cols());
  for (Eigen::Index i = 6; i < unit.size(); ++i) unit[i] = sigmas[i] > 0 ? 1 / sigmas[i] : 0;
  const Eigen::MatrixXd scaled = unit.asDiagonal() * whole * unit.asDiagonal();
  p.covariance =
      turned * model.repeatability.covariance * turned.transpose() + by_model * scaled * by_model.transpose();
  return p;
}

}  // namespace handsight
