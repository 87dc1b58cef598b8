// SPDX-License-Identifier: Apache-2.0
// The window speaks German where it is asked to: every text of the sources has its translation, with the same places
// for what is put in, and plurals are those of the language.
#include "window/language.h"

#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QApplication>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLocale>
#include <QRegularExpression>
#include <QScrollBar>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "app/two_hands.h"
#include "app/window/desk.h"
#include "app/window/said_forms.h"
#include "base/error.h"
#include "base/files.h"
#include "base/xml.h"
#include "chain/chain.h"
#include "diagnosis/attribution/common.h"
#include "diagnosis/verdict/robot_check.h"
#include "document/document.h"
#include "document/effect_words.h"
#include "effects/part_effects.h"
#include "print/target_xml.h"
#include "temporary_folder.h"
#include "widgets/base/number_text.h"
#include "widgets/plots/convergence_plot.h"
#include "widgets/plots/history_plot.h"
#include "window/rail_button.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::test {
namespace {

/// Every text that the sources hand to tr, said or translate, with the file that does.
std::map<QString, std::string> texts_of_the_sources() {
  static const QRegularExpression call(
      "\\b(?:(?:tr|said|QT_TRANSLATE_NOOP)\\(\\s*(?:\"(?:workspaces|titles)\",\\s*)?|translate\\(\\s*\"[A-Za-z:]+\","
      "\\s*)"
      "((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)");
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

TEST(Language, WhatTheCoreWritesForTerminalsHasItsSignsInTheWindow) {
  EXPECT_EQ(app::translated(message("It is {} +- {} mm.", 1.2, 0.1)), QString("It is 1.2 ± 0.1 mm."));
}

TEST(Language, NumbersOfCurvesAreSaidInWords) {
  EXPECT_EQ(app::number_title("x_slope"), "slope along x");
  EXPECT_EQ(app::number_title("ry_bow"), "bow about y");
  EXPECT_EQ(app::number_title("sine"), "sine");
  EXPECT_EQ(app::number_title("my_number"), "my_number") << "a user's own name stays";
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

TEST(Language, EveryTextOfTheCatalogueIsTranslated) {
  const app::Translation german("de");
  const QStringList table = german.sources("effects");
  const auto is_there = [&](const std::string& text) { return table.contains(QString::fromStdString(text)); };
  // Symbols and units of physics stay what they are: x, ry, tu, xx, k; rad, kg m.
  static const QRegularExpression symbol("^([a-z]|r[a-z]|t[a-z]|xx|xy|yy)$");
  std::vector<Effect> effects = catalogue();
  const TemporaryFolder folder;
  app::Document both;  // between sessions an offset may change
  both.open(two_hands(folder.path, 8));
  for (const auto& effect : part_effects(make_chain(both.session()))) effects.push_back(*effect);
  for (const Effect& effect : effects) {
    for (const std::string& text : {effect.title, effect.cause, effect.visibility, effect.check})
      EXPECT_TRUE(text.empty() || is_there(text)) << effect.id << ": " << text;
    for (const EffectParameter& p : effect.parameters)
      EXPECT_TRUE(symbol.match(QString::fromStdString(p.name)).hasMatch() || is_there(p.name))
          << effect.id << ": " << p.name;
  }
}

TEST(Language, SentencesOfTheCoreAreTranslatedWithWhatIsPutIn) {
  app::Translation german("de");
  const Message rejected =
      message("joints moved {:.1f} deg since observation {}; {:.0f} deg count as new", 0.7, 21, 2.0);
  EXPECT_EQ(app::translated(rejected), QString::fromStdString(rejected.english())) << "English without a translation";
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  EXPECT_EQ(app::translated(rejected), "Gelenke seit Beobachtung 21 um 0,7 Grad bewegt; neu ist eine Pose ab 2 Grad");
  EXPECT_EQ(app::translated(message("excluded: {}", Message("no reason given"))),
            "ausgeschlossen: kein Grund angegeben");
  EXPECT_EQ(app::translated(answer_check({"", "", 1, 0.5, "1", {}}, 1.6, 0).text),
            "Innerhalb: 1,2 Sigma von der Vorhersage. Das spricht für diese Ursache.");
  EXPECT_EQ(app::translated(message("excluded: {}", std::string("left"))), "ausgeschlossen: left")
      << "what a user has written is no word of the table";
  EXPECT_EQ(app::translated(Message("what nobody has translated")), "what nobody has translated");
  EXPECT_EQ(app::effect_text("joint_elasticity", {"arm_2", "time"}), "Gelenkelastizität von arm_2 und time")
      << "joints keep their names";
  QCoreApplication::removeTranslator(&german);
  EXPECT_EQ(app::effect_text("joint_elasticity", {"arm_2"}), "joint elasticity of arm_2");
}

TEST(Language, ANumberHasTheMarkOfTheLanguageAndATextKeepsItsPoints) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  EXPECT_EQ(app::translated(message("its points are known to {:.2g} mm", 0.5)), "seine Punkte sind auf 0,5 mm bekannt");
  EXPECT_EQ(app::translated(message("{}: has no link {}.", std::string("a.urdf"), std::string("arm.2"))),
            "a.urdf: hat kein Glied arm.2.");
  QCoreApplication::removeTranslator(&german);
}

/// What the act refuses with, as the window says it.
template <class Act>
std::string refused(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return app::translated_error(error).toStdString();
  }
  return {};
}

TEST(Language, ErrorsAreTranslatedWhateverFileTheyName) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  EXPECT_EQ(refused([] { read_file("/data/angles.csv"); }),
            "/data/angles.csv: die Datei lässt sich nicht öffnen: es gibt sie nicht.");
  const auto of_node = [](const std::string& xml, const auto& read) {
    return refused([&] {
      const auto document = parse_xml(xml, "s/session.xml");
      read(require_root(*document, "s/session.xml", "camera"));
    });
  };
  EXPECT_EQ(of_node("<camera/>", [](const XmlNode& node) { required_text(node, "width"); }),
            "s/session.xml, Zeile 1: <camera> hat kein Attribut width; erwartet wird width=\"...\".");
  EXPECT_EQ(of_node("<camera width=\"wide\"/>", [](const XmlNode& node) { required_number(node, "width"); }),
            "s/session.xml, Zeile 1: <camera> hat width=\"wide\"; erwartet wird eine endliche Zahl.");
  EXPECT_EQ(refused([] {
              throw InputError(message("{}: T_cn_cnm1 holds no rotation; expected the motion from the camera before.",
                                       std::string("camchain.yaml")));
            }),
            "camchain.yaml: T_cn_cnm1 enthält keine Drehung; erwartet wird die Bewegung von der Kamera davor.");
  EXPECT_EQ(refused([] { throw InputError(verbatim("nobody: has translated this.")); }),
            "nobody: has translated this.");
  QCoreApplication::removeTranslator(&german);
}

