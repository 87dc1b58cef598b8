// SPDX-License-Identifier: GPL-3.0-or-later
// What was touched: of each fixture that a table names its kind, by a picture, and what is known of it.
#pragma once

#include <QStringList>
#include <QWidget>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/robot.h"

class QDoubleSpinBox;
class QLineEdit;
class QVBoxLayout;

namespace handsight::widgets {
class PictureChoice;
}

namespace handsight::app {

/// The fixtures of a table of touches, in their order; empty where the file is none.
QStringList fixtures_in(const std::filesystem::path& file, const Robot& robot);

class TouchForm : public QWidget {
  Q_OBJECT

 public:
  explicit TouchForm(QWidget* parent = nullptr);

  /// Asks for these fixtures; what was answered of one that was there before stays.
  void ask(const QStringList& fixtures);
  const QStringList& fixtures() const { return names_; }
  /// As ConvertOptions takes them: "plane table sigma=2e-5"; "socket_1 socket_2 by=0.05 sigma=1e-5".
  std::vector<std::string> described() const;
  std::vector<std::string> apart() const;
  /// m, of one reading; nothing where it is to be estimated.
  std::optional<double> sigma() const;

 private:
  struct Row {
    QWidget* page = nullptr;
    widgets::PictureChoice* kind = nullptr;
    QLineEdit* known = nullptr;
  };
  Row add_row(const QString& name);

  QStringList names_;
  std::vector<Row> rows_;  // of names_
  QVBoxLayout* column_;
  QDoubleSpinBox* sigma_;
  QLineEdit* apart_;
};

}  // namespace handsight::app
