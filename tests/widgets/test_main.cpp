// SPDX-License-Identifier: Apache-2.0
// The widgets' tests need a display: run them under tests/app/with_display.sh. Any warning of Qt fails the test.
#include <gtest/gtest.h>

#include <QApplication>

#include "widgets/base/apply_theme.h"
#include "widgets/base/theme.h"
#include "widgets/scene/robot_view.h"

namespace {

void fail_on_warning(QtMsgType kind, const QMessageLogContext&, const QString& text) {
  std::fprintf(stderr, "Qt: %s\n", qPrintable(text));
  if (kind == QtWarningMsg || kind == QtCriticalMsg) ADD_FAILURE() << "Qt warned: " << text.toStdString();
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  handsight::widgets::set_surface_format();
  QApplication application(argc, argv);
  handsight::widgets::apply_theme(application, handsight::widgets::ThemeKind::light);
  qInstallMessageHandler(fail_on_warning);
  return RUN_ALL_TESTS();
}
