// SPDX-License-Identifier: Apache-2.0
// The bill of a model: a row a cause, with what it is worth at the hand, how sure that is, whether robots are built so,
// and what these poses cannot tell it from. Made once; window, report and command line show the same rows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "diagnosis/selection/inclusion_probability.h"

namespace handsight {

/// One cause of a model: an effect with all of its places, or a curve without a name.
struct BillRow {
  std::string id;
  std::vector<std::string> where;  // joints, markers, "from observation 37 on"; of a curve where it acts
  bool unnamed = false;
  std::string follows;    // of a curve: what it follows; else empty
  bool held = false;      // by the user, not estimated
  bool is_small = false;  // a little at each joint, as in every robot: part of the model, no cause that is told
  /// Root mean square over the observations of how far it moves the body's origin as the sensor sees it, m. Where the
  /// mount is estimated too, what is the same in all of them is the mount's and left out.
  double hand_m = 0;
  double hand_sigma_m = 0;   // one sigma of it, by the covariance of the cause's own numbers; 0 where it is held
  bool too_large = false;    // larger than robots are built (stand_in.h)
  bool pushes_back = false;  // a spring that does
  std::vector<std::string> stands_in_at;  // those of its places where either is so; empty: at all of them, or nowhere
  std::optional<double> probability;      // that it is there at all; nothing where nobody has looked
  /// Ids of what could do the same to the measurements on these poses; nothing where nobody has looked.
  std::optional<std::vector<std::string>> indistinguishable_from;

  /// It stands in for another cause: no robot is built so.
  bool stands_in() const { return too_large || pushes_back; }
};

/// Of the model of a fit, what moves the hand most first. `inclusion_probabilities`: of the same model, null where
/// nobody has looked. Of long sessions a part of the observations, evenly taken, tells how much.
std::vector<BillRow> make_bill(const Fit& fit, const InclusionProbabilities* inclusion_probabilities = nullptr);

/// The same rows with what the probabilities say of them.
std::vector<BillRow> with_inclusion_probabilities(std::vector<BillRow> rows,
                                                  const InclusionProbabilities& inclusion_probabilities);

/// "2.31 +- 0.04 mm": what it is worth at the hand, to two digits of its sigma and three of its own.
Message hand_text(const BillRow& row);

/// A table for terminals, a line a row with a head; empty where there are none.
std::vector<std::string> bill_lines(const std::vector<BillRow>& rows);

}  // namespace handsight
