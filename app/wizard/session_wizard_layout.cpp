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
#include <QScreen>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

#include "widgets/base/theme.h"
#include "widgets/scene/robot_view.h"
#include "wizard/session_wizard.h"
#include "wizard/target_form.h"
#include "workbench/heading.h"

namespace handsight::app {

SessionWizard::SessionWizard(QWidget& window, std::function<void(const QString& path)> open,
                             std::function<void()> bring)
    : QDialog(&window), open_made_(std::move(open)), bring_(std::move(bring)) {
  setObjectName("wizard");
  setWindowTitle(tr("New session"));
  const QSize screen = window.screen()->availableSize();
  resize(QSize(1040, 780).boundedTo(screen - QSize(24, 48)));
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->addWidget(make_questions());
  grid_ = new QGridLayout;
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(1, 1);
  column->addLayout(grid_);
  column->addStretch(1);
  add_files();

  auto* scroll = new QScrollArea;
  scroll->setObjectName("wizard_scroll");
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 20);
  refusal_ = new QLabel(this);
  refusal_->setObjectName("wizard_refusal");
  refusal_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(this);
  make_ = buttons->addButton(tr("Make the session"), QDialogButtonBox::ActionRole);
  make_->setObjectName("wizard_make");
  make_->setDefault(true);
  QPushButton* other = buttons->addButton(tr("From a bag or other files…"), QDialogButtonBox::ResetRole);
  other->setObjectName("wizard_bring");
  other->setToolTip(tr("A ROS 2 bag, samples of easy_handeye, tables of points: each is known by its content"));
  other->setAutoDefault(false);
  connect(other, &QPushButton::clicked, this, [this] {
    reject();
    bring_();
  });
  buttons->addButton(QDialogButtonBox::Cancel)->setIcon({});
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(make_, &QPushButton::clicked, this, &SessionWizard::make);
  auto* halves = new QHBoxLayout;
  halves->setSpacing(widgets::wide_gap);
  halves->addWidget(scroll, 3);
  halves->addWidget(make_scene(), 2);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(halves, 1);
  layout->addWidget(refusal_);
  layout->addWidget(buttons);
  connect_all();
  ask_known();
}

void SessionWizard::connect_all() {
  for (const Part* part : {&left_, &right_, &more_})
    connect(part->path, &QLineEdit::textChanged, this, &SessionWizard::read_images);
  connect(robot_.path, &QLineEdit::textChanged, this, &SessionWizard::read_robot);
  connect(angles_.path, &QLineEdit::textChanged, this, &SessionWizard::read_angles);
  connect(calibration_.path, &QLineEdit::textChanged, this, &SessionWizard::read_calibration);
  connect(poses_.path, &QLineEdit::textChanged, this, &SessionWizard::read_poses_of_target);
  connect(target_.path, &QLineEdit::textChanged, this, &SessionWizard::read_target);
  connect(form_, &TargetForm::changed, this, &SessionWizard::refresh);
}

QLabel* SessionWizard::add_heading(const QString& text) {
  QLabel* label = heading(text);
  grid_->addWidget(label, grid_->rowCount(), 0, 1, 3);
  return label;
}

void SessionWizard::add_files() {
  add_heading(tr("Files"));
  robot_ = add_part("wizard_robot", tr("Robot"), tr("URDF file"), Choice::file, tr("URDF (*.urdf *.xml)"));
  add_flange_row();
  add_robot_rows();
  angles_ = add_part("wizard_angles", tr("Joint angles"), tr("CSV: a line for each instant, rad"), Choice::file,
                     tr("Tables (*.csv *.txt *.yaml *.yml *.samples)"));
  left_ = add_part("wizard_left", tr("Left images"), tr("folder"), Choice::folder);
  right_ = add_part("wizard_right", tr("Right images"), tr("folder; may be the same"), Choice::folder);
  more_ = add_part("wizard_more", tr("More cameras"), tr("folders; several by ;"), Choice::folder);
  calibration_ = add_part("wizard_calibration", tr("Stereo calibration"), tr("of OpenCV, Kalibr or ROS; several by ;"),
                          Choice::files, tr("Calibrations (*.yml *.yaml *.xml *.json)"));
  poses_ = add_part("wizard_poses", tr("Poses of the target"), tr("CSV or YAML: x y z qx qy qz qw"), Choice::file,
                    tr("Tables (*.csv *.txt *.yaml *.yml *.samples)"));
  add_markers_row();
  add_mount_rows();
  add_session_rows();
}

