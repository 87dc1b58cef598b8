// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/experiment_result.h"

namespace handsight {

const char* end_name(ExperimentEnd end) {
  switch (end) {
    case ExperimentEnd::reached:
      return "reached";
    case ExperimentEnd::count:
      return "count";
    case ExperimentEnd::time:
      return "time";
    case ExperimentEnd::no_more_poses:
      return "no_more_poses";
    case ExperimentEnd::interrupted:
      return "interrupted";
    case ExperimentEnd::not_confirmed:
      return "not_confirmed";
    case ExperimentEnd::fault:
      return "driver";
    default:
      return "dry_run";
  }
}

}  // namespace handsight
