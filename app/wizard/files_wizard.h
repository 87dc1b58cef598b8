// SPDX-License-Identifier: GPL-3.0-or-later
// A new session from files as other programs write them: ROS 2 bags, camera_info, Kalibr's camchain, easy_handeye's
// samples, tables of joints, poses or points, folders of images, a URDF. Each is known by its content; what has to be
// known beside them is asked; the session is made as `handsight-cli convert` makes it.
#pragma once

#include <QDialog>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "convert/conversion.h"
#include "convert/file_kind.h"
#include "jobs/jobs.h"
#include "readers/field_urdf.h"
#include "wizard/made_of_files.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace handsight::app {

class TargetForm;
class TouchForm;

class FilesWizard : public QDialog {
  Q_OBJECT

 public:
  /// Over `window`, with these files to begin with; the session that it makes is handed to `open`.
  static FilesWizard* run(QWidget& window, Jobs& jobs, std::vector<std::filesystem::path> files,
                          std::function<void(const QString& path)> open);

  /// What it is making is no longer wanted.
  ~FilesWizard() override;

  void add(const std::vector<std::filesystem::path>& files);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void reject() override;

 private:
  FilesWizard(QWidget& window, Jobs& jobs, std::function<void(const QString& path)> open);
  /// One of the files, as it was recognised.
  struct Named {
    std::filesystem::path path;
    std::optional<FileKind> kind;
    QString refusal;  // where it is nothing that a session is made from
  };

  void make_layout();
  void add_questions();
  void connect_all();
  void choose_files();
  void choose_folder();
  void remove_chosen();
  void read();
  void read_robot();
  void offer_links();
  void refresh();
  void show_questions();
  bool has(FileKind kind) const;
  bool shows_images() const;
  bool are_touches() const;
  QStringList fixtures() const;
  QString what_is_missing() const;
  ConvertOptions options() const;
  void make();
  void stop_making();
  void end_making();
  QString in_words_of_window(QString sentence) const;
  void show_made(const MadeOfFiles& made);
  void open_made();

  Jobs& jobs_;
  std::function<void(const QString& path)> open_made_;
  std::vector<Named> files_;
  std::optional<FieldUrdf> robot_;
  std::vector<std::string> offered_;  // links that the combo boxes hold
  QString made_;                      // session.xml, once it is made
  bool is_busy_ = false, names_folder_ = false;
  std::shared_ptr<std::atomic<bool>> is_stopped_;  // what is being made; the worker asks
  QWidget *content_, *working_;                    // what is entered; what is there while it is made
  QListWidget* list_;
  QPushButton *remove_, *make_, *stop_;
  QFormLayout* questions_;
  QComboBox *tcp_, *mount_, *shown_;
  QCheckBox *degrees_, *eye_on_base_, *find_lag_;
  QDoubleSpinBox* still_;
  QLineEdit *frame_, *title_, *out_;
  QSpinBox* markers_;
  TargetForm* target_;
  TouchForm* touches_;  // hidden where no table of touches is among the files
  QLabel* said_;
  QPlainTextEdit* report_;
};

}  // namespace handsight::app
