// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of the model that were tried and not taken.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "document/document.h"

namespace handsight::app {

struct Refusal {
  std::string id;
  std::vector<std::string> where;
  QString reason;
  QString before;             // the action after which it was tried
  int index = 0;              // of the undo stack
  std::int64_t revision = 0;  // of the document
};

/// Was it tried on the model as it is now?
bool still_stands(const Refusal& refusal, const Document& document);
/// Those of them, by id.
std::set<std::string> refused_now(const std::vector<Refusal>& refused, const Document& document);

}  // namespace handsight::app
