// SPDX-License-Identifier: Apache-2.0
#include "printing/export_output.h"

#include "printing/json_values.h"

namespace handsight::cli {
namespace {

Json in_millimetres(const std::optional<double>& m) { return m ? number(1e3 * *m) : Json(nullptr); }

}  // namespace

Json export_json(const std::string& kind, const std::string& name, const ExportedFile& file) {
  return {{"kind", kind},
          {"file", name},
          {"left_mm", in_millimetres(file.left)},
          {"left_max_mm", in_millimetres(file.largest_left)},
          {"nominal_mm", in_millimetres(file.nominal)},
          {"poses", file.poses},
          {"notes", file.notes}};
}

}  // namespace handsight::cli
