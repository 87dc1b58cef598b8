// SPDX-License-Identifier: GPL-3.0-or-later
// The window's language: English, or a translation from resources/translations (files of Qt's Linguist, read as they
// are).
#pragma once

#include <QHash>
#include <QTranslator>

class QCoreApplication;

namespace handsight::app {

/// Texts by what they are in English, wherever they stand; plurals by Qt's numbers (two forms: one, and all others).
/// What the core says is a Message, whose form ("%1: the image is cut off after %2 bytes") is looked up like any other
/// text and filled afterwards (words/core_words.h): nothing is read back out of a finished sentence.
class Translation : public QTranslator {
 public:
  /// Of "de" and the like; empty where there is none of that language.
  explicit Translation(const QString& language);
  QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
  bool isEmpty() const override { return forms_.isEmpty(); }
  /// What is translated in that context, for tests.
  QStringList sources(const QString& context) const { return sources_.value(context); }

 private:
  QHash<QString, QStringList> forms_, sources_;
};

/// Those that there are, besides English, each a file of resources/translations: "de".
QStringList languages();

/// Speaks this language from now on ("en", "de"; empty: the desktop's, where there is a translation). Texts that are
/// shown already stay as they are: before the window is made.
void speak(QCoreApplication& application, const QString& language);

}  // namespace handsight::app
