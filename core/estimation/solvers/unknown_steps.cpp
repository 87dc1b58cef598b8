// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/unknown_steps.h"

#include <Eigen/Cholesky>

#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {

Eigen::MatrixXd step_basis(const Problem& problem, const Unknowns& unknowns, bool fixed_body) {
  if (!fixed_body) return Eigen::MatrixXd::Identity(problem.columns(), problem.columns());
  const Eigen::Index markers = 3 * problem.marker_count;
  const Eigen::Index mount = problem.columns() - markers;
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(problem.columns(), 6 + mount);
  for (int m = 0; m < problem.marker_count; ++m) {
    basis.block<3, 3>(3 * m, 0) = Matrix3::Identity();
    basis.block<3, 3>(3 * m, 3) = -cross_matrix(unknowns.markers_in_tcp[static_cast<std::size_t>(m)]);
  }
  basis.bottomRightCorner(mount, mount).setIdentity();
  return basis;
}

Unknowns stepped(const Problem& problem, const Unknowns& unknowns, const Eigen::VectorXd& step, bool fixed_body) {
  if (!fixed_body) return moved(problem, unknowns, step);
  Unknowns next = unknowns;
  const Rigid motion = small_motion<double>(step.head<6>());
  for (Vector3& marker : next.markers_in_tcp) marker = motion * marker;
  for (int i = 0; i < problem.mount_count(); ++i)
    if (const Eigen::Index column = problem.column_of_mount(i); column >= 0)
      next.mount(i) = unknowns.mount(i) * small_motion<double>(step.segment<6>(6 + column - problem.mount_column()));
  next.effects += step.tail(problem.effect_count());
  return next;
}

Eigen::MatrixXd by_steps(const Eigen::MatrixXd& information, const Eigen::MatrixXd& basis, bool fixed_body) {
  return fixed_body ? Eigen::MatrixXd(basis.transpose() * information * basis) : information;
}

Eigen::VectorXd gradient_by_steps(const NormalEquations& normal, const Eigen::MatrixXd& basis, bool fixed_body) {
  return fixed_body ? Eigen::VectorXd(basis.transpose() * normal.gradient) : normal.gradient;
}

Eigen::VectorXd damped_step(const Eigen::MatrixXd& h, const Eigen::VectorXd& gradient, double damping) {
  const Eigen::VectorXd scale = inverse_scale(h);
  Eigen::MatrixXd scaled = scale.asDiagonal() * h * scale.asDiagonal();
  scaled.diagonal().array() += damping;
  for (Eigen::Index i = 0; i < scaled.rows(); ++i)
    if (scale[i] == 0) scaled(i, i) = 1;
  const Eigen::VectorXd right = scale.asDiagonal() * gradient;
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(scaled);
  if (ldlt.info() == Eigen::Success && ldlt.vectorD().minCoeff() > 1e-11) return scale.asDiagonal() * ldlt.solve(right);
  return scale.asDiagonal() * (pseudo_inverse(scaled) * right);
}

Eigen::VectorXd damped_step_across(const Eigen::VectorXd& along, const Eigen::MatrixXd& h,
                                   const Eigen::VectorXd& gradient, double damping) {
  const Eigen::VectorXd plain = damped_step(h, gradient, damping);
  const Eigen::VectorXd weighed = h.diagonal().cwiseProduct(along);
  const Eigen::VectorXd on = damped_step(h, weighed, damping);
  const double length = weighed.dot(on);
  return length > 0 ? Eigen::VectorXd(plain - on * (weighed.dot(plain) / length)) : plain;
}

}  // namespace handsight
