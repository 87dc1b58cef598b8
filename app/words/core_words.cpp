// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/core_words.h"

#include <QCoreApplication>
#include <QObject>
#include <cmath>
#include <vector>

#include "base/error.h"

namespace handsight::app {
namespace {

/// The translation of "%1 has %2" and the like, with its places.
QString looked_up(const std::string& form) { return QCoreApplication::translate("core", form.c_str()); }

/// The core writes what every terminal has. No line ends after the sign in brackets. A unit stands alone in its
/// message.
QString with_signs(QString text) {
  if (text == "um" || text.startsWith("urad") || text.startsWith("um/")) text[0] = QChar(0x00B5);
  return text.replace("(+- ", QString::fromUtf8("(±\u00a0")).replace("+-", QString::fromUtf8("±"));
}

/// Also with a true minus: the core writes what every terminal has.
QString with_mark(QString number) {
  if (number.startsWith('-')) number[0] = QChar(0x2212);
  const QString mark = QObject::tr("decimal point");  // the mark itself where it is translated
  return mark.size() == 1 ? number.replace('.', mark) : number;
}

QString put_in(const QString& form, const std::vector<Message>& arguments) {
  QString text;
  for (qsizetype i = 0; i < form.size(); ++i) {
    const qsizetype place = form[i] == '%' && i + 1 < form.size() ? form[i + 1].digitValue() : -1;
    if (place < 1 || place > static_cast<qsizetype>(arguments.size())) {
      text += form[i];
      continue;
    }
    text += translated(arguments[static_cast<std::size_t>(place - 1)]);
    ++i;
  }
  return text;
}

}  // namespace

QString translated(const Message& message) {
  QString text = QString::fromStdString(message.form());
  switch (message.kind()) {
    case Message::Kind::verbatim:
      return text;
    case Message::Kind::number:
      return with_mark(text);
    case Message::Kind::form:
      return text.isEmpty() ? text : put_in(with_signs(looked_up(message.form())), message.arguments());
    case Message::Kind::sequence:
      break;
  }
  QString all;
  for (const Message& part : message.arguments()) all += translated(part);
  return all;
}

QString translated(const std::string& text) { return translated(handsight::looked_up(text)); }

QString translated_error(const std::exception& error) {
  const auto* const reported = dynamic_cast<const InputError*>(&error);
  return reported ? translated(reported->sentence()) : translated(std::string(error.what()));
}

QString short_number(double value, int digits) {
  int before = value != 0 ? static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1 : 1;
  if (std::round(std::abs(value) * std::pow(10, digits - before)) >= std::pow(10, digits)) ++before;  // 0.996 is 1.0
  return with_mark(QString::number(value, 'f', std::max(digits - before, 0)));
}

QString within_sentence(QString title) {
  // As Qt asks for the direction of writing: what the translation of a text is tells of the language.
  static constexpr const char* english = "a noun begins small";
  if (!title.isEmpty() && QObject::tr("a noun begins small") == QLatin1String(english)) title[0] = title[0].toLower();
  return title;
}

}  // namespace handsight::app
