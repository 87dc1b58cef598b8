// SPDX-License-Identifier: GPL-3.0-or-later
// A line drawing of each effect of the catalogue: what the robot does.
#pragma once

#include <QPainter>
#include <QWidget>
#include <string>
#include <vector>

#include "widgets/base/theme.h"

namespace handsight::widgets {

/// Draws the effect of that id (empty: the unnamed curve) into a square in the middle of `area`, in lines that scale
/// with it, in the colours given: nominal parts in ink 2, what the effect does in the candidate's purple. An unknown id
/// gets a question mark.
void paint_effect(QPainter& painter, const QRectF& area, const std::string& effect_id, const Colors& colors);

bool has_effect_drawing(const std::string& effect_id);

/// The drawing as a widget, 96 x 96 by itself.
class EffectDrawing : public QWidget {
  Q_OBJECT
 public:
  explicit EffectDrawing(QWidget* parent = nullptr);
  void set_effect(const std::string& effect_id);
  QSize sizeHint() const override { return {96, 96}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::string effect_;
};

}  // namespace handsight::widgets
