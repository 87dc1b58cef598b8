// SPDX-License-Identifier: Apache-2.0
// A table of poses is read to whole finite poses, or refused with a sentence.
#include "fuzz.h"
#include "readers/csv.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handsight;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    std::vector<Message> notes;
    const PoseTable table = parse_pose_table(text, "poses.csv", {"j1", "j2"}, &notes);
    demand(!table.positions.empty(), "there is a pose");
    demand(table.velocities.empty() || table.velocities.size() == table.positions.size(), "velocities are whole");
    demand(table.times.empty() || table.times.size() == table.positions.size(), "times are whole");
    for (const auto& position : table.positions)
      demand(position.size() == 2 && position.allFinite(), "poses are whole and finite");
    demand(parse_poses(text, "poses.csv", {"j1", "j2"}).size() == table.positions.size(), "both readers see the same");
  } catch (const InputError& error) {
    demand_sentence(error);
  }
  return 0;
}
