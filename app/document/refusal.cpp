// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/refusal.h"

namespace handsight::app {

bool still_stands(const Refusal& refusal, const Document& document) {
  const QUndoStack& stack = document.undo_stack();
  return refusal.revision == document.revision() ||
         (refusal.index == stack.index() && refusal.before == stack.undoText());
}

std::set<std::string> refused_now(const std::vector<Refusal>& refused, const Document& document) {
  std::set<std::string> ids;
  for (const Refusal& r : refused)
    if (still_stands(r, document)) ids.insert(r.id);
  return ids;
}

}  // namespace handsight::app
