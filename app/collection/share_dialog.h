// SPDX-License-Identifier: GPL-3.0-or-later
// What a session shares with another of the same robot: of an open collection changed at once, of a session that is
// being added before it is.
#pragma once

#include <QDialog>
#include <array>
#include <filesystem>
#include <optional>

#include "collection/shared.h"
#include "workbench/workbench.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace handsight::app {

class SharePicture;

class ShareDialog : public QDialog {
  Q_OBJECT

 public:
  /// Of the collection that is open.
  ShareDialog(Workbench& workbench, QWidget* parent);
  /// A session that is to be added to what is open.
  ShareDialog(Workbench& workbench, const std::filesystem::path& added, QWidget* parent);

 signals:
  /// The collection was written there; it is to be opened.
  void written(const QString& file);
  /// The session is to be opened by itself instead.
  void open_wanted(const QString& path);

 private:
  void make_layout();
  QWidget* find_row(std::size_t what, const QString& text, const QString& says);
  void fill_sessions();
  void show_present();
  void choose(std::size_t what, bool is_shared);
  void try_joining();
  void add();
  Collection present() const;
  Collection wanted() const;
  std::size_t entry() const;
  std::size_t with() const;
  void say(const QString& sentence);

  Workbench& workbench_;
  std::optional<std::filesystem::path> added_;  // a session's folder
  QComboBox *session_, *with_;
  std::array<QCheckBox*, 3> boxes_{};  // robot, rig, body
  std::array<SharePicture*, 3> pictures_{};
  QLabel* said_;
  QLineEdit* file_ = nullptr;  // where a collection of two is written
  QPushButton* add_ = nullptr;
};

}  // namespace handsight::app
