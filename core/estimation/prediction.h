// SPDX-License-Identifier: Apache-2.0
// Where the TCP really is in poses that were not measured: the purpose of it all.
#pragma once

#include "estimation/fit_report.h"

namespace handsight {

/// How the real TCP scatters about the model's, learned from the observations of a fit.
struct TcpScatter {
  Matrix6 covariance = Matrix6::Zero();  // of tcp_from_tcp_est: translation (m) and rotation vector (rad), TCP axes
  int observations = 0;                  // that showed three markers
};

/// Second moments of tcp_from_tcp_est over the observations, less what the noise of the measurement alone would
/// show. With fewer than three such observations nothing is known of it: zero, and `observations` says so.
TcpScatter tcp_scatter(const Fit& fit);

struct TcpPrediction {
  Rigid root_from_tcp;              // as commanded: the nominal robot
  Rigid root_from_tcp_est;          // with the effects of the model
  Vector6 sigma = Vector6::Zero();  // of root_from_tcp_est: position (m), then rotation (rad), about the root's axes
};

/// For one pose, joints in the order of the chain. sigma is the scatter of the observations about the model and the
/// uncertainty of tcp_from_body, to which TCPest is tied, together; without observations only what is known.
TcpPrediction predict_tcp(const Chain& chain, const Eigen::VectorXd& position, const std::vector<EffectTerm>& effects,
                          const TcpScatter& scatter, const Rigid& tcp_from_body, const Matrix6& body_covariance);

}  // namespace handsight
