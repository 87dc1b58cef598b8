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

/// One whole HTML file, pictures inside it. `verdict` says in a sentence or two how good the model is.
QString report_html(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures,
                    const QString& verdict);

/// The same as PDF, A4.
QByteArray report_pdf(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures,
                      const QString& verdict);

}  // namespace handsight::app
