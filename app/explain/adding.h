// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a candidate in the background while the window watches; the document changes only when it is taken.
#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>

#include "diagnosis/selection/improvement_result.h"
#include "findings/explain_texts.h"
#include "findings/fit_watch.h"
#include "findings/proof_plots.h"

namespace handsight::app {

/// How an addition ended.
enum class AdditionEnd {
  taken,
  refused,  // it would not make the model better on unseen observations
  stopped,  // by the user, or by an action that made it stale
  failed    // it could not be worked out, or not be written down
};

class Adding : public QObject {
  Q_OBJECT

 public:
  explicit Adding(Workbench& workbench, QObject* parent = nullptr);

  /// Adds a candidate of the present diagnosis by its find_id. Nothing happens where there is none, or while one is
  /// added.
  void add(const std::string& id);
  /// What is sought where nothing is left to add.
  enum class Seeking {
    other_names,  // for what is in the model, where they are clearly likelier; else as the next
    likely,       // a name that is likely beside them, else one in the place of all, else where `improve` would end
    thoroughly    // all ends of a search: minutes
  };
  /// Nothing happens without a diagnosis, or while something is added.
  void seek(Seeking what);
  /// Ends what seeks at its next look: what was found until then is taken.
  void settle() { *enough_ = true; }
  bool is_running() const { return is_running_; }
  /// Of the open document, in the order in which they were tried.
  const std::vector<Refusal>& refused() const { return workbench_.refused; }
  /// The proof plots of what is being added, or was added last, and the same once it was in the model (empty where it
  /// was not taken).
  const Proof& offered() const { return offered_; }
  const Proof& taken() const { return taken_; }
  bool added_likely() const { return added_likely_; }  // what was taken last
  bool added_background() const { return added_background_; }
  bool found_other_names() const { return found_other_names_; }
  /// How many models were fitted to choose from, since the document was opened.
  int models() const { return models_; }
  int pictures() const { return pictures_; }  // shown of the last addition
  int skipped() const { return skipped_; }

 signals:
  void began(const QString& what);
  void iterated(int iteration, double rms);  // px or mm
  void pictured(const FitPicture& picture);
  void ended(handsight::app::AdditionEnd end, const QString& sentence);

 private:
  struct Run {
    std::shared_ptr<const Diagnosis> before;
    std::optional<DiagnosisCandidate> candidate;  // none: other names are sought
    std::int64_t revision = 0;
    Seeking seeking = Seeking::other_names;
  };
  struct Outcome {
    ModelChange change;                      // its model is handed on:
    std::shared_ptr<const Diagnosis> model;  // null where nothing was taken
    std::shared_ptr<ModelVersion> version;   // null where nothing was taken
    std::shared_ptr<const ModelResiduals> residuals;
    std::vector<ProofPlot> proof;
  };
  /// `what` is done for the user; `offered`: what it is to prove.
  void start(Run run, const QString& what, Proof offered);
  static Outcome make_outcome(const Run& run, const Session& session, const ModelSettings& settings,
                              const SecondLooks& looks, const std::atomic<bool>& enough, JobControl& control);
  QString find_refusal(const Run& run) const;
  void show_news(bool is_end);
  void finish(const Run& run, const Outcome& outcome);
  void stop();
  void end(AdditionEnd end, const QString& sentence);

  Workbench& workbench_;
  std::shared_ptr<FitWatch> watch_;
  std::shared_ptr<std::atomic<bool>> enough_ = std::make_shared<std::atomic<bool>>(false);  // of the present run
  QTimer timer_;
  Proof offered_, taken_;
  bool is_running_ = false;
  bool added_likely_ = false, added_background_ = false, found_other_names_ = false;
  bool is_taking_ = false;  // the document is being changed by what was found
  int pictures_ = 0, skipped_ = 0;
  int models_ = 0;
};

}  // namespace handsight::app
