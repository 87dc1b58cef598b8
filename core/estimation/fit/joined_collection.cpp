// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/joined_collection.h"

#include "estimation/fit/member_noise.h"

namespace handsight {

std::vector<JoinedMember> opened_members(const Collection& collection, const OpenOne& open) {
  std::vector<JoinedMember> members;
  for (const CollectionEntry& entry : collection.entries) {
    JoinedMember& m = members.emplace_back();
    m.session = open(find_folder(collection, entry).string());
    m.title = entry.title;
    m.rig = entry.rig;
    m.body = entry.body;
    m.own = entry.own;
  }
  return members;
}

std::vector<JoinedMember> list_members(const Collection& collection, const OpenOne& open) {
  std::vector<JoinedMember> members = opened_members(collection, open);
  learn_noise(members);
  return members;
}

Session join_collection(const Collection& collection, const OpenOne& open) {
  return joined(list_members(collection, open), collection.title, collection.file);
}

}  // namespace handsight
