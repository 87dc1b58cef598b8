// SPDX-License-Identifier: Apache-2.0
// Readings of a session in which one blunder or two are put right, each tried quickly by hand-eye alone.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "blunders/blunder_kinds.h"
#include "blunders/hand_eye.h"

namespace handsight {

struct Mend {
  const BlunderKind* kind = nullptr;
  std::string where;
};

struct Trial {
  std::vector<Mend> mends;
  std::optional<HandEye> found;     // nothing where too little is left to be seen
  double ln_bayes_factor = -1e300;  // over the session as it is, less what it costs to have tried so many

  double left() const { return found ? found->mean_square : 1e300; }
};

/// ln of how much likelier measurements become where the mean square falls from `before` to `after`: observations count
/// as independent with `rows` numbers each, the noise is unknown, and so many numbers were found with it.
double ln_likelier(double before, double after, std::size_t observations, int rows, int numbers);

/// All of them, best first; empty where fewer than 6 observations show the body as points. `goes_on` is asked from time
/// to time with the share that is done; where it says no, what was tried so far.
class Trials {
 public:
  explicit Trials(const Session& thin);
  std::vector<Trial> run(const std::function<bool(double)>& goes_on);
  const Trial& as_it_is() const { return base_; }
  std::size_t sights() const { return sights_; }
  int rows() const { return rows_; }

 private:
  Trial tried(std::vector<Mend> mends, std::size_t of_so_many) const;
  const Session& list_points(const Mend& mend);
  std::vector<Mend> singles() const;
  std::vector<std::vector<Mend>> beside_poses(const std::vector<Mend>& alone) const;
  void drop_needless(const std::vector<Mend>& alone, std::vector<Trial>& pairs, std::size_t of_so_many) const;
  std::vector<std::vector<Mend>> pairs(const std::vector<Trial>& singles) const;

  const Session& thin_;
  std::map<std::string, Session> points_;  // by the mend of the images; empty: as they are
  Trial base_;
  std::size_t sights_ = 0;
  int rows_ = 6;
  bool stand_still_ = false;
};

}  // namespace handsight
