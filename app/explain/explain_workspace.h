// SPDX-License-Identifier: GPL-3.0-or-later
// The Explain workspace, as far as it goes: the error against the noise, in words, and how it spreads.
#pragma once

#include "frame/workspace.h"

class QLabel;

namespace handsight::widgets {
class HistogramPlot;
}

namespace handsight::app {

/// "The model misses by 9.1 px (12 mm at the hand) where the cameras' noise is 0.2 px."
QString comparison_sentence(const ModelVersion& model);

class ExplainWorkspace : public Workspace {
  Q_OBJECT

 public:
  explicit ExplainWorkspace(Workbench& bench, QWidget* parent = nullptr);

  QString name() const override { return tr("Explain"); }
  WorkStatus status() const override;
  void activate() override;

 private:
  QLabel *verdict_, *shares_, *later_;
  widgets::HistogramPlot* histogram_;
};

}  // namespace handsight::app