SessionWizard::Part SessionWizard::add_part(const char* name, const QString& label, const QString& hint, Choice choice,
                                            const QString& filter) {
  Part part;
  const int row = grid_->rowCount();
  part.path = new QLineEdit;
  part.path->setObjectName(name);
  part.path->setPlaceholderText(hint);
  part.path->setMinimumHeight(widgets::control_height);
  part.sentence = new QLabel;
  part.sentence->setObjectName(QString(name) + "_sentence");
  part.sentence->setWordWrap(true);
  part.sentence->hide();
  part.sentence->setFont(widgets::text_font(widgets::TextRole::small));
  part.browse = new QPushButton(tr("Choose…"));
  part.browse->setAutoDefault(false);
  part.caption = new QLabel(label);
  part.caption->setBuddy(part.path);
  grid_->addWidget(part.caption, row, 0);
  grid_->addWidget(part.path, row, 1);
  grid_->addWidget(part.browse, row, 2);
  grid_->addWidget(part.sentence, row + 1, 1, 1, 2);
  connect(part.browse, &QPushButton::clicked, this, [this, part, choice, filter] {
    const QString title = part.caption->text();
    QStringList chosen;
    if (choice == Choice::folder) {
      chosen << QFileDialog::getExistingDirectory(this, title, part.path->text());
    } else if (choice == Choice::file) {
      chosen << QFileDialog::getOpenFileName(this, title, part.path->text(), filter);
    } else {
      chosen = QFileDialog::getOpenFileNames(this, title, {}, filter);
    }
    if (!chosen.join("").isEmpty()) part.path->setText(chosen.join(";"));
  });
  return part;
}

void SessionWizard::show_part(const Part& part, bool visible) {
  for (QWidget* w : std::initializer_list<QWidget*>{part.caption, part.path, part.browse}) w->setVisible(visible);
  part.sentence->setVisible(visible && !part.sentence->text().isEmpty());
}

void SessionWizard::add_flange_row() {
  flange_only_ = new QCheckBox(tr("No URDF: the controller says where the flange is"));
  flange_only_->setObjectName("wizard_flange_only");
  flange_only_->setToolTip(tr("What bends or is off in the joints can then not be told apart."));
  grid_->addWidget(flange_only_, grid_->rowCount(), 1, 1, 2);
  connect(flange_only_, &QCheckBox::toggled, this, &SessionWizard::ask_flange_only);
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
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(12);
    connect(box, &QComboBox::currentIndexChanged, this, &SessionWizard::refresh);
  }
  grid_->addWidget(new QLabel(tr("Camera on link")), row, 0);
  grid_->addWidget(mount_link_, row, 1);
  grid_->addWidget(new QLabel(tr("Target on link")), row + 1, 0);
  grid_->addWidget(tcp_, row + 1, 1);
}

void SessionWizard::add_mount_rows() {
  const int row = grid_->rowCount();
  mount_is_known_ = new QCheckBox;
  mount_is_known_->setObjectName("wizard_mount_known");
  mount_is_known_->setToolTip(tr("Left out, it is found from the observations."));
  mount_xyz_ = new QLineEdit;
  mount_xyz_->setObjectName("wizard_mount_xyz");
  mount_xyz_->setPlaceholderText(tr("x y z, m"));
  mount_rpy_ = new QLineEdit;
  mount_rpy_->setObjectName("wizard_mount_rpy");
  mount_rpy_->setPlaceholderText(tr("roll pitch yaw, rad"));
  grid_->addWidget(mount_is_known_, row, 0, 1, 3);
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

void SessionWizard::add_markers_row() {
  const int row = grid_->rowCount();
  markers_ = new QSpinBox;
  markers_->setObjectName("wizard_markers");
  markers_->setRange(1, 64);
  markers_->setValue(3);
  markers_->setFocusPolicy(Qt::StrongFocus);
  markers_caption_ = new QLabel(tr("Number of markers"));
  grid_->addWidget(markers_caption_, row, 0);
  grid_->addWidget(markers_, row, 1, Qt::AlignLeft);
}

void SessionWizard::add_session_rows() {
  add_heading(tr("The session"));
  const int row = grid_->rowCount();
  title_ = new QLineEdit;
  title_->setObjectName("wizard_title");
  title_->setPlaceholderText(tr("Right hand, 12 March"));
  title_->setMinimumHeight(widgets::control_height);
  grid_->addWidget(new QLabel(tr("Title")), row, 0);
  grid_->addWidget(title_, row, 1);
  target_ = add_part("wizard_target", tr("Session folder"), tr("made where it is not there"), Choice::folder);
}

}  // namespace handsight::app
