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
  /// Reads recent and sample sessions anew, at once or, where nobody sees the page, when it is shown.
  void refresh();
  /// A sentence about what could not be opened, beside the buttons; empty: none.
  void set_refusal(const QString& sentence);

 signals:
  void open_requested();
  void new_requested();
  void session_chosen(const QString& path);
  void sample_chosen(const QString& name);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make();
  void make_lists(QWidget* column);
  void show_refusal();
  void use_the_room();
  QGridLayout* make_grid();

  bool is_stale_ = true;
  QString refused_;
  QWidget *content_ = nullptr, *column_ = nullptr;
  QVBoxLayout* list_ = nullptr;
  QLabel* refusal_ = nullptr;
};

}  // namespace handsight::app
