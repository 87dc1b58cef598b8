// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/comparing_several.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "correct/calibrated_robot.h"
#include "session/calibration_xml.h"
#include "session/collection.h"
#include "session/session_xml.h"
#include "workbench/session_parts.h"

namespace handsight::app {
namespace {

/// A collection's sessions with what they share.
std::vector<JoinedMember> members_of_open(const Session& joined) {
  std::vector<JoinedMember> members;
  for (std::size_t i = 0; i < joined.parts.size(); ++i) {
    const SessionPart& part = joined.parts[i];
    members.push_back({.session = searched(part_session(joined, static_cast<int>(i))),
                       .title = part.title,
                       .rig = fmt::format("sensor {} {}", part.mount, part.first_camera),
                       .body = fmt::format("body {}", part.body),
                       .own = part.own});
  }
  return members;
}

[[noreturn]] void refuse(const QString& sentence) { throw InputError(verbatim(sentence.toStdString())); }

/// Their titles; where two are called the same, the names of their folders, and a number where these are the same too.
void name_all(std::vector<JoinedMember>& members) {
  const auto are_apart = [&] {
    std::set<std::string> titles;
    for (const JoinedMember& m : members) titles.insert(m.title);
    return titles.size() == members.size();
  };
  for (JoinedMember& m : members) m.title = display_name(m.session).toStdString();
  if (are_apart()) return;
  for (JoinedMember& m : members) m.title = folder_name(m.session).toStdString();
  if (are_apart()) return;
  for (std::size_t i = 0; i < members.size(); ++i) members[i].title += fmt::format(" ({})", i + 1);
}

/// The others and the open one, as if nothing had been changed between them.
std::vector<JoinedMember> list_members(const SeveralTask& task) {
  if (is_joined(*task.session)) {
    if (!task.others.empty())
      refuse(QObject::tr("The sessions of a collection are compared by themselves: add the other one to it first."));
    return members_of_open(*task.session);
  }
  std::vector<JoinedMember> members;
  const auto add = [&](Session session) {
    members.push_back({.session = searched(std::move(session)), .rig = "the same", .body = "the same"});
  };
  for (const std::filesystem::path& other : task.others) {
    std::error_code error;
    if (is_collection(other))
      refuse(QObject::tr("%1 is a collection: open it, and its sessions are compared with each other.")
                 .arg(QString::fromStdString(other.string())));
    if (std::filesystem::is_regular_file(other, error) && is_calibration_file(other))
      refuse(QObject::tr("%1 is a calibration, which is compared with one session alone.")
                 .arg(QString::fromStdString(other.string())));
    add(read_session(other));
    if (std::filesystem::equivalent(members.back().session.file, task.session->file, error)) members.pop_back();
  }
  add(*task.session);
  name_all(members);
  return members;
}

/// "joint_offset:arm_2", as the command line names them.
std::vector<std::string> list_names(const std::vector<EffectTerm>& terms, const Robot& robot) {
  std::vector<std::string> names;
  for (const EffectTerm& term : terms) {
    const Effect& effect = term_effect(term);
    if (effect.is_unnamed()) continue;
    const std::string place = place_name(effect, term.place, robot);
    names.push_back(place.empty() ? term.id : term.id + ":" + place);
  }
  return names;
}

}  // namespace

int ComparedSeveral::side(const std::string& title) const {
  const auto& all = comparison.sessions;
  const auto found = std::find(all.begin(), all.end(), title);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

ComparedSeveral compare_several(const SeveralTask& task, JobControl& control) {
  ComparedSeveral all;
  const std::vector<JoinedMember> members = list_members(task);
  ModelSettings shared;
  // A collection's model names joints of all its hands, and mounts of its own: each session begins without.
  if (!is_joined(*task.session)) shared = shared_settings(task.settings, all.notes);
  const auto progress = [&control](double share) {
    control.report(0.02 + 0.7 * share);
    return !control.is_cancelled();
  };
  all.comparison = compare(members, list_names(shared.estimated, task.session->robot), progress);
  for (const JoinedMember& m : members) {
    ComparedSide& side = all.sides.emplace_back(side_of(std::make_shared<Session>(m.session)));
    side.name = QString::fromStdString(m.title);
    look_into(side, shared, nullptr, control);
    control.report(0.72 + 0.28 * static_cast<double>(all.sides.size()) / static_cast<double>(members.size()));
  }
  return all;
}

}  // namespace handsight::app
