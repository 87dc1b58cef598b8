// SPDX-License-Identifier: GPL-3.0-or-later
// What the core says in English, in the window's language.
#pragma once

#include <QString>
#include <exception>
#include <string>

namespace handsight::app {

/// A text of the catalogue (a title, a cause, a number's name) or a sentence of the core, translated by the contexts
/// "effects" and "core" of resources/translations; as it stands where these do not have it.
QString translated(const std::string& english);

/// What is said of a file, whichever it is: the same, by the context "errors" too.
QString translated_of_file(const std::string& english);
QString translated_error(const std::exception& error);

/// So many digits of a number, with the decimal mark of the window's language: 9.1, 0.24, 1200.
QString short_number(double value, int digits = 2);

/// A title as it stands within a sentence: English begins it small, a language that writes its nouns with a capital
/// leaves it.
QString within_sentence(QString title);

}  // namespace handsight::app
