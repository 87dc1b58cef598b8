// SPDX-License-Identifier: GPL-3.0-or-later
// One of several, each with a drawing and a few words.
#pragma once

#include <QWidget>
#include <vector>

class QAbstractButton;

namespace handsight::widgets {

struct PictureOption {
  QString icon;   // of resources/icons
  QString words;  // two short lines at most
  QString hint;   // a sentence, shown over it
};

class PictureChoice : public QWidget {
  Q_OBJECT
 public:
  /// So many in a row. The buttons are called `name`_0, `name`_1, ...
  PictureChoice(const QString& name, const std::vector<PictureOption>& options, int columns, QWidget* parent = nullptr);

  int current() const;
  /// As if it were clicked.
  void choose(int option);
  /// One that is not possible stands there in grey.
  void set_possible(int option, bool possible);

 signals:
  void chosen(int option);

 private:
  std::vector<QAbstractButton*> buttons_;
};

}  // namespace handsight::widgets
