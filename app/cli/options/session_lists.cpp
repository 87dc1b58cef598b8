// SPDX-License-Identifier: Apache-2.0
#include "session_lists.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight::cli {
namespace {

/// Does this begin a target, and is no NAME=VALUE or number of one ("charuco", "<target", "board.yaml", "-")?
bool begins_target(const std::string& words) {
  const std::vector<std::string_view> parts = split_words(words);
  if (parts.empty()) return false;
  const std::string_view first = parts.front();
  if (first.starts_with('<') || first.starts_with("kind=") || first == "-") return true;
  for (const char* ending : {".xml", ".yaml", ".yml"})
    if (first.ends_with(ending)) return true;
  return first.find('=') == std::string_view::npos && !std::isdigit(static_cast<unsigned char>(first.front()));
}

/// One a target: --target was given for each, and the words of one may be typed without quotes.
std::vector<TargetOptions> single_targets(const TargetOptions& all) {
  std::vector<TargetOptions> single;
  for (const std::string& words : all.whole) {
    if (single.empty() || begins_target(words)) {
      single.push_back(all);
      single.back().whole.clear();
    }
    single.back().whole.push_back(words);
  }
  if (single.empty() && is_given(all)) single.push_back(all);
  return single;
}

std::size_t session_count(const std::vector<std::pair<const char*, std::size_t>>& given) {
  const auto most =
      std::max_element(given.begin(), given.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  for (const auto& [option, times] : given)
    if (times > 1 && times != most->second)
      throw InputError(
          message("{} is given {} times and {} {} times; give each once for all sessions, or once for each (- where "
                  "a session has none).",
                  option, times, most->first, most->second));
  return std::max<std::size_t>(1, most->second);
}

/// The i-th, or the only one; "" for none and for "-".
std::string of_session(const std::vector<std::string>& list, std::size_t i) {
  if (list.empty()) return "";
  const std::string& value = list[list.size() == 1 ? 0 : i];
  return value == "-" ? "" : value;
}

std::optional<double> of_session(const std::vector<double>& list, std::size_t i) {
  if (list.empty()) return std::nullopt;
  const double value = list[list.size() == 1 ? 0 : i];
  return value > 0 ? std::optional(value) : std::nullopt;
}

std::optional<Target> of_session(const std::vector<TargetOptions>& list, std::size_t i) {
  if (list.empty()) return std::nullopt;
  const TargetOptions& one = list[list.size() == 1 ? 0 : i];
  return one.whole == std::vector<std::string>{"-"} ? std::nullopt : std::optional(target_from(one));
}

}  // namespace

void add_session_lists(const CommandLine& command, SessionLists& lists) {
  command
      .option("--tcp", lists.tcps,
              "The link that is the hand; this and the options below may be given once for each session of a "
              "collection, - for none")
      .one_at_a_time();
  command.option("--mount", lists.mounts, "The link that carries the sensor; the root link where it stands")
      .one_at_a_time();
  command.option("--title", lists.titles, "Title of the session, or of the collection").one_at_a_time();
  command
      .option("--camera", lists.cameras,
              "Of a bag with several cameras: what stands in the topics of those to take (\"/head/\")")
      .one_at_a_time();
  command
      .option("--target-frame", lists.target_frames,
              "The target: its frame in /tf of a bag, its topic, its rigid body in motion capture, or its table")
      .one_at_a_time();
  command
      .option(
          "--sigma", lists.sigmas,
          "m: how exactly the tracker or the sensor of poses tells a place; of images how exactly the target is known")
      .one_at_a_time()
      .within(0, 1);
  command.option("--sigma-angle", lists.sigma_angles, "rad: how exactly a sensor of poses tells a turn")
      .one_at_a_time()
      .within(0, 3);
  add_target_options(command, lists.target, true);
}

std::vector<ConvertOptions> options_of_sessions(const SessionLists& l, const ConvertOptions& common) {
  const std::vector<TargetOptions> targets = single_targets(l.target);
  const std::size_t count = session_count({{"--tcp", l.tcps.size()},
                                           {"--mount", l.mounts.size()},
                                           {"--title", l.titles.size()},
                                           {"--camera", l.cameras.size()},
                                           {"--target-frame", l.target_frames.size()},
                                           {"--target", targets.size()},
                                           {"--sigma", l.sigmas.size()},
                                           {"--sigma-angle", l.sigma_angles.size()}});
  std::vector<ConvertOptions> sessions(count, common);
  for (std::size_t i = 0; i < count; ++i) {
    ConvertOptions& o = sessions[i];
    o.tcp = of_session(l.tcps, i);
    o.mount = of_session(l.mounts, i);
    o.title = l.titles.size() == 1 && count > 1 ? "" : of_session(l.titles, i);  // one is the collection's
    o.camera = of_session(l.cameras, i);
    o.target_frame = of_session(l.target_frames, i);
    o.target = of_session(targets, i);
    o.sigma = of_session(l.sigmas, i);
    o.sigma_angle = of_session(l.sigma_angles, i);
  }
  return sessions;
}

}  // namespace handsight::cli
