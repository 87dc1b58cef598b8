// SPDX-License-Identifier: GPL-3.0-or-later
// A mistake of a whole kind in the open session (a joint that counts the other way, readings paired one off), above the
// workspaces: what is wrong, what is left with it and without it, and a button that writes the session put right beside
// the old one.
#pragma once

#include <QFrame>

#include "blunders/blunder.h"
#include "workbench/workbench.h"

class QLabel;
class QPushButton;

namespace handsight::app {

class BlunderBar : public QFrame {
  Q_OBJECT

 public:
  explicit BlunderBar(Workbench& workbench, QWidget* parent = nullptr);
  /// Looks now, however good the fit is; says so where nothing is found.
  void look();
  const std::vector<Blunder>& found() const { return workbench_.blunders(); }

 signals:
  void open_wanted(const QString& session);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void follow();
  void search(bool is_asked_for);
  void take(const std::vector<Blunder>& found);
  void refresh();
  void write();
  void say(const QString& sentence, bool is_refusal);

  Workbench& workbench_;
  QString written_;          // the folder of the session that was put right; empty: none yet
  bool has_looked_ = false;  // in this session
  QLabel *text_, *sizes_, *said_;
  QPushButton *write_, *open_;
};

/// The folder beside the session that takes it put right: "NAME_mended", with a number where that is there.
std::filesystem::path mended_folder(const Session& session);

}  // namespace handsight::app
