// SPDX-License-Identifier: GPL-3.0-or-later
// The window's language: English, or a translation from resources/translations (files of Qt's Linguist, read as they
// are).
#pragma once

#include <QHash>
#include <QRegularExpression>
#include <QTranslator>
#include <vector>

class QCoreApplication;

namespace handsight::app {

/// Texts by what they are in English, wherever they stand; plurals by Qt's numbers (two forms: one, and all others). In
/// the contexts "core" and "errors" a text with %1, %2 ... stands for every sentence of that form: what takes their
/// places is translated in its turn where that is known ("rejected: %1"). Forms of errors ("%1, line %2: %3") are so
/// wide that they count for errors alone.
class Translation : public QTranslator {
 public:
  /// Of "de" and the like; empty where there is none of that language.
  explicit Translation(const QString& language);
  QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
  bool isEmpty() const override { return forms_.isEmpty(); }
  /// What is translated in that context, for tests.
  QStringList sources(const QString& context) const { return sources_.value(context); }

 private:
  /// A sentence of the core with places for what is put in.
  struct Phrase {
    QString begin;  // up to the first place
    QRegularExpression form;
    QStringList places;  // "%1" and so on, in the order of the English sentence
    QString translated;
  };
  using Phrases = std::vector<Phrase>;  // those that say most first
  static Phrase phrase_of(const QString& source, const QString& translated);
  QString of_place(const QString& put_in, bool is_error) const;
  QString put_together(const Phrase& phrase, const QRegularExpressionMatch& match, bool is_error) const;
  QString phrase(const QString& source, bool is_error) const;
  QString phrase(const Phrases& phrases, const QString& source, bool is_error) const;

  QHash<QString, QStringList> forms_, sources_;
  Phrases core_, errors_;
};

/// Those that there are, besides English: "de".
QStringList languages();

/// Speaks this language from now on ("en", "de"; empty: the desktop's, where there is a translation). Texts that are
/// shown already stay as they are: before the window is made.
void speak(QCoreApplication& application, const QString& language);

}  // namespace handsight::app
