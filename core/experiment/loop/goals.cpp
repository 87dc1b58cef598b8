// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/goals.h"

#include <array>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {
namespace {

struct Unit {
  const char* name;
  double size;
};
constexpr std::array lengths{Unit{"um", 1e-6}, Unit{"mm", 1e-3}, Unit{"cm", 1e-2}, Unit{"m", 1}};
constexpr std::array times{Unit{"min", 60}, Unit{"h", 3600}, Unit{"s", 1}};

[[noreturn]] void refuse_goal(const std::string& text) {
  throw InputError(message(
      "--until {}: expected hand=0.3mm, odds=20, count=60 or time=30min (um, mm, cm, m; s, min, h), several with | "
      "between.",
      in_quotes(text)));
}

template <class Units>
double with_unit(const std::string& text, const Units& units, const std::string& whole) {
  const auto end = text.find_first_not_of("0123456789.+-eE");
  if (end == std::string::npos || end == 0) refuse_goal(whole);
  const auto value = parse_number(text.substr(0, end));
  if (!value || !(*value > 0)) refuse_goal(whole);
  for (const Unit& unit : units)
    if (text.substr(end) == unit.name) return *value * unit.size;
  refuse_goal(whole);
}

void add_goal(const std::string& text, Goals& goals) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) refuse_goal(text);
  const std::string what = text.substr(0, equals), value = text.substr(equals + 1);
  if (what == "hand") {
    goals.hand = with_unit(value, lengths, text);
  } else if (what == "time") {
    goals.seconds = with_unit(value, times, text);
  } else if (what == "odds") {
    goals.odds = parse_number(value);
    if (!goals.odds || !(*goals.odds > 1 && *goals.odds <= 1e9)) refuse_goal(text);
  } else if (what == "count") {
    const auto count = parse_integer(value);
    if (!count || *count < 1 || *count > 100000) refuse_goal(text);
    goals.count = static_cast<int>(*count);
  } else {
    refuse_goal(text);
  }
}

}  // namespace

void add_goals(const std::string& text, Goals& goals) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find_first_of("|,", begin), text.size());
    add_goal(text.substr(begin, end - begin), goals);
    begin = end + 1;
  }
}

}  // namespace handsight
