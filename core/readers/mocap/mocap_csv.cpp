// SPDX-License-Identifier: Apache-2.0
#include "readers/mocap/mocap_csv.h"

namespace handsight {

bool is_mocap(const std::string& text) { return is_motive_csv(text) || is_vicon_csv(text) || is_qualisys_tsv(text); }

std::optional<MocapTables> read_mocap(const std::string& text, const std::string& file) {
  if (is_motive_csv(text)) return read_motive_csv(text, file);
  if (is_vicon_csv(text)) return read_vicon_csv(text, file);
  return is_qualisys_tsv(text) ? std::optional(read_qualisys_tsv(text, file)) : std::nullopt;
}

}  // namespace handsight
