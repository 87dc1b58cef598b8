// SPDX-License-Identifier: Apache-2.0
// What is said to people, as data: an English form with places for what is put in. The form is the message's id: it
// stands once, where it is said; the window's translations are keyed by it, and nothing ever has to be read back out of
// a finished sentence.
#pragma once

#include <fmt/format.h>

#include <array>
#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace handsight {

/// A sentence or a part of one.
class Message {
 public:
  enum class Kind {
    form,      // English, to be translated, with %1, %2 ... for the arguments
    verbatim,  // the same in each language: a name, a path, what a library said
    number,    // written with a decimal point, which is a comma elsewhere
    sequence,  // the arguments one after another
  };

  Message() = default;
  /// A form without places, or a word that is translated.
  Message(const char* form) : text_(form) {}  // NOLINT(google-explicit-constructor)
  /// What stays as it is in each language.
  explicit Message(std::string verbatim) : kind_(Kind::verbatim), text_(std::move(verbatim)) {}
  Message(Kind kind, std::string text, std::vector<Message> arguments = {})
      : kind_(kind), text_(std::move(text)), arguments_(std::move(arguments)) {}

  Kind kind() const { return kind_; }
  /// The form with its places, or the text itself of what is verbatim or a number; empty for a sequence.
  const std::string& form() const { return text_; }
  /// What takes the places %1, %2 ..., in this order.
  const std::vector<Message>& arguments() const { return arguments_; }
  bool empty() const { return text_.empty() && arguments_.empty(); }

  std::string english() const;
  /// Where a text stands in the English, as std::string has it.
  std::size_t find(std::string_view text) const { return english().find(text); }
  operator std::string() const { return english(); }  // NOLINT(google-explicit-constructor)

  Message& operator+=(const Message& after);
  friend Message operator+(Message before, const Message& after) { return before += after; }
  /// Whether both say the same in English.
  friend bool operator==(const Message& a, const Message& b) { return a.english() == b.english(); }
  friend bool operator==(const Message& a, const std::string& english) { return a.english() == english; }
  friend bool operator==(const Message& a, const char* english) { return a.english() == english; }
  friend std::ostream& operator<<(std::ostream& stream, const Message& message);

 private:
  Kind kind_ = Kind::form;
  std::string text_;
  std::vector<Message> arguments_;
};

/// What stays as it is in each language.
inline Message verbatim(std::string text) { return {Message::Kind::verbatim, std::move(text)}; }

/// A number that is written already: "0.53", "1200".
inline Message number(std::string text) { return {Message::Kind::number, std::move(text)}; }

/// A text of the catalogue or of another table, which is looked up as it is: a title, a cause, a unit.
inline Message looked_up(std::string text) { return {Message::Kind::form, std::move(text)}; }

std::vector<Message> verbatim(const std::vector<std::string>& texts);
std::vector<std::string> english(const std::vector<Message>& messages);

/// The messages one after another with `between` between them, and `before_last` before the last.
Message joined(const std::vector<Message>& messages, const Message& between, const Message& before_last);
inline Message joined(const std::vector<Message>& messages, const Message& between = ", ") {
  return joined(messages, between, between);
}

namespace detail {

/// How an argument is kept in a message, and the argument itself where it is one.
struct Kept {
  Message::Kind kind = Message::Kind::verbatim;
  const Message* message = nullptr;
};

template <class T>
Kept kept(const T& argument) {
  using Plain = std::decay_t<T>;
  if constexpr (std::is_same_v<Plain, Message>) return {Message::Kind::form, &argument};
  if constexpr (std::is_same_v<Plain, const char*> || std::is_same_v<Plain, char*>) return {Message::Kind::form};
  if constexpr (std::is_arithmetic_v<Plain> && !std::is_same_v<Plain, char> && !std::is_same_v<Plain, bool>)
    return {Message::Kind::number};
  return {};
}

Message message(std::string_view form, const Kept* kept, fmt::format_args arguments);

}  // namespace detail
}  // namespace handsight

template <>
struct fmt::formatter<handsight::Message> : fmt::formatter<std::string> {
  template <class Context>
  auto format(const handsight::Message& message, Context& context) const {
    return fmt::formatter<std::string>::format(message.english(), context);
  }
};

namespace handsight {

/// The message of a form of fmt and its arguments: message("{} has {:.1f} mm", name, size). A Message keeps its parts,
/// a `const char*` is a word to translate, a number keeps its digits, all else is verbatim. Each argument takes one
/// place.
template <class... Arguments>
Message message(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
  const std::array<detail::Kept, sizeof...(Arguments) + 1> kept{detail::kept(arguments)...};
  const fmt::string_view text = form;
  return detail::message({text.data(), text.size()}, kept.data(), fmt::make_format_args(arguments...));
}

}  // namespace handsight
