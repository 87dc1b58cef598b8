// SPDX-License-Identifier: GPL-3.0-or-later
// What all parts of one window share: document, selection, jobs, images. No widgets.
#pragma once

#include <QObject>
#include <deque>
#include <unordered_map>

#include "blunders/blunder.h"
#include "diagnosis/story/story.h"
#include "document/diagnosing.h"
#include "document/document.h"
#include "document/refit.h"
#include "document/refusal.h"
#include "document/selection.h"
#include "images/image_source.h"
#include "jobs/jobs.h"
#include "widgets/base/cells.h"
#include "workbench/display_units.h"
#include "workbench/session_filter.h"

namespace handsight::app {

/// The six workspaces, in the order of the work.
enum class Place { label, calibrate, experiment, inspect, explain, write_out };

class Workbench : public QObject {
  Q_OBJECT

 public:
  explicit Workbench(QObject* parent = nullptr);

  Document document;
  Selection selection;
  SessionFilter sessions{document};
  DisplayUnits units;
  Jobs jobs;        // what the user waits for: fits, plays; shown in the header
  Jobs background;  // corners, second looks
  Refit refit{document, jobs};
  Diagnosing diagnosing{document, explaining};
  Jobs explaining;  // diagnoses, added effects, planned poses. After what its work reports to: it dies first
  ImageSource images;
  std::vector<Refusal> refused;  // of this session, by Explain

  /// The mistakes of a whole kind that were found in this session: as long as there are some, its verdict is about
  /// them.
  const std::vector<Blunder>& blunders() const { return blunders_; }
  void set_blunders(std::vector<Blunder> found);

  /// What there is to say of a version of the model, made once for every place that speaks of it (story.h); of a model
  /// without a fit an empty one. The diagnosis is of the present model.
  const Story& find_story(const ModelVersionPointer& model) const;
  /// Of the shown model, which is the present one but where an earlier one is looked at.
  const Story& story() const { return find_story(document.is_open() ? document.shown_model() : nullptr); }
  /// The diagnosis that its story goes by; null where it has none.
  std::shared_ptr<const Diagnosis> find_diagnosis(const ModelVersionPointer& model) const;
  /// The bill of a version, with how sure its causes are where that is known: of the present model.
  std::vector<BillRow> make_bill(const ModelVersionPointer& model) const;
  /// Whose fault one observation's error is, in the light of the same cause as the whole session's.
  ErrorAttribution attribute_error(const InspectionRow& row) const;

  /// The inspection of the shown model; null before there is one.
  const Inspection* inspection() const;
  /// Its row of an observation; null where there is none or the observation shows no markers.
  const InspectionRow* row(std::int64_t id) const;
  const InspectionRow* selected_row() const;
  const Observation* selected_observation() const;

  /// Every observation as a cell of strip and plots.
  std::vector<widgets::ObservationCell> cells() const;
  /// Those of the sessions that are shown.
  std::vector<widgets::ObservationCell> shown_cells() const;

  /// What is being tried before it is added: the error it would leave (px or m) and, per observation id, the rms of one
  /// coordinate over the noise; shown purple everywhere. No error: nothing is tried.
  void try_out(std::optional<double> error, std::unordered_map<std::int64_t, double> ratios = {});
  std::optional<double> predicted_error() const { return predicted_error_; }

  /// The observation whose label a play waits for: the mount is unknown, and it would tell most.
  std::optional<std::int64_t> label_wanted;

  /// Actions on observations, each one action to undo. Ids that are so already are left out.
  void exclude(const std::vector<std::int64_t>& ids, const Message& reason = by_the_user);
  void include(const std::vector<std::int64_t>& ids);

 signals:
  /// Asks the window to show a workspace.
  void workspace_requested(handsight::app::Place place);
  /// Asks Label to open an observation there.
  void relabel_requested(qint64 id);
  void tried();
  void blunders_changed();
  /// A read-out under the pointer; empty: nothing.
  void pointed_at(const QString& text);

 private:
  void look_again();
  /// What the story was made from: as long as it is the same, the story is.
  struct Told {
    ModelVersionPointer model;
    std::shared_ptr<const Diagnosis> diagnosis;
    std::set<std::string> refused;
    std::optional<double> elsewhere;
    bool operator==(const Told&) const = default;
  };
  mutable std::deque<std::pair<Told, Story>> stories_;  // the latest first; a reference stays good while it is kept
  std::vector<Blunder> blunders_;
  std::optional<double> predicted_error_;
  std::unordered_map<std::int64_t, double> predicted_ratios_;
};

/// "observation 7", "3 observations"
QString observations_text(const std::vector<std::int64_t>& ids);

}  // namespace handsight::app
