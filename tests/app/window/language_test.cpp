// SPDX-License-Identifier: Apache-2.0
// The window speaks German where it is asked to: every text of the sources has its translation, with the same places
// for what is put in, and plurals are those of the language.
#include "window/language.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QRegularExpression>
#include <filesystem>
#include <limits>
#include <map>

#include "app/window/desk.h"
#include "base/error.h"
#include "base/files.h"
#include "diagnosis/attribution/common.h"
#include "document/effect_words.h"
#include "print/target_xml.h"
#include "widgets/plots/convergence_plot.h"
#include "window/rail_button.h"
#include "words/core_words.h"
#include "words/counted.h"

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
  static const QRegularExpression call(
      "\\b(?:tr|said|QT_TRANSLATE_NOOP)\\(\\s*(?:\"workspaces\",\\s*)?((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)");
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
  EXPECT_EQ(app::translated("It is 1.2 +- 0.1 mm."), QString("It is 1.2 ± 0.1 mm."));
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
  for (const Effect& effect : catalogue()) {
    for (const std::string& text : {effect.title, effect.cause, effect.visibility, effect.check})
      EXPECT_TRUE(text.empty() || is_there(text)) << effect.id << ": " << text;
    for (const EffectParameter& p : effect.parameters)
      EXPECT_TRUE(symbol.match(QString::fromStdString(p.name)).hasMatch() || is_there(p.name))
          << effect.id << ": " << p.name;
  }
}

TEST(Language, SentencesOfTheCoreAreTranslatedWithWhatIsPutIn) {
  app::Translation german("de");
  const std::string rejected = "joints moved 0.7 deg since observation 21; 2 deg count as new";
  EXPECT_EQ(app::translated(rejected), QString::fromStdString(rejected)) << "English without a translation";
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  EXPECT_EQ(app::translated(rejected),
            "Gelenke seit Beobachtung 21 um 0.7 Grad bewegt; neu ist eine Stellung ab 2 Grad");
  EXPECT_EQ(app::translated("excluded: no reason given"), "ausgeschlossen: kein Grund angegeben");
  EXPECT_EQ(app::translated("Inside: 1.2 sigma from the prediction. That speaks for this cause."),
            "Innerhalb: 1.2 Sigma von der Vorhersage. Das spricht für diese Ursache.");
  EXPECT_EQ(app::translated("excluded: my own words: 3"), "ausgeschlossen: my own words: 3");
  EXPECT_EQ(app::translated("what nobody has translated"), "what nobody has translated");
  EXPECT_EQ(app::effect_of("joint_elasticity", {"arm_2", "time"}), "Gelenkelastizität von arm_2 und time")
      << "joints keep their names";
  QCoreApplication::removeTranslator(&german);
  EXPECT_EQ(app::effect_of("joint_elasticity", {"arm_2"}), "joint elasticity of arm_2");
}

TEST(Language, ErrorsAreTranslatedWhateverFileTheyName) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  const auto told = [](const char* english) { return app::translated_of_file(english).toStdString(); };
  EXPECT_EQ(told("/data/angles.csv: the file cannot be opened: No such file or directory."),
            "/data/angles.csv: die Datei lässt sich nicht öffnen: es gibt sie nicht.");
  EXPECT_EQ(told("s/session.xml, line 5: <camera> has no attribute width, expected width=\"...\"."),
            "s/session.xml, Zeile 5: <camera> hat kein Attribut width; erwartet wird width=\"...\".");
  EXPECT_EQ(
      told("s/session.xml, line 3: <joints> names \"arm_9\", which the robot does not have, expected joints of the "
           "robot that move by themselves."),
      "s/session.xml, Zeile 3: <joints> nennt \"arm_9\", das der Roboter nicht hat; erwartet werden Gelenke des "
      "Roboters, die sich von selbst bewegen.");
  EXPECT_EQ(told("camchain.yaml: T_cn_cnm1 holds no rotation; expected the motion from the camera before."),
            "camchain.yaml: T_cn_cnm1 enthält keine Drehung; erwartet wird die Bewegung von der Kamera davor.");
  EXPECT_EQ(told("morning.db3, topic /left: it is not plain CDR; the bag is damaged, or the message is of another type "
                 "than it says."),
            "morning.db3, topic /left: es ist kein schlichtes CDR; das Bag ist beschädigt, oder die Nachricht ist von "
            "anderer Art, als sie sagt.");
  EXPECT_EQ(
      told("photos: is a folder without images, without files of poses and without a bag; expected a URDF, a folder of "
           "images, a table "
           "(CSV) of joints, poses or points, a calibration of OpenCV, ROS or Kalibr, samples of easy_handeye, or "
           "a bag of ROS."),
      "photos: ist ein Ordner ohne Bilder, ohne Dateien von Posen und ohne Bag; erwartet wird eine URDF, ein Ordner "
      "mit Bildern, eine "
      "Tabelle (CSV) von Gelenken, Posen oder Punkten, eine Kalibrierung von OpenCV, ROS oder Kalibr, Proben von "
      "easy_handeye oder ein Bag von ROS.");
  EXPECT_EQ(told("angles.csv, line 2: the line has 6 columns, expected 7."),
            "angles.csv, Zeile 2: die Zeile hat 6 Spalten; erwartet werden 7.");
  EXPECT_EQ(told("nobody: has translated this."), "nobody: has translated this.");
  QCoreApplication::removeTranslator(&german);
}

