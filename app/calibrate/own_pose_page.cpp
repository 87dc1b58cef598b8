// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/own_pose_page.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QVBoxLayout>

#include "base/degrees.h"
#include "base/numbers.h"
#include "chain/chain.h"
#include "correct/correction.h"
#include "widgets/base/number_box.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "workbench/observation_views.h"

namespace handsight::app {

OwnPosePage::OwnPosePage(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  typed_ = new QLineEdit(this);
  typed_->setObjectName("own_pose_typed");
  typed_->setPlaceholderText(tr("joint angles in rad, in the session's order"));
  auto* take = new QPushButton(tr("From the selected"), this);
  take->setObjectName("own_pose_take");
  auto* row = new QHBoxLayout;
  row->addWidget(typed_, 1);
  row->addWidget(take);
  joints_ = new QWidget(this);
  grid_ = new QGridLayout(joints_);
  grid_->setContentsMargins(0, 0, 8, 0);
  grid_->setVerticalSpacing(2);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(joints_);
  result_ = new QLabel(this);
  result_->setObjectName("own_pose_result");
  result_->setWordWrap(true);
  result_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  correction_ = new QLabel(this);
  correction_->setObjectName("own_pose_correction");
  correction_->setWordWrap(true);
  correction_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 0);
  layout->addWidget(result_);
  layout->addWidget(correction_);
  layout->addLayout(row);
  layout->addWidget(scroll, 1);
  connect(take, &QPushButton::clicked, this, &OwnPosePage::take_selected);
  connect(typed_, &QLineEdit::editingFinished, this, &OwnPosePage::take_typed);
  connect(&workbench.document, &Document::model_changed, this, [this] {
    if (isVisible()) refresh();
  });
}

void OwnPosePage::set_session() {
  is_filling_ = true;
  for (QObject* child : joints_->children())
    if (auto* w = qobject_cast<QWidget*>(child)) w->deleteLater();
  sliders_.clear();
  boxes_.clear();
  commands_.clear();
  scales_.clear();
  const Session& s = workbench_.document.session();
  for (std::size_t i = 0; i < s.joints.size(); ++i) {
    const Joint& joint = s.robot.joints[static_cast<std::size_t>(find_joint(s.robot, s.joints[i]))];
    const bool prismatic = joint.kind == JointKind::prismatic;
    const double scale = prismatic ? 1e3 : degrees;
    const double wide = prismatic ? 1.0 : 3.14159265358979;
    const double lower = std::max(joint.lower, -wide), upper = std::min(joint.upper, wide);
    auto* name = new QLabel(QString::fromStdString(s.joints[i]), joints_);
    auto* slider = new QSlider(Qt::Horizontal, joints_);
    slider->setRange(static_cast<int>(lower * 1000), static_cast<int>(upper * 1000));
    auto* box = new widgets::NumberBox(joints_);
    box->setObjectName("own_pose_joint_" + QString::number(i));
    box->setDecimals(2);
    box->setSuffix(prismatic ? tr(" mm") : tr(" deg"));
    box->setRange(-36000, 36000);
    box->setFocusPolicy(Qt::StrongFocus);
    slider->setFocusPolicy(Qt::StrongFocus);
    const int r = static_cast<int>(i);
    grid_->addWidget(name, r, 0);
    grid_->addWidget(slider, r, 1);
    grid_->addWidget(box, r, 2);
    auto* command = new QLabel(joints_);
    command->setObjectName("own_pose_command_" + QString::number(i));
    command->setFont(widgets::number_font(widgets::TextRole::body));
    command->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    command->setTextInteractionFlags(Qt::TextSelectableByMouse);
    command->setToolTip(tr("What to command so that the hand arrives where it was meant to be."));
    grid_->addWidget(command, r, 3);
    commands_.push_back(command);
    connect(slider, &QSlider::valueChanged, this, [this, box, scale](int value) {
      if (!is_filling_) box->setValue(1e-3 * value * scale);
    });
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, slider, scale](double value) {
      if (is_filling_) return;
      is_filling_ = true;
      slider->setValue(static_cast<int>(1000 * value / scale));
      is_filling_ = false;
      refresh();
    });
    sliders_.push_back(slider);
    boxes_.push_back(box);
    scales_.push_back(scale);
  }
  is_filling_ = false;
  prediction_.reset();
}

void OwnPosePage::set_active(bool active) {
  if (!active || boxes_.empty()) return;
  if (!prediction_) take_selected();
  refresh();
}

/// The model may have changed while another page was looked at.
void OwnPosePage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (prediction_) refresh();
}

Eigen::VectorXd OwnPosePage::position() const {
  Eigen::VectorXd q(static_cast<Eigen::Index>(boxes_.size()));
  for (std::size_t i = 0; i < boxes_.size(); ++i) q[static_cast<Eigen::Index>(i)] = boxes_[i]->value() / scales_[i];
  return q;
}

