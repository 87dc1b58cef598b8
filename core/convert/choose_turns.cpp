// SPDX-License-Identifier: Apache-2.0
#include "convert/choose_turns.h"

#include <algorithm>
#include <numbers>

#include "base/error.h"
#include "base/text.h"
#include "geometry/hand_eye_consensus.h"
#include "geometry/hand_eye_misfit.h"

namespace handsight {
namespace {

constexpr double at_all = 0.4;     // rad: of robots that err by degrees, where nothing else comes near
constexpr double as_well = 3;      // times the best
constexpr double as_exact = 0.01;  // rad
constexpr double degree = std::numbers::pi / 180;

/// One reading of both tables.
struct Trial {
  std::size_t flange = 0, target = 0;  // places among the readings
  Misfit misfit;
  std::vector<Rigid> flange_poses, target_poses;
  std::vector<bool> agrees = {};  // where not all rows do: those that go together
};

std::size_t count_numbers(const NamedPoses& p) { return std::max<std::size_t>(1, p.turns.readings.size()); }

std::vector<Rigid> read_by(const NamedPoses& p, std::size_t reading) {
  PoseSeries series = p.series;
  if (!p.turns.readings.empty()) read_turns(p.turns, p.turns.readings[reading], series);
  return series.poses;
}

/// All that can be tried, the best first.
std::vector<Trial> trials_of(const NamedPoses& flange, const NamedPoses& target, bool eye_in_hand) {
  std::vector<Trial> trials;
  for (std::size_t f = 0; f < count_numbers(flange); ++f)
    for (std::size_t t = 0; t < count_numbers(target); ++t) {
      Trial trial{f, t, {}, read_by(flange, f), read_by(target, t)};
      const auto misfit = hand_eye_misfit(trial.flange_poses, trial.target_poses, eye_in_hand);
      if (!misfit) continue;
      trial.misfit = *misfit;
      trials.push_back(std::move(trial));
    }
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& a, const Trial& b) { return a.misfit.size() < b.misfit.size(); });
  return trials;
}

double largest_turn_between(const std::vector<Rigid>& a, const std::vector<Rigid>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, vector_from_rotation(Matrix3(a[i].rotation.transpose() * b[i].rotation)).norm());
  return largest;
}

/// Two readings by which all poses are the same, as far as it matters.
bool are_alike(const Trial& a, const Trial& b, double noise) {
  return std::max(largest_turn_between(a.flange_poses, b.flange_poses),
                  largest_turn_between(a.target_poses, b.target_poses)) < std::max(1e-3, noise);
}

bool is_usual(const Trial& trial, const NamedPoses& flange, const NamedPoses& target) {
  return (!flange.turns.first_is_usual || trial.flange == 0) && (!target.turns.first_is_usual || trial.target == 0);
}

/// Those that serve as well as the best; of them those that take what is usual, where there are some.
std::vector<const Trial*> serving(const std::vector<Trial>& trials, const NamedPoses& flange,
                                  const NamedPoses& target) {
  std::vector<const Trial*> all, usual;
  const double most = std::max(as_well * trials.front().misfit.size(), as_exact);
  for (const Trial& trial : trials)
    if (trial.misfit.size() <= most) {
      all.push_back(&trial);
      if (is_usual(trial, flange, target)) usual.push_back(&trial);
    }
  return usual.empty() ? all : usual;
}

Message readings_text(const NamedPoses& flange, const NamedPoses& target, const Trial& trial) {
  std::vector<Message> texts;
  for (const auto& [poses, reading] : {std::pair(&flange, trial.flange), std::pair(&target, trial.target)})
    if (is_open(*poses))
      texts.push_back(message("{}: {} are read as {}", poses->file,
                              columns_text(poses->turns, poses->turns.readings[reading]),
                              reading_text(poses->turns.readings[reading])));
  return joined(texts, "; ");
}

void take(const Trial& trial, NamedPoses& flange, NamedPoses& target) {
  flange.series.poses = trial.flange_poses;
  target.series.poses = trial.target_poses;
  for (const auto& [poses, reading] : {std::pair(&flange, trial.flange), std::pair(&target, trial.target)})
    if (is_open(*poses)) poses->turns.readings = {poses->turns.readings[reading]};
}

