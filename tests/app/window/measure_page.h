// SPDX-License-Identifier: Apache-2.0
// The Experiment workspace in the user's words.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>

#include "app/window/desk.h"
#include "cli/cli_runner.h"
#include "experiment/experiment_page.h"
#include "experiment/experiment_workspace.h"

namespace handsight::test {

inline const std::string simulated_driver = HANDSIGHT_BINARY_DIR "/app/cli/handsight-driver-simulated ";

struct MeasurePage {
  Desk& desk;

  app::ExperimentWorkspace* workspace() { return desk.find<app::ExperimentWorkspace>("experiment"); }
  app::RunState state() { return workspace()->run().state(); }
  QString said() { return desk.find<QLabel>("experiment_said")->text(); }
  QTableWidget* poses() { return desk.find<QTableWidget>("experiment_poses"); }
  void open() {
    desk.key(Qt::Key_6, Qt::ControlModifier);
    QTest::qWait(20);
  }
  void type_driver(const std::string& command) {
    desk.find<QComboBox>("experiment_driver")->setEditText(QString::fromStdString(command));
  }
  /// A simulated robot of the open session.
  void type_simulated(const std::string& options = "") {
    const std::string session = desk.document().file().parent_path().string();
    type_driver(simulated_driver + quoted_argument(session) + ' ' + options);
  }
  /// Until the first poses are shown.
  bool connect() {
    desk.press_button("experiment_begin");
    return desk.wait([this] { return state() == app::RunState::asking || state() == app::RunState::resting; }, 60000) &&
           state() == app::RunState::asking;
  }
  void set_count(int poses) { set_field<QSpinBox>("goal_poses", QString::number(poses)); }
  void set_speed(double speed) { set_field<QDoubleSpinBox>("experiment_speed", QString::number(speed)); }
  /// Presses Start, and says yes to the one question.
  void start() {
    desk.press_button("experiment_begin");
    desk.press_button("experiment_yes");
  }
  bool ends(int milliseconds = 120000) {
    return desk.wait([this] { return state() == app::RunState::resting; }, milliseconds);
  }
  bool moves() {
    return desk.wait([this] { return state() == app::RunState::moving; }, 60000);
  }
  /// From now until the driver was asked to stop and has answered, ms; -1: it never was.
  qint64 time_to_stand() {
    QElapsedTimer clock;
    clock.start();
    const bool stands =
        desk.wait([this] { return state() == app::RunState::halted || state() == app::RunState::resting; }, 5000);
    return stands ? clock.elapsed() : -1;
  }
  void show_tab(int place) {
    QTabBar* bar = desk.find<QTabWidget>("experiment_tabs")->tabBar();
    desk.click(bar, bar->tabRect(place).center());
  }

 private:
  template <class Field>
  void set_field(const char* name, const QString& text) {
    auto* field = desk.find<Field>(name);
    desk.click(field, {12, field->height() / 2});
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Tab);
  }
};

}  // namespace handsight::test
