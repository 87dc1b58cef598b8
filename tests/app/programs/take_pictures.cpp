// SPDX-License-Identifier: Apache-2.0
// Drives the user's story and keeps a picture of every workspace: take_pictures FOLDER light|dark. The scale is Qt's
// own (QT_SCALE_FACTOR), the window's size HANDSIGHT_WINDOW, the language HANDSIGHT_LANGUAGE; of a session of one's own
// with HANDSIGHT_SESSION and --gtest_filter='*OnesOwn'. pictures.sh runs it on four kinds of screens,
// in both themes and languages.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QPainter>
#include <QTabWidget>

#include "app/programs/pictures/photographer.h"
#include "explain/missing_pane.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "widgets/base/apply_theme.h"
#include "widgets/base/theme.h"
#include "widgets/explain/what_if_slider.h"
#include "widgets/scene/robot_view.h"
#include "window/language.h"
#include "workbench/observation_views.h"

namespace handsight::test {

QString folder_of_pictures, suffix;

namespace {

/// The 3D view alone, as large as a page.
void take_the_robot(Desk& desk) {
  for (auto* view : desk.window.findChildren<widgets::RobotView*>()) {
    if (!view->isVisible()) continue;
    const QSize before = view->size();
    view->resize(1000, 640);
    view->look(widgets::StandardView::all);
    view->picture(2).save(folder_of_pictures + "/robot" + suffix + ".png");
    view->resize(before);
    view->look(widgets::StandardView::all);
  }
}

TEST(Pictures, OfEveryWorkspace) {
  Desk desk;
  desk.window.resize(window_size());
  QTest::qWait(100);
  Photographer photo{desk};
  LabelPage label{desk};
  CalibratePage calibrate{desk};
  InspectPage inspect{desk};
  photo.take("start");
  desk.press_button("sample_hundred_poses");
  ASSERT_TRUE(label.corners_are_found());
  photo.take("label_empty");
  const auto go = [&](int n) { desk.key(Qt::Key_0 + n, Qt::ControlModifier); };
  go(2);
  photo.take("calibrate_empty");
  go(3);
  photo.take("inspect_empty");
  go(4);
  photo.take("explain_empty");
  go(5);
  photo.take("export_empty");
  go(1);
  for (const Vector2& px : {Vector2(519, 98), Vector2(515, 132), Vector2(576, 113)}) label.click_left(px);
  photo.take("label");
  label.use();
  calibrate.set_fastest();
  ASSERT_TRUE(calibrate.play_to_the_end());
  desk.settle();
  auto* strip = desk.find<widgets::ObservationStrip>("strip");
  desk.click(strip, strip->cell_rect(0).center().toPoint());  // one of those with images
  photo.take("calibrate");
  take_the_robot(desk);
  desk.press_button("watch");
  photo.take_now("calibrate_watch");
  desk.press_button("watch");
  auto* tabs = desk.find<QTabWidget>("calibrate_tabs");
  const char* names[] = {"", "calibrate_objective", "calibrate_one_marker", "calibrate_own_pose"};
  for (int i = 1; i < tabs->count(); ++i) {
    desk.click(tabs->tabBar(), tabs->tabBar()->tabRect(i).center());
    photo.take(names[i]);
  }
  go(3);
  inspect.sort_worst_first("px");
  inspect.click_row(0);
  photo.take("inspect");
  auto* inspect_tabs = desk.find<QTabWidget>("inspect_tabs");
  desk.click(inspect_tabs->tabBar(), inspect_tabs->tabBar()->tabRect(1).center());
  photo.take("inspect_map");
  desk.key(Qt::Key_U);
  photo.take("inspect_map_mm");
  desk.click(inspect_tabs->tabBar(), inspect_tabs->tabBar()->tabRect(0).center());
  photo.take("inspect_mm");
  desk.key(Qt::Key_U);
  photo.take("inspect_sigma");
  desk.key(Qt::Key_U);
  go(4);
  photo.take("explain");
  go(5);
  photo.take("export");
  desk.key(Qt::Key_Question);
  photo.take("keys");
  desk.key(Qt::Key_Escape);
  desk.key(Qt::Key_K, Qt::ControlModifier);
  for (const char c : {'a', 'r', 'm'}) QTest::keyClick(desk.window.windowHandle(), c);
  photo.take("find");
}

/// What is drawn of a robot: clearly darker (or lighter) than the ground and its grid, and not the axes or the cube in
/// the lower left corner.
QRect drawn_in(const QImage& picture) {
  const QRgb ground = picture.pixel(picture.width() / 2, 4);
  QRect all;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const bool is_corner = x < picture.width() / 3 && y > picture.height() * 7 / 10;
      if (!is_corner && std::abs(qGray(picture.pixel(x, y)) - qGray(ground)) > 48) all |= QRect(x, y, 1, 1);
    }
  return all;
}

/// The robot as large as it can be, with more contrast than the 3D view has: it is looked at small.
QImage thumbnail_of(const QImage& picture) {
  constexpr int width = 288, height = 192;
  QRectF part = drawn_in(picture);
  const double rim = 0.05 * std::max(part.width(), part.height());
  part.adjust(-rim, -rim, rim, rim);
  const QSizeF wanted = QSizeF(width, height).scaled(part.size(), Qt::KeepAspectRatioByExpanding);
  part = QRectF(part.center() - QPointF(wanted.width() / 2, wanted.height() / 2), wanted);
  QImage all(part.size().toSize(), QImage::Format_RGB32);
  all.fill(picture.pixel(picture.width() / 2, 4));
  QPainter(&all).drawImage(-part.topLeft(), picture);
  const bool is_light = qGray(all.pixel(0, 0)) > 128;
  for (int y = 0; y < all.height() && is_light; ++y)
    for (int x = 0; x < all.width(); ++x) {
      const QColor c(all.pixel(x, y));
      const auto darker = [](int v) { return static_cast<int>(255 * std::pow(v / 255.0, 1.6)); };
      all.setPixel(x, y, qRgb(darker(c.red()), darker(c.green()), darker(c.blue())));
    }
  return all.scaled(width, height, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Of the sample sessions without images, for the start page (resources/pictures).
TEST(Thumbnails, OfTheRobots) {
  for (const char* name : {"thesis_simulation", "hidden_1", "hidden_2", "hidden_3", "hidden_4", "hidden_5", "hidden_6",
                           "hidden_7", "hidden_8", "probe_and_plate", "panda_sockets"}) {
    const Session s =
        read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name / "session.xml");
    widgets::RobotView view;
    view.resize(330, 260);
    view.show();
    view.set_robot(s.robot, folder(s));
    const std::size_t shown = s.observations.size() / (s.fixtures.empty() ? 2 : 3);  // where the whole arm is in view
    view.set_posture(app::link_motions(s, s.observations[shown].position));
    view.look(widgets::StandardView::all);
    view.picture(2);
    QImage picture = view.picture(2);
    picture.setDevicePixelRatio(1);
    thumbnail_of(picture).save(folder_of_pictures + "/" + name + ".png");
  }
}

class Explained : public testing::Test {
 protected:
  void open(const char* name) {
    desk.window.resize(window_size());
    desk.window.open_sample(name, true);
    ASSERT_TRUE(desk.settle());
    ASSERT_TRUE(explain.open());
  }
  void rest_on(QWidget* widget, const QPoint& at) {
    QTest::mouseMove(widget->window()->windowHandle(), widget->mapTo(widget->window(), at));
    QTest::qWait(100);
  }
  Desk desk;
  Photographer photo{desk};
  ExplainPage explain{desk};
};

TEST_F(Explained, FromTheVerdictToTheTruth) {
  open("hidden_3");
  photo.take("explain");
  desk.key(Qt::Key_U);
  photo.take("explain_mm");
  desk.key(Qt::Key_U);
  photo.take("explain_sigma");
  desk.key(Qt::Key_U);
  rest_on(explain.cards()->card(0), QPoint(20, 20));
  photo.take_now("explain_preview");
  explain.measure("1.0");
  photo.take_now("explain_check");
  desk.key(Qt::Key_Z, Qt::ControlModifier);
  desk.click(explain.cards()->card(0)->what_if_button());
  photo.take_now("explain_what_if");
  desk.find<widgets::WhatIfSlider>("what_if")->setFocus();
  for (auto* button : desk.find<QWidget>("what_if")->findChildren<QAbstractButton*>())
    if (button->text() == QObject::tr("Close")) desk.click(button);
  auto* plot = desk.find<QWidget>("pattern_large");
  desk.drag(plot, {plot->width() * 6 / 10, 30}, {plot->width() - 20, plot->height() - 40}, Qt::ShiftModifier);
  photo.take_now("explain_common");
  desk.key(Qt::Key_Escape);
  plot->setFocus();
  QTest::keyPress(desk.window.windowHandle(), Qt::Key_N);
  photo.take_now("explain_noise");
  QTest::keyRelease(desk.window.windowHandle(), Qt::Key_N);
  desk.click(explain.cards()->why_not_button());
  photo.take_now("explain_why_not");
  desk.press_button("table_back");
  explain.press_add();
  QTest::qWait(60);
  desk.window.grab().save(folder_of_pictures + "/explain_adding" + suffix + ".png");
  ASSERT_TRUE(explain.is_settled());
  photo.take_now("explain_added");
  ASSERT_TRUE(desk.wait([&] { return !desk.document().model()->prediction.model_uncertainty.others.empty(); }, 30000));
  desk.click(explain.cards()->why_not_button());
  photo.take_now("explain_how_sure");
  desk.press_button("table_back");
  desk.press_button("tab_versions");
  photo.take_now("explain_versions");
  desk.press_button("tab_fit");
  photo.take_now("explain_fit");
  desk.choose("reveal");
  photo.take_now("explain_truth");
  desk.press_button("truth_back");
  auto* lock = desk.find<QWidget>("hold_joint_elasticity_1");
  for (auto* area : desk.find<QWidget>("model_panel")->findChildren<QScrollArea*>()) area->ensureWidgetVisible(lock);
  QTest::qWait(20);
  desk.click(lock);
  ASSERT_TRUE(explain.is_settled());
  photo.take_now("explain_held");
  desk.key(Qt::Key_5, Qt::ControlModifier);
  photo.take("export_effects");
  desk.type_into(desk.find<QLineEdit>("export_path"), folder_of_pictures + "/report" + suffix + ".xml");
  desk.press_button("report_pdf");
  desk.press_button("report_html");
}

/// Of a session of one's own, HANDSIGHT_SESSION: Explain at the end of *Add until it stops*, and of *Seek longer* where
/// that is offered, the truth where it has one; Inspect and Export.
TEST_F(Explained, ASessionOfOnesOwn) {
  const QString session = qEnvironmentVariable("HANDSIGHT_SESSION");
  if (session.isEmpty()) GTEST_SKIP() << "HANDSIGHT_SESSION names no session";
  desk.window.resize(window_size());
  ASSERT_TRUE(desk.window.open(session));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  photo.take_now("own_explain");
  if (desk.find<QWidget>("until_it_stops")->isEnabled()) desk.press_button("until_it_stops");
  const QString running = QObject::tr("Stop");
  ASSERT_TRUE(desk.wait([&] { return desk.find<QAbstractButton>("until_it_stops")->text() != running; }, 400000));
  ASSERT_TRUE(explain.is_settled());
  photo.take_now("own_explain_end");
  if (desk.find<QWidget>("until_it_stops")->isEnabled()) {
    desk.press_button("until_it_stops");
    QTest::qWait(1500);
    photo.take_now("own_explain_seeking");
    ASSERT_TRUE(desk.wait([&] { return desk.find<QAbstractButton>("until_it_stops")->text() != running; }, 400000));
    ASSERT_TRUE(explain.is_settled());
    photo.take_now("own_explain_sought");
  }
  if (explain.workspace()->findChild<app::MissingPane*>()->can_reveal()) {
    desk.choose("reveal");
    photo.take_now("own_truth");
    desk.press_button("truth_back");
  }
  desk.key(Qt::Key_3, Qt::ControlModifier);
  photo.take("own_inspect_end");
  desk.key(Qt::Key_2, Qt::ControlModifier);
  photo.take("own_calibrate_end");
  desk.key(Qt::Key_5, Qt::ControlModifier);
  photo.take("own_export_end");
  desk.type_into(desk.find<QLineEdit>("export_path"), folder_of_pictures + "/own_report" + suffix + ".xml");
  desk.press_button("report_pdf");
}

TEST_F(Explained, Tour) {
  open("hidden_3");
  desk.press_button("start_tour");
  for (int i = 0; i < 4; ++i) {
    photo.take_now("explain_tour_" + std::to_string(i));
    desk.press_button("tour_next");
  }
}

TEST_F(Explained, PosesThatWouldTell) {
  open("hidden_3");
  explain.workspace()->findChild<app::MissingPane*>()->show_poses({});
  ASSERT_TRUE(desk.wait([this] { return !desk.window.workbench().explaining.is_busy(); }));
  photo.take_now("explain_poses");
}

TEST_F(Explained, HonestCards) {
  for (const int i : {1, 2, 4, 5, 6, 7, 8}) {
    open(("hidden_" + std::to_string(i)).c_str());
    photo.take_now("explain_hidden_" + std::to_string(i));
    desk.document().close();
  }
}

}  // namespace
}  // namespace handsight::test

int main(int argc, char** argv) {
  using namespace handsight;
  testing::InitGoogleTest(&argc, argv);
  if (argc < 3) return std::fprintf(stderr, "take_pictures FOLDER light|dark\n"), 2;
  const TemporaryFolder state;
  ::setenv("XDG_STATE_HOME", state.path.c_str(), 1);
  widgets::set_surface_format();
  QApplication application(argc, argv);
  app::speak(application, qEnvironmentVariable("HANDSIGHT_LANGUAGE", "en"));
  const bool dark = std::string(argv[2]) == "dark";
  widgets::apply_theme(application, dark ? widgets::ThemeKind::dark : widgets::ThemeKind::light);
  if (!QDir().mkpath(argv[1])) return std::fprintf(stderr, "%s: cannot be made.\n", argv[1]), 2;
  test::folder_of_pictures = argv[1];
  const char* scale = std::getenv("QT_SCALE_FACTOR");
  test::suffix = QString("_%1_%2").arg(argv[2], scale ? QString::number(100 * std::atof(scale)) : QString("100"));
  return RUN_ALL_TESTS();
}
