// SPDX-License-Identifier: Apache-2.0
// The tests of the window need a display: run them under with_display.sh. Any warning of Qt fails the test at hand.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <QApplication>
#include <QMessageBox>

#include "app/window/measuring_window.h"
#include "app/window/working_window.h"
#include "temporary_folder.h"
#include "widgets/base/apply_theme.h"
#include "widgets/base/theme.h"
#include "widgets/scene/robot_view.h"

namespace {

void fail_on_warning(QtMsgType kind, const QMessageLogContext&, const QString& text) {
  std::fprintf(stderr, "Qt: %s\n", qPrintable(text));
  if (kind == QtWarningMsg || kind == QtCriticalMsg) ADD_FAILURE() << "Qt warned: " << text.toStdString();
}

/// Errors are shown in place: no message box ever opens.
class NoMessageBox : public QObject {
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Show && qobject_cast<QMessageBox*>(watched)) ADD_FAILURE() << "a message box opened";
    return false;
  }
};

/// No test leaves its theme to the next.
class LightAgain : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo&) override {
    using namespace handsight::widgets;
    if (theme() == ThemeKind::light) return;
    apply_theme(*qApp, ThemeKind::light);
    ADD_FAILURE() << "the theme is still dark when the test ends";
  }
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  if (argc == 4 && std::string(argv[1]) == "--work-until-killed") {
    handsight::widgets::set_surface_format();
    QApplication application(argc, argv);
    handsight::widgets::apply_theme(application, handsight::widgets::ThemeKind::light);
    return handsight::test::work_until_killed(argv[2], argv[3]);
  }
  if (argc == 3 && std::string(argv[1]) == "--measure-until-killed") {
    handsight::widgets::set_surface_format();
    QApplication application(argc, argv);
    handsight::widgets::apply_theme(application, handsight::widgets::ThemeKind::light);
    return handsight::test::measure_until_killed(argv[2]);
  }
  const handsight::TemporaryFolder state;  // journals and copies of tests do not meet the user's
  ::setenv("XDG_STATE_HOME", state.path.c_str(), 1);
  handsight::widgets::set_surface_format();
  QApplication application(argc, argv);
  handsight::widgets::apply_theme(application, handsight::widgets::ThemeKind::light);
  qInstallMessageHandler(fail_on_warning);
  NoMessageBox watch;
  application.installEventFilter(&watch);
  testing::UnitTest::GetInstance()->listeners().Append(new LightAgain);  // which owns it
  return RUN_ALL_TESTS();
}
