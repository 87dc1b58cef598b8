// SPDX-License-Identifier: GPL-3.0-or-later
// The Export workspace: TCP->Body as it will be written, saved, copied, reported.
#pragma once

#include "export/export_texts.h"
#include "workbench/workspace.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QScrollArea;
class QTableWidget;
class QVBoxLayout;

namespace handsight::app {

class CorrectionBox;

class ExportWorkspace : public Workspace {
  Q_OBJECT

 public:
  explicit ExportWorkspace(Workbench& workbench, QWidget* parent = nullptr);

  std::vector<Action> own_actions() const override;
  WorkStatus status() const override;
  void activate() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;  // the table's new width
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_layout();
  QWidget* make_left();
  QWidget* make_right();
  void refresh();
  void refresh_motion();
  void fit_columns();
  widgets::SessionVerdict verdict(const ModelVersionPointer& model) const;
  void refresh_remarks(const ModelVersionPointer& model);
  void fit_remarks();
  void refresh_excluded(const ModelVersion& model);
  void show_changes(const QString& text);
  void save_xml();
  void save_report(bool pdf);
  void save_certificate();
  void save_for_others(const std::string& kind);
  void connect_buttons();
  void say(const QString& sentence, bool is_refusal);
  void fill_hands();
  /// The chosen session of a collection; 0 where one is open.
  std::size_t hand() const;
  MotionForm form() const;
  std::filesystem::path path() const;

  QScrollArea* before_;
  QWidget *reported_, *body_;
  QVBoxLayout* remarks_;
  CorrectionBox* correction_;
  QButtonGroup* forms_;
  QTableWidget *motion_, *excluded_;
  QPlainTextEdit* xml_;
  QLineEdit* path_;
  QLabel *fresh_, *excluded_title_, *empty_, *said_;
  QPushButton *save_, *copy_, *html_, *pdf_, *certificate_, *calibrate_, *save_other_;
  QComboBox* hand_;             // of a collection: whose
  QComboBox* other_;            // kinds of files for other programs
  std::int64_t exported_ = -1;  // revision
};

}  // namespace handsight::app
