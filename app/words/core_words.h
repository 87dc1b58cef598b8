// SPDX-License-Identifier: GPL-3.0-or-later
// What the core says, in the window's language.
#pragma once

#include <QString>
#include <exception>
#include <string>

#include "base/message.h"

namespace handsight::app {

/// A message of the core: its form is looked up (resources/translations), its arguments are translated in their turn,
/// numbers get the decimal mark of the language, and what is verbatim stays. English where there is no translation.
QString translated(const Message& message);

/// A text of the catalogue (a title, a cause, a number's name, a unit), looked up as it is.
QString translated(const std::string& text);
inline QString translated(const char* text) { return translated(Message(text)); }

/// What went wrong, as the window says it.
QString translated_error(const std::exception& error);

/// So many digits of a number, with the decimal mark of the window's language: 9.1, 0.24, 1200.
QString short_number(double value, int digits = 2);

/// A title as it stands within a sentence: English begins it small, a language that writes its nouns with a capital
/// leaves it.
QString within_sentence(QString title);

}  // namespace handsight::app
