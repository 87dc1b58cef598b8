// SPDX-License-Identifier: Apache-2.0
// An amount is said once: what an effect of the catalogue does to the chain is what its formula says.
#include "effects/amount.h"

#include <gtest/gtest.h>

#include <cmath>

#include "effects/formula.h"
#include "effects/own_effect.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

TEST(Symbol, WhatIsDoneWithSymbolsIsAFormula) {
  const Symbol q("q"), sine("sine");
  EXPECT_EQ((sine * sin(2 * q)).text(), "(sine * sin((2 * q)))");
  const Symbol all =
      where(q >= -0.5, -sine * cos(q) / 3 + abs(q - 1) * tanh(q) - tan(q)) + sqrt(exp(q)) + where(q < 0.1, sine);
  const Formula formula(all.text(), {"q", "sine"}, "here");
  for (const double x : {-0.7, -0.3, 0.2, 0.9}) {
    const double s = 0.4;
    const double wanted = (x >= -0.5 ? -s * std::cos(x) / 3 + std::abs(x - 1) * std::tanh(x) - std::tan(x) : 0) +
                          std::sqrt(std::exp(x)) + (x < 0.1 ? s : 0);
    EXPECT_NEAR(formula.value(std::vector{x, s}), wanted, 1e-14) << x;
  }
}

/// Where the formulas' sites of the catalogue are: of a joint's angle, and of the body.
double read_site(const Sites& sites, const std::string& site, int joint) {
  if (site == "angle" || site == every_angle) return sites.robot.joints[static_cast<std::size_t>(joint)].angle;
  for (int i = 0; i < 6; ++i)
    if (site == std::string("body_") + motion_axes[i]) return sites.body[i];
  ADD_FAILURE() << site;
  return 0;
}

TEST(Amount, WhatAnEffectDoesIsWhatItsFormulaSays) {
  Session session = fixture::stand_session();
  session.robot = fixture::coupled_torso();
  session.tcp = "hand";
  session.mount.link = "base";
  session.joints = {"t1", "t2", "arm_1", "arm_2"};
  const Chain chain = make_chain(session);
  ObservationState here = states_at(chain, Eigen::Vector4d(0.3, 0.8, -0.7, 0.4));
  here.velocity = Eigen::VectorXd::LinSpaced(here.sensor.size(), 0.1, 0.3);
  here.approach.setConstant(-1);
  here.order = 9;
  int count = 0;
  for (const Effect& e : catalogue()) {
    if (!e.formulas) continue;
    for (const int place : effect_places(e, chain)) {
      EffectTerm term = term_of(e, place);
      for (std::size_t p = 0; p < term.values.size(); ++p)
        if (!e.parameters[p].is_choice) term.values[p] = 0.3 + 0.2 * static_cast<double>(p);
      const Sites moved = moved_sites(here, {term});
      for (const DefinedMove& m : e.formulas(chain, place, term.values)) {
        const int joint = place >= 0 ? place : chain.joints.front();
        std::vector<std::string> names{"q", "velocity", "approach", "order"};
        std::vector<double> numbers{here.sensor[joint], here.velocity[joint], here.approach[joint], 9.0};
        for (std::size_t p = 0; p < e.parameters.size(); ++p) {
          names.push_back(e.parameters[p].name);
          numbers.push_back(term.values[p]);
        }
        for (std::size_t j = 0; j < chain.robot.joints.size(); ++j) {
          names.push_back("q_" + formula_name(chain.robot.joints[j].name));
          numbers.push_back(here.sensor[static_cast<Eigen::Index>(j)]);
        }
        EXPECT_NEAR(Formula(m.formula, names, e.id).value(numbers), read_site(moved, m.site, joint), 1e-14)
            << e.id << ": " << m.formula;
        ++count;
      }
    }
  }
  EXPECT_GE(count, 20);
}

}  // namespace
}  // namespace handsight
