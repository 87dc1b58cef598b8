// SPDX-License-Identifier: GPL-3.0-or-later
// That another program has written the open session is said above the workspaces, soon after it has.
#pragma once

#include <QFileSystemWatcher>
#include <QFrame>
#include <QTimer>
#include <filesystem>
#include <optional>

#include "workbench/workbench.h"

namespace handsight::app {

class ForeignBar : public QFrame {
  Q_OBJECT

 public:
  explicit ForeignBar(Workbench& workbench, QWidget* parent = nullptr);

 signals:
  /// What both have written is to be put together, as a save does.
  void save_requested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Stamp {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type written;
    bool operator==(const Stamp&) const = default;
  };
  void begin();
  void end();
  void look();
  void say(bool is_changed);
  void tint();

  Workbench& workbench_;
  QFileSystemWatcher files_;
  QTimer timer_;
  std::optional<Stamp> seen_;  // of what was looked at last; nothing: not yet
  bool is_put_off_ = false;
};

}  // namespace handsight::app
