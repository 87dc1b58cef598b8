// SPDX-License-Identifier: Apache-2.0
// What the core can say, read from its sources: the forms of its messages and the words that are put into them.
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "base/files.h"

namespace handsight::test {

/// What stands between the quotes of one or several literals.
inline QString joined_literals(const QString& literals) {
  static const QRegularExpression one("\"((?:[^\"\\\\]|\\\\.)*)\"");
  QString text;
  for (auto i = one.globalMatch(literals); i.hasNext();) text += i.next().captured(1);
  return text.replace("\\\"", "\"").replace("\\n", "\n").replace("\\\\", "\\");
}

inline QString core_source(const std::filesystem::path& file) {
  static const QRegularExpression comment("(?<!:)//[^\n]*"), quote("'\\\\?\"'");
  return QString::fromStdString(read_file(file)).remove(comment).replace(quote, "0");
}

/// The place of the bracket that closes the one at `open`, literals left aside; -1 where none does.
inline qsizetype closing(const QString& text, qsizetype open) {
  int depth = 0;
  for (qsizetype i = open; i < text.size(); ++i) {
    if (text[i] == '"') {
      for (++i; i < text.size() && text[i] != '"'; ++i)
        if (text[i] == '\\') ++i;
    } else if (text[i] == '(' || text[i] == '{' || text[i] == '[') {
      ++depth;
    } else if ((text[i] == ')' || text[i] == '}' || text[i] == ']') && --depth == 0) {
      return i;
    }
  }
  return -1;
}

/// "{} has {:.{}f}" as the message has it: "%1 has %2".
inline QString form_of(const QString& literal) {
  QString form;
  int next = 0;
  QList<int> order;
  for (qsizetype i = 0; i < literal.size(); ++i) {
    const bool is_brace = literal[i] == '{' || literal[i] == '}';
    if (is_brace && i + 1 < literal.size() && literal[i + 1] == literal[i]) {
      form += literal[i++];
      continue;
    }
    const qsizetype end = literal[i] == '{' ? closing(literal, i) : -1;
    if (end < 0) {
      form += literal[i];
      continue;
    }
    const QString inside = literal.mid(i + 1, end - i - 1);
    const QString digits = inside.section(':', 0, 0);
    const int index = digits.isEmpty() ? next++ : digits.toInt();
    next += static_cast<int>(inside.count("{}"));
    if (!order.contains(index)) order << index;
    form += '%' + QString::number(order.indexOf(index) + 1);
    i = end;
  }
  return form;
}

/// The text without calls of these functions, from their names to the closing brackets.
inline QString without_calls(QString text, const QRegularExpression& names) {
  for (auto call = names.match(text); call.hasMatch(); call = names.match(text)) {
    const qsizetype end = closing(text, call.capturedEnd() - 1);
    text.replace(call.capturedStart(), (end < 0 ? text.size() : end + 1) - call.capturedStart(), "0");
  }
  return text;
}

/// Literals that are words: what is compared, handed to another function, a name with _ or one letter is none.
inline QStringList words_in(QString text) {
  static const QRegularExpression other("(?<!\\w)(?!(?:Message|refuse|InputError)\\()[A-Za-z_]\\w*\\("),
      compared("(?:==|!=) *\"(?:[^\"\\\\]|\\\\.)*\"|\\w+\\[\"[^\"]*\"\\]|\"\\w*\"(?=\\[)"),
      literals("(?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+"), letters("[A-Za-z]{2}"), name("^[a-z]+(_[a-z]+)+$");
  text = without_calls(text, other).remove(compared);
  QStringList words;
  for (auto i = literals.globalMatch(text); i.hasNext();) {
    const QString word = joined_literals(i.next().captured());
    if (word.contains(letters) && !word.contains(name)) words << word;
  }
  return words;
}

/// Every form and word of one source that is said to people.
inline QStringList said_in(const QString& source) {
  static const QRegularExpression message("(?<![\\w:])message\\("),
      literals("^\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)"),
      whole(
          "(?<![\\w:])(?:InputError|DriverFault|Message|refuse)\\(|"
          "(?:notes|took|lost|warnings|problems|contents|doubts|texts)_?(?:\\.|->)(?:push|emplace)_back\\("),
      sayer("\\n(?:static )?(?:Message|std::vector<Message>) (?:\\w+::)*\\w+\\("),
      reported("\\breturn\\b((?:[^;\"]|\"(?:[^\"\\\\]|\\\\.)*\")*);"), letters("[A-Za-z]{2}");
  QStringList said;
  for (auto i = message.globalMatch(source); i.hasNext();) {
    const auto call = i.next();
    const qsizetype end = closing(source, call.capturedEnd() - 1);
    if (end < 0) continue;
    const QString inside = source.mid(call.capturedEnd(), end - call.capturedEnd());
    const auto first = literals.match(inside);
    if (!first.hasMatch()) continue;
    const QString form = form_of(joined_literals(first.captured(1)));
    if (QString(form).remove(QRegularExpression("%\\d")).contains(letters)) said << form;
    said << words_in(inside.mid(first.capturedEnd()));
  }
  for (auto i = whole.globalMatch(source); i.hasNext();) {
    const auto call = i.next();
    const qsizetype end = closing(source, call.capturedEnd() - 1);
    if (end < 0) continue;
    said << words_in(source.mid(call.capturedEnd(), end - call.capturedEnd()));
  }
  for (auto i = sayer.globalMatch(source); i.hasNext();) {
    const qsizetype arguments = closing(source, i.next().capturedEnd() - 1), body = source.indexOf('{', arguments);
    if (body < 0 || source.mid(arguments, body - arguments).contains(';')) continue;
    const qsizetype end = closing(source, body);
    if (end < 0) continue;
    const QString text = source.mid(body, end - body);
    for (auto k = reported.globalMatch(text); k.hasNext();) said << words_in(k.next().captured(1));
  }
  return said;
}

/// All sources of the core that speak in the window.
inline std::map<QString, std::string> said_by_the_core() {
  std::map<QString, std::string> said;
  const auto core = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "core";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(core)) {
    const std::string file = entry.path().lexically_relative(core).string();
    if (entry.path().extension() != ".cpp" || file.starts_with("base/message")) continue;
    for (const QString& form : said_in(core_source(entry.path()))) said.emplace(form, file);
  }
  return said;
}

/// All literals of the core, as forms.
inline std::set<QString> literals_of_the_core() {
  static const QRegularExpression literals("(?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+");
  std::set<QString> all;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "core")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    const QString source = core_source(entry.path());
    for (auto i = literals.globalMatch(source); i.hasNext();) {
      const QString text = joined_literals(i.next().captured());
      all.insert(text);
      all.insert(form_of(text));
    }
  }
  return all;
}

}  // namespace handsight::test
