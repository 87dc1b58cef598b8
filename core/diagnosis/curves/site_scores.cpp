// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/curves/site_scores.h"

#include "base/threads.h"
#include "estimation/problem/column_products.h"

namespace handsight {
namespace {

constexpr double joint_size = 1e-3;                    // rad (m): plausible
constexpr double shift_size = 1e-3, turn_size = 2e-3;  // m, rad

struct Place {
  EmpiricalErrorSite kind;
  int joint;
  Eigen::VectorXd sizes;
  std::vector<Eigen::MatrixXd>
      directions;  // per observation, the body's motion by the site's directions, 6 x directions
};

CurveSite make_site(const Place& place, const WhitenedModel& w) {
  const LinearModel& m = *w.model;
  const auto count = static_cast<Eigen::Index>(m.observations.size()), n = place.sizes.size();
  CurveSite site{place.kind, place.joint, place.sizes, Eigen::MatrixXd(count, n * n), Eigen::MatrixXd(count, n), {}};
  site.shared.assign(static_cast<std::size_t>(n), Eigen::MatrixXd(count, m.base));
  for (Eigen::Index i = 0; i < count; ++i) {
    const LinearObservation& o = m.observations[static_cast<std::size_t>(i)];
    const auto at = static_cast<std::size_t>(i);
    const Eigen::MatrixXd columns = w.whiteners[at] * (o.by_body * place.directions[at]);
    const Eigen::MatrixXd information = columns.transpose() * columns;
    site.information.row(i) = information.reshaped().transpose();
    site.gradient.row(i) = w.external_error.segment(o.first, o.count).transpose() * columns;
    for (Eigen::Index d = 0; d < n; ++d)
      site.shared[static_cast<std::size_t>(d)].row(i).noalias() =
          columns.col(d).transpose() * w.external.middleRows(o.first, o.count).leftCols(m.base);
  }
  for (Eigen::MatrixXd& shared : site.shared) w.base.matrixU().solveInPlace<Eigen::OnTheRight>(shared);
  return site;
}

Vector6 rigid_sizes() {
  Vector6 sizes;
  sizes << shift_size, shift_size, shift_size, turn_size, turn_size, turn_size;
  return sizes;
}

}  // namespace

std::vector<CurveSite> curve_sites(const WhitenedModel& w, const Problem& problem) {
  const LinearModel& m = *w.model;
  std::vector<Place> places;
  std::vector<Eigen::MatrixXd> tcp, mount;
  for (const LinearObservation& o : m.observations) {
    tcp.push_back(adjoint(o.sensor_from_tcp) * rigid_sizes().asDiagonal());
    mount.push_back(-Matrix6(rigid_sizes().asDiagonal()));
  }
  places.push_back({EmpiricalErrorSite::tcp, -1, rigid_sizes(), std::move(tcp)});
  places.push_back({EmpiricalErrorSite::mount, -1, rigid_sizes(), std::move(mount)});
  const Chain& chain = problem.source->chain;
  for (std::size_t j = 0; j < chain.joints.size(); ++j) {
    std::vector<Eigen::MatrixXd> directions;
    double largest = 0;
    for (std::size_t i = 0; i < m.observations.size(); ++i) {
      directions.push_back(joint_size * m.observations[i].joint_motions.col(static_cast<Eigen::Index>(j)));
      largest = std::max(largest, m.observations[i].by_joints.col(static_cast<Eigen::Index>(j)).norm());
    }
    if (largest > 0)
      places.push_back(
          {EmpiricalErrorSite::joint, chain.joints[j], Eigen::VectorXd::Constant(1, joint_size), directions});
  }
  std::vector<CurveSite> sites(places.size());
  each_part(static_cast<int>(places.size()), true,
            [&](int i) { sites[static_cast<std::size_t>(i)] = make_site(places[static_cast<std::size_t>(i)], w); });
  return sites;
}

namespace {

/// What functions share with the base, and with what is left, direction by direction of a site.
struct SharesOfFunctions {
  Eigen::MatrixXd gradient;             // directions x functions
  std::vector<Eigen::MatrixXd> shared;  // per direction, base x functions
};

SharesOfFunctions shares_of_functions(const CurveSite& site, const Eigen::MatrixXd& values) {
  SharesOfFunctions shares{column_products(site.gradient, values), {}};
  for (const Eigen::MatrixXd& of_direction : site.shared)
    shares.shared.push_back(column_products(of_direction, values));
  return shares;
}

/// Of functions whose shares begin at the column `first`.
Score score_from(const SharesOfFunctions& shares, Eigen::Index first, const WhitenedModel& w, const CurveSite& site,
                 const Eigen::MatrixXd& values) {
  const Eigen::Index s = site.directions(), f = values.cols();
  Score score{Eigen::MatrixXd(s * f, s * f), shares.gradient.middleCols(first, f).reshaped()};
  Eigen::MatrixXd shared(w.model->base, s * f);
  for (Eigen::Index d = 0; d < s; ++d)
    for (Eigen::Index a = 0; a < f; ++a)
      shared.col(s * a + d) = shares.shared[static_cast<std::size_t>(d)].col(first + a);
  for (Eigen::Index a = 0; a < f; ++a) {
    const Eigen::MatrixXd products = values.leftCols(a + 1).array().colwise() * values.col(a).array();
    const Eigen::MatrixXd information = column_products(site.information, products);
    for (Eigen::Index b = 0; b <= a; ++b) {
      const auto block = information.col(b).reshaped(s, s);
      score.information.block(s * a, s * b, s, s) = block;
      score.information.block(s * b, s * a, s, s) = block.transpose();
    }
  }
  const Eigen::VectorXd raw = score.information.diagonal();
  score.information -= column_products(shared);
  score.gradient -= shared.transpose() * w.base_gradient;
  for (Eigen::Index i = 0; i < raw.size(); ++i) {
    if (score.information(i, i) > 1e-9 * raw[i]) continue;
    score.information.row(i).setZero();
    score.information.col(i).setZero();
    score.gradient[i] = 0;
  }
  return score;
}

}  // namespace

Score score_at(const WhitenedModel& w, const CurveSite& site, const Eigen::MatrixXd& values) {
  return score_from(shares_of_functions(site, values), 0, w, site, values);
}

std::vector<Score> scores_at(const WhitenedModel& w, const CurveSite& site,
                             const std::vector<const Eigen::MatrixXd*>& values) {
  if (values.empty()) return {};
  Eigen::Index count = 0;
  for (const Eigen::MatrixXd* v : values) count += v->cols();
  Eigen::MatrixXd all(values.front()->rows(), count);
  Eigen::Index first = 0;
  for (const Eigen::MatrixXd* v : values) {
    all.middleCols(first, v->cols()) = *v;
    first += v->cols();
  }
  const SharesOfFunctions shares = shares_of_functions(site, all);
  std::vector<Score> scores;
  first = 0;
  for (const Eigen::MatrixXd* v : values) {
    scores.push_back(score_from(shares, first, w, site, *v));
    first += v->cols();
  }
  return scores;
}

}  // namespace handsight
