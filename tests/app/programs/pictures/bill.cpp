// SPDX-License-Identifier: Apache-2.0
// Pictures of the proof that comes first, of the bill after *Add until it stops*, and of the report's pages.
#include <gtest/gtest.h>

#include "app/programs/pictures/photographer.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

class Bills : public testing::TestWithParam<const char*> {};

TEST_P(Bills, FromTheProofToTheReport) {
  const TemporaryFolder folder;
  const std::string name = GetParam();
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  ExplainPage explain{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, name).string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  QTest::mouseMove(desk.window.windowHandle(), QPoint(5, 5));
  QTest::qWait(600);
  photo.take("proof_first_" + name);
  desk.key(Qt::Key_3, Qt::ControlModifier);
  photo.take("inspect_" + name);
  desk.key(Qt::Key_4, Qt::ControlModifier);
  desk.press_button("until_it_stops");
  const auto* button = desk.find<QAbstractButton>("until_it_stops");
  const QString stop = button->text();
  ASSERT_TRUE(desk.wait([&] { return button->text() != stop; }, 300000));
  ASSERT_TRUE(explain.is_settled());
  desk.wait([&] { return desk.window.workbench().diagnosing.inclusion_probabilities() != nullptr; });
  QTest::qWait(3000);
  photo.take("bill_" + name);
  desk.key(Qt::Key_5, Qt::ControlModifier);
  desk.type_into(desk.find<QLineEdit>("export_path"),
                 folder_of_pictures + "/report_" + QString::fromStdString(name) + ".xml");
  desk.press_button("report_pdf");
  photo.take("export_" + name);
}

INSTANTIATE_TEST_SUITE_P(Samples, Bills, testing::Values("hidden_3", "hidden_6", "hidden_8"));

}  // namespace
}  // namespace handsight::test