bool is_usual_for(const NamedPoses& p) { return !is_open(p) || p.turns.first_is_usual; }

Message open_tables(const NamedPoses& flange, const NamedPoses& target) {
  std::vector<Message> tables;
  for (const NamedPoses* p : {&flange, &target})
    if (is_open(*p)) tables.push_back(message("{} of {}", p->turns.columns, p->file));
  return joined(tables);
}

constexpr char how_to_say[] =
    "say it with --angles (rotation_vector, rpy, abc, wpr, oat, staubli ...) and --degrees, or in the header ([deg])";

[[noreturn]] void refuse_two(const NamedPoses& flange, const NamedPoses& target, const Trial& a, const Trial& b) {
  throw InputError(message("{}, or {}: both suit the other poses as well; {}.",
                           at_most(readings_text(flange, target, a), 180),
                           at_most(readings_text(flange, target, b), 180), how_to_say));
}

/// Three angles in every way, whatever --angles said of them.
NamedPoses with_all_readings(NamedPoses p) {
  if (!p.turns.is_reported || p.turns.numbers.empty() || p.turns.numbers.front().size() != 3) return p;
  using K = AngleKind;
  p.turns.readings.clear();
  for (const bool in_degrees : {false, true})
    for (const K kind : {K::rotation_vector, K::rpy, K::zyx, K::moving_xyz, K::zyz})
      p.turns.readings.push_back({kind, in_degrees});
  return p;
}

/// What --angles should have said, where another reading makes the motions agree; empty: none does.
Message better_reading(const NamedPoses& flange, const NamedPoses& target, bool eye_in_hand) {
  const NamedPoses f = with_all_readings(flange), t = with_all_readings(target);
  const std::vector<Trial> trials = trials_of(f, t, eye_in_hand);
  if (trials.empty() || trials.front().misfit.size() > most_misfit) return {};
  return message("{} they agree to {}: leave --angles out.", at_most(readings_text(f, t, trials.front()), 250),
                 misfit_text(trials.front().misfit));
}

/// Where nothing goes together what is usual stays, else nobody knows.
void without_agreement(NamedPoses& flange, NamedPoses& target, const Trial& best, bool eye_in_hand,
                       std::vector<Message>& notes) {
  const Message better = better_reading(flange, target, eye_in_hand);
  if (!is_usual_for(flange) || !is_usual_for(target))
    throw InputError(
        message("No reading of {} makes the motions of both agree (the best leaves {}): do the rows belong together, "
                "is one of them inverted, is the robot's file of this robot? If they do, {}.",
                at_most(open_tables(flange, target), 150), misfit_text(best.misfit), how_to_say));
  take_usual_turns(flange, notes);
  take_usual_turns(target, notes);
  if (!better.empty()) {
    notes.push_back(
        message("As --angles has it, the motions of the flange and of the target do not agree (the best "
                "leaves {}); if {}",
                misfit_text(best.misfit), better));
    return;
  }
  notes.push_back(
      message("However they are read, the motions of the flange and of the target do not agree (the best leaves "
              "{}); see what fit says.",
              misfit_text(best.misfit)));
}

/// How far the next reading is that is not the same in other words.
Message next_best(const std::vector<Trial>& trials, const Trial& chosen) {
  for (const Trial& trial : trials)
    if (&trial != &chosen && !are_alike(trial, chosen, chosen.misfit.size()))
      return message("; the next best reading leaves {}", misfit_text(trial.misfit));
  return "";
}

/// Do the motions go together by the best, be it that they are noisy and no other reading comes near?
bool goes_together(const std::vector<Trial>& trials) {
  const Trial& best = trials.front();
  if (best.misfit.size() <= most_misfit) return true;
  return best.misfit.size() <= at_all && std::all_of(trials.begin(), trials.end(), [&](const Trial& other) {
           return other.misfit.size() > as_well * best.misfit.size() || are_alike(other, best, best.misfit.size());
         });
}

std::vector<Rigid> inverted(std::vector<Rigid> poses) {
  for (Rigid& pose : poses) pose = inverse(pose);
  return poses;
}

