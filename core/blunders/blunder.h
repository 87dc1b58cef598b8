// SPDX-License-Identifier: Apache-2.0
// A mistake of a whole kind in a session: a joint that counts the other way, angles and images paired one off, a pose
// read the other way round. Not a small deviation, which is an effect.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"

namespace handsight {

struct Blunder {
  std::string id;         // "joint_sense"
  std::string where;      // "elbow", "a3=1.5708", "1"; empty where the kind has one place only
  Message text;           // one sentence: what is wrong
  Message fix;            // one sentence: what to change, and in which file
  bool is_by_fit = true;  // false: it shows in the files themselves; nothing is known of what is left
  bool in_pixels = true;
  double rms_before = 0;                     // px or m of one coordinate, of the session as it is
  double rms_after = 0;                      // ... once this one is put right, with those of `together_with`
  double error_before = 0, error_after = 0;  // the same as a fit's report says it (reported_error)
  double ln_bayes_factor = 0;
  std::vector<std::string> together_with = {};  // ID:WHERE of those that have to be put right beside it
  std::string session = {}, folder = {};        // of several sessions: the title of the one that has it, and its folder
};

/// "joint_sense:elbow"; the id alone where there is no place.
inline std::string display_name(const std::string& id, const std::string& where) {
  return where.empty() ? id : id + ":" + where;
}
inline std::string display_name(const Blunder& blunder) { return display_name(blunder.id, blunder.where); }

}  // namespace handsight
