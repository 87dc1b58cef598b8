// SPDX-License-Identifier: Apache-2.0
// Formulas of effects as trees, so that they can be written in other languages. What effects/formula.h evaluates and no
// more: + - * / ^, comparisons, && ||, c ? a : b, its functions, pi.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace handsight {

/// A number, a name, or an operator or function with its parts. "negate" is the sign; "?" has three parts.
struct Expression {
  enum class Kind { number, name, operation, function };
  Kind kind = Kind::number;
  double number = 0;
  std::string word;  // name, operator or function
  std::vector<Expression> parts;
};

/// Parses a formula that effects/formula.h understands, with the same precedences. InputError where it is another.
Expression parse_expression(const std::string& text);

/// Replaces every name by what `of_name` gives for it.
Expression with_names(const Expression& expression, const std::function<Expression(const std::string&)>& of_name);

Expression number_expression(double number);
Expression name_expression(const std::string& name);

/// C++17 over <cmath> and <algorithm>; `sign_of` must be there. Names stand as they are.
std::string cpp_text(const Expression& expression);

/// Python 3 over `math`; `sign_of` must be there.
std::string python_text(const Expression& expression);

}  // namespace handsight
