// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a candidate in the background while the window watches; the document changes only when it is taken.
#pragma once

#include <QObject>
#include <QTimer>

#include "explain/explain_texts.h"
#include "explain/fit_watch.h"

namespace handsight::app {

class Adding : public QObject {
  Q_OBJECT

 public:
  explicit Adding(Workbench& bench, QObject* parent = nullptr);

  /// Adds a candidate of the present diagnosis. Nothing happens where there is none, or while one is added.
  void add(const std::string& id);
  bool is_running() const { return is_running_; }
  /// Of the open document, in the order in which they were tried.
  const std::vector<Refusal>& refused() const { return refused_; }
  int pictures() const { return pictures_; }  // shown of the last addition
  int skipped() const { return skipped_; }

 signals:
  void began(const QString& what);
  void iterated(int iteration, double rms);  // px or mm
  void pictured(const FitPicture& picture);
  /// `outcome` is a sentence.
  void ended(bool taken, const QString& outcome);

 private:
  struct Run {
    std::shared_ptr<const Diagnosis> before;
    DiagnosisCandidate candidate;
    std::int64_t revision = 0;
  };
  struct Outcome {
    ModelChange change;
    ModelVersionPointer version;  // null where nothing was taken
    std::shared_ptr<const ModelResiduals> residuals;
  };
  void show_news();
  void finish(const Run& run, const Outcome& outcome);
  void end(bool taken, const QString& outcome);

  Workbench& bench_;
  std::shared_ptr<FitWatch> watch_;
  QTimer timer_;
  std::vector<Refusal> refused_;
  bool is_running_ = false;
  int pictures_ = 0, skipped_ = 0;
};

}  // namespace handsight::app