/// The reading by which most of the rows go together, where no other comes near; nothing where there is none by which
/// half of them do, and six.
std::optional<Trial> by_most_rows(std::vector<Trial> trials, bool eye_in_hand) {
  constexpr std::size_t fewest = 6;
  constexpr double agreement = 0.1;  // rad
  std::vector<std::size_t> counts;
  for (Trial& trial : trials) {
    const auto found =
        hand_eye_consensus(eye_in_hand ? trial.flange_poses : inverted(trial.flange_poses), trial.target_poses);
    const bool is_good =
        found && found->left < agreement && found->count() >= fewest && 2 * found->count() >= trial.flange_poses.size();
    counts.push_back(is_good ? found->count() : 0);
    if (is_good) trial.agrees = found->agrees, trial.misfit = {found->left, 0};
  }
  const auto best = std::max_element(counts.begin(), counts.end());
  if (best == counts.end() || *best == 0) return std::nullopt;
  Trial chosen = trials[static_cast<std::size_t>(best - counts.begin())];
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (counts[i] > 0 && !are_alike(trials[i], chosen, agreement)) return std::nullopt;
  return chosen;
}

/// Takes the reading of most rows, and says which do not go with them.
void take_by_most_rows(const Trial& chosen, NamedPoses& flange, NamedPoses& target, std::vector<Message>& notes) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < chosen.agrees.size(); ++i)
    if (!chosen.agrees[i]) others.push_back(fmt::format("{}", i));
  const std::size_t all = chosen.agrees.size();
  notes.push_back(
      message("{}: so {} of {} rows go together to {:.2g} degrees; the others do not go with them, however they are "
              "read: observations {}. See what check says.",
              readings_text(flange, target, chosen), all - others.size(), all, chosen.misfit.turn / degree,
              shortened(fmt::format("{}", fmt::join(others, ", ")), 150)));
  take(chosen, flange, target);
}

}  // namespace

bool is_open(const NamedPoses& poses) { return poses.turns.readings.size() > 1; }

void choose_turns(NamedPoses& flange, NamedPoses& target, bool eye_in_hand, std::vector<Message>& notes) {
  if (!is_open(flange) && !is_open(target)) return;
  std::vector<Trial> trials = trials_of(flange, target, eye_in_hand);
  if (trials.empty()) {
    take_usual_turns(flange, notes);
    take_usual_turns(target, notes);
    return;
  }
  if (!goes_together(trials)) {  // as if one table were inverted
    std::vector<Trial> other_way = trials_of(flange, target, !eye_in_hand);
    if (other_way.empty() || other_way.front().misfit.size() > most_misfit) {
      for (const bool other : {false, true})
        if (const auto most = by_most_rows(other ? other_way : trials, other ? !eye_in_hand : eye_in_hand))
          return take_by_most_rows(*most, flange, target, notes);
      return without_agreement(flange, target, trials.front(), eye_in_hand, notes);
    }
    notes.emplace_back(
        "The motions of the flange and of the target agree only if the poses of one of them are inverted (the sensor "
        "in the target's frame for the target in the sensor's), or with the sensor on the other side (--eye-on-base); "
        "see what fit says.");
    trials = std::move(other_way);
  }
  const std::vector<const Trial*> good = serving(trials, flange, target);
  for (const Trial* other : good)
    if (!are_alike(*other, *good.front(), good.front()->misfit.size()))
      refuse_two(flange, target, *good.front(), *other);
  const Trial chosen = *good.front();
  notes.push_back(message("{}: so the motions of the flange and of the target agree to {}{}.",
                          readings_text(flange, target, chosen), misfit_text(chosen.misfit),
                          next_best(trials, *good.front())));
  take(chosen, flange, target);
}

void take_usual_turns(NamedPoses& p, std::vector<Message>& notes) {
  if (!is_open(p)) return;
  if (!p.turns.first_is_usual)
    throw InputError(
        message("{}: {} may be {}, or {}, and nothing here can tell: say it with --angles "
                "(rotation_vector, rpy, abc, wpr, oat, staubli ...) and --degrees, or in the header "
                "([deg]).",
                p.file, p.turns.columns, reading_text(p.turns.readings[0]), reading_text(p.turns.readings[1])));
  p.turns.readings.resize(1);
  read_turns(p.turns, p.turns.readings[0], p.series);
  notes.push_back(message("{}: {} are taken for {}.", p.file, p.turns.columns, reading_text(p.turns.readings[0])));
}

}  // namespace handsight
