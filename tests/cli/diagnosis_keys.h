// SPDX-License-Identifier: Apache-2.0
// The keys of the JSON that `diagnose` writes, and what their values are.
#pragma once

#include <cmath>

#include "cli/hidden_sessions.h"

namespace handsight::test {

inline void expect_candidate_keys(const Json& c, bool tracker) {
  for (const char* key : {"id", "where", "ln_bayes_factor", "p_value", "explained", "parameters", "plausible",
                          "cannot_be_told_from", "explanation"})
    EXPECT_TRUE(c.contains(key)) << key;
  for (const std::string key : {"predicted_held_out_rms", "held_out_rms"}) {
    ASSERT_TRUE(c.contains(key + "_pixel") && c.contains(key + "_m"));
    if (tracker) {
      EXPECT_TRUE(c[key + "_pixel"].is_null()) << key;
    }
  }
  EXPECT_TRUE(c["where"].is_array() && c["parameters"].is_array() && c["cannot_be_told_from"].is_array());
  EXPECT_TRUE(c["plausible"].is_boolean());
  for (const Json& p : c["parameters"]) EXPECT_EQ(p.at("prior_sigma"), p.at("plausible_size")) << "its older name";
  if (c.contains("noncentrality_of_prior_sigma")) {
    EXPECT_EQ(c.at("noncentrality_of_prior_sigma"), c.at("noncentrality_of_plausible_size")) << "its older name";
  }
  EXPECT_TRUE(c["ln_bayes_factor"].is_number());
  if (c["explained"].is_number()) {
    EXPECT_GE(c["explained"].get<double>(), 0);
    EXPECT_LE(c["explained"].get<double>(), 1);
  }
  expect_sentence(c["explanation"]);
  for (const Json& p : c["parameters"])
    for (const char* key : {"of", "name", "value", "sigma", "unit"}) EXPECT_TRUE(p.contains(key)) << key;
}

/// The keys that every result of `diagnose` has, whatever its verdict.
inline void expect_keys(const Json& d, bool tracker) {
  for (const char* key : {"verdict", "reason", "candidates", "patterns", "invisible"})
    ASSERT_TRUE(d.contains(key)) << key;
  const Names verdicts = {"too_few_observations", "missing_effect", "ambiguous", "unexplained", "adequate"};
  EXPECT_EQ(verdicts.count(d["verdict"]), 1u);
  expect_sentence(d["reason"]);
  for (const std::string key : {"rms", "held_out_rms", "noise"})
    EXPECT_TRUE(d.contains(key + "_pixel") && d.contains(key + "_m")) << key;
  for (const auto& [name, older] :
       {std::pair{"error_attribution", "blame"}, {"place_repeatability_m", "place_scatter_m"}})
    EXPECT_EQ(d.at(name), d.at(older));
  double last = INFINITY;
  for (const Json& c : d["candidates"]) {
    expect_candidate_keys(c, tracker);
    EXPECT_LE(c["ln_bayes_factor"].get<double>(), last);
    last = c["ln_bayes_factor"];
  }
  for (const Json& p : d["patterns"]) {
    for (const char* key : {"residual", "against", "unit"}) EXPECT_TRUE(p[key].is_string()) << key;
    EXPECT_GE(p["strength"].get<double>(), 0);
    EXPECT_LE(p["strength"].get<double>(), 1);
    EXPECT_GE(p["p_value"].get<double>(), 0);
    EXPECT_LE(p["p_value"].get<double>(), 1);
    double before = -INFINITY;
    for (const Json& t : p["trend"]) {
      EXPECT_GT(t["x"].get<double>(), before);
      before = t["x"];
      EXPECT_LE(t["low"].get<double>(), t["y"].get<double>());
      EXPECT_GE(t["high"].get<double>(), t["y"].get<double>());
    }
  }
  for (const Json& id : d["invisible"]) EXPECT_TRUE(id.is_string());
}

}  // namespace handsight::test
