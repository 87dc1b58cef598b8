// SPDX-License-Identifier: Apache-2.0
#include "compare/number_changes.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "effects/own_effect.h"
#include "effects/units.h"

namespace handsight {
namespace {

void add_number(std::vector<NumberChange>& all, std::string name, const char* unit, double before, double after,
                double variance) {
  all.push_back({std::move(name), unit, before, after, std::sqrt(std::max(0.0, variance))});
}

}  // namespace

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
      if (o.id == t.id && o.place == t.place)
        for (std::size_t p = 0; p < t.values.size(); ++p) {
          const Effect& e = term_effect(t);
          const std::string where = place_name(e, t.place, robot);
          const auto i = static_cast<Eigen::Index>(p);
          if (!e.parameters[p].is_choice)
            add_number(all, fmt::format("{}{}: {}", t.id, where.empty() ? "" : " of " + where, e.parameters[p].name),
                       unit_at(e, p, t.place, robot).c_str(), t.values[p], o.values[p],
                       variance_a[first_a + i] + variance_b[first_b + i]);
        }
      first_b += static_cast<Eigen::Index>(o.values.size());
    }
    first_a += static_cast<Eigen::Index>(t.values.size());
  }
}

}  // namespace handsight
