// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/session_parts.h"

namespace handsight::app {

bool is_joined(const Session& session) { return session.parts.size() > 1 && !session.is_touch(); }

OwnSession take_own_session(const Session& s, int part) {
  if (!is_joined(s)) return {s.tcp, &s.mount, 0, s.rig ? s.rig->count() : 0};
  const SessionPart& own = s.parts.at(static_cast<std::size_t>(part));
  const Mount& mount = own.mount == 0 ? s.mount : s.other_mounts.at(static_cast<std::size_t>(own.mount - 1));
  return {own.tcp, &mount, own.first_camera, own.camera_count};
}

Rigid mount_from_sensor(const Session& s, int part, const ModelVersion* model) {
  if (!model || !model->fit) return take_own_session(s, part).mount->mount_from_sensor;
  if (!is_joined(s)) return estimate(*model->fit).mount_from_sensor;
  const auto place = static_cast<std::size_t>(part);
  return place < model->parts.size() ? model->parts[place].found.mount_from_sensor
                                     : take_own_session(s, part).mount->mount_from_sensor;
}

}  // namespace handsight::app
