// SPDX-License-Identifier: GPL-3.0-or-later
// The report: numbers, plots, what was excluded and why, what was done.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <vector>

#include "document/document.h"

namespace handsight::app {

/// A picture of the report with its caption.
struct ReportPicture {
  QString caption;
  QImage image;
};

/// One whole HTML file, pictures inside it.
QString report_html(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures);

/// The same as PDF, A4.
QByteArray report_pdf(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures);

}  // namespace handsight::app
