// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/attribution/common.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace handsight {
namespace {

constexpr double open = std::numeric_limits<double>::infinity();

/// The range of values over which chosen less others is largest: the largest sum of neighbours in sorted order
/// (Kadane), where equal values stay together.
Common best_range(const Eigen::VectorXd& x, const std::vector<char>& is_chosen, int chosen, int others) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(x.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return x[a] < x[b]; });
  struct Group {
    double value;
    int chosen = 0, others = 0;
  };
  std::vector<Group> groups;
  for (const Eigen::Index i : order) {
    if (groups.empty() || x[i] > groups.back().value) groups.push_back({x[i]});
    ++(is_chosen[static_cast<std::size_t>(i)] ? groups.back().chosen : groups.back().others);
  }
  Common best;
  std::size_t first = 0;
  Common run;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (run.parted <= 0) {
      run = {};
      first = g;
    }
    run.chosen += groups[g].chosen;
    run.others += groups[g].others;
    run.parted = static_cast<double>(run.chosen) / chosen - static_cast<double>(run.others) / others;
    if (run.parted <= best.parted) continue;
    best = run;
    best.low = first == 0 ? -open : 0.5 * (groups[first - 1].value + groups[first].value);
    best.high = g + 1 == groups.size() ? open : 0.5 * (groups[g].value + groups[g + 1].value);
  }
  best.all_chosen = chosen;
  best.all_others = others;
  return best;
}

}  // namespace

std::vector<Common> what_is_common(const std::vector<Variable>& variables, const std::vector<char>& is_chosen) {
  const auto chosen = static_cast<int>(std::count_if(is_chosen.begin(), is_chosen.end(), [](char c) { return c; }));
  const int others = static_cast<int>(is_chosen.size()) - chosen;
  std::vector<Common> list;
  if (chosen == 0 || others == 0) return list;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    list.push_back(best_range(variables[v].values, is_chosen, chosen, others));
    list.back().variable = v;
  }
  std::stable_sort(list.begin(), list.end(), [](const Common& a, const Common& b) { return a.parted > b.parted; });
  return list;
}

Message common_text(const Common& c, const Variable& v) {
  const bool low = c.low > -open, high = c.high < open;
  if (!low && !high) return message("{} does not part these from the rest.", v.name);
  const bool all = c.chosen == c.all_chosen;
  const Message who = all ? message("All {}", c.all_chosen) : message("{} of these {}", c.chosen, c.all_chosen);
  const std::string unit = v.unit.empty() || v.kind == VariableKind::order ? "" : " " + v.unit;
  Message what;
  if (v.kind == VariableKind::approach) {
    what = message("share the {} ({})", v.name, low ? "positive" : "negative");
  } else if (low && high) {
    what = message("have the {} between {:.3g} and {:.3g}{}", v.name, c.low, c.high, unit);
  } else if (low) {
    what = message("have the {} above {:.3g}{}", v.name, c.low, unit);
  } else {
    what = message("have the {} below {:.3g}{}", v.name, c.high, unit);
  }
  const Message rest = c.others == 0                 ? Message("none")
                       : 2 * c.others > c.all_others ? message("{} too", c.others)
                                                     : message("only {}", c.others);
  return message("{} {}; of the other {} {}.", who, what, c.all_others, rest);
}

}  // namespace handsight
