// SPDX-License-Identifier: Apache-2.0
// Formulas mean the same as muParser's wherever they are written.
#include "export/expression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "effects/formula.h"
#include "fixtures/robots_with_everything.h"

namespace handsight {
namespace {

/// A formula over x and y drawn at random; of every operator and function.
std::string drawn(std::mt19937_64& random, int depth) {
  const auto part = [&] { return drawn(random, depth - 1); };
  if (depth == 0) {
    static const char* const leaves[] = {"x", "y", "2", "0.5", "1e-3", "3.25E+1", "pi", ".75"};
    return leaves[random() % 8];
  }
  static const char* const binary[] = {"+", "-", "*", "/", "^", "<", ">", "<=", ">=", "==", "!="};
  static const char* const unary[] = {"sin", "cos", "tan", "tanh", "exp", "log", "sqrt", "abs", "sign"};
  switch (random() % 9) {
    case 8:  // muParser cuts constants beside && and || to whole numbers: there a condition is meant
      return part() + (random() % 2 ? " < x && y >= " : " > y || x != ") + part();
    case 0:
      return std::string(unary[random() % 9]) + "(" + part() + ")";
    case 1:
      return std::string(random() % 2 ? "min" : "max") + "(" + part() + ", " + part() + ")";
    case 2:
      return "(" + part() + " ? " + part() + " : " + part() + ")";
    case 3:
      return "(" + part() + ")";
    case 4:
      return "-" + part();
    default:
      return part() + " " + binary[random() % 11] + " " + part();  // precedence decides
  }
}

struct Case {
  std::string formula;
  double x, y, value;
};

std::vector<Case> cases() {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-2, 2);
  std::vector<Case> all;
  while (all.size() < 1500) {
    Case c{drawn(random, 1 + static_cast<int>(random() % 4)), uniform(random), uniform(random), 0};
    try {
      c.value = Formula(c.formula, {"x", "y"}, "here").value(std::array{c.x, c.y});
    } catch (const InputError&) {
      continue;  // two signs in a row: muParser refuses them
    }
    if (std::isfinite(c.value) && std::abs(c.value) < 1e12) all.push_back(c);
  }
  return all;
}

void expect_values(const std::vector<Case>& cases, const std::vector<fixture::Answer>& found, const char* language) {
  ASSERT_EQ(found.size(), cases.size()) << language;
  for (std::size_t i = 0; i < cases.size(); ++i)
    EXPECT_NEAR(found[i].numbers.at(0), cases[i].value, 1e-12 * (1 + std::abs(cases[i].value)))
        << language << ": " << cases[i].formula << " at " << cases[i].x << " " << cases[i].y;
}

TEST(Expression, MeansTheSameInCppAndPythonAsInAFormula) {
  const std::vector<Case> all = cases();
  const TemporaryFolder folder;
  std::ofstream cpp(folder.path / "f.cpp"), python(folder.path / "f.py");
  cpp.precision(17);
  python.precision(17);
  cpp << "#include <algorithm>\n#include <cmath>\n#include <cstdio>\n"
         "double sign_of(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }\nint main() { double x, y;\n";
  python << "import math\ndef sign_of(x):\n    return 1.0 if x > 0 else -1.0 if x < 0 else 0.0\n";
  for (const Case& c : all) {
    const Expression e = parse_expression(c.formula);
    cpp << "x = " << c.x << "; y = " << c.y << "; (void)x; (void)y; std::printf(\"%.17g\\n\", " << cpp_text(e)
        << ");\n";
    // Python raises where C++ has a number that is not finite; only what is asked for may do so.
    python << "x = " << c.x << "\ny = " << c.y << "\ntry:\n    print(repr(float(" << python_text(e)
           << ")))\nexcept (ValueError, OverflowError, ZeroDivisionError):\n    print(" << c.value << ")\n";
  }
  cpp << "}\n";
  cpp.close();
  python.close();
  ASSERT_EQ(fixture::compiled(folder.path / "f.cpp", folder.path / "f", "-O0 -Wno-float-equal"), "");
  expect_values(all, fixture::answers(folder.path, "'" + (folder.path / "f").string() + "'", {}), "C++");
  expect_values(all, fixture::answers(folder.path, "python3 '" + (folder.path / "f.py").string() + "'", {}), "Python");
}

TEST(Expression, RefusesWhatIsNoFormula) {
  for (const char* text : {"", "x +", "sin x", "sinh(x)", "min(x)", "x y", "2q", "(x", "x ? y", "a = 3", "x, y", "$"})
    EXPECT_THROW(parse_expression(text), InputError) << text;
}

}  // namespace
}  // namespace handsight
