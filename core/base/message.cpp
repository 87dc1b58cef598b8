// SPDX-License-Identifier: Apache-2.0
#include "base/message.h"

#include <ostream>
#include <stdexcept>

namespace handsight {
namespace {

/// The whole number at the text's start, taken off it; `next`, counted up, where there is none.
std::size_t take_index(std::string_view& text, std::size_t& next) {
  if (text.empty() || text[0] < '0' || text[0] > '9') return next++;
  std::size_t index = 0;
  while (!text.empty() && text[0] >= '0' && text[0] <= '9') {
    index = 10 * index + static_cast<std::size_t>(text[0] - '0');
    text.remove_prefix(1);
  }
  return index;
}

/// The characters of a place between its braces: the end of "{:.{}f}" is its second brace.
std::size_t end_of_place(std::string_view form) {
  int depth = 0;
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] == '{') ++depth;
    if (form[i] == '}' && --depth == 0) return i;
  }
  return form.size();
}

/// One place of a form: which argument it takes, and that argument as it is shown.
struct Place {
  std::size_t index = 0;
  std::string format;  // of fmt, with every index written out
};

/// `inside`: what stands between the braces. A number of digits that is an argument too ("{:.{}f}") gets its index.
Place locate(std::string_view inside, std::size_t& next) {
  Place place{.index = take_index(inside, next), .format = {}};
  place.format = "{" + std::to_string(place.index);
  while (!inside.empty()) {
    place.format += inside[0];
    const bool opens = inside[0] == '{';
    inside.remove_prefix(1);
    if (opens) place.format += std::to_string(take_index(inside, next));
  }
  place.format += "}";
  return place;
}

std::string with_arguments(const std::string& form, const std::vector<Message>& arguments) {
  std::string text;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const std::size_t digit =
        form[i] == '%' && i + 1 < form.size() ? static_cast<std::size_t>(form[i + 1] - '1') : arguments.size();
    if (digit < arguments.size()) {
      text += arguments[digit].english();
      ++i;
    } else {
      text += form[i];
    }
  }
  return text;
}

}  // namespace

std::string Message::english() const {
  switch (kind_) {
    case Kind::verbatim:
    case Kind::number:
      return text_;
    case Kind::form:
      return with_arguments(text_, arguments_);
    case Kind::sequence:
      break;
  }
  std::string text;
  for (const Message& part : arguments_) text += part.english();
  return text;
}

Message& Message::operator+=(const Message& after) {
  if (after.empty()) return *this;
  if (empty()) return *this = after;
  if (kind_ != Kind::sequence) *this = Message(Kind::sequence, {}, {*this});
  arguments_.push_back(after);
  return *this;
}

std::ostream& operator<<(std::ostream& stream, const Message& message) { return stream << message.english(); }

std::vector<Message> verbatim(const std::vector<std::string>& texts) {
  std::vector<Message> messages;
  for (const std::string& text : texts) messages.push_back(verbatim(text));
  return messages;
}

std::vector<std::string> english(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(message.english());
  return texts;
}

Message joined(const std::vector<Message>& messages, const Message& between, const Message& before_last) {
  Message all;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (i > 0) all += i + 1 < messages.size() ? between : before_last;
    all += messages[i];
  }
  return all;
}

namespace detail {

Message message(std::string_view form, const Kept* kept, fmt::format_args arguments) {
  std::string text;
  std::vector<Message> put_in;
  std::vector<std::size_t> indices;  // of the arguments that stand in `put_in`
  std::size_t next = 0;
  const auto put = [&](const Place& place) {
    for (std::size_t i = 0; i < indices.size(); ++i)
      if (indices[i] == place.index) return i;
    const Kept& k = kept[place.index];
    put_in.push_back(k.message ? *k.message : Message(k.kind, fmt::vformat(place.format, arguments)));
    indices.push_back(place.index);
    return indices.size() - 1;
  };
  while (!form.empty()) {
    const bool is_brace = form[0] == '{' || form[0] == '}';
    const bool is_doubled = is_brace && form.size() > 1 && form[1] == form[0];
    if (!is_brace || is_doubled) {
      text += form[0];
      form.remove_prefix(is_doubled ? 2 : 1);
      continue;
    }
    const std::size_t end = end_of_place(form);
    text += '%' + std::to_string(put(locate(form.substr(1, end - 1), next)) + 1);
    form.remove_prefix(end + 1);
  }
  if (put_in.size() > 9) throw std::logic_error("the message \"" + text + "\" has more than nine places");
  return {Message::Kind::form, text, put_in};
}

}  // namespace detail
}  // namespace handsight
