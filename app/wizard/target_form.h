// SPDX-License-Identifier: GPL-3.0-or-later
// What a board or a set of tags is: its numbers, and the sheet to print.
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "print/target.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace handsight::app {

class TargetForm : public QWidget {
  Q_OBJECT

 public:
  explicit TargetForm(QWidget* parent = nullptr);

  /// Asks for the numbers of this kind. `printed`: a board that is offered for printing; its numbers are given.
  void ask(TargetKind kind, bool printed);
  /// Asks for those of a grid of circles.
  void ask_circles();
  /// Nothing where the numbers are of no target: the form says why.
  const std::optional<Target>& target() const { return target_; }
  /// The sheet as a PDF; a sentence where it cannot be written.
  void save_sheet(const QString& file);

 signals:
  void changed();

 private:
  using Words = std::vector<std::pair<std::string, std::string>>;
  Words words() const;
  Words circle_words() const;
  void show_row(QWidget* field, bool visible);
  void show_rows(bool printed);
  void read();
  void choose_sheet();

  TargetKind kind_ = TargetKind::charuco;
  bool is_printed_ = false, are_circles_ = false;
  std::optional<Target> target_;
  QFormLayout* rows_;
  QWidget* counts_;
  QSpinBox *columns_, *rows_count_;
  QDoubleSpinBox *square_, *tag_, *spacing_;
  QComboBox *dictionary_, *layout_;
  QLineEdit* ids_;
  QLabel *numbers_hint_, *said_;
  QPushButton* sheet_;
};

}  // namespace handsight::app
