// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the document's model: residual views and the diagnosis, made in the background while somebody looks,
// part by part. Results of an earlier model are dropped; those of a model that comes back (undo) are taken up again.
#pragma once

#include <QObject>
#include <deque>

#include "diagnosis/proof/proof.h"
#include "diagnosis/residuals/residual_views.h"
#include "diagnosis/verdict/diagnosis_result.h"
#include "document/document.h"
#include "jobs/jobs.h"

namespace handsight::app {

/// The model's residuals and what they follow.
struct ModelResiduals {
  ResidualViews views;
  std::vector<Pattern> patterns;  // all pairs, most structured first
};

/// The title of what these residuals are drawn in; where they are those of a part of the observations it says so.
QString titled(const QString& title, const ModelResiduals& residuals);

/// Takes a moment: for the background.
std::shared_ptr<const ModelResiduals> make_residuals(const ModelVersion& version);

/// How a candidate shows on these poses, once TCP->Body and the rest have taken up what they can.
struct CandidateView {
  EffectView effect;
  Eigen::VectorXd numbers;  // the candidate's own
  double rms_left = 0;      // px or m, of one coordinate, fitted
  std::vector<ProofPlot> proof;
};

class Diagnosing : public QObject {
  Q_OBJECT

 public:
  Diagnosing(Document& document, Jobs& jobs, QObject* parent = nullptr);

  /// While wanted (Explain is shown), the diagnosis follows the model.
  void set_wanted(bool wanted);

  /// Of the present model; null until they are there.
  std::shared_ptr<const ModelResiduals> residuals() const { return now_ ? now_->residuals : nullptr; }
  std::shared_ptr<const Diagnosis> diagnosis() const { return now_ ? now_->diagnosis : nullptr; }
  std::shared_ptr<const InclusionProbabilities> inclusion_probabilities() const {
    return now_ ? now_->inclusion_probabilities : nullptr;
  }
  /// The present model's error where whole regions of poses are held out (px or m); nothing until it is worked out.
  std::optional<double> elsewhere() const { return now_ ? now_->elsewhere : std::nullopt; }
  /// By find_id the candidate, of the present diagnosis; null where it was not worked out (yet).
  std::shared_ptr<const CandidateView> find_view(const std::string& id) const;
  bool is_running() const { return jobs_.is_busy("diagnosis"); }
  double share() const { return share_; }

  /// What has been found out on the way (by adding a candidate).
  void take(const ModelVersionPointer& version, std::shared_ptr<const Diagnosis> diagnosis,
            std::shared_ptr<const ModelResiduals> residuals);

  /// The residuals of any version; worked out at once where they are not known. Null while those of the present one are
  /// on their way.
  std::shared_ptr<const ModelResiduals> compute_residuals(const ModelVersionPointer& version);

 signals:
  void residuals_changed();
  void diagnosis_changed();                // the candidates
  void views_changed();                    // how candidates show
  void inclusion_probabilities_changed();  // how sure the names are; the document's version then allows for it
  void elsewhere_changed();                // the error where the robot has not been measured
  void progressed();

 private:
  struct Result {
    ModelVersionPointer version;
    std::shared_ptr<const ModelResiduals> residuals;
    std::shared_ptr<const Diagnosis> diagnosis;
    std::map<std::string, std::shared_ptr<const CandidateView>> views;
    bool has_views = false;
    std::optional<double> elsewhere;
    std::shared_ptr<const InclusionProbabilities>
        inclusion_probabilities;  // null where the model has no effects, or until it is there
  };
  using ResultPointer = std::shared_ptr<Result>;
  void follow();
  void start();
  void post(std::function<void()> news);
  void take_inclusion_probabilities(const ResultPointer& result,
                                    const std::shared_ptr<const InclusionProbabilities>& inclusion_probabilities);
  void forget_with_the_document();
  ResultPointer known(const ModelVersionPointer& version) const;

  Document& document_;
  Jobs& jobs_;
  ResultPointer now_;
  std::deque<ResultPointer> earlier_;
  bool is_wanted_ = false;
  std::atomic<double> share_{0};
};

}  // namespace handsight::app
