// SPDX-License-Identifier: GPL-3.0-or-later
// What the table, the map and the blame bar of Inspect show, as plain data.
#pragma once

#include "widgets/lists/attribution_bar.h"
#include "widgets/lists/observation_table.h"
#include "widgets/plots/residual_map.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// The shares as the bar shows them: what follows from the cause to look at first is counted with it. Images that do
/// not agree make body and robot look wrong too, a body that is wrong the robot. Nothing where nothing stands out.
/// What the whole session lacks is to blame for each observation as for all of them (Workbench::attribute_error).
std::optional<widgets::ErrorAttribution> shown_attribution(const Workbench& workbench, const InspectionRow& row);

std::vector<widgets::ObservationRow> table_rows(const Workbench& workbench);
std::vector<widgets::MapPoint> map_points(const Workbench& workbench);

/// Whose fault, in a sentence, and what would mend it.
QString attribution_sentence(const Workbench& workbench, const InspectionRow* row, const Observation* observation);

/// What an exclusion would change: "7 of 100. Error 9.1 -> 8.8 px; TCP->Body moves 0.3 sigma."
QString exclusion_sentence(const ModelVersion& now, const ModelVersion& then, std::size_t excluded, std::size_t of,
                           const DisplayUnits& units);

}  // namespace handsight::app
