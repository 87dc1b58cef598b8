// SPDX-License-Identifier: Apache-2.0
#include "convert/frames_by_motion.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "convert/convert_inputs.h"
#include "convert/convert_pairing.h"
#include "geometry/hand_eye_misfit.h"
#include "readers/robots/robot_file.h"

namespace handsight {
namespace {

constexpr double apart = 3;  // times the best: what a frame of another hand leaves at least

std::optional<FieldUrdf> robot_of(const Bag& bag, const ConvertOptions& o) {
  if (!o.robot.empty()) return robot_of_file(o.robot);
  const std::string text = find_robot_description(bag);
  return text.empty() ? std::nullopt : std::optional(field_urdf(text, "robot_description"));
}

/// How well this hand's motions and the frame's go together; nothing where too few were seen together.
std::optional<Misfit> misfit_of(const FieldUrdf& robot, const BagContents& bag, const ConvertOptions& o,
                                const std::string& frame) {
  const PoseSeries& seen = bag.frames.at(frame).series;
  std::vector<Message> unsaid;
  SessionParts parts;
  parts.tcp = o.tcp;
  parts.mount = o.mount.empty() ? robot.robot.links.front().name : o.mount;
  try {
    const Paired p = pair_events(bag.joints, seen.times, seen.poses.size(), {}, o, unsaid);
    parts.joints = {bag.joints.names, {}, p.positions};
    return hand_eye_misfit(hand_of(robot, parts).series.poses, chosen(seen.poses, p.events), false);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

struct Choice {
  std::string frame;
  Misfit misfit, next;
};

std::optional<Choice> choice_of(const FieldUrdf& robot, const BagContents& bag, const ConvertOptions& o,
                                const std::vector<std::string>& frames) {
  std::vector<std::pair<Misfit, std::string>> tried;
  for (const std::string& frame : frames)
    if (const auto misfit = misfit_of(robot, bag, o, frame)) tried.emplace_back(*misfit, frame);
  std::sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.first.size() < b.first.size(); });
  if (tried.size() < 2 || tried[0].first.size() > most_misfit || tried[1].first.size() < apart * tried[0].first.size())
    return std::nullopt;
  return Choice{tried[0].second, tried[0].first, tried[1].first};
}

}  // namespace

std::vector<ConvertOptions> frames_by_motion(const Bag& bag, std::vector<ConvertOptions> sessions,
                                             const std::vector<std::string>& frames, std::vector<Message>& notes) {
  const auto robot = robot_of(bag, sessions.front());
  if (!robot) return sessions;
  const BagContents contents = read_bag_contents(bag, robot->robot, [&] { ask_whether_to_go_on(sessions.front()); });
  std::vector<ConvertOptions> told = sessions;
  std::vector<Message> said;
  std::set<std::string> taken;
  for (ConvertOptions& o : told) {
    if (!o.target_frame.empty() && taken.insert(o.target_frame).second) continue;  // its name has told it
    if (find_link(robot->robot, o.tcp) < 0 || contents.joints.positions.empty()) return sessions;
    const auto choice = choice_of(*robot, contents, o, frames);
    if (!choice || !taken.insert(choice->frame).second) return sessions;
    o.target_frame = choice->frame;
    said.push_back(message("{} moves with {} (to {}; the next best frame to {})", choice->frame, o.tcp,
                           misfit_text(choice->misfit), misfit_text(choice->next)));
  }
  notes.push_back(message("{}: so the hands' targets are told apart (--target-frame says otherwise).",
                          at_most(joined(said, "; "), 500)));
  return told;
}

}  // namespace handsight
