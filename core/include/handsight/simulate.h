// SPDX-License-Identifier: Apache-2.0
/// @file
/// Sessions whose truth is known: handsight::simulate_session makes one like another, with effects, noise and wrong
/// points of one's choice; handsight::write_simulated writes it as a folder, with rendered images where asked for.
#pragma once

#include "handsight/model.h"
#include "simulation/simulated_files.h"
#include "simulation/simulated_session.h"

namespace handsight {

/// The same with the effects of a model, held or estimated, at their values as the hidden truth, in place of
/// SimulationOptions::effects. The same options give the same session.
/// Throws InputError where no pose is found in which the markers are seen, and where the model does not suit `like`.
SimulatedSession simulate(const Session& like, const Model& truth, const SimulationOptions& options = {});

}  // namespace handsight
