// SPDX-License-Identifier: GPL-3.0-or-later
// A version of the model as an entry of the list of versions.
#pragma once

#include <QString>
#include <optional>

namespace handsight::widgets {

struct VersionEntry {
  QString name;    // "+ joint elasticity of arm_2"
  QString detail;  // why it was refused, or what was excluded
  std::optional<double> held_out, fitted;
  std::optional<double> change, change_sigma;  // of the held-out error against the version before
  bool is_refused = false;
};

}  // namespace handsight::widgets
