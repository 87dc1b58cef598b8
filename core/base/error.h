// SPDX-License-Identifier: Apache-2.0
// The three roads of errors: Check (our own broken promise), InputError (the user's bad input);
// "cannot be computed here" is an optional or a status in the result, never an exception.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "base/message.h"

namespace handsight {

/// Bad input: one sentence of 20 to 600 characters that says what is wrong, where, and what was expected; `what` is its
/// English.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const Message& sentence) : InputError(sentence, sentence.english()) {}
  /// `english`: the sentence as it is shown, where that is shorter.
  InputError(const Message& sentence, const std::string& english)
      : std::runtime_error(english), sentence_(std::make_shared<const Message>(sentence)) {}

  const Message& sentence() const { return *sentence_; }

 private:
  std::shared_ptr<const Message> sentence_;  // an exception is copied without throwing another
};

/// A promise of our own code that does not hold.
class BrokenPromise : public std::logic_error {
 public:
  explicit BrokenPromise(const std::string& what) : std::logic_error(what) {}
};

/// Throws BrokenPromise with the formatted text where `holds` is false.
template <class... Args>
void check(bool holds, fmt::format_string<Args...> text, Args&&... args) {
  if (!holds) throw BrokenPromise(fmt::format(text, std::forward<Args>(args)...));
}

}  // namespace handsight
