// SPDX-License-Identifier: GPL-3.0-or-later
// TCP->Body as people and programs write it down.
#pragma once

#include <QString>
#include <vector>

#include "document/document.h"
#include "widgets/explain/verdict_line.h"

namespace handsight::app {

enum class MotionForm { matrix, xyz_rpy, quaternion };

/// One line of a table: name, value, sigma, unit; empty where there is none.
struct MotionLine {
  QString name, value, sigma, unit;
};
/// `hand`: of a collection, which session's.
std::vector<MotionLine> motion_lines(const ModelVersion& model, MotionForm form, std::size_t hand = 0);

/// TCP->Body of one hand of a collection; of a session by itself its own.
const Rigid& tcp_from_body(const ModelVersion& model, std::size_t hand);
/// What would be written of it alone.
const Calibration& calibration_of_hand(const ModelVersion& model, std::size_t hand);

/// The same as text to paste: full precision, SI.
QString motion_text(const Rigid& motion, MotionForm form);

/// The effects of the model with their numbers, one line a number; "held" in place of the sigma of a held one.
std::vector<MotionLine> effect_lines(const Session& session, const Fit& fit);

/// Sentences about what to know before the matrix is used, and whether they are a warning.
struct ExportRemark {
  QString sentence;
  bool is_warning = false;
};
/// Whether the model agrees, as Explain says it.
ExportRemark verdict_remark(const widgets::SessionVerdict& verdict, const ModelVersion& model);
/// All the rest.
std::vector<ExportRemark> export_remarks(const Document& document, const ModelVersion& model);

}  // namespace handsight::app
