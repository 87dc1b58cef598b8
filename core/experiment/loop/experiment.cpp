// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/experiment.h"

#include "experiment/loop/experiment_run.h"

namespace handsight {

ExperimentResult run_experiment(Session session, DrivenRobot& robot, const ExperimentOptions& options) {
  return Experiment(std::move(session), robot, options).run();
}

}  // namespace handsight