TEST(Language, WhatAnErrorOrAResultPutsTogetherIsGerman) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  const Target board = target_from_words({{"kind", "charuco"},
                                          {"columns", "8"},
                                          {"rows", "11"},
                                          {"square", "0.022"},
                                          {"marker", "0.016"},
                                          {"dictionary", "DICT_5X5_100"}},
                                         "The target");
  EXPECT_EQ(app::translated(describe_target(board)),
            "ChArUco-Brett mit 8 × 11 Feldern von 22 mm, Tags von 16 mm aus DICT_5X5_100");
  const Common common{.low = -std::numeric_limits<double>::infinity(),
                      .high = 76.8,
                      .chosen = 16,
                      .others = 1,
                      .all_chosen = 16,
                      .all_others = 64};
  EXPECT_EQ(app::translated(common_text(common, {.kind = VariableKind::torque,
                                                 .name = message("gravity torque at {}", std::string("torso_4")),
                                                 .unit = "N m",
                                                 .values = {}})),
            "Alle 16 haben Schweremoment an torso_4 unter 76,8 N m; von den 64 anderen nur 1.");
  QCoreApplication::removeTranslator(&german);
}

/// Every id has both languages, in all of the core.
TEST(Language, EveryFormThatTheCoreSaysIsTranslated) {
  static const QRegularExpression place("%\\d");
  const app::Translation german("de");
  const auto said = said_by_the_core();
  EXPECT_GT(said.size(), 1100U);
  for (const auto& [form, file] : said) {
    const QString translated = german.translate("core", form.toUtf8(), nullptr, -1);
    EXPECT_FALSE(translated.isEmpty()) << file << ": \"" << form.toStdString() << "\"";
    for (auto i = place.globalMatch(translated); i.hasNext();)
      EXPECT_TRUE(form.contains(i.next().captured())) << file << ": " << translated.toStdString();
  }
}

