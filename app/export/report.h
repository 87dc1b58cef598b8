// SPDX-License-Identifier: GPL-3.0-or-later
// The report: numbers, plots, what was excluded and why, what was done.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <vector>

#include "document/document.h"
#include "export/report_content.h"

namespace handsight::app {

/// One whole HTML file, pictures inside it: the story with the first of the pictures and the bill, the other pictures,
/// then the numbers, what was left out and what was done.
QString report_html(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures,
                    const ReportStory& story);

/// The same as PDF, A4; pictures are ordered, and drawn smaller, so that no page stays half empty.
QByteArray report_pdf(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures,
                      const ReportStory& story);

}  // namespace handsight::app
