// SPDX-License-Identifier: Apache-2.0
#include "estimation/prediction.h"

#include <Eigen/Eigenvalues>

namespace handsight {
namespace {

/// The nearest matrix without negative eigenvalues: a difference of two estimated covariances may have some.
Matrix6 without_negative(const Matrix6& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(symmetric);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

Rigid root_from_tcp_with(const Chain& chain, const Eigen::VectorXd& position, const std::vector<EffectTerm>& effects) {
  const Circumstances c = circumstances_at(chain, position);
  return observed_ends(c, moved_sites(c, effects)).ends.root_from_tcp;
}

}  // namespace

TcpScatter tcp_scatter(const Fit& fit) {
  TcpScatter scatter;
  Matrix6 measured = Matrix6::Zero(), noise = Matrix6::Zero();
  const double variance = fit.noise ? *fit.noise * *fit.noise : 0.0;
  for (const ProblemObservation& o : fit.problem.observations) {
    const auto deviation = tcp_deviation(fit.problem, o, estimate(fit));
    if (!deviation) continue;
    Vector6 v;
    v << deviation->tcp_from_tcp_est.translation, vector_from_rotation(deviation->tcp_from_tcp_est.rotation);
    measured += v * v.transpose();
    noise += variance * deviation->unit_covariance;
    ++scatter.observations;
  }
  if (scatter.observations >= 3) scatter.covariance = without_negative((measured - noise) / scatter.observations);
  return scatter;
}

TcpPrediction predict_tcp(const Chain& chain, const Eigen::VectorXd& position, const std::vector<EffectTerm>& effects,
                          const TcpScatter& scatter, const Rigid& tcp_from_body, const Matrix6& body_covariance) {
  TcpPrediction p;
  p.root_from_tcp = chain_ends(chain, position).root_from_tcp;
  p.root_from_tcp_est = root_from_tcp_with(chain, position, effects);
  // exp(xi) tcp_from_body = tcp_from_body exp(Ad xi): an error of the mount of the body moves the TCP by the inverse.
  const Matrix6 in_tcp = scatter.covariance + body_covariance;
  Matrix6 turned = Matrix6::Zero();
  turned.topLeftCorner<3, 3>() = turned.bottomRightCorner<3, 3>() = p.root_from_tcp_est.rotation;
  p.sigma = (turned * in_tcp * turned.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
  return p;
}

}  // namespace handsight
