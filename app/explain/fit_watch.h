// SPDX-License-Identifier: GPL-3.0-or-later
// What a running fit hands to the window: every cost, and pictures while there is room for them. Where the window does
// not keep up, pictures are left out; the fit never waits.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "diagnosis/residual_views.h"
#include "widgets/explain/residual_cloud.h"

namespace handsight::app {

struct FitPicture {
  std::vector<widgets::CloudPoint> cloud;
  std::vector<Rigid> bent;  // the robot's links as the effects bend it, in one observation
};

class FitWatch {
 public:
  /// A fit of this session with these effects is about to run; the robot is shown in that observation.
  void begin(const Session& session, const std::vector<EffectTerm>& held, const std::vector<EffectTerm>& estimated,
             int observation);

  Eigen::Index effect_count() const { return problem_ ? problem_->effect_count() : 0; }
  /// In the fit's thread: one iteration.
  void iteration(int number, double cost, const Unknowns& unknowns);

  struct News {
    std::vector<std::pair<int, double>> costs;  // iteration and rms of one coordinate since the last time
    std::optional<FitPicture> picture;          // the oldest that was not shown yet
    int skipped = 0;                            // pictures for which there was no room
  };
  /// In the window's thread: what came since the last time.
  News fetch();

 private:
  std::optional<Problem> problem_;
  std::vector<std::int64_t> ids_;  // per place
  int rows_ = 1, observation_ = 0, running_ = 0;
  std::mutex mutex_;
  News news_;
  std::deque<FitPicture> pictures_;
};

/// Residuals as points of the cloud. `ids` per place of the problem.
std::vector<widgets::CloudPoint> cloud_of(const std::vector<CornerResidual>& corners,
                                          const std::vector<std::int64_t>& ids);
std::vector<std::int64_t> ids_of_places(const Problem& problem, const Session& session);

}  // namespace handsight::app
