// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "command.h"
#include "detection/target_finding.h"
#include "printing/first_look.h"
#include "printing/reported_json.h"
#include "session/collection.h"

namespace handsight::cli {
namespace {

struct CheckArguments {
  std::string session;
  Output output;
  Json* result = nullptr;  // of one session of a collection: where its answer goes
};

/// A target that no image shows is no session that works.
void add_lost_target(const Session& session, const TargetSearch& search, SessionCheck& check) {
  if (search.looked_at == 0 || search.found > 0) return;
  const bool is_seen_elsewhere = std::any_of(session.observations.begin(), session.observations.end(),
                                             [](const Observation& o) { return !o.sightings.empty(); });
  Message text = message("The {} is found in none of the {} observations whose images were looked at.",
                         describe_target(*session.target), search.looked_at);
  if (!search.in_its_place.empty())
    text = message("{} Put that into <target> of {}, or convert again with it.", search.in_its_place,
                   session.file.filename().string());
  (is_seen_elsewhere ? check.warnings : check.problems).push_back(text);
}

std::string verdict(const SessionCheck& check, const FirstLook& look) {
  if (!check.problems.empty())
    return fmt::format("{} problem{}: these would not work.", check.problems.size(),
                       check.problems.size() == 1 ? "" : "s");
  if (!look.blunders.empty()) return "Everything in the session can be read; it does not go together:";
  return check.warnings.empty() ? "Everything in the session works."
                                : "Everything in the session can be used; look at what is odd.";
}

int run(const CheckArguments& o);

/// Each session of a collection by itself, and whether they can be one.
int run_of_collection(const CheckArguments& o) {
  const Collection collection = read_collection(o.session);
  Json all = Json::array();
  int worst = done;
  for (const CollectionEntry& entry : collection.entries) {
    o.output.line(entry.title + ":");
    CheckArguments one = o;
    one.session = find_folder(collection, entry).string();
    one.output.json_file.clear();
    Json json;
    one.result = &json;
    worst = std::max(worst, run(one));
    json["title"] = entry.title;
    all.push_back(std::move(json));
  }
  const Session together = open_session(o.session);
  o.output.line(fmt::format("Together: {} observations of {} sessions, {} mount{} and {} marker{}.",
                            together.observations.size(), collection.entries.size(), 1 + together.other_mounts.size(),
                            together.other_mounts.empty() ? "" : "s", together.marker_count,
                            together.marker_count == 1 ? "" : "s"));
  o.output.json({{"sessions", all}});
  return worst;
}

int run(const CheckArguments& o) {
  if (is_collection(o.session)) return run_of_collection(o);
  TargetSearch search;
  const Session session = open_searched_session(o.session, o.output, search);
  SessionCheck check = check_session(session);
  add_lost_target(session, search, check);
  for (const Message& line : check.contents) o.output.line(line);
  const FirstLook look = first_look(session, check);
  for (const Message& line : check.warnings) o.output.line("warning: " + line);
  for (const Message& line : check.problems) o.output.line("PROBLEM: " + line);
  o.output.line(verdict(check, look));
  print_blunders(o.output, o.session, look.blunders);
  const Json json = first_look_json(session, check, look);
  o.output.json(json);
  if (o.result) *o.result = json;
  for (const Message& line : check.problems) Output::note(line);
  return check.problems.empty() ? done : wrong_input;
}

}  // namespace

Command add_check(const CommandLine& program) {
  auto options = std::make_shared<CheckArguments>();
  const CommandLine command =
      program.command("check", "Reads everything, images too, and says what is there and what would not work");
  add_session_option(command, options->session);
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
