// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/core_words.h"

#include <QCoreApplication>
#include <QObject>

namespace handsight::app {
namespace {

/// The core writes what every terminal has.
QString said_in(const char* context, const std::string& english) {
  if (english.empty()) return {};
  return QCoreApplication::translate(context, english.c_str()).replace(" +- ", QString::fromUtf8(" ± "));
}

}  // namespace

QString translated(const std::string& english) { return said_in("core", english); }

QString translated_of_file(const std::string& english) { return said_in("errors", english); }

QString translated_error(const std::exception& error) { return translated_of_file(error.what()); }

QString within_sentence(QString title) {
  // As Qt asks for the direction of writing: what the translation of a text is tells of the language.
  static constexpr const char* english = "a noun begins small";
  if (!title.isEmpty() && QObject::tr("a noun begins small") == QLatin1String(english)) title[0] = title[0].toLower();
  return title;
}

}  // namespace handsight::app
