// SPDX-License-Identifier: Apache-2.0
// The calibrated robot as another kind of file, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "command.h"
#include "export/exported.h"

namespace handsight::cli {

/// `name`: of the file, as it was asked for.
Json export_json(const std::string& kind, const std::string& name, const ExportedFile& file);

}  // namespace handsight::cli
