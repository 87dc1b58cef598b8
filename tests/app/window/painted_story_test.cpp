// SPDX-License-Identifier: Apache-2.0
// What is painted against what the story knows: its figures stand everywhere the same, and nothing is said to agree
// that is more than 1.5 times the noise.
#include <gtest/gtest.h>

#include <QRegularExpression>

#include "app/two_hands.h"
#include "app/window/explain_fixture.h"
#include "app/window/painted_text.h"
#include "app/window/reported_story.h"
#include "app/window/rig_sessions.h"

namespace handsight::test {
namespace {

/// Figures of this unit in a text.
QStringList figures_in(const QString& text, const QString& unit) {
  static const QRegularExpression one(
      QString::fromUtf8("(?<!± )(?<![\\d.\\w−-])(\\d+(?:\\.\\d+)?)[ \u00A0](px|mm)(?![\\w/])"));
  QStringList figures;
  for (auto i = one.globalMatch(text); i.hasNext();) {
    const auto found = i.next();
    if (found.captured(2) == unit) figures << found.captured(1);
  }
  return figures;
}

struct State {
  const char* name;
  std::string session;  // a sample; "both" the collection of two hands, "three" three cameras
};

class PaintedStory : public Explain, public testing::WithParamInterface<State> {
 protected:
  std::filesystem::path made() {
    const std::string& name = GetParam().session;
    if (name == "both") return two_hands(folder.path);
    if (name == "three") return sample_with_cameras(folder.path, "hidden_4", 3);
    if (const auto real = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / name; std::filesystem::exists(real)) {
      std::filesystem::copy(real, folder.path / name, std::filesystem::copy_options::recursive);
      return folder.path / name;
    }
    return copy_of_sample(folder.path, name);
  }
  /// Near one of the story's figures, and yet another one: 0.20 beside 0.21.
  void expect_same_figures(const QStringList& lines, const std::vector<double>& figures, const QString& unit,
                           const char* where) {
    for (const QString& line : lines)
      for (const QString& shown : figures_in(line, unit)) {
        const double value = shown.toDouble();
        const auto decimals = shown.contains('.') ? static_cast<int>(shown.size() - shown.indexOf('.') - 1) : 0;
        const auto is_near = [&](double figure) { return std::abs(value - figure) <= 0.03 * figure; };
        const auto is_same = [&](double figure) { return shown == QString::number(figure, 'f', decimals); };
        if (std::none_of(figures.begin(), figures.end(), is_near)) continue;
        EXPECT_TRUE(std::any_of(figures.begin(), figures.end(), is_same))
            << where << ", " << GetParam().name << ": " << shown.toStdString() << " in " << line.toStdString();
      }
  }
  Told reported{desk};
};

TEST_P(PaintedStory, IsToldAlikeEverywhere) {
  desk.window.resize(1440, 900);
  if (GetParam().session.starts_with("justin") &&
      !std::filesystem::exists(std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / GetParam().session))
    GTEST_SKIP() << "the real robot is not here";
  ASSERT_TRUE(desk.window.open(QString::fromStdString(made().string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  const auto look = [&](const char* where) {
    QTest::qWait(60);
    const QStringList lines = painted(desk.window);
    ASSERT_GT(lines.size(), 20);
    const StoryError& error = reported.story().error;
    const QString unit = error.in_pixels ? "px" : "mm";
    const double scale = error.in_pixels ? 1 : 1e3;
    ASSERT_TRUE(error.error);
    const QString all = lines.join('\n');
    std::vector<double> figures;
    for (const auto& figure : {error.error, error.noise, error.elsewhere})
      if (figure) figures.push_back(scale * *figure);
    for (const StoryCause& cause : reported.story().causes)  // "0.30 -> 0.21 px" on a card
      if (cause.left) figures.push_back(scale * *cause.left);
    const auto of_error = error.in_pixels ? widgets::SizeUnit::pixel : widgets::SizeUnit::millimetre;
    if (desk.window.workbench().units.unit() == of_error) expect_same_figures(lines, figures, unit, where);
    if (error.ratio().value_or(0) > most_that_agrees) {
      EXPECT_FALSE(Told::says_that_it_agrees(all)) << where;
    }
    EXPECT_FALSE(all.contains("nan", Qt::CaseSensitive) && all.contains(QRegularExpression("\\bnan\\b"))) << where;
    EXPECT_FALSE(all.contains(QRegularExpression("\\binf\\b"))) << where;
  };
  look("Explain");
  desk.key(Qt::Key_5, Qt::ControlModifier);
  desk.settle();
  look("Export");
  desk.key(Qt::Key_4, Qt::ControlModifier);
  if (reported.story().lead()) {
    explain.press_add();
    ASSERT_TRUE(explain.is_settled());
    look("Explain, added");
    desk.press_button("tab_versions");
    look("Versions");
    desk.press_button("tab_stairs");
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(explain.is_settled());
    look("Explain, undone");
  }
}

INSTANTIATE_TEST_SUITE_P(Sessions, PaintedStory,
                         testing::Values(State{"springs", "hidden_3"}, State{"scatter", "hidden_6"},
                                         State{"offset", "hidden_2"}, State{"a_curve", "hidden_8"},
                                         State{"link_geometry", "hidden_7"}, State{"real_robot", "justin_right_even"},
                                         State{"three_cameras", "three"}, State{"both_hands", "both"}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace handsight::test
