// SPDX-License-Identifier: Apache-2.0
// The window speaks German where it is asked to: every text of the sources has its translation, with the same places
// for what is put in, and plurals are those of the language.
#include "frame/language.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QRegularExpression>
#include <filesystem>
#include <map>

#include "app/window/desk.h"
#include "base/files.h"
#include "document/counted.h"
#include "frame/rail_button.h"

namespace handsight::test {
namespace {

/// What stands between the quotes of one or several literals.
QString joined_literals(const QString& literals) {
  static const QRegularExpression one("\"((?:[^\"\\\\]|\\\\.)*)\"");
  QString text;
  for (auto i = one.globalMatch(literals); i.hasNext();) text += i.next().captured(1);
  return text.replace("\\\"", "\"").replace("\\n", "\n");
}

/// Every text that the sources hand to tr or said, with the file that does.
std::map<QString, std::string> texts_of_the_sources() {
  static const QRegularExpression call("\\b(?:tr|said)\\(\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)");
  std::map<QString, std::string> texts;
  for (const char* folder : {"app", "widgets"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / folder)) {
      const std::string name = entry.path().string();
      if (name.find("/cli/") != std::string::npos || !(name.ends_with(".cpp") || name.ends_with(".h"))) continue;
      const QString source = QString::fromStdString(read_file(entry.path()));
      for (auto i = call.globalMatch(source); i.hasNext();) texts[joined_literals(i.next().captured(1))] = name;
    }
  return texts;
}

QStringList places_in(const QString& text) {
  static const QRegularExpression place("%(\\d|n)");
  QStringList places;
  for (auto i = place.globalMatch(text); i.hasNext();) places << i.next().captured();
  places.sort();
  return places;
}

TEST(Language, EveryTextOfTheWindowIsTranslated) {
  const app::Translation german("de");
  const auto texts = texts_of_the_sources();
  EXPECT_GT(texts.size(), 600U);
  for (const auto& [text, file] : texts) {
    const QString translated = german.translate("", text.toUtf8(), nullptr, -1);
    EXPECT_FALSE(translated.isEmpty()) << file << ": " << text.toStdString();
    if (translated.isEmpty()) continue;
    EXPECT_EQ(places_in(translated), places_in(text)) << text.toStdString();
  }
}

TEST(Language, PluralsAreThoseOfTheLanguage) {
  EXPECT_EQ(app::counted(1, "%n observation(s)"), "1 observation");
  EXPECT_EQ(app::counted(7, "%n observation(s)"), "7 observations");
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  EXPECT_EQ(app::counted(1, "%n observation(s)"), "1 Beobachtung");
  EXPECT_EQ(app::counted(7, "%n observation(s)"), "7 Beobachtungen");
  EXPECT_EQ(app::counted(0, "%n joint(s)"), "0 Gelenke");
  QCoreApplication::removeTranslator(&german);
}

TEST(Language, AWholeWindowInGerman) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  {
    Desk desk;
    EXPECT_EQ(desk.find<QAbstractButton>("start_open")->text(), QString::fromUtf8("Sitzung öffnen…"));
    EXPECT_EQ(desk.find<app::RailButton>("rail_3")->text(), QString::fromUtf8("Erklären"));
  }
  QCoreApplication::removeTranslator(&german);
}

}  // namespace
}  // namespace handsight::test