/// A phrase that the core no longer says would stay in the table unseen.
TEST(Language, EveryPhraseIsOneThatTheCoreSays) {
  const app::Translation table("de");
  const std::set<QString> said = literals_of_the_core();
  for (const QString& phrase : table.sources("core") + table.sources("errors"))
    EXPECT_TRUE(said.contains(phrase)) << phrase.toStdString();
}

/// Nothing is read back out of a finished sentence.
TEST(Language, TheWindowMatchesNoSentence) {
  for (const char* name : {"window/language.cpp", "window/language.h", "words/core_words.cpp"}) {
    const QString source = core_source(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "app" / name);
    EXPECT_FALSE(source.contains("QRegularExpression")) << name;
    EXPECT_FALSE(source.contains("std::regex")) << name;
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

TEST(Language, AnglesAreInTheUnitThatIsWrittenBesideThem) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  widgets::ConvergencePlot plot("Drehung", "deg", {"rx", "ry", "rz"});
  plot.set_samples({{1, 1, {0.5, 0, 0}, {}}, {2, 2, {0.5, 0, 0}, {}}});
  EXPECT_TRUE(plot.csv().contains("rx (Grad)")) << plot.csv().toStdString();
  EXPECT_TRUE(plot.csv().contains("28.64788")) << plot.csv().toStdString();
  QCoreApplication::removeTranslator(&german);
}

TEST(Language, AWholeWindowInGerman) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  {
    Desk desk;
    EXPECT_EQ(desk.find<QAbstractButton>("start_open")->text(), QString::fromUtf8("Sitzung öffnen…"));
    EXPECT_EQ(desk.find<app::RailButton>("rail_explain")->text(), QString::fromUtf8("Erklären"));
  }
  QCoreApplication::removeTranslator(&german);
}

TEST(Language, TheStartPageNeedsNoScrollingOnALaptop) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  {
    Desk desk;
    desk.window.resize(1366, 728);
    QTest::qWait(30);
    const auto* page = desk.find<QScrollArea>("start_page");
    if (!page->findChild<QWidget*>("recent_0")) {  // what other tests have opened stands above the samples
      EXPECT_EQ(page->verticalScrollBar()->maximum(), 0);
    }
  }
  QCoreApplication::removeTranslator(&german);
}

TEST(Language, FieldsAndAxesHaveItsDecimalMark) {
  const QLocale before;
  const QChar mark = widgets::decimal_mark();
  app::speak(*qApp, "de");
  QDoubleSpinBox field;
  field.setDecimals(2);
  field.setRange(0, 1e6);
  field.setValue(1234.5);
  EXPECT_EQ(field.text(), "1234,50") << "no point, and none between thousands";
  widgets::HistoryPlot plot(widgets::HistoryPlot::Along::observations);
  plot.resize(400, 240);
  for (const bool is_log : {false, true}) {
    plot.set_quantity("x", "mm", is_log);
    plot.set_points({{.x = 1, .y = 0.1}, {.x = 2, .y = 0.4}});
    plot.show();
    QTest::qWait(30);
    const QString labels = plot.plot()->yAxis->tickVectorLabels().join(' ');
    EXPECT_TRUE(labels.contains("0,")) << labels.toStdString();
    EXPECT_FALSE(labels.contains('.')) << labels.toStdString();
  }
  app::speak(*qApp, "en");
  EXPECT_EQ(QLocale().decimalPoint(), ".");
  qDeleteAll(qApp->findChildren<QTranslator*>());  // it speaks English again
  QLocale::setDefault(before);
  widgets::set_decimal_mark(mark);
}

}  // namespace
}  // namespace handsight::test
