// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/core_words.h"

#include <QCoreApplication>
#include <QObject>
#include <cmath>

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

QString short_number(double value, int digits) {
  int before = value != 0 ? static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1 : 1;
  if (std::round(std::abs(value) * std::pow(10, digits - before)) >= std::pow(10, digits)) ++before;  // 0.996 is 1.0
  const QString mark = QObject::tr("decimal point");  // the mark itself where it is translated
  QString text = QString::number(value, 'f', std::max(digits - before, 0));
  return mark.size() == 1 ? text.replace('.', mark) : text;
}

QString within_sentence(QString title) {
  // As Qt asks for the direction of writing: what the translation of a text is tells of the language.
  static constexpr const char* english = "a noun begins small";
  if (!title.isEmpty() && QObject::tr("a noun begins small") == QLatin1String(english)) title[0] = title[0].toLower();
  return title;
}

}  // namespace handsight::app
