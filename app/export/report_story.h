// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says first: the story, its picture, the bill.
#pragma once

#include "bench/workbench.h"
#include "export/report.h"

namespace handsight::app {

/// Of a model with a fit, as every other place tells it.
ReportStory report_story(const Workbench& bench, const ModelVersionPointer& model);

}  // namespace handsight::app
