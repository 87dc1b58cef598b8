// SPDX-License-Identifier: Apache-2.0
// At which scalar site of the chain one number of an effect acts, and what it follows there. Found from what the effect
// moves, whatever it is called.
#pragma once

#include "base/message.h"
#include "estimation/problem/problem.h"

namespace handsight {

struct ProofSite {
  std::optional<std::size_t> entry;  // of Sites, as site_entries numbers them; none: the number itself is the site
  Message quantity;                  // what moves there
  std::string unit;
  Message against;  // what the number follows
  std::string against_unit;
  Eigen::VectorXd x;      // per observation of the problem
  Eigen::VectorXd load;   // of the entry by what moves: a spring's torque; 1 where they are the same
  Eigen::VectorXd share;  // what moves per unit of the number, load included
};

/// `problem` must hold torques (EffectMotion).
ProofSite proof_site(const Problem& problem, const EffectTerm& term, std::size_t parameter);

/// An effect of one number that moves one entry of the sites by it.
std::shared_ptr<const Effect> make_probe(std::size_t entry);

}  // namespace handsight
