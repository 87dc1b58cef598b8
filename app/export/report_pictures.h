// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "export/report.h"
#include "frame/workbench.h"

namespace handsight::app {

/// Plots of the shown model for the report: errors against the noise, residuals over the image.
std::vector<ReportPicture> report_pictures(const Workbench& bench);

}  // namespace handsight::app
