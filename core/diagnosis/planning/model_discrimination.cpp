// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/model_discrimination.h"

#include <Eigen/QR>
#include <cmath>

namespace handsight {
namespace {

/// The covariance of a pose's measurement by a model's uncertainty and the noise.
Eigen::MatrixXd predicted_covariance(const Eigen::MatrixXd& whitened) {
  Eigen::MatrixXd v = whitened.transpose() * whitened;
  v.diagonal().array() += 1;
  return v;
}

}  // namespace

Eigen::VectorXd ModelDiscrimination::difference(const ExpectedRows& by_truth, const ExpectedRows& by_rival) const {
  Eigen::VectorXd d = by_truth.predicted - by_rival.predicted;
  if (rival_shift_.size() > 0) d -= by_rival.by_columns * rival_shift_;
  return d;
}

Eigen::MatrixXd ModelDiscrimination::wandering(const ExpectedRows& by_truth, const ExpectedRows& by_rival) const {
  if (truth_wander_.cols() == 0) return Eigen::MatrixXd(by_truth.predicted.size(), 0);
  return by_truth.by_columns * truth_wander_ - by_rival.by_columns * rival_wander_;
}

double ModelDiscrimination::expected(const ExpectedRows& by_truth, const ExpectedRows& by_rival) const {
  const Eigen::MatrixXd v_truth = predicted_covariance(truth_->whitened(by_truth));
  const Eigen::LLT<Eigen::MatrixXd> truth(v_truth), rival(predicted_covariance(rival_->whitened(by_rival)));
  const auto rows = static_cast<double>(by_truth.predicted.size());
  const double trace = rival.matrixL().solve(Eigen::MatrixXd(truth.matrixL())).squaredNorm();
  const double squares = rival.matrixL().solve(difference(by_truth, by_rival)).squaredNorm();
  const Eigen::MatrixXd wander = wandering(by_truth, by_rival);
  const double wandered = wander.cols() > 0 ? rival.matrixL().solve(wander).squaredNorm() : 0.0;
  // Kullback and Leibler's divergence of what the two models predict, in the mean over the measurements before.
  return 0.5 * (trace - rows + squares + wandered) + half_ln_determinant(rival) - half_ln_determinant(truth);
}

void ModelDiscrimination::measure(const ExpectedRows& by_truth, const ExpectedRows& by_rival) {
  const Eigen::MatrixXd w_truth = truth_->whitened(by_truth), w_rival = rival_->whitened(by_rival);
  const Eigen::LLT<Eigen::MatrixXd> v_truth(predicted_covariance(w_truth)), v_rival(predicted_covariance(w_rival));
  const Eigen::MatrixXd gain_truth =
      v_truth.solve(truth_->information().matrixU().solve(w_truth).transpose()).transpose();
  const Eigen::MatrixXd gain_rival =
      v_rival.solve(rival_->information().matrixU().solve(w_rival).transpose()).transpose();
  const Eigen::VectorXd d = difference(by_truth, by_rival);
  const Eigen::MatrixXd wander = wandering(by_truth, by_rival);
  if (rival_shift_.size() == 0) rival_shift_ = Eigen::VectorXd::Zero(gain_rival.rows());
  rival_shift_ += gain_rival * d;
  const Eigen::MatrixXd surprise = v_truth.matrixL();  // what is measured, about the truth's prediction
  const Eigen::Index before = wander.cols();
  Eigen::MatrixXd joint(gain_truth.rows() + gain_rival.rows(), before + surprise.cols());
  joint.rightCols(surprise.cols()) << gain_truth * surprise, gain_rival * surprise;
  if (before > 0) joint.leftCols(before) << truth_wander_, rival_wander_ + gain_rival * wander;
  if (joint.cols() > joint.rows()) {  // the same covariance by fewer numbers
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(joint.transpose());
    const Eigen::MatrixXd upper = qr.matrixQR().topRows(joint.rows()).triangularView<Eigen::Upper>();
    joint = upper.transpose();
  }
  truth_wander_ = joint.topRows(gain_truth.rows());
  rival_wander_ = joint.bottomRows(gain_rival.rows());
}

}  // namespace handsight
