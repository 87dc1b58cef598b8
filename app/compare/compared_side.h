// SPDX-License-Identifier: GPL-3.0-or-later
// One of the sessions that are compared, with what the page shows of it. For a job: no widgets.
#pragma once

#include <QStringList>

#include "document/diagnosing.h"
#include "jobs/jobs.h"
#include "widgets/plots/convergence_plot.h"

namespace handsight::app {

/// One of those that are compared.
struct ComparedSide {
  QString name;  // the session's title; its folder's or file's name where it has none, or both have the same
  std::filesystem::path file;                          // session.xml, or the calibration
  std::shared_ptr<const Session> session;              // null: a calibration
  ModelVersionPointer version;                         // its own fit by the model of the open session; null: as above
  std::shared_ptr<const ModelResiduals> residuals;     // of that fit; null where nothing could be fitted
  std::vector<widgets::ConvergencePoint> convergence;  // of TCP->Body, observation by observation

  bool is_calibration() const { return session == nullptr; }
};

/// The session with the points of its target, where it has one and they are not there yet.
Session searched(Session session);

ComparedSide side_of(std::shared_ptr<const Session> session);

/// The name of the folder that it lies in.
QString folder_name(const Session& session);

/// Its own fit (`known` where that is it) with what it leaves, and how TCP->Body came about.
void look_into(ComparedSide& side, const ModelSettings& settings, const ModelVersionPointer& known,
               const JobControl& control);

/// The model that all sides have: what jumped at an observation of one did not at that of another. Says in `notes` what
/// it leaves out.
ModelSettings shared_settings(const ModelSettings& of_open, QStringList& notes);

}  // namespace handsight::app
