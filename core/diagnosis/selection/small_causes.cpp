// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/small_causes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis/space/spreading.h"

namespace handsight {
namespace {

Chosen without_name(const ModelSpace& all, Chosen chosen, std::size_t name) {
  std::erase_if(chosen, [&](std::size_t u) { return all.units()[u].name == name; });
  return chosen;
}

}  // namespace

std::vector<SmallCauses> find_small_causes(const ModelSpace& all, const Chosen& chosen) {
  constexpr double least_told = 1 / 21.0, largest_share = 0.95;
  std::vector<SmallCauses> causes(all.names().size());
  if (chosen.empty()) return causes;
  const Spreading spreading(all, chosen);
  const double alone = spreading.worth(chosen), beside = spreading.sum(chosen, std::nullopt, std::nullopt).ln;
  for (std::size_t name = 0; name < causes.size(); ++name) {
    const Chosen fewer = without_name(all, chosen, name);
    if (fewer.size() == chosen.size()) continue;
    const Spreading::Sum instead = spreading.sum(fewer, std::nullopt, name);
    double others = 0;
    for (const double worth : {alone, beside, spreading.sum(fewer, name, std::nullopt).ln})
      others += std::exp(std::min(700.0, worth - instead.ln));
    const double share = 1 / (1 + others);
    causes[name].share = std::min(share, largest_share);
    if (share < least_told) continue;
    for (const SpreadName& s : instead.likeliest) causes[name].names.push_back(all.names()[s.name].id);
  }
  return causes;
}

double ln_standing(const std::vector<SmallCauses>& causes) {
  double ln = 0;
  for (const SmallCauses& of_name : causes) ln += std::log1p(-of_name.share);
  return ln;
}

}  // namespace handsight
