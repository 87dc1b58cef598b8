// SPDX-License-Identifier: GPL-3.0-or-later
// One panel of a workspace fills the window's centre, instead of floating docks: a double click on its title or
// Shift+Space; Esc, or the same again, puts everything back.
#pragma once

#include <QObject>
#include <QPointer>
#include <vector>

class QWidget;

namespace handsight::app {

class CentreFill : public QObject {
  Q_OBJECT

 public:
  /// Panels are the views below `centre`: plots, images, the 3D view, tables, tabs.
  explicit CentreFill(QWidget* centre);

  /// The panel that has the focus, else the one under the pointer. Puts back where one fills the centre already.
  void toggle();
  /// True where a panel filled the centre.
  bool put_back();
  bool is_filled() const { return panel_ != nullptr; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* find_panel(QWidget* widget) const;
  void fill_with(QWidget* panel);

  QWidget* centre_;
  QPointer<QWidget> panel_;
  std::vector<QPointer<QWidget>> hidden_;
};

}  // namespace handsight::app
