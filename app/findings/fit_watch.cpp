// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/fit_watch.h"

#include <cmath>

#include "chain/sighting.h"
#include "document/bent_robot.h"
#include "document/document.h"

namespace handsight::app {

std::vector<std::int64_t> ids_of_places(const Problem& problem, const Session& session) {
  std::vector<std::int64_t> ids;
  for (const ProblemObservation& o : problem.observations) ids.push_back(id_at(session, o.index));
  return ids;
}

std::vector<widgets::CloudPoint> make_cloud(const std::vector<CornerResidual>& corners,
                                            const std::vector<std::int64_t>& ids) {
  std::vector<widgets::CloudPoint> points;
  points.reserve(corners.size());
  for (const CornerResidual& c : corners) {
    const double scale = c.camera == by_tracker ? 1e3 : 1;
    points.push_back({ids[static_cast<std::size_t>(c.place)], c.marker, std::max(c.camera, 0), scale * c.residual.x(),
                      scale * c.residual.y()});
  }
  return points;
}

void FitWatch::begin(const Session& session, const std::vector<EffectTerm>& held,
                     const std::vector<EffectTerm>& estimated, int observation) {
  problem_ = make_problem(session, make_chain(session), held, estimated);
  ids_ = ids_of_places(*problem_, session);
  observation_ = observation;
  running_ = 0;
  rows_ = 0;
  for (const ProblemObservation& o : problem_->observations)
    for (const Sighting& s : o.sightings) rows_ += row_count(s);
  const std::lock_guard lock(mutex_);
  costs_.clear();
  shots_.clear();
  skipped_ = 0;
}

void FitWatch::iteration(double cost, const Unknowns& unknowns) {
  constexpr std::size_t most_waiting = 24;  // longer than the fits that are seen, and a bound all the same
  const double rms = std::sqrt(cost / std::max(rows_, 1));
  const int number = running_++;
  bool has_room = false;
  {
    const std::lock_guard lock(mutex_);
    costs_.push_back({number, problem_ && !problem_->rig ? 1e3 * rms : rms});
    has_room = shots_.size() < most_waiting;
    if (!has_room) ++skipped_;
  }
  if (!problem_ || !has_room || unknowns.effects.size() != problem_->effect_count()) return;
  FitPicture picture;
  picture.cloud = make_cloud(corner_residuals(*problem_, unknowns), ids_);
  picture.bent = bent_links(*problem_->source, observation_, terms_with(*problem_, unknowns.effects));
  const std::lock_guard lock(mutex_);
  shots_.push_back({number, std::move(picture)});
}

FitWatch::News FitWatch::fetch(bool is_end) {
  const std::lock_guard lock(mutex_);
  News news;
  news.skipped = std::exchange(skipped_, 0);
  if (is_end && shots_.size() > 1) shots_.erase(shots_.begin(), shots_.end() - 1);
  while (!costs_.empty() && (is_end || shots_.empty() || costs_.front().first <= shots_.front().iteration)) {
    news.costs.push_back(costs_.front());
    costs_.pop_front();
  }
  if (shots_.empty()) return news;
  news.picture = std::move(shots_.front().picture);
  shots_.pop_front();
  return news;
}

}  // namespace handsight::app
