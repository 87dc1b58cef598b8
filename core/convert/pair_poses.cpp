// SPDX-License-Identifier: Apache-2.0
#include "convert/pair_poses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "base/error.h"
#include "base/letters.h"
#include "base/text.h"

namespace handsight {
namespace {

using Rows = std::vector<std::size_t>;

struct Pairs {
  Rows first, second;
};

template <class T>
std::vector<T> some_of(const std::vector<T>& all, const Rows& rows) {
  std::vector<T> some;
  if (!all.empty())
    for (const std::size_t r : rows) some.push_back(all[r]);
  return some;
}

/// "img_01" of "images/IMG_01.jpg".
std::string image_stem(const std::string& name) {
  std::string plain = name.substr(name.find_last_of("/\\") == std::string::npos ? 0 : name.find_last_of("/\\") + 1);
  if (const std::size_t dot = plain.rfind('.'); dot != std::string::npos && dot > 0) plain.resize(dot);
  return lower_case(plain);
}

std::vector<std::string> plain_names(const std::vector<std::string>& names) {
  std::vector<std::string> plain;
  for (const std::string& name : names) plain.push_back(image_stem(name));
  return plain;
}

/// In the order of the first; what has no partner is left out.
template <class Key>
Pairs pair_by(const std::vector<Key>& first, const std::vector<Key>& second) {
  std::map<Key, std::size_t> places;
  for (std::size_t i = 0; i < second.size(); ++i) places.emplace(second[i], i);
  Pairs pairs;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (const auto found = places.find(first[i]); found != places.end()) {
      pairs.first.push_back(i);
      pairs.second.push_back(found->second);
    }
  return pairs;
}

double median_step(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  if (steps.empty()) return 0;
  std::sort(steps.begin(), steps.end());
  return steps[steps.size() / 2];
}

/// Each of the sparser one with the nearest in time of the other.
Pairs pair_by_time(const std::vector<double>& flange, const std::vector<double>& target, double lag) {
  constexpr double together = 0.1;  // s: rows that were written together
  const double widest = std::max(together, 0.4 * std::max(median_step(flange), median_step(target)));
  Pairs pairs;
  for (std::size_t t = 0; t < target.size(); ++t) {
    const double at = target[t] - lag;
    const auto after = std::lower_bound(flange.begin(), flange.end(), at) - flange.begin();
    auto best = static_cast<std::size_t>(std::min<std::ptrdiff_t>(after, std::ssize(flange) - 1));
    if (best > 0 && std::abs(flange[best - 1] - at) < std::abs(flange[best] - at)) --best;
    if (std::abs(flange[best] - at) > widest) continue;
    if (!pairs.first.empty() && pairs.first.back() == best) continue;  // of two the earlier one
    pairs.first.push_back(best);
    pairs.second.push_back(t);
  }
  return pairs;
}

std::size_t row_count(const PoseSeries& s) { return s.row_count > 0 ? s.row_count : s.poses.size(); }

Rows list_places(const PoseSeries& s) {
  if (!s.places.empty()) return s.places;
  Rows places(s.poses.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  return places;
}

/// `how` says by what; where poses are left over it goes on with how many have a partner.
void say_pairs(const Message& how, const Pairs& pairs, std::size_t flange, std::size_t other,
               std::vector<Message>& notes) {
  notes.push_back(pairs.first.size() == std::max(flange, other)
                      ? message("{}.", how)
                      : message("{}: {} of {} and {} have a partner.", how, pairs.first.size(), flange, other));
}

Pairs pairs_of(const PoseSeries& flange, const PoseSeries& target, const ConvertOptions& o,
               std::vector<Message>& notes) {
  const auto reported = [&](const char* sentence, Pairs pairs) {
    say_pairs(sentence, pairs, flange.poses.size(), target.poses.size(), notes);
    return pairs;
  };
  if (!flange.names.empty() && !target.names.empty())
    if (Pairs pairs = pair_by(plain_names(flange.names), plain_names(target.names)); !pairs.first.empty())
      return reported("Poses of the flange and of the target are paired by the names of their images",
                      std::move(pairs));
  if (!flange.numbers.empty() && !target.numbers.empty())
    if (Pairs pairs = pair_by(flange.numbers, target.numbers); !pairs.first.empty())
      return reported("Poses of the flange and of the target are paired by their numbers", std::move(pairs));
  const bool same_count = row_count(flange) == row_count(target);
  if (!flange.times.empty() && !target.times.empty()) {
    if (Pairs pairs = pair_by_time(flange.times, target.times, o.pairing.lag); !pairs.first.empty())
      return reported("Poses of the flange and of the target are paired by their times", std::move(pairs));
    if (!same_count)
      throw InputError(
          message("No pose of the target has one of the flange at its time: they are from {:.3f} to {:.3f} s, those "
                  "of the flange from {:.3f} to {:.3f} s. Do the clocks agree (--lag)?",
                  target.times.front(), target.times.back(), flange.times.front(), flange.times.back()));
    notes.emplace_back("The clocks of the two tables do not agree; their poses are paired row by row.");
  }
  if (!same_count)
    throw InputError(
        message("There are {} poses of the flange and {} of the target; expected one of each an instant, in the same "
                "order, or a column that pairs them: number, image or time.",
                row_count(flange), row_count(target)));
  return pair_by(list_places(flange), list_places(target));
}

std::vector<double> list_numbers(const Rigid& a, const Rigid& b) {
  std::vector<double> all;
  for (const Rigid* m : {&a, &b}) {
    all.insert(all.end(), m->translation.data(), m->translation.data() + 3);
    all.insert(all.end(), m->rotation.data(), m->rotation.data() + 9);
  }
  return all;
}

/// Those that are no copy of an earlier one.
Rows once(const std::vector<Rigid>& flange, const std::vector<Rigid>& target) {
  std::set<std::vector<double>> seen;
  Rows rows;
  for (std::size_t i = 0; i < flange.size(); ++i)
    if (seen.insert(list_numbers(flange[i], target[i])).second) rows.push_back(i);
  return rows;
}

/// The instants' numbers as those of a table.
std::vector<double> list_numbers(const std::vector<InstantImages>& images) {
  std::vector<double> numbers;
  for (const InstantImages& instant : images) numbers.push_back(static_cast<double>(instant.number));
  return numbers;
}

/// Each name of an instant's images, in any camera.
Pairs pair_by_image_names(const std::vector<std::string>& names, const std::vector<InstantImages>& images) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < images.size(); ++i)
    for (const auto& file : images[i].files)
      if (!file.empty()) places.emplace(image_stem(file.filename().string()), i);
  Pairs pairs;
  for (std::size_t r = 0; r < names.size(); ++r)
    if (const auto found = places.find(image_stem(names[r])); found != places.end()) {
      pairs.first.push_back(r);
      pairs.second.push_back(found->second);
    }
  return pairs;
}

/// s since 1970 of images that are called by it, in ns, us or ms; empty: they are not.
std::vector<double> list_times(const std::vector<InstantImages>& images) {
  const double first = static_cast<double>(images.front().number);
  const double unit = first > 1e17 ? 1e-9 : first > 1e14 ? 1e-6 : first > 1e11 ? 1e-3 : 0;
  std::vector<double> times;
  for (const InstantImages& instant : images)
    if (unit > 0) times.push_back(unit * static_cast<double>(instant.number));
  return times;
}

Pairs pairs_of_images(const PoseSeries& flange, const std::vector<InstantImages>& images, int cameras, double lag,
                      std::vector<Message>& notes) {
  const auto reported = [&](const char* sentence, Pairs pairs) {
    say_pairs(sentence, pairs, flange.poses.size(), images.size(), notes);
    return pairs;
  };
  if (!flange.names.empty()) {
    Pairs pairs = pair_by_image_names(flange.names, images);
    if (pairs.first.empty())
      throw InputError(
          message("The table of the flange names images ({} ...), and none of them is there (the first is {}).",
                  in_quotes(flange.names.front()), in_quotes(images.front().files.front().filename().string())));
    return reported("Poses of the flange and the images are paired by the images' names", std::move(pairs));
  }
  const bool same_count = images.size() == row_count(flange);
  if (const std::vector<double> times = list_times(images); !flange.times.empty() && !times.empty())
    if (Pairs pairs = pair_by_time(flange.times, times, lag); !pairs.first.empty())
      return reported("Poses of the flange and the images are paired by their times", std::move(pairs));
  if (!flange.numbers.empty()) {
    Pairs pairs = pair_by(flange.numbers, list_numbers(images));
    if (pairs.first.size() == flange.numbers.size() || (!pairs.first.empty() && !same_count))
      return reported("Poses of the flange and the images are paired by their numbers", std::move(pairs));
  }
  if (!same_count)
    throw InputError(message(
        "There are {} {} and {} poses of the flange; expected one for each, in the order of the images' numbers, or a "
        "column that pairs them: image or number. The first image has the number {}, the last {}.",
        images.size(), cameras == 2 ? "pairs of images" : "instants with images", row_count(flange),
        images.front().number, images.back().number));
  return {Rows(pair_by(list_places(flange), list_places(flange)).first), list_places(flange)};
}

}  // namespace

