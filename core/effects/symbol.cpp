// SPDX-License-Identifier: Apache-2.0
#include "effects/symbol.h"

#include <fmt/format.h>

namespace handsight {
namespace {

Symbol between(const Symbol& a, const char* operation, const Symbol& b) {
  return Symbol(fmt::format("({} {} {})", a.text(), operation, b.text()));
}

Symbol of(const char* function, const Symbol& a) { return Symbol(fmt::format("{}({})", function, a.text())); }

}  // namespace

Symbol::Symbol(double number) : text_(number < 0 ? fmt::format("({})", number) : fmt::format("{}", number)) {}

Symbol operator-(const Symbol& a) { return Symbol(fmt::format("(-{})", a.text())); }
Symbol operator+(const Symbol& a, const Symbol& b) { return between(a, "+", b); }
Symbol operator-(const Symbol& a, const Symbol& b) { return between(a, "-", b); }
Symbol operator*(const Symbol& a, const Symbol& b) { return between(a, "*", b); }
Symbol operator/(const Symbol& a, const Symbol& b) { return between(a, "/", b); }
Symbol operator>=(const Symbol& a, const Symbol& b) { return between(a, ">=", b); }
Symbol operator<(const Symbol& a, const Symbol& b) { return between(a, "<", b); }

Symbol sin(const Symbol& a) { return of("sin", a); }
Symbol cos(const Symbol& a) { return of("cos", a); }
Symbol tan(const Symbol& a) { return of("tan", a); }
Symbol tanh(const Symbol& a) { return of("tanh", a); }
Symbol exp(const Symbol& a) { return of("exp", a); }
Symbol sqrt(const Symbol& a) { return of("sqrt", a); }
Symbol abs(const Symbol& a) { return of("abs", a); }

Symbol where(const Symbol& condition, const Symbol& yes) {
  return Symbol(fmt::format("({} ? {} : 0)", condition.text(), yes.text()));
}

}  // namespace handsight
