// SPDX-License-Identifier: GPL-3.0-or-later
// The row above Calibrate: play, step, rewind, speed, the watched folder, how far it is, and how much deviations are
// magnified.
#pragma once

#include <QWidget>
#include <functional>

#include "calibrate/player.h"
#include "live/live_watch.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace handsight::app {

class Transport : public QWidget {
  Q_OBJECT

 public:
  Transport(Workbench& workbench, Player& player, QWidget* parent = nullptr);

  void refresh();
  void toggle_play();
  double magnification() const;

 signals:
  void magnification_changed(double times);

 private:
  void make_layout();
  QWidget* make_live_row();
  void connect_live();
  void fill_sources();
  void choose_folder(int camera);
  void choose_table();
  void choose(const QString& title, const std::filesystem::path& now, const QString& filter,
              const std::function<void(LiveSources&, const std::filesystem::path&)>& set);
  QString progress_text() const;
  bool is_labelled() const;

  Workbench& workbench_;
  Player& player_;
  LiveWatch live_;
  QPushButton *play_, *label_next_;
  QToolButton *step_, *rewind_, *watch_, *sources_;
  QComboBox* speed_;
  QLabel *progress_, *ghost_text_, *live_text_;
  QSlider* ghost_;
  QWidget* live_row_;
};

}  // namespace handsight::app
