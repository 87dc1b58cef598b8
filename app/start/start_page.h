// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows while no session is open: open, make a new one, recent sessions, sample sessions.
#pragma once

#include <QScrollArea>
#include <filesystem>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace handsight::app {

class StartPage : public QScrollArea {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);
  /// Reads recent and sample sessions anew.
  void refresh();
  /// A sentence about what could not be opened, beside the buttons; empty: none.
  void set_refusal(const QString& sentence);

 signals:
  void open_requested();
  void new_requested();
  void session_chosen(const QString& path);
  void sample_chosen(const QString& name);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QGridLayout* make_grid();

  QWidget* content_;
  QVBoxLayout* list_;
  QLabel* refusal_;
};

}  // namespace handsight::app
