// SPDX-License-Identifier: Apache-2.0
// The sample sessions hidden_1 ... hidden_8, what their truth.xml says, and how results are compared with it.
#pragma once

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <map>
#include <set>
#include <tuple>

#include "base/numbers.h"
#include "cli/cli_runner.h"

namespace handsight::test {

using Json = nlohmann::json;
using Names = std::set<std::string>;

inline std::filesystem::path sample_session(const std::string& name) {
  return std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name;
}

/// What was hidden.
struct HiddenTruth {
  double noise = 0;                                                            // px
  std::map<std::string, Names> effects;                                        // id -> the joints or markers it sits at
  std::map<std::tuple<std::string, std::string, std::string>, double> values;  // id, of (or empty), parameter name
  std::string curve_at;                                                        // the joint of what no effect describes
  std::map<std::tuple<int, int, std::string>, double> wrong_corners;           // observation, marker, camera -> px off
  std::vector<double> tcp_from_body;                                           // 16 numbers, row by row
  Names ids() const {
    Names names;
    for (const auto& [id, where] : effects) names.insert(id);
    return names;
  }
};

inline HiddenTruth hidden_truth(const std::filesystem::path& session) {
  tinyxml2::XMLDocument document;
  document.LoadFile((session / "truth.xml").c_str());
  const tinyxml2::XMLElement* root = document.RootElement();
  HiddenTruth truth;
  truth.noise = root->DoubleAttribute("noise_pixel");
  truth.tcp_from_body =
      *parse_numbers(root->FirstChildElement("tcp_from_body")->FirstChildElement("matrix")->GetText());
  for (auto* e = root->FirstChildElement("effects")->FirstChildElement(); e; e = e->NextSiblingElement()) {
    Names& where = truth.effects[e->Attribute("id")];
    for (auto* p = e->FirstChildElement(); p; p = p->NextSiblingElement()) {
      const std::string of = p->Attribute("of") ? p->Attribute("of") : "";
      if (!of.empty()) where.insert(of);
      truth.values[{e->Attribute("id"), of, p->Attribute("name")}] = p->DoubleAttribute("value");
    }
  }
  if (auto* curve = root->FirstChildElement("curve")) truth.curve_at = curve->Attribute("of");
  for (auto* w = root->FirstChildElement("wrong_corner"); w; w = w->NextSiblingElement("wrong_corner")) {
    const auto off = *parse_numbers(w->Attribute("off"));
    truth.wrong_corners[{w->IntAttribute("observation"), w->IntAttribute("marker"), w->Attribute("seen_by")}] =
        std::hypot(off[0], off[1]);
  }
  return truth;
}

/// `where` of a candidate or a step against the truth: the same joints, no fewer and no more; of a slip its instant.
inline void expect_where(const Json& where, const HiddenTruth& truth, const std::string& id) {
  const auto slip = truth.values.find({id, "", "k"});
  if (slip != truth.values.end()) {
    const std::string instant = "observation " + std::to_string(static_cast<int>(slip->second));
    EXPECT_NE(where.dump().find(instant), std::string::npos) << where.dump();
    return;
  }
  EXPECT_EQ(where.get<Names>(), truth.effects.at(id)) << id << " at " << where.dump();
}

/// Every estimated number of the effect is within 4.5 sigma of what was hidden (0 where nothing was hidden), and every
/// number that was hidden is among them.
inline void expect_values(const Json& parameters, const HiddenTruth& truth, const std::string& id) {
  std::size_t found = 0, hidden = 0;
  for (const auto& [key, value] : truth.values) hidden += std::get<0>(key) == id && value != 0 ? 1 : 0;
  for (const Json& p : parameters) {
    const std::string of = p["of"].is_null() ? "" : p["of"].get<std::string>(), name = p["name"];
    const auto known = truth.values.find({id, of, name});
    const double value = known == truth.values.end() ? 0 : known->second;
    found += value != 0 ? 1 : 0;
    if (p["sigma"] == 0) {  // a choice among alternatives: the right one
      EXPECT_EQ(p["value"], value) << id << " " << of << "." << name;
      continue;
    }
    EXPECT_LT(std::abs(p["value"].get<double>() - value), 4.5 * p["sigma"].get<double>())
        << id << " " << of << "." << name << ": " << p["value"] << " +- " << p["sigma"] << ", hidden " << value;
  }
  EXPECT_EQ(found, hidden) << id;
}

/// A sentence for people.
inline void expect_sentence(const Json& text) {
  ASSERT_TRUE(text.is_string());
  EXPECT_GE(text.get<std::string>().size(), 20u);
  EXPECT_EQ(text.get<std::string>().find("nan"), std::string::npos) << text;
}

/// An error of `key`_pixel and `key`_m as a session of its kind must have them: a stereo session has both (of noise
/// only px), a tracker session only m.
inline void expect_error_twins(const Json& result, const std::string& key, bool tracker) {
  ASSERT_TRUE(result.contains(key + "_pixel")) << key;
  ASSERT_TRUE(result.contains(key + "_m")) << key;
  if (tracker) {
    EXPECT_TRUE(result[key + "_pixel"].is_null()) << key;
    EXPECT_TRUE(result[key + "_m"].is_number()) << key;
  } else {
    EXPECT_TRUE(result[key + "_pixel"].is_number()) << key;
  }
}

/// A folder of the test's own, and sessions made in it.
inline CliResult simulate(const std::filesystem::path& folder, const std::string& name, const std::string& rig,
                          std::vector<std::string> more) {
  std::vector<std::string> arguments = {"simulate", "--like", sample_session("rigs/" + rig).string(), "--out",
                                        (folder / name).string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_cli(folder, arguments);
}

/// The six-axis arm before a tracker on the floor, to simulate like; its folder.
inline std::filesystem::path tracker_rig(const std::filesystem::path& folder) {
  const auto rig = folder / "tracker_rig";
  write_text(rig / "session.xml",
             "<?xml version=\"1.0\"?>\n<handsight_session version=\"1\" title=\"Tracker\">\n"
             "  <robot file=\"six_axis.urdf\" tcp=\"hand\"/>\n"
             "  <tracker mount=\"stand\" sigma=\"0.0002\"><mount_from_tracker xyz=\"2 1 0.4\" rpy=\"0.1 -0.2 2\" "
             "estimate=\"yes\"/></tracker>\n"
             "  <markers count=\"3\"/>\n  <joints>axis_1 axis_2 axis_3 axis_4 axis_5 axis_6</joints>\n"
             "  <observations><observation id=\"0\" time=\"0\"><position>0 0.3 0.2 0 0.4 0</position></observation>"
             "</observations>\n</handsight_session>\n");
  std::filesystem::copy_file(sample_session("robots/six_axis.urdf"), rig / "six_axis.urdf");
  return rig;
}

}  // namespace handsight::test
