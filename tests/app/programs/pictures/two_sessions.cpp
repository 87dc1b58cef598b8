// SPDX-License-Identifier: Apache-2.0
// Pictures of two sessions beside each other, and of one that another program wrote into.
#include <gtest/gtest.h>

#include <QTabWidget>

#include "app/programs/pictures/photographer.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

/// Two halves of a sample: in the second a joint stands 4 mrad further than it reads.
std::pair<std::filesystem::path, std::filesystem::path> two_sessions(const std::filesystem::path& folder) {
  const auto half = [&](const char* name, bool first) {
    std::filesystem::create_directories(folder / name);
    const auto copy = copy_of_sample(folder / name, "hidden_2");
    Session s = read_session(copy);
    const auto middle = s.observations.begin() + static_cast<std::ptrdiff_t>(s.observations.size() / 2);
    first ? s.observations.erase(middle, s.observations.end()) : s.observations.erase(s.observations.begin(), middle);
    s.title = name;
    s.source.reset();
    for (Observation& o : s.observations) o.position[2] -= first ? 0 : 0.004;
    save_session(s);
    return copy;
  };
  return {half("march", true), half("april", false)};
}

TEST(Pictures, OfTheComparison) {
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  const auto [before, after] = two_sessions(folder.path);
  ASSERT_TRUE(desk.window.open(QString::fromStdString(after.string())));
  ASSERT_TRUE(desk.settle());
  const auto compare = [&](const std::filesystem::path& other) {
    desk.window.compare_with(QString::fromStdString(other.string()));
    return desk.wait([&] { return !desk.window.workbench().explaining.is_busy(); }, 120000);
  };
  ASSERT_TRUE(compare(before));
  auto* tabs = desk.find<QTabWidget>("compare_tabs");
  const char* names[] = {"compare", "compare_convergence", "compare_patterns"};
  for (int i = 0; i < 3; ++i) {
    desk.click(tabs->tabBar(), tabs->tabBar()->tabRect(i).center());
    photo.take(names[i]);
  }
  ASSERT_TRUE(compare(folder.path / "nowhere.xml"));
  photo.take("compare_refused");
  desk.document().close();
  // A recheck against what the first session was calibrated to.
  ASSERT_TRUE(desk.window.open(QString::fromStdString(before.string())));
  ASSERT_TRUE(desk.settle());
  desk.key(Qt::Key_5, Qt::ControlModifier);
  ASSERT_TRUE(ExportPage{desk}.save_as(folder.path / "calibration.xml"));
  desk.document().close();
  ASSERT_TRUE(desk.window.open(QString::fromStdString(after.string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(compare(folder.path / "calibration.xml"));
  for (int i = 0; i < 2; ++i) {
    desk.click(tabs->tabBar(), tabs->tabBar()->tabRect(i).center());
    photo.take(i == 0 ? "compare_calibration" : "compare_calibration_convergence");
  }
}

TEST(Pictures, OfWhatAnotherProgramWrote) {
  const TemporaryFolder folder;
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  const auto session = copy_of_sample(folder.path, "hidden_2");
  ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
  ASSERT_TRUE(desk.settle());
  desk.window.workbench().exclude({1, 2, 5});
  Session there = read_session(session);
  for (const std::size_t i : {1U, 2U, 5U, 9U}) {
    there.observations[i].decision = i == 2 ? Decision::rejected : Decision::excluded;
    there.observations[i].reason = i == 2 ? "corner 2 is 9 mm from where it must be (limit 5)" : "blurred";
  }
  replace_session(there);
  ASSERT_TRUE(desk.wait([&] { return desk.find<QWidget>("foreign")->isVisible(); }));
  photo.take("foreign");
  desk.key(Qt::Key_S, Qt::ControlModifier);
  photo.take("merge");
}

}  // namespace
}  // namespace handsight::test
