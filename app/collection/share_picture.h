// SPDX-License-Identifier: GPL-3.0-or-later
// A small picture of what sessions can share.
#pragma once

#include <QWidget>

namespace handsight::app {

class SharePicture : public QWidget {
 public:
  enum class What { robot, rig, body };
  explicit SharePicture(What what, QWidget* parent = nullptr);
  /// One for both sessions, else one for each.
  void set_shared(bool is_shared);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  What what_;
  bool is_shared_ = false;
};

}  // namespace handsight::app
