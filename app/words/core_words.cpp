// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/core_words.h"

#include <QCoreApplication>
#include <QObject>

namespace handsight::app {

QString translated(const std::string& english) {
  return english.empty() ? QString() : QCoreApplication::translate("core", english.c_str());
}

QString translated_of_file(const std::string& english) {
  return english.empty() ? QString() : QCoreApplication::translate("errors", english.c_str());
}

QString translated_error(const std::exception& error) { return translated_of_file(error.what()); }

QString within_sentence(QString title) {
  // As Qt asks for the direction of writing: what the translation of a text is tells of the language.
  static constexpr const char* english = "a noun begins small";
  if (!title.isEmpty() && QObject::tr("a noun begins small") == QLatin1String(english)) title[0] = title[0].toLower();
  return title;
}

}  // namespace handsight::app
