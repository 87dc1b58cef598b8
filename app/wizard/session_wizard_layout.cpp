// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the wizard.
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

#include "frame/main_window.h"
#include "widgets/theme.h"
#include "wizard/session_wizard.h"

namespace handsight::app {

SessionWizard::SessionWizard(MainWindow& window) : QDialog(&window), window_(window) {
  setObjectName("wizard");
  setWindowTitle(tr("New session from images"));
  resize(760, 680);
  auto* content = new QWidget;
  grid_ = new QGridLayout(content);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(1, 1);
  left_ = add_part("wizard_left", tr("Left images"), tr("folder"), Choice::folder);
  right_ = add_part("wizard_right", tr("Right images"), tr("folder; may be the same"), Choice::folder);
  robot_ = add_part("wizard_robot", tr("Robot"), tr("URDF file"), Choice::file, tr("URDF (*.urdf *.xml)"));
  add_robot_rows();
  angles_ = add_part("wizard_angles", tr("Joint angles"), tr("CSV: a line for each image pair, rad"), Choice::file,
                     tr("Tables (*.csv *.txt)"));
  calibration_ = add_part("wizard_calibration", tr("Stereo calibration"), tr("OpenCV's YAML or XML; several by ;"),
                          Choice::files, tr("OpenCV (*.yml *.yaml *.xml *.json)"));
  add_mount_rows();
  add_target_rows();
  grid_->setRowStretch(grid_->rowCount(), 1);

  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  refusal_ = new QLabel(this);
  refusal_->setObjectName("wizard_refusal");
  refusal_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(this);
  make_ = buttons->addButton(tr("Make the session"), QDialogButtonBox::ActionRole);
  make_->setObjectName("wizard_make");
  make_->setDefault(true);
  buttons->addButton(QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(make_, &QPushButton::clicked, this, &SessionWizard::make);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll, 1);
  layout->addWidget(refusal_);
  layout->addWidget(buttons);
  connect(left_.path, &QLineEdit::textChanged, this, &SessionWizard::read_images);
  connect(right_.path, &QLineEdit::textChanged, this, &SessionWizard::read_images);
  connect(robot_.path, &QLineEdit::textChanged, this, &SessionWizard::read_robot);
  connect(angles_.path, &QLineEdit::textChanged, this, &SessionWizard::read_angles);
  connect(calibration_.path, &QLineEdit::textChanged, this, &SessionWizard::read_calibration);
  connect(target_.path, &QLineEdit::textChanged, this, &SessionWizard::read_target);
  refresh();
}

SessionWizard::Part SessionWizard::add_part(const char* name, const QString& label, const QString& hint, Choice choice,
                                            const QString& filter) {
  Part part;
  const int row = grid_->rowCount();
  part.path = new QLineEdit;
  part.path->setObjectName(name);
  part.path->setPlaceholderText(hint);
  part.path->setMinimumHeight(widgets::kControlHeight);
  part.sentence = new QLabel;
  part.sentence->setObjectName(QString(name) + "_sentence");
  part.sentence->setWordWrap(true);
  part.sentence->setFont(widgets::text_font(widgets::TextRole::small));
  auto* browse = new QPushButton(tr("Choose…"));
  browse->setAutoDefault(false);
  auto* caption = new QLabel(label);
  caption->setBuddy(part.path);
  grid_->addWidget(caption, row, 0);
  grid_->addWidget(part.path, row, 1);
  grid_->addWidget(browse, row, 2);
  grid_->addWidget(part.sentence, row + 1, 1, 1, 2);
  connect(browse, &QPushButton::clicked, this, [this, part, label, choice, filter] {
    QStringList chosen;
    if (choice == Choice::folder) {
      chosen << QFileDialog::getExistingDirectory(this, label, part.path->text());
    } else if (choice == Choice::file) {
      chosen << QFileDialog::getOpenFileName(this, label, part.path->text(), filter);
    } else {
      chosen = QFileDialog::getOpenFileNames(this, label, {}, filter);
    }
    if (!chosen.join("").isEmpty()) part.path->setText(chosen.join(";"));
  });
  return part;
}

void SessionWizard::add_robot_rows() {
  const int row = grid_->rowCount();
  tcp_ = new QComboBox;
  tcp_->setObjectName("wizard_tcp");
  mount_link_ = new QComboBox;
  mount_link_->setObjectName("wizard_mount");
  for (QComboBox* box : {tcp_, mount_link_}) {
    box->setEnabled(false);
    box->setFocusPolicy(Qt::StrongFocus);
    connect(box, &QComboBox::currentIndexChanged, this, &SessionWizard::refresh);
  }
  grid_->addWidget(new QLabel(tr("TCP link")), row, 0);
  grid_->addWidget(tcp_, row, 1);
  grid_->addWidget(new QLabel(tr("Camera link")), row + 1, 0);
  grid_->addWidget(mount_link_, row + 1, 1);
}

void SessionWizard::add_mount_rows() {
  const int row = grid_->rowCount();
  mount_is_known_ = new QCheckBox(tr("I know where the left camera sits on its link"));
  mount_is_known_->setObjectName("wizard_mount_known");
  mount_is_known_->setToolTip(tr("Left out, it is found from the observations."));
  mount_xyz_ = new QLineEdit;
  mount_xyz_->setObjectName("wizard_mount_xyz");
  mount_xyz_->setPlaceholderText(tr("x y z, m"));
  mount_rpy_ = new QLineEdit;
  mount_rpy_->setObjectName("wizard_mount_rpy");
  mount_rpy_->setPlaceholderText(tr("roll pitch yaw, rad"));
  grid_->addWidget(mount_is_known_, row, 1, 1, 2);
  grid_->addWidget(mount_xyz_, row + 1, 1);
  grid_->addWidget(mount_rpy_, row + 2, 1);
  for (QLineEdit* edit : {mount_xyz_, mount_rpy_}) {
    edit->setVisible(false);
    connect(edit, &QLineEdit::textChanged, this, &SessionWizard::refresh);
  }
  connect(mount_is_known_, &QCheckBox::toggled, this, [this](bool on) {
    mount_xyz_->setVisible(on);
    mount_rpy_->setVisible(on);
    refresh();
  });
}

void SessionWizard::add_target_rows() {
  const int row = grid_->rowCount();
  markers_ = new QSpinBox;
  markers_->setObjectName("wizard_markers");
  markers_->setRange(1, 64);
  markers_->setValue(3);
  markers_->setFocusPolicy(Qt::StrongFocus);
  title_ = new QLineEdit;
  title_->setObjectName("wizard_title");
  title_->setPlaceholderText(tr("Right hand, 12 March"));
  grid_->addWidget(new QLabel(tr("Markers on the hand")), row, 0);
  grid_->addWidget(markers_, row, 1, Qt::AlignLeft);
  grid_->addWidget(new QLabel(tr("Title")), row + 1, 0);
  grid_->addWidget(title_, row + 1, 1);
  target_ = add_part("wizard_target", tr("Session folder"), tr("made where it is not there"), Choice::folder);
}

}  // namespace handsight::app
