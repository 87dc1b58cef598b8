// SPDX-License-Identifier: GPL-3.0-or-later
// The bill of a model (diagnosis/selection/bill.h) in words.
#pragma once

#include "widgets/explain/bill_list.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// A row a cause, what is worth most first; empty without a fit or causes.
std::vector<widgets::BillEntry> bill_entries(const Workbench& workbench, const ModelVersionPointer& model);
std::vector<widgets::BillEntry> bill_entries(const std::vector<BillRow>& rows, const Fit& fit);

}  // namespace handsight::app
