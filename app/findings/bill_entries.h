// SPDX-License-Identifier: GPL-3.0-or-later
// The bill of a model (diagnosis/selection/bill.h) in words.
#pragma once

#include "bench/workbench.h"
#include "widgets/explain/bill_list.h"

namespace handsight::app {

/// A row a cause, what is worth most first; empty without a fit or causes.
std::vector<widgets::BillEntry> bill_entries(const Workbench& bench, const ModelVersionPointer& model);
std::vector<widgets::BillEntry> bill_entries(const std::vector<BillRow>& rows, const Fit& fit);

}  // namespace handsight::app
