// SPDX-License-Identifier: GPL-3.0-or-later
// A pose of the user's own: sliders or typed numbers, where the TCP really is in it, and what to command instead.
#pragma once

#include <QWidget>
#include <vector>

#include "estimation/report/prediction.h"
#include "workbench/workbench.h"

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QSlider;

namespace handsight::widgets {
class RobotView;
}

namespace handsight::app {

class OwnPosePage : public QWidget {
  Q_OBJECT

 public:
  OwnPosePage(Workbench& workbench, QWidget* parent);
  /// Sliders for the joints of the open session.
  void set_session();
  void set_active(bool active);
  /// The robot in this pose with the predicted TCP and its ellipsoid.
  void show(widgets::RobotView& view);

 signals:
  void changed();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  const HandModel* hand(const ModelVersion& model) const;
  std::shared_ptr<const Session> own_session(const ModelVersion& model) const;
  const PredictionModel& own_prediction(const ModelVersion& model) const;
  void take_selected();
  void take_typed();
  void refresh();
  void show_correction(const ModelVersion* model);
  Eigen::VectorXd position() const;
  void set_position(const Eigen::VectorXd& position);

  Workbench& workbench_;
  QWidget* joints_;
  QGridLayout* grid_;
  QLineEdit* typed_;
  QLabel *result_, *correction_;
  std::vector<QSlider*> sliders_;
  std::vector<QDoubleSpinBox*> boxes_;  // degrees (mm for prismatic joints)
  std::vector<QLabel*> commands_;       // what to command instead, beside each box
  std::vector<double> scales_;          // shown per SI unit
  std::optional<TcpPrediction> prediction_;
  bool is_filling_ = false;
};

}  // namespace handsight::app
