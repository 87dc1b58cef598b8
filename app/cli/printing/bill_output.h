// SPDX-License-Identifier: Apache-2.0
// The bill of a model (diagnosis/selection/bill.h) on the terminal and as JSON.
#pragma once

#include "command.h"
#include "diagnosis/selection/bill.h"

namespace handsight::cli {

/// The table with an empty line before it; nothing where the model has no causes.
void print_bill(const Output& out, const std::vector<BillRow>& rows);
Json bill_json(const std::vector<BillRow>& rows);

}  // namespace handsight::cli