PoseSeries take_rows(const PoseSeries& s, const Rows& rows) {
  return {some_of(s.times, rows), some_of(s.poses, rows), some_of(s.numbers, rows), some_of(s.names, rows), {}, 0};
}

NamedPoses take_rows(const NamedPoses& p, const Rows& rows) {
  NamedPoses some = p;
  some.series = take_rows(p.series, rows);
  some.turns.numbers = some_of(p.turns.numbers, rows);
  some.turns.places = some_of(p.turns.places, rows);
  return some;
}

void pair_poses(NamedPoses& flange, NamedPoses& target, const ConvertOptions& o, std::vector<Message>& notes) {
  const Pairs pairs = pairs_of(flange.series, target.series, o, notes);
  if (pairs.first.empty())
    throw InputError("No row has both a pose of the flange and one of the target; expected one of each an instant.");
  flange = take_rows(flange, pairs.first);
  target = take_rows(target, pairs.second);
  const Rows own = once(flange.series.poses, target.series.poses);
  if (own.size() == flange.series.poses.size()) return;
  notes.push_back(
      message("{} rows repeat another one in both tables; each counts once.", flange.series.poses.size() - own.size()));
  flange = take_rows(flange, own);
  target = take_rows(target, own);
}

void pair_images(NamedPoses& flange, std::vector<InstantImages>& images, int cameras, double lag,
                 std::vector<Message>& notes) {
  const Pairs pairs = pairs_of_images(flange.series, images, cameras, lag, notes);
  flange = take_rows(flange, pairs.first);
  images = some_of(images, pairs.second);
}

}  // namespace handsight
