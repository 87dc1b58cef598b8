// SPDX-License-Identifier: Apache-2.0
#include "effects/formula.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/text.h"

namespace handsight {

namespace {

double sign_of(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }

/// The functions that are promised, and no others: muParser has more, some of which differ between its versions.
void define_functions(mu::Parser& parser) {
  parser.ClearFun();
  parser.ClearConst();
  parser.DefineFun("sin", static_cast<double (*)(double)>([](double x) { return std::sin(x); }));
  parser.DefineFun("cos", static_cast<double (*)(double)>([](double x) { return std::cos(x); }));
  parser.DefineFun("tan", static_cast<double (*)(double)>([](double x) { return std::tan(x); }));
  parser.DefineFun("tanh", static_cast<double (*)(double)>([](double x) { return std::tanh(x); }));
  parser.DefineFun("exp", static_cast<double (*)(double)>([](double x) { return std::exp(x); }));
  parser.DefineFun("log", static_cast<double (*)(double)>([](double x) { return std::log(x); }));
  parser.DefineFun("sqrt", static_cast<double (*)(double)>([](double x) { return std::sqrt(x); }));
  parser.DefineFun("abs", static_cast<double (*)(double)>([](double x) { return std::abs(x); }));
  parser.DefineFun("sign", static_cast<double (*)(double)>(sign_of));
  parser.DefineFun("min", static_cast<double (*)(double, double)>([](double x, double y) { return std::min(x, y); }));
  parser.DefineFun("max", static_cast<double (*)(double, double)>([](double x, double y) { return std::max(x, y); }));
  parser.DefineConst("pi", 3.14159265358979323846);
}

[[noreturn]] void refuse_formula(const std::string& place, const std::string& text, const mu::ParserError& error) {
  const int at = error.GetPos();
  Message found = error.GetToken().empty() ? Message() : message(" at {}", in_quotes(error.GetToken()));
  if (at >= 0 && at < static_cast<int>(text.size())) found += message(", column {}", at + 1);
  throw InputError(
      message("{}: the formula {} is not understood{}; expected parameters, variables such as q, tau, velocity, "
              "time or q_NAME, "
              "numbers, + - * / ^ and the functions sin cos tan tanh exp log sqrt abs sign min max.",
              place, in_quotes(text, 120), found));
}

/// A parser reads its variables from numbers of its own.
struct Reader {
  std::optional<mu::Parser> parser;  // none before it has read
  std::vector<double> numbers;
  std::mutex one_at_a_time;

  void read(const std::string& text, const std::vector<std::string>& names) {
    numbers.assign(names.size(), 0.0);
    define_functions(parser.emplace());
    parser->SetExpr(text);
    for (std::size_t i = 0; i < names.size(); ++i) parser->DefineVar(names[i], &numbers[i]);
  }
};

}  // namespace

struct Formula::Parsed {
  std::string text;
  std::vector<std::string> names;
  std::vector<std::size_t> used;
  /// Threads that ask at the same time have one each; all but the first are made when they are needed.
  std::array<Reader, 8> readers;

  /// A reader that nobody uses, held.
  std::pair<Reader*, std::unique_lock<std::mutex>> free_reader() {
    for (Reader& reader : readers) {
      std::unique_lock lock(reader.one_at_a_time, std::try_to_lock);
      if (!lock) continue;
      if (!reader.parser) reader.read(text, names);
      return {&reader, std::move(lock)};
    }
    return {&readers.front(), std::unique_lock(readers.front().one_at_a_time)};
  }
};

Formula::Formula(const std::string& text, const std::vector<std::string>& names, const std::string& place)
    : parsed_(std::make_shared<Parsed>()) {
  Parsed& p = *parsed_;
  p.text = text;
  p.names = names;
  try {
    p.readers.front().read(text, names);
    mu::Parser& parser = *p.readers.front().parser;
    for (const auto& [name, address] : parser.GetUsedVar()) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        throw mu::ParserError(mu::ecUNASSIGNABLE_TOKEN, name, text, static_cast<int>(text.find(name)));
      p.used.push_back(static_cast<std::size_t>(found - names.begin()));
    }
    std::sort(p.used.begin(), p.used.end());
    parser.Eval();
    if (parser.GetNumResults() != 1) throw mu::ParserError(mu::ecUNEXPECTED_ARG_SEP, ",", text, -1);
  } catch (const mu::ParserError& error) {
    refuse_formula(place, text, error);
  }
}

double Formula::value(std::span<const double> numbers) const {
  check(numbers.size() == parsed_->names.size(), "a formula of {} names, but {} numbers", parsed_->names.size(),
        numbers.size());
  const auto [reader, held] = parsed_->free_reader();
  std::copy(numbers.begin(), numbers.end(), reader->numbers.begin());
  return reader->parser->Eval();
}

const std::vector<std::size_t>& Formula::used() const { return parsed_->used; }

}  // namespace handsight
