// SPDX-License-Identifier: GPL-3.0-or-later
// The window's language: English, or a translation from resources/translations (files of Qt's Linguist, read as they
// are).
#pragma once

#include <QHash>
#include <QTranslator>

class QCoreApplication;

namespace handsight::app {

/// Texts by what they are in English, wherever they stand; plurals by Qt's numbers (two forms: one, and all others).
class Translation : public QTranslator {
 public:
  /// Of "de" and the like; empty where there is none of that language.
  explicit Translation(const QString& language);
  QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
  bool isEmpty() const override { return forms_.isEmpty(); }
  /// What is translated, for tests.
  QStringList sources() const { return forms_.keys(); }

 private:
  QHash<QString, QStringList> forms_;
};

/// Those that there are, besides English: "de".
QStringList languages();

/// Speaks this language from now on ("en", "de"; empty: the desktop's, where there is a translation). Texts that are
/// shown already stay as they are: before the window is made.
void speak(QCoreApplication& application, const QString& language);

}  // namespace handsight::app
