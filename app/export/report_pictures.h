// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "export/report.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// Pictures for the report, on light paper: first what proves the cause that leads, if one does; the staircase, the
/// residual cloud at first and now, where the first model failed and what is left there, errors against the noise,
/// residuals over the image, a labelled image pair, the robot. What the session has nothing of is left out.
std::vector<ReportPicture> report_pictures(Workbench& workbench);

}  // namespace handsight::app
