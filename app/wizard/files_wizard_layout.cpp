// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the wizard of files.
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

#include "widgets/base/theme.h"
#include "wizard/files_wizard.h"
#include "wizard/target_form.h"
#include "wizard/touch_form.h"

namespace handsight::app {

FilesWizard::FilesWizard(QWidget& window, Jobs& jobs, std::function<void(const QString& path)> open)
    : QDialog(&window), jobs_(jobs), open_made_(std::move(open)) {
  setObjectName("files_wizard");
  setWindowTitle(tr("New session from files"));
  setAcceptDrops(true);
  const QSize screen = window.screen()->availableSize();
  resize(QSize(760, 680).boundedTo(screen - QSize(24, 48)));
  make_layout();
  connect_all();
  read();
}

void FilesWizard::make_layout() {
  auto* content = content_ = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 8, 0);
  auto* intro = new QLabel(
      tr("Drop here what there is, or add it: a ROS 2 bag, images, camera_info or a camchain of Kalibr, samples of "
         "easy_handeye, tables of joints, poses, points or touches, the robot's URDF. Each is known by its content."),
      content);
  intro->setWordWrap(true);
  column->addWidget(intro);
  list_ = new QListWidget(content);
  list_->setObjectName("files_list");
  list_->setAccessibleName(tr("Files of the new session"));
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setWordWrap(true);
  list_->setMinimumHeight(130);
  column->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  const auto button = [&](const char* name, const QString& text) {
    auto* b = new QPushButton(text, content);
    b->setObjectName(name);
    b->setAutoDefault(false);
    b->setMinimumHeight(widgets::control_height);
    row->addWidget(b);
    return b;
  };
  connect(button("files_add", tr("Add files…")), &QPushButton::clicked, this, &FilesWizard::choose_files);
  connect(button("files_add_folder", tr("Add a folder…")), &QPushButton::clicked, this, &FilesWizard::choose_folder);
  remove_ = button("files_remove", tr("Remove"));
  row->addStretch(1);
  column->addLayout(row);
  add_questions();
  column->addLayout(questions_);
  target_ = new TargetForm(content);
  target_->setObjectName("files_target");
  column->addWidget(target_);
  touches_ = new TouchForm(content);
  touches_->setObjectName("files_touches");
  column->addWidget(touches_);
  report_ = new QPlainTextEdit(content);
  report_->setObjectName("files_report");
  report_->setAccessibleName(tr("What was understood"));
  report_->setReadOnly(true);
  report_->setMinimumHeight(160);
  report_->hide();
  column->addWidget(report_, 2);

  auto* scroll = new QScrollArea(this);
  scroll->setObjectName("files_scroll");
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  said_ = new QLabel(this);
  said_->setObjectName("files_said");
  said_->setWordWrap(true);
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // Stop has a place of its own: whoever presses it a moment too late presses nothing else.
  working_ = new QWidget(this);
  auto* progress = new QProgressBar(working_);
  progress->setRange(0, 0);
  progress->setTextVisible(false);
  progress->setFixedHeight(6);
  stop_ = new QPushButton(tr("Stop"), working_);
  stop_->setObjectName("files_stop");
  stop_->setToolTip(tr("Stops what is being made; nothing of it stays (Esc)"));
  stop_->setAutoDefault(false);
  stop_->setMinimumHeight(widgets::control_height);
  auto* working = new QHBoxLayout(working_);
  working->setContentsMargins(0, 0, 0, 0);
  working->addWidget(progress, 1);
  working->addWidget(stop_);
  working_->hide();
  auto* buttons = new QDialogButtonBox(this);
  make_ = buttons->addButton(tr("Make the session"), QDialogButtonBox::ActionRole);
  make_->setObjectName("files_make");
  make_->setDefault(true);
  QPushButton* cancel = buttons->addButton(QDialogButtonBox::Cancel);
  cancel->setObjectName("files_cancel");
  cancel->setIcon({});
  cancel->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QWidget::close);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll, 1);
  layout->addWidget(said_);
  layout->addWidget(working_);
  layout->addWidget(buttons);
}

void FilesWizard::add_questions() {
  questions_ = new QFormLayout;
  questions_->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  const auto add = [&](const char* name, auto* field, const QString& text) {
    field->setObjectName(name);
    field->setMinimumHeight(widgets::control_height);
    if (qobject_cast<QComboBox*>(field)) field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    questions_->addRow(text, field);
    return field;
  };
  tcp_ = add("files_tcp", new QComboBox, tr("Link of the hand (TCP)"));
  mount_ = add("files_mount", new QComboBox, tr("Link that carries the sensor"));
  shown_ = add("files_shown", new QComboBox, tr("What the images show"));
  shown_->addItems({tr("Markers without numbers (two cameras)"), tr("Chessboard"), tr("ChArUco board"), tr("AprilGrid"),
                    tr("Tags"), tr("Grid of circles")});
  markers_ = add("files_markers", new QSpinBox, tr("Markers"));
  markers_->setRange(1, 64);
  markers_->setValue(3);
  eye_on_base_ = add("files_eye_on_base", new QCheckBox(tr("The camera stands; the flange carries the target")), {});
  degrees_ = add("files_degrees", new QCheckBox(tr("Joint angles are in degrees")), {});
  frame_ = add("files_frame", new QLineEdit, tr("Target's frame in /tf"));
  frame_->setPlaceholderText(tr("where the bag has no images of it; empty: the one that sounds like a target"));
  still_ = add("files_still", new QDoubleSpinBox, tr("The robot must stand for"));
  still_->setRange(0, 60);
  still_->setDecimals(2);
  still_->setSingleStep(0.1);
  still_->setValue(0.2);
  still_->setSuffix(tr(" s"));
  find_lag_ =
      add("files_find_lag", new QCheckBox(tr("The clocks of robot and sensor may differ: find by how much")), {});
  title_ = add("files_title", new QLineEdit, tr("Title"));
  out_ = add("files_out", new QLineEdit, tr("New folder"));
}

void FilesWizard::connect_all() {
  connect(remove_, &QPushButton::clicked, this, &FilesWizard::remove_chosen);
  connect(list_, &QListWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(!list_->selectedItems().isEmpty() && !is_busy_); });
  connect(shown_, &QComboBox::currentIndexChanged, this, &FilesWizard::show_questions);
  connect(frame_, &QLineEdit::textChanged, this, &FilesWizard::show_questions);
  for (QComboBox* box : {tcp_, mount_}) connect(box, &QComboBox::currentIndexChanged, this, &FilesWizard::refresh);
  connect(target_, &TargetForm::changed, this, &FilesWizard::refresh);
  connect(out_, &QLineEdit::textChanged, this, &FilesWizard::refresh);
  connect(out_, &QLineEdit::textEdited, this, [this] { names_folder_ = true; });
  connect(make_, &QPushButton::clicked, this, [this] { made_.isEmpty() ? make() : open_made(); });
  connect(stop_, &QPushButton::clicked, this, &FilesWizard::stop_making);
}

void FilesWizard::choose_files() {
  auto* dialog = new QFileDialog(this, tr("Files of the new session"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& chosen) {
    std::vector<std::filesystem::path> files;
    for (const QString& file : chosen) files.emplace_back(file.toStdString());
    add(files);
  });
  dialog->open();
}

void FilesWizard::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("A folder of images, or a bag"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) { add({folder.toStdString()}); });
  dialog->open();
}

}  // namespace handsight::app
