// SPDX-License-Identifier: Apache-2.0
// A user in Explain with a copy of a sample session.
#pragma once

#include "app/window/pages.h"
#include "base/files.h"
#include "cli/cli_runner.h"
#include "document/effect_words.h"
#include "document/journal.h"
#include "temporary_folder.h"

namespace handsight::test {

class Explain : public testing::Test {
 protected:
  std::filesystem::path make_copy(const std::string& name) { return copy_of_sample(folder.path, name); }
  void open(const std::string& name) {
    desk.window.resize(1440, 900);
    session = make_copy(name);
    ASSERT_TRUE(desk.window.open(QString::fromStdString(session.string())));
    ASSERT_TRUE(desk.settle());
    ASSERT_TRUE(explain.open()) << name;
  }
  /// A session of the six-axis robot with `extra` in it becomes the fixture's; not yet opened.
  bool simulate(std::vector<std::string> extra) {
    session = folder.path / "simulated";
    const std::string like = std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/rigs/six_axis_stand";
    std::vector<std::string> arguments{"simulate", "--like", like, "--out", session.string()};
    if (std::find(extra.begin(), extra.end(), "--seed") == extra.end()) extra.insert(extra.end(), {"--seed", "1"});
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    return run_cli(folder.path, arguments).exit_code == 0;
  }
  double held_out() { return *desk.document().model()->report->held_out.rms_pixel; }
  /// Ids with their places, as `improve` prints them.
  std::set<std::string> effects_in_the_model() {
    std::set<std::string> list;
    for (const FittedEffect& f : desk.document().model()->fit->effects)
      list.insert(f.term.id + " " + place_name(term_effect(f.term), f.term.place, desk.document().session().robot));
    return list;
  }
  static std::set<std::string> list_effects(const nlohmann::json& fit) {
    std::set<std::string> list;
    for (const auto& effect : fit["effects"])
      for (const auto& p : effect["parameters"])
        list.insert(effect["id"].get<std::string>() + " " + (p["of"].is_string() ? p["of"].get<std::string>() : ""));
    return list;
  }
  std::string session_digest() { return app::compute_digest(read_file(session / "session.xml")); }
  TemporaryFolder folder;
  std::filesystem::path session;
  Desk desk;
  ExplainPage explain{desk};
};

}  // namespace handsight::test
