// SPDX-License-Identifier: GPL-3.0-or-later
// "What if": the size of an effect that is not in the model, by hand.
#pragma once

#include <QWidget>

#include "widgets/explain/what_if_state.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace handsight::widgets {

class WhatIfTrack;

/// A track from -3 to 3 prior sigmas (wider where the best is beyond), the plausible range shaded, a tick with its
/// sigma at the size that fits best. Arrows step by a hundredth of the range, Page by a tenth, Home goes to 0, B or a
/// double click to the best; the wheel only with the focus.
class WhatIfSlider : public QWidget {
  Q_OBJECT
 public:
  explicit WhatIfSlider(QWidget* parent = nullptr);
  void set_state(WhatIfState state);
  void set_answer(const QString& sentence);
  void set_value(double value);  // in the parameter's unit; no signal
  double value() const;
  const WhatIfState& state() const { return state_; }
  WhatIfTrack* track() const { return track_; }
  QComboBox* place_box() const { return places_; }
  QComboBox* parameter_box() const { return parameters_; }

 signals:
  void changed(double value);  // while it is dragged
  void settled(double value);  // when it is let go, or by a key
  void place_chosen(int place);
  void parameter_chosen(int parameter);
  void closed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void take(double value, bool is_final);

  WhatIfState state_;
  WhatIfTrack* track_ = nullptr;
  QComboBox *places_, *parameters_;
  QLabel *title_, *value_, *answer_;
  QPushButton *best_, *close_;
  bool is_filling_ = false;
};

}  // namespace handsight::widgets
