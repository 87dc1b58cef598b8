// SPDX-License-Identifier: GPL-3.0-or-later
// What an observation's own session has: in a collection each has its hand and what watches it.
#pragma once

#include "document/model_version.h"
#include "session/session.h"

namespace handsight::app {

struct OwnSession {
  std::string tcp;               // its link
  const Mount* mount = nullptr;  // of what watches it
  int first_camera = 0, camera_count = 0;
};
/// Of a session by itself, or of touches, all that it has.
OwnSession take_own_session(const Session& session, int part);

/// Where a session's cameras or tracker sit on their link: as the model has it, else as the session says.
Rigid mount_from_sensor(const Session& session, int part, const ModelVersion* model);

/// Is it several sessions that were joined?
bool is_joined(const Session& session);

}  // namespace handsight::app
