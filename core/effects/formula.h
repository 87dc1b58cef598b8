// SPDX-License-Identifier: Apache-2.0
// Formulas of effects: numbers, parameters and variables of an observation (parsed by muParser).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handsight {

/// Functions: sin cos tan tanh exp log (natural) sqrt abs sign min max; + - * / ^, comparisons, && ||, c ? a : b; pi.
/// One formula may be evaluated from several threads.
class Formula {
 public:
  /// `names` are those that the formula may use, in the order of the numbers given to value(). Throws InputError "...
  /// column 7 ..." where the formula is not understood; `place` begins the sentence.
  Formula(const std::string& text, const std::vector<std::string>& names, const std::string& place);

  double value(std::span<const double> numbers) const;

  /// The places in `names` of those that it uses.
  const std::vector<std::size_t>& used() const;

 private:
  struct Parsed;
  std::shared_ptr<Parsed> parsed_;
};

}  // namespace handsight
