// SPDX-License-Identifier: GPL-3.0-or-later
// Three sessions of one robot and more, or those of a collection, compared and made ready to be shown. For a job: no
// widgets.
#pragma once

#include "compare/compared_side.h"
#include "compare/several_comparison.h"

namespace handsight::app {

struct ComparedSeveral {
  SeveralComparison comparison;
  std::vector<ComparedSide> sides;  // as SeveralComparison::sessions: in order of time
  QStringList notes;                // of the window, beside those of the comparison

  /// The place of a session among them, by its title; -1: it is none of them.
  int side(const std::string& title) const;
};

/// What is to be compared.
struct SeveralTask {
  std::shared_ptr<const Session> session;  // the open one as it stands, the latest; or a collection's, by itself
  ModelSettings settings;                  // its model; estimated in all
  std::vector<std::filesystem::path> others;
};

/// Reads the others, fits each and compares. InputError where they cannot be compared: what does not fit and what to
/// do.
ComparedSeveral compare_several(const SeveralTask& task, JobControl& control);

}  // namespace handsight::app
