// SPDX-License-Identifier: Apache-2.0
#include "blunders/trials.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/threads.h"
#include "blunders/blunder.h"
#include "blunders/seen_points.h"

namespace handsight {
namespace {

constexpr std::size_t fewest_sights = 6;
/// m: what moves less before the sensor (a probe's tip) any link beside it would explain.
constexpr double still = 0.01;
constexpr double fewest_kept = 0.8;  // of the sights: with images read otherwise some may show no body

std::string display_name(const Mend& mend) { return handsight::display_name(mend.kind->id, mend.where); }

const Mend* image_mend(const std::vector<Mend>& mends) {
  const auto found = std::find_if(mends.begin(), mends.end(), [](const Mend& m) { return m.kind->of_images; });
  return found == mends.end() ? nullptr : &*found;
}

void put_right(Mend& mend, Session& points) {
  if (mend.kind->settle) mend.where = mend.kind->settle(mend.where, points);
  mend.kind->mend(mend.where, points);
}

/// Those with numbers to be found come last; where there are two, the first is found again beside the second.
void put_right_all(std::vector<Mend>& mends, const Session& points, Session& right) {
  std::stable_partition(mends.begin(), mends.end(), [](const Mend& m) { return !m.kind->settle; });
  right = points;
  for (Mend& mend : mends)
    if (!mend.kind->of_images) put_right(mend, right);
  if (mends.size() < 2 || !mends[0].kind->settle || !mends[1].kind->settle) return;
  for (int pass = 0; pass < 2; ++pass) {
    right = points;
    std::swap(mends[0], mends[1]);
    mends[0].kind->mend(mends[0].where, right);
    mends[1].where = mends[1].where.substr(0, mends[1].where.find('='));
    put_right(mends[1], right);
  }
}

/// m: how far a point moves before the sensor, r.m.s. of all.
double spread_of(const std::vector<HandSight>& sights, int count) {
  std::vector<Vector3> sums(static_cast<std::size_t>(count), Vector3::Zero());
  std::vector<double> squares(sums.size(), 0.0), counts(sums.size(), 0.0);
  for (const HandSight& s : sights)
    for (const SightedPoint& p : s.points) {
      const auto k = static_cast<std::size_t>(p.number);
      sums[k] += p.in_sensor, squares[k] += p.in_sensor.squaredNorm(), counts[k] += 1;
    }
  double all = 0, count_of_all = 0;
  for (std::size_t k = 0; k < sums.size(); ++k)
    if (counts[k] > 0) all += squares[k] - sums[k].squaredNorm() / counts[k], count_of_all += counts[k];
  return count_of_all > 0 ? std::sqrt(std::max(0.0, all / count_of_all)) : 0;
}

/// Two that are put right in one thing.
bool collide(const Mend& a, const Mend& b) {
  if (a.kind->of_images && b.kind->of_images) return true;
  const auto first = [](const std::string& where) { return where.substr(0, where.find('=')); };
  const auto turns = [](const Mend& m) { return m.kind->id == "quaternion_order" || m.kind->id == "euler_convention"; };
  if (turns(a) && turns(b))  // of one table
    return first(a.where) == first(b.where) || first(a.where) == "both" || first(b.where) == "both";
  if (a.kind->id != b.kind->id) return false;
  return a.where == b.where || a.kind->id == "pairing_shift" || a.kind->id == "wrong_link" ||
         first(a.where) == first(b.where);
}

}  // namespace

double ln_likelier(double before, double after, std::size_t observations, int rows, int numbers) {
  const double mount_and_body = 12;
  const double free = std::max(1.0, rows * static_cast<double>(observations) - mount_and_body - numbers);
  const double price = 0.5 * std::log(rows * static_cast<double>(observations)) * numbers;
  return 0.5 * free * std::log(std::max(before, 1e-30) / std::max(after, 1e-30)) - price;
}

Trials::Trials(const Session& thin) : thin_(thin) {
  points_.emplace("", as_point_session(with_few_markers(thin)));
  const std::vector<HandSight> sights = list_sights(points_.at(""));
  sights_ = sights.size();
  std::size_t seen = 0;
  for (const HandSight& s : sights) seen += s.points.size();
  rows_ = sights_ > 0 ? static_cast<int>(std::clamp<std::size_t>(3 * seen / sights_, 1, 6)) : 6;
  stand_still_ = spread_of(sights, points_.at("").marker_count) < still;
  base_.found = solve_hand_eye(points_.at(""));
}

const Session& Trials::list_points(const Mend& mend) {
  const auto [place, is_new] = points_.try_emplace(display_name(mend));
  if (is_new) {
    Session right = thin_;
    mend.kind->mend(mend.where, right);
    place->second = as_point_session(with_few_markers(right));
  }
  return place->second;
}

Trial Trials::tried(std::vector<Mend> mends, std::size_t of_so_many) const {
  Trial trial{std::move(mends), {}, -1e300};
  const Mend* of_images = image_mend(trial.mends);
  Session right;
  try {
    put_right_all(trial.mends, points_.at(of_images ? display_name(*of_images) : ""), right);
    const std::vector<HandSight> sights = list_sights(right);
    if (static_cast<double>(sights.size()) < fewest_kept * static_cast<double>(sights_)) return trial;
    trial.found = solve_hand_eye(right);
  } catch (const InputError&) {  // one makes the other impossible
    return trial;
  }
  int numbers = 0;
  double unit = 1;
  for (const Mend& mend : trial.mends) {
    numbers += mend.kind->numbers;
    unit *= mend.kind->points_unit;
  }
  // Shrunk to a point all go together well: what counts is what is left beside how large they are.
  if (trial.found) trial.found->mean_square *= unit * unit;
  if (trial.found)
    trial.ln_bayes_factor = ln_likelier(base_.left(), trial.left(), sights_, rows_, numbers) -
                            std::log(static_cast<double>(std::max<std::size_t>(1, of_so_many)));
  return trial;
}

std::vector<Mend> Trials::singles() const {
  std::vector<Mend> all;
  for (const BlunderKind& kind : blunder_kinds()) {
    if (!kind.is_tried_alone) continue;
    for (const std::string& where : kind.places(thin_))
      if (!stand_still_ || kind.id != "wrong_link") all.push_back({&kind, where});
  }
  return all;
}

/// Those that show only once the poses are read otherwise, beside each of these.
std::vector<std::vector<Mend>> Trials::beside_poses(const std::vector<Mend>& alone) const {
  std::vector<std::vector<Mend>> pairs;
  for (const BlunderKind& kind : blunder_kinds()) {
    if (kind.is_tried_alone || !kind.is_tried_in_pairs) continue;
    for (const std::string& where : kind.places(thin_))
      for (const Mend& mend : alone)
        if (mend.kind->of_poses) pairs.push_back({mend, {&kind, where}});
  }
  return pairs;
}

/// What shows only beside another one and explains as much by itself needs no other: poses that all turn about one axis
/// hardly tell how their turns are to be read.
void Trials::drop_needless(const std::vector<Mend>& alone, std::vector<Trial>& pairs, std::size_t of_so_many) const {
  constexpr double clearly = 10;  // ln of a Bayes factor
  std::map<std::string, double> by_itself;
  for (const std::vector<Mend>& pair : beside_poses(alone))
    if (!by_itself.contains(pair[1].kind->id))
      by_itself[pair[1].kind->id] = tried({pair[1]}, of_so_many).ln_bayes_factor;
  std::erase_if(pairs, [&](const Trial& t) {
    return std::any_of(t.mends.begin(), t.mends.end(), [&](const Mend& m) {
      const auto one = by_itself.find(m.kind->id);
      return one != by_itself.end() && t.ln_bayes_factor < one->second + clearly;
    });
  });
}

/// The best few beside every other one; turned joints and poses, of which two are often wrong at once, all of them. Of
/// a robot of very many joints the likeliest: most_pairs bounds what a search costs.
std::vector<std::vector<Mend>> Trials::pairs(const std::vector<Trial>& singles) const {
  constexpr std::size_t followed = 4, most_pairs = 1500;
  std::vector<const Trial*> best;
  for (const Trial& t : singles) best.push_back(&t);
  std::stable_sort(best.begin(), best.end(), [](const Trial* a, const Trial* b) { return a->left() < b->left(); });
  std::vector<const Trial*> leading(best.begin(),
                                    best.begin() + static_cast<std::ptrdiff_t>(std::min(followed, best.size())));
  std::size_t without_numbers = 0;
  for (const Trial* t : best)
    if (t->mends[0].kind->numbers == 0 && without_numbers++ < followed &&
        std::find(leading.begin(), leading.end(), t) == leading.end())
      leading.push_back(t);
  const auto leads = [&](const Trial& t) { return std::find(leading.begin(), leading.end(), &t) != leading.end(); };
  const auto often_twice = [](const Mend& a, const Mend& b) {
    return (a.kind->id == "joint_sense" && b.kind->id == "joint_sense") || (a.kind->of_poses && b.kind->of_poses);
  };
  std::map<const Trial*, std::size_t> locate;
  for (std::size_t i = 0; i < best.size(); ++i) locate[best[i]] = i;
  struct Pair {
    std::vector<Mend> mends;
    std::size_t order;  // of promise
  };
  std::vector<Pair> all;
  for (std::size_t i = 0; i < singles.size(); ++i)
    for (std::size_t j = i + 1; j < singles.size(); ++j) {
      Mend a = singles[i].mends[0], b = singles[j].mends[0];
      if (collide(a, b) || !(leads(singles[i]) || leads(singles[j]) || often_twice(a, b))) continue;
      for (Mend* m : {&a, &b})
        if (m->kind->settle) m->where = m->where.substr(0, m->where.find('='));
      all.push_back({{a, b}, often_twice(a, b) ? 0 : locate.at(&singles[i]) + locate.at(&singles[j])});
    }
  if (all.size() > most_pairs) {
    std::stable_sort(all.begin(), all.end(), [](const Pair& a, const Pair& b) { return a.order < b.order; });
    all.resize(most_pairs);
  }
  std::vector<std::vector<Mend>> pairs;
  for (Pair& p : all) pairs.push_back(std::move(p.mends));
  return pairs;
}

std::vector<Trial> Trials::run(const std::function<bool(double)>& goes_on) {
  if (sights_ < fewest_sights || !base_.found) return {};
  const std::vector<Mend> alone = singles();
  for (const Mend& mend : alone)
    if (mend.kind->of_images) list_points(mend);
  std::vector<Trial> trials(alone.size());
  each_part(static_cast<int>(alone.size()), true, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    trials[k] = tried({alone[k]}, alone.size());
  });
  if (!goes_on(0.2)) return {};
  auto two = pairs(trials);
  for (auto& pair : beside_poses(alone)) two.push_back(std::move(pair));
  std::vector<Trial> of_two(two.size());
  const std::size_t so_many = alone.size() * alone.size() / 2;
  each_part(static_cast<int>(two.size()), true, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    of_two[k] = tried(two[k], so_many);
  });
  if (!goes_on(0.8)) return {};
  drop_needless(alone, of_two, so_many);
  trials.insert(trials.end(), std::make_move_iterator(of_two.begin()), std::make_move_iterator(of_two.end()));
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& a, const Trial& b) { return a.ln_bayes_factor > b.ln_bayes_factor; });
  return trials;
}

}  // namespace handsight