/// What a user who reads a file that is not there is told, from the file to the sentence.
TEST(Language, ARefusalOfTheCoreIsGerman) {
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  try {
    read_file("/nowhere/at/all.xml");
    ADD_FAILURE() << "it is there";
  } catch (const InputError& error) {
    EXPECT_EQ(app::translated_error(error),
              "/nowhere/at/all.xml: die Datei lässt sich nicht öffnen: es gibt sie nicht.");
  }
  const Target board = target_from_words({{"kind", "charuco"},
                                          {"columns", "8"},
                                          {"rows", "11"},
                                          {"square", "0.022"},
                                          {"marker", "0.016"},
                                          {"dictionary", "DICT_5X5_100"}},
                                         "The target");
  EXPECT_EQ(app::translated(description_of(board)),
            "ChArUco-Brett mit 8 × 11 Feldern von 22 mm, Tags von 16 mm aus DICT_5X5_100");
  const Common common{.low = -std::numeric_limits<double>::infinity(),
                      .high = 76.8,
                      .chosen = 16,
                      .others = 1,
                      .all_chosen = 16,
                      .all_others = 64};
  EXPECT_EQ(
      app::translated(common_text(
          common, {.kind = VariableKind::torque, .name = "gravity torque at torso_4", .unit = "N m", .values = {}})),
      "Alle 16 haben Schwerkraftmoment an torso_4 unter 76.8 N m; von den 64 anderen nur 1.");
  QCoreApplication::removeTranslator(&german);
}

/// The sentences with which a reader refuses, as they are with 7 in every place.
std::map<QString, std::string> refusals_of(const std::filesystem::path& source) {
  static const QString literals = "((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)";
  static const QRegularExpression call(
      "(?:InputError\\(|refuse\\([^;\"]*?|fail\\((?:file, )?|refuse_kind\\(path, |refuse_pose\\(file, number, "
      ")\\s*(?:[a-z_.]+ "
      "\\+\\s*)?(?:fmt::format\\(\\s*)?" +
      literals);
  static const QRegularExpression place("\\{[^}]*\\}"), file("^(?:7)?(?:, line 7)?: ");
  const QString text = QString::fromStdString(read_file(source));
  std::map<QString, std::string> refusals;
  for (auto i = call.globalMatch(text); i.hasNext();) {
    QString sentence = joined_literals(i.next().captured(1));
    sentence.replace(place, "7");
    if (sentence.endsWith(' ')) continue;  // goes on with what is put together
    refusals[sentence.remove(file)] = source.filename().string();
  }
  return refusals;
}

/// What wizard, watched folders and calibrations may say of files that others wrote.
TEST(Language, EveryRefusalOfTheReadersIsTranslated) {
  const auto core = std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "core";
  app::Translation german("de");
  ASSERT_TRUE(QCoreApplication::installTranslator(&german));
  std::size_t found = 0;
  for (const char* name : {"readers/bags/bag",
                           "readers/bags/decompress",
                           "readers/bags/file_bytes",
                           "readers/bags/mcap_bag",
                           "readers/bags/messages",
                           "readers/bags/ros1_bag",
                           "readers/bags/sqlite_bag",
                           "readers/bag_contents",
                           "readers/bag_images",
                           "readers/kalibr_target",
                           "readers/maker_cameras",
                           "readers/mocap_cells",
                           "readers/motive_csv",
                           "readers/vicon_csv",
                           "readers/ost_cameras",
                           "readers/realsense",
                           "readers/robots/lerobot",
                           "readers/robots/mjcf",
                           "readers/robots/mjcf_mass",
                           "readers/robots/mjcf_model",
                           "readers/robots/robot_file",
                           "convert/brought",
                           "convert/file_kind",
                           "convert/foreign_files",
                           "readers/camera_files",
                           "convert/convert",
                           "convert/convert_bag",
                           "convert/convert_images",
                           "convert/convert_pairing",
                           "convert/convert_points",
                           "readers/joint_file",
                           "readers/point_file",
                           "readers/pose_files",
                           "readers/table",
                           "readers/yaml_text",
                           "convert/session_parts",
                           "readers/stereo_calibration",
                           "readers/opencv_storage",
                           "camera_calibration/board_images",
                           "camera_calibration/board_knowledge",
                           "camera_calibration/bundle_start",
                           "camera_calibration/camera_images"})
    for (const auto& [sentence, file] : refusals_of(core / (std::string(name) + ".cpp"))) {
      ++found;
      EXPECT_NE(app::translated_of_file(sentence.toStdString()), sentence) << file << ": " << sentence.toStdString();
    }
  EXPECT_GT(found, 90U);
  QCoreApplication::removeTranslator(&german);
}

/// A phrase that the core no longer says would stay in the table unseen.
TEST(Language, EveryPhraseIsOneThatTheCoreSays) {
  QString said;
  static const QRegularExpression literal("\"((?:[^\"\\\\]|\\\\.)*)\"\\s*");
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "core")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    QString source = QString::fromStdString(read_file(entry.path()));
    source.replace("'\"'", "' '");  // a character, no beginning of a text
    qsizetype end = -1;
    for (auto i = literal.globalMatch(source); i.hasNext();) {
      const auto one = i.next();
      if (one.capturedStart() != end) said += '\n';  // else it goes on: "one " "sentence"
      said += one.captured(1);
      end = one.capturedEnd();
    }
  }
  said.replace("\\\"", "\"");
  static const QRegularExpression place("%\\d");
  const app::Translation table("de");
  for (const QString& phrase : table.sources("core") + table.sources("errors"))
    for (const QString& piece : phrase.split(place, Qt::SkipEmptyParts))
      EXPECT_TRUE(piece.trimmed().size() < 3 || said.contains(piece))
          << phrase.toStdString() << ": \"" << piece.toStdString() << "\"";
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

}  // namespace
}  // namespace handsight::test