void OwnPosePage::set_position(const Eigen::VectorXd& q) {
  is_filling_ = true;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    boxes_[i]->setValue(q[static_cast<Eigen::Index>(i)] * scales_[i]);
    sliders_[i]->setValue(static_cast<int>(1000 * q[static_cast<Eigen::Index>(i)]));
  }
  is_filling_ = false;
  refresh();
}

void OwnPosePage::take_selected() {
  if (const Observation* o = workbench_.selected_observation()) set_position(o->position);
}

void OwnPosePage::take_typed() {
  const std::string text = typed_->text().simplified().replace(",", " ").toStdString();
  if (text.empty()) return;
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != boxes_.size()) {
    result_->setText(tr("%1 numbers are wanted, one for each joint; there are %2.")
                         .arg(boxes_.size())
                         .arg(numbers ? QString::number(numbers->size()) : tr("some that cannot be read")));
    return;
  }
  set_position(Eigen::Map<const Eigen::VectorXd>(numbers->data(), static_cast<Eigen::Index>(numbers->size())));
}

/// Of a collection the hand that the selected observation shows.
const HandModel* OwnPosePage::hand(const ModelVersion& model) const {
  const Observation* o = workbench_.selected_observation();
  const auto place = static_cast<std::size_t>(o ? o->part : 0);
  return place < model.hands.size() ? &model.hands[place] : nullptr;
}

std::shared_ptr<const Session> OwnPosePage::own_session(const ModelVersion& model) const {
  const HandModel* own = hand(model);
  return own ? own->session : workbench_.document.shared_session();
}

const PredictionModel& OwnPosePage::own_prediction(const ModelVersion& model) const {
  const HandModel* own = hand(model);
  return own ? own->prediction : model.prediction;
}

void OwnPosePage::refresh() {
  const ModelVersionPointer model = workbench_.document.shown_model();
  if (!model || !model->fit) {
    prediction_.reset();
    result_->setText(tr("Waits for a fit; then it says where the TCP really is."));
    show_correction(nullptr);
    emit changed();
    return;
  }
  prediction_ = predict_tcp(make_chain(*own_session(*model)), position(), own_prediction(*model));
  const Vector3 t = prediction_->root_from_tcp_est.translation;
  const Vector6 s = prediction_->sigma();
  result_->setText(tr("TCP at %1, %2, %3 mm (± %4, %5, %6)")
                       .arg(widgets::fixed_text(1e3 * t.x(), 1), widgets::fixed_text(1e3 * t.y(), 1),
                            widgets::fixed_text(1e3 * t.z(), 1), widgets::short_text(1e3 * s[0]),
                            widgets::short_text(1e3 * s[1]), widgets::short_text(1e3 * s[2])));
  show_correction(model.get());
  emit changed();
}

/// The joints that bring the hand where it was meant to be, beside those that were asked for.
void OwnPosePage::show_correction(const ModelVersion* model) {
  const bool is_moved = model && !own_prediction(*model).effects.empty();
  correction_->setVisible(is_moved);
  for (QLabel* command : commands_) command->clear();
  if (!is_moved) return;
  const Chain chain = make_chain(*own_session(*model));
  const Correction c = corrected(states_at(chain, position()), own_prediction(*model));
  for (std::size_t i = 0; i < commands_.size(); ++i)
    commands_[i]->setText("→ " + widgets::fixed_text(c.position[static_cast<Eigen::Index>(i)] * scales_[i], 3) +
                          boxes_[i]->suffix());
  const QString before = widgets::short_text(1e3 * c.error_before_m),
                after = widgets::short_text(1e3 * c.error_after_m), sigma = widgets::short_text(1e3 * c.sigma_m);
  correction_->setText(
      c.reached
          ? tr("The hand misses its place by %1 mm. Command the angles at the right, and it arrives to ± %2 mm.")
                .arg(before, sigma)
          : tr("The hand misses its place by %1 mm. Within the joints' limits %2 mm stay (± %3 mm), by the angles "
               "at the right.")
                .arg(before, after, sigma));
}

void OwnPosePage::show(widgets::RobotView& view) {
  Observation pose;
  pose.id = widgets::no_observation;
  if (const Observation* o = workbench_.selected_observation()) pose.part = o->part;
  pose.position = position();
  show_pose(workbench_.document, pose, nullptr, view);
  if (!prediction_) return;
  view.set_tcp_est(prediction_->root_from_tcp_est);
  widgets::SceneEllipsoid ellipsoid{.center = prediction_->root_from_tcp_est.translation};
  ellipsoid.covariance = prediction_->covariance.topLeftCorner<3, 3>();
  view.set_ellipsoid(ellipsoid);
}

}  // namespace handsight::app
