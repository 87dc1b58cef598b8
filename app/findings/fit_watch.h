// SPDX-License-Identifier: GPL-3.0-or-later
// What a running fit hands to the window: every cost, and pictures while there is room for them. Where the window does
// not keep up, pictures are left out; the fit never waits.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "diagnosis/residuals/residual_views.h"
#include "widgets/explain/residual_cloud.h"

namespace handsight::app {

struct FitPicture {
  std::vector<widgets::CloudPoint> cloud;
  std::vector<Rigid> bent;  // the robot's links as the effects bend it, in one observation
};

class FitWatch {
 public:
  /// Iterations of a fit of this session with these effects follow; the robot is shown in that observation.
  void begin(const Session& session, const std::vector<EffectTerm>& held, const std::vector<EffectTerm>& estimated,
             int observation);

  Eigen::Index effect_count() const { return problem_ ? problem_->effect_count() : 0; }
  /// In the fit's thread: one iteration.
  void iteration(double cost, const Unknowns& unknowns);

  struct News {
    std::vector<std::pair<int, double>> costs;  // iteration and rms of one coordinate since the last time
    std::optional<FitPicture> picture;
    int skipped = 0;  // pictures for which there was no room
  };
  /// In the window's thread: the next picture with the costs up to it; or, at the end, all that is left with the last.
  News fetch(bool is_end = false);

 private:
  std::optional<Problem> problem_;
  std::vector<std::int64_t> ids_;  // per place
  int rows_ = 1, observation_ = 0, running_ = 0;
  std::mutex mutex_;
  struct Shot {
    int iteration;
    FitPicture picture;
  };
  std::deque<std::pair<int, double>> costs_;
  std::deque<Shot> shots_;
  int skipped_ = 0;
};

/// Residuals as points of the cloud. `ids` per place of the problem.
std::vector<widgets::CloudPoint> make_cloud(const std::vector<CornerResidual>& corners,
                                            const std::vector<std::int64_t>& ids);
std::vector<std::int64_t> ids_of_places(const Problem& problem, const Session& session);

}  // namespace handsight::app
