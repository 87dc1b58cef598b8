// SPDX-License-Identifier: GPL-3.0-or-later
// What correcting buys: the hand's error over poses like the measured ones, as commanded and corrected.
#pragma once

#include <QWidget>

#include "correct/correction.h"
#include "workbench/workbench.h"

class QLabel;

namespace handsight::app {

class GainBars;

class CorrectionBox : public QWidget {
  Q_OBJECT

 public:
  CorrectionBox(Workbench& workbench, QWidget* parent);
  /// Of this model, worked out beside the window where it is not known; nothing is shown of a model without effects.
  /// `hand`: of a collection, which session's.
  void show_model(const ModelVersionPointer& model, std::size_t hand = 0);
  /// What is shown; null: nothing yet.
  const CorrectionGain* gain() const { return gain_ ? &*gain_ : nullptr; }

 private:
  void show_gain();

  Workbench& workbench_;
  ModelVersionPointer model_;
  std::size_t hand_ = 0;
  std::optional<CorrectionGain> gain_;
  QLabel* sentence_;
  GainBars* bars_;
};

/// Shares of errors by size: bins that grow by the same factor from the smallest to the largest of both lists.
struct GainBins {
  std::vector<double> edges;  // m, one more than there are bins
  std::vector<double> before, after;
};
GainBins gain_bins(const CorrectionGain& gain);

}  // namespace handsight::app
