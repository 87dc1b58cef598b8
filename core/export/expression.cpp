// SPDX-License-Identifier: Apache-2.0
#include "export/expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {
namespace {

using Kind = Expression::Kind;

Expression operation(const std::string& word, std::vector<Expression> parts) {
  return {Kind::operation, 0, word, std::move(parts)};
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Recursive descent; each level parses what binds more tightly than the one that calls it.
class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  Expression whole() {
    Expression e = choice();
    skip_spaces();
    if (at_ < text_.size()) fail();
    return e;
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError(message("The formula {} cannot be written in another language: {} is not understood there.",
                             in_quotes(text_, 200), at_ < text_.size() ? message("column {}", at_ + 1) : "its end"));
  }
  void skip_spaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r'))
      ++at_;
  }
  bool take(const std::string& word) {
    skip_spaces();
    if (text_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }
  /// The first of these that stands here; longer ones first.
  std::string take_one(std::initializer_list<const char*> words) {
    for (const char* word : words)
      if (take(word)) return word;
    return "";
  }

  Expression choice() {
    Expression condition = any_of();
    if (!take("?")) return condition;
    Expression yes = choice();
    if (!take(":")) fail();
    return operation("?", {std::move(condition), std::move(yes), choice()});
  }
  Expression any_of() {
    Expression e = all_of();
    while (take("||")) e = operation("||", {std::move(e), all_of()});
    return e;
  }
  Expression all_of() {
    Expression e = comparison();
    while (take("&&")) e = operation("&&", {std::move(e), comparison()});
    return e;
  }
  Expression comparison() {
    Expression e = sum();
    for (std::string word; !(word = take_one({"<=", ">=", "==", "!=", "<", ">"})).empty();)
      e = operation(word, {std::move(e), sum()});
    return e;
  }
  Expression sum() {
    Expression e = product();
    for (std::string word; !(word = take_one({"+", "-"})).empty();) e = operation(word, {std::move(e), product()});
    return e;
  }
  Expression product() {
    Expression e = signed_power();
    for (std::string word; !(word = take_one({"*", "/"})).empty();) e = operation(word, {std::move(e), signed_power()});
    return e;
  }
  Expression signed_power() {
    if (take("-")) return operation("negate", {signed_power()});
    if (take("+")) return signed_power();
    Expression base = atom();
    if (take("^")) return operation("^", {std::move(base), signed_power()});  // from the right
    return base;
  }
  Expression atom() {
    skip_spaces();
    if (at_ >= text_.size()) fail();
    if (take("(")) {
      Expression e = choice();
      if (!take(")")) fail();
      return e;
    }
    if (is_letter(text_[at_])) return word();
    if (is_digit(text_[at_]) || text_[at_] == '.') return number();
    fail();
  }
  Expression number() {
    std::size_t end = at_;
    while (end < text_.size() && (is_digit(text_[end]) || text_[end] == '.')) ++end;
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      std::size_t digits = end + 1;
      if (digits < text_.size() && (text_[digits] == '+' || text_[digits] == '-')) ++digits;
      if (digits < text_.size() && is_digit(text_[digits])) {
        end = digits;
        while (end < text_.size() && is_digit(text_[end])) ++end;
      }
    }
    const auto value = parse_number(std::string_view(text_).substr(at_, end - at_));
    if (!value) fail();
    at_ = end;
    return number_expression(*value);
  }
  Expression word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string name = text_.substr(begin, at_ - begin);
    if (!take("(")) return name == "pi" ? number_expression(std::numbers::pi) : name_expression(name);
    static constexpr std::array functions{"sin",  "cos", "tan",  "tanh", "exp", "log",
                                          "sqrt", "abs", "sign", "min",  "max"};
    if (std::find(functions.begin(), functions.end(), name) == functions.end()) fail();
    Expression call{Kind::function, 0, name, {choice()}};
    while (take(",")) call.parts.push_back(choice());
    if (call.parts.size() != (name == "min" || name == "max" ? 2u : 1u) || !take(")")) fail();
    return call;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

bool is_comparison(const std::string& word) {
  return word == "<" || word == ">" || word == "<=" || word == ">=" || word == "==" || word == "!=";
}

std::string number_text(double number) {
  std::string text = format_number(number);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return number < 0 || std::signbit(number) ? "(" + text + ")" : text;
}

/// How a language writes what is not the same in both.
struct Language {
  std::string prefix;  // of functions
  bool is_python = false;
};

std::string make_text(const Expression& e, const Language& language);

/// As a condition: "1 < 2" in place of its number.
std::string condition_text(const Expression& e, const Language& l) {
  if (e.kind == Kind::operation && is_comparison(e.word))
    return "(" + make_text(e.parts[0], l) + " " + e.word + " " + make_text(e.parts[1], l) + ")";
  if (e.kind == Kind::operation && (e.word == "&&" || e.word == "||")) {
    const std::string word = !l.is_python ? e.word : e.word == "&&" ? "and" : "or";
    return "(" + condition_text(e.parts[0], l) + " " + word + " " + condition_text(e.parts[1], l) + ")";
  }
  return "(" + make_text(e, l) + " != 0.0)";
}

std::string choice_text(const std::string& condition, const std::string& yes, const std::string& no,
                        const Language& l) {
  return l.is_python ? "(" + yes + " if " + condition + " else " + no + ")"
                     : "(" + condition + " ? " + yes + " : " + no + ")";
}

std::string function_text(const Expression& e, const Language& l) {
  std::string arguments;
  for (const Expression& part : e.parts) arguments += (arguments.empty() ? "" : ", ") + make_text(part, l);
  std::string name = l.prefix + e.word;
  if (e.word == "sign") name = "sign_of";
  if (e.word == "abs") name = l.is_python ? "abs" : "std::abs";
  if (e.word == "min" || e.word == "max") name = l.is_python ? e.word : "std::" + e.word + "<double>";
  return name + "(" + arguments + ")";
}

std::string make_text(const Expression& e, const Language& l) {
  if (e.kind == Kind::number) return number_text(e.number);
  if (e.kind == Kind::name) return e.word;
  if (e.kind == Kind::function) return function_text(e, l);
  if (e.word == "negate") return "(-" + make_text(e.parts[0], l) + ")";
  if (e.word == "^") return l.prefix + "pow(" + make_text(e.parts[0], l) + ", " + make_text(e.parts[1], l) + ")";
  if (e.word == "?")
    return choice_text(condition_text(e.parts[0], l), make_text(e.parts[1], l), make_text(e.parts[2], l), l);
  if (is_comparison(e.word) || e.word == "&&" || e.word == "||")
    return choice_text(condition_text(e, l), "1.0", "0.0", l);
  return "(" + make_text(e.parts[0], l) + " " + e.word + " " + make_text(e.parts[1], l) + ")";
}

}  // namespace

Expression number_expression(double number) { return {Kind::number, number, "", {}}; }

Expression name_expression(const std::string& name) { return {Kind::name, 0, name, {}}; }

Expression parse_expression(const std::string& text) { return Parser(text).whole(); }

Expression with_names(const Expression& e, const std::function<Expression(const std::string&)>& of_name) {
  if (e.kind == Kind::name) return of_name(e.word);
  Expression copy = e;
  for (Expression& part : copy.parts) part = with_names(part, of_name);
  return copy;
}

std::string cpp_text(const Expression& expression) { return make_text(expression, {"std::", false}); }

std::string python_text(const Expression& expression) { return make_text(expression, {"math.", true}); }

}  // namespace handsight
