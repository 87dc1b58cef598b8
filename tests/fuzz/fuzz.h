// SPDX-License-Identifier: Apache-2.0
// What every fuzzer of a reader asks for.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "base/text.h"

namespace handsight {

/// Stops the fuzzer where a promise does not hold.
inline void demand(bool holds, const char* promise, const std::string& what = {}) {
  if (holds) return;
  std::fprintf(stderr, "Broken promise: %s\n%s\n", promise, what.c_str());
  std::abort();
}

/// Refusals are one sentence for people; anything else that is thrown ends the fuzzer.
inline void demand_sentence(const InputError& error) {
  const std::string sentence = error.what();
  demand(sentence.size() >= 20 && sentence.size() <= 600, "a refusal has 20 to 600 characters", sentence);
  demand(sentence.find('\n') == std::string::npos, "a refusal is one line", sentence);
  demand(is_utf8(sentence), "a refusal is UTF-8", sentence);
  demand(sentence.find("expected") != std::string::npos, "a refusal says what was expected", sentence);
}

}  // namespace handsight
