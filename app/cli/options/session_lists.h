// SPDX-License-Identifier: Apache-2.0
// Options of `convert` that may be given once for all sessions of a collection, or once for each.
#pragma once

#include <string>
#include <vector>

#include "convert/conversion.h"
#include "target_option.h"

namespace handsight::cli {

struct SessionLists {
  std::vector<std::string> tcps, mounts, titles, cameras, target_frames;
  std::vector<double> sigmas, sigma_angles;  // 0: not known
  TargetOptions target;                      // its `whole` may hold several
};

void add_session_lists(const CommandLine& command, SessionLists& lists);

/// The options of each session that is asked for: those of all, and of each list its own or the only one; "-" is none.
/// One where nothing is given more than once. InputError where two are given more than once and not as often, or a
/// target is none.
std::vector<ConvertOptions> options_of_sessions(const SessionLists& lists, const ConvertOptions& common);

}  // namespace handsight::cli
