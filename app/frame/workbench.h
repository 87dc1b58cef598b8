// SPDX-License-Identifier: GPL-3.0-or-later
// What all parts of one window share: document, selection, jobs, images. No widgets.
#pragma once

#include <QObject>

#include "document/document.h"
#include "document/refit.h"
#include "document/selection.h"
#include "images/image_source.h"
#include "jobs/jobs.h"
#include "widgets/cells.h"

namespace handsight::app {

class Workbench : public QObject {
  Q_OBJECT

 public:
  explicit Workbench(QObject* parent = nullptr);

  Document document;
  Selection selection;
  Jobs jobs;        // what the user waits for: fits, plays; shown in the header
  Jobs background;  // corners, second looks
  Refit refit{document, jobs};
  ImageSource images;

  /// The inspection of the shown model; null before there is one.
  const Inspection* inspection() const;
  /// Its row of an observation; null where there is none or the observation shows no markers.
  const InspectionRow* row(std::int64_t id) const;
  const InspectionRow* selected_row() const;
  const Observation* selected_observation() const;

  /// Every observation as a cell of strip and plots.
  std::vector<widgets::ObservationCell> cells() const;

  /// Actions on observations, each one action to undo. Ids that are so already are left out.
  void exclude(const std::vector<std::int64_t>& ids, const std::string& reason = "by the user");
  void include(const std::vector<std::int64_t>& ids);

 signals:
  /// Asks the window to show a workspace: 0 Label ... 4 Export.
  void workspace_requested(int workspace);
  /// Asks Label to open an observation there.
  void relabel_requested(qint64 id);
  /// A read-out under the pointer; empty: nothing.
  void pointed_at(const QString& text);

 private:
  void look_again();
};

/// "observation 7", "3 observations"
QString observations_text(const std::vector<std::int64_t>& ids);

}  // namespace handsight::app
