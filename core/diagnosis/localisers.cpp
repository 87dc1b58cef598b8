// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/localisers.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace handsight {
namespace {

constexpr double joint_size = 1e-3;                    // rad (m): plausible
constexpr double shift_size = 1e-3, turn_size = 2e-3;  // m, rad

struct Curve {
  std::string text;
  Eigen::MatrixXd values;  // observations x functions
  bool at_joint = true, at_rigid = true;
};

Curve waves(const Eigen::VectorXd& x, double frequency) {
  Curve s{fmt::format("sine and cosine of {:g} times it", frequency), Eigen::MatrixXd(x.size(), 2)};
  s.values.col(0) = (frequency * x).array().sin();
  s.values.col(1) = (frequency * x).array().cos();
  return s;
}

/// What the catalogue has at joints itself (waves of one and two turns, a line) is left to it.
std::vector<Curve> shapes_of_angle(const Eigen::VectorXd& q) {
  std::vector<Curve> shapes;
  for (const double frequency : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0}) {
    Curve s = waves(q, frequency);
    s.at_joint = frequency > 2;
    shapes.push_back(std::move(s));
  }
  return shapes;
}

std::vector<Curve> shapes_of_torque(const Eigen::VectorXd& torque) {
  const double size = std::sqrt(torque.squaredNorm() / static_cast<double>(torque.size()));
  const Eigen::ArrayXd u = torque.array() / (size > 0 ? size : 1);
  std::vector<Curve> shapes;
  const auto add = [&](const char* text, const Eigen::ArrayXd& values) {
    shapes.push_back({text, Eigen::MatrixXd(values.matrix()), true, false});
  };
  add("its square, signed", u * u.abs());
  add("its cube", u * u * u / 3);
  add("a saturation of it", u.tanh());
  add("a steep saturation of it", (3 * u).tanh());
  return shapes;
}

std::vector<Curve> shapes_of_time(const Eigen::VectorXd& t) {
  std::vector<Curve> shapes;
  const double whole = t.maxCoeff() > 0 ? t.maxCoeff() : 1;
  for (int k = 1; k <= 8; ++k) {
    Curve s{fmt::format("a wave of {:g} periods over the session", k / 2.0), Eigen::MatrixXd(t.size(), 2), true, true};
    s.values.col(0) = (std::numbers::pi * k / whole * t).array().sin();
    s.values.col(1) = (std::numbers::pi * k / whole * t).array().cos();
    shapes.push_back(std::move(s));
  }
  return shapes;
}

std::vector<Curve> shapes_of_place(const Eigen::VectorXd& x) {
  const Eigen::ArrayXd u = (x.array() - x.mean()) / std::max((x.maxCoeff() - x.minCoeff()) / 2, 1e-12);
  Curve s{"a curve of it", Eigen::MatrixXd(x.size(), 2), false, true};
  s.values.col(0) = u;
  s.values.col(1) = u * u;
  return {s};
}

std::vector<Curve> shapes_of(const Variable& v) {
  switch (v.kind) {
    case VariableKind::angle:
      return shapes_of_angle(v.values);
    case VariableKind::torque:
      return shapes_of_torque(v.values);
    case VariableKind::time:
      return shapes_of_time(v.values);
    case VariableKind::image_u:
    case VariableKind::image_v:
    case VariableKind::depth:
      return shapes_of_place(v.values);
    default:
      return {};
  }
}

/// A site's directions in one observation, whitened: their information, score, and share in the base.
struct SiteBlock {
  Eigen::MatrixXd information;  // s x s
  Eigen::VectorXd gradient;     // s
  Eigen::MatrixXd shared;       // base x s
};

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

/// The score of functions of the observation at a site: parameters function by function, direction by direction.
Score score_of(const WhitenedModel& w, const std::vector<SiteBlock>& blocks, const Eigen::MatrixXd& values) {
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

struct Site {
  LocaliserSite kind;
  int joint;
  std::vector<SiteBlock> blocks;
  Eigen::VectorXd sizes;  // per direction
};

Vector6 rigid_sizes() {
  Vector6 sizes;
  sizes << shift_size, shift_size, shift_size, turn_size, turn_size, turn_size;
  return sizes;
}

std::vector<Site> sites_of(const WhitenedModel& w, const Problem& problem) {
  const LinearModel& m = *w.model;
  std::vector<Site> sites;
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

void consider(const WhitenedModel& w, const NoiseKnowledge& noise, const Site& site, const Curve& shape,
              Localiser& localiser, std::vector<double>& factors) {
  const Score s = score_of(w, site.blocks, shape.values);
  const double factor = ln_bayes_factor(s, w, noise);
  factors.push_back(factor);
  if (factors.size() > 1 && factor <= localiser.best.ln_bayes_factor) return;
  const LinearEstimate estimate = linear_estimate(s, w, noise);
  LocaliserTerm term{site.kind, site.joint, shape.text, shape.values, factor, estimate.value};
  for (Eigen::Index i = 0; i < term.estimate.size(); ++i) term.estimate[i] *= site.sizes[i % site.sizes.size()];
  localiser.best = std::move(term);
}

}  // namespace

std::vector<Localiser> localise(const WhitenedModel& w, const NoiseKnowledge& noise, const Problem& problem,
                                const std::vector<Variable>& variables) {
  const std::vector<Site> sites = sites_of(w, problem);
  std::vector<Localiser> localisers;
  for (const Variable& v : variables) {
    Localiser localiser{std::make_shared<Variable>(v), 0, {}};
    std::vector<double> at_joint, at_rigid;
    std::vector<double> factors;
    for (const Curve& shape : shapes_of(v))
      for (const Site& site : sites) {
        const bool joint = site.kind == LocaliserSite::joint;
        if (joint ? !shape.at_joint : !shape.at_rigid) continue;
        // Angles and torques act at their own joint; time at every one.
        if (joint && v.joint >= 0 && site.joint != v.joint) continue;
        consider(w, noise, site, shape, localiser, factors);
      }
    if (v.kind == VariableKind::angle) {  // a coupling: another joint's deviation in proportion to this one's angle
      const Curve line{"in proportion to it", Eigen::MatrixXd(v.values), true, false};
      for (const Site& site : sites)
        if (site.kind == LocaliserSite::joint && site.joint != v.joint)
          consider(w, noise, site, line, localiser, factors);
    }
    if (factors.empty()) continue;
    localiser.ln_bayes_factor = ln_mean_exp(factors);
    localisers.push_back(std::move(localiser));
  }
  return localisers;
}

}  // namespace handsight
