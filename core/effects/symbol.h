// SPDX-License-Identifier: Apache-2.0
// Numbers that are written instead of computed: what is done with them becomes a formula (effects/formula.h).
#pragma once

#include <string>
#include <utility>

namespace handsight {

class Symbol {
 public:
  /// A variable's or parameter's name, or a formula in brackets.
  explicit Symbol(std::string text) : text_(std::move(text)) {}
  Symbol(double number);  // NOLINT(google-explicit-constructor): 2 * q is meant to be written so

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

Symbol operator-(const Symbol& a);
Symbol operator+(const Symbol& a, const Symbol& b);
Symbol operator-(const Symbol& a, const Symbol& b);
Symbol operator*(const Symbol& a, const Symbol& b);
Symbol operator/(const Symbol& a, const Symbol& b);
Symbol operator>=(const Symbol& a, const Symbol& b);
Symbol operator<(const Symbol& a, const Symbol& b);

Symbol sin(const Symbol& a);
Symbol cos(const Symbol& a);
Symbol tan(const Symbol& a);
Symbol tanh(const Symbol& a);
Symbol exp(const Symbol& a);
Symbol sqrt(const Symbol& a);
Symbol abs(const Symbol& a);

/// `yes` where the condition holds, 0 elsewhere.
Symbol where(const Symbol& condition, const Symbol& yes);
inline double where(bool condition, double yes) { return condition ? yes : 0.0; }

}  // namespace handsight
