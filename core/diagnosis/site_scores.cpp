// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/site_scores.h"

namespace handsight {
namespace {

constexpr double joint_size = 1e-3;                    // rad (m): plausible
constexpr double shift_size = 1e-3, turn_size = 2e-3;  // m, rad

std::vector<SiteBlock> site_blocks(const WhitenedModel& w, const std::vector<Eigen::MatrixXd>& directions) {
  const LinearModel& m = *w.model;
  std::vector<SiteBlock> blocks(m.observations.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const LinearObservation& o = m.observations[i];
    const Eigen::MatrixXd columns = w.whiteners[i] * (o.by_body * directions[i]);
    blocks[i].information = columns.transpose() * columns;
    blocks[i].gradient = columns.transpose() * w.external_error.segment(o.first, o.count);
    blocks[i].shared = w.external.middleRows(o.first, o.count).leftCols(m.base).transpose() * columns;
    blocks[i].shared = w.base.matrixL().solve(blocks[i].shared);
  }
  return blocks;
}

Vector6 rigid_sizes() {
  Vector6 sizes;
  sizes << shift_size, shift_size, shift_size, turn_size, turn_size, turn_size;
  return sizes;
}

}  // namespace

std::vector<CurveSite> curve_sites(const WhitenedModel& w, const Problem& problem) {
  const LinearModel& m = *w.model;
  std::vector<CurveSite> sites;
  std::vector<Eigen::MatrixXd> tcp, mount;
  for (const LinearObservation& o : m.observations) {
    tcp.push_back(adjoint(o.sensor_from_tcp) * rigid_sizes().asDiagonal());
    mount.push_back(-Matrix6(rigid_sizes().asDiagonal()));
  }
  sites.push_back({LocaliserSite::tcp, -1, site_blocks(w, tcp), rigid_sizes()});
  sites.push_back({LocaliserSite::mount, -1, site_blocks(w, mount), rigid_sizes()});
  const Chain& chain = problem.source->chain;
  for (std::size_t j = 0; j < chain.joints.size(); ++j) {
    std::vector<Eigen::MatrixXd> directions;
    double largest = 0;
    for (std::size_t i = 0; i < m.observations.size(); ++i) {
      directions.push_back(joint_size * m.observations[i].joint_motions.col(static_cast<Eigen::Index>(j)));
      largest = std::max(largest, m.observations[i].by_joints.col(static_cast<Eigen::Index>(j)).norm());
    }
    if (largest > 0)
      sites.push_back({LocaliserSite::joint, chain.joints[j], site_blocks(w, directions),
                       Eigen::VectorXd::Constant(1, joint_size)});
  }
  return sites;
}

Score score_at(const WhitenedModel& w, const CurveSite& site, const Eigen::MatrixXd& values) {
  const std::vector<SiteBlock>& blocks = site.blocks;
  const Eigen::Index s = blocks.front().gradient.size(), f = values.cols();
  Score score{Eigen::MatrixXd::Zero(s * f, s * f), Eigen::VectorXd::Zero(s * f)};
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(w.model->base, s * f);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (Eigen::Index a = 0; a < f; ++a) {
      score.gradient.segment(s * a, s) += values(row, a) * blocks[i].gradient;
      shared.middleCols(s * a, s) += values(row, a) * blocks[i].shared;
      for (Eigen::Index b = 0; b <= a; ++b)
        score.information.block(s * a, s * b, s, s) += values(row, a) * values(row, b) * blocks[i].information;
    }
  }
  score.information = Eigen::MatrixXd(score.information.selfadjointView<Eigen::Lower>());
  const Eigen::VectorXd raw = score.information.diagonal();
  score.information -= shared.transpose() * shared;
  score.gradient -= shared.transpose() * w.base_gradient;
  for (Eigen::Index i = 0; i < raw.size(); ++i) {
    if (score.information(i, i) > 1e-9 * raw[i]) continue;
    score.information.row(i).setZero();
    score.information.col(i).setZero();
    score.gradient[i] = 0;
  }
  return score;
}

}  // namespace handsight
