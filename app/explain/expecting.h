// SPDX-License-Identifier: GPL-3.0-or-later
// What to expect on new poses of a model whose causes were chosen by few: the held-out error has had its say in the
// choice, and is too small.
#pragma once

#include <QObject>

#include "explain/adding.h"

namespace handsight::app {

class Expecting : public QObject {
  Q_OBJECT

 public:
  Expecting(Workbench& workbench, const Adding& adding, QObject* parent = nullptr);

  /// Chooses the present model's causes anew without each part of its poses, in the background. Nothing happens where
  /// they are many, where nothing was chosen by them, or where it would take long (diagnosis/selection/choosing.h).
  void start();
  /// "Expect 0.31 px on new poses: ..."; empty where it is not known of this model.
  QString sentence(const ModelVersionPointer& model) const;

 signals:
  void changed();

 private:
  bool is_asked_of(const ModelVersion& model) const;

  Workbench& workbench_;
  const Adding& adding_;
  std::shared_ptr<const Fit> fit_;  // of the model that was asked about last
  std::optional<ErrorSummary> error_;
};

}  // namespace handsight::app
