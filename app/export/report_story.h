// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says first: the story, its picture, the bill.
#pragma once

#include "export/report.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// Of a model with a fit, as every other place tells it.
ReportStory report_story(const Workbench& workbench, const ModelVersionPointer& model);

}  // namespace handsight::app
