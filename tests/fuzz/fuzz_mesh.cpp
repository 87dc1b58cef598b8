// SPDX-License-Identifier: Apache-2.0
// A mesh is read to triangles of points that are there, or refused with a sentence. The first byte says as what it is
// read.
#include "fuzz.h"
#include "robot/collada_text.h"
#include "robot/mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const handsight::Mesh mesh = data[0] % 3 == 0   ? handsight::parse_obj(text, "link.obj")
                                 : data[0] % 3 == 1 ? handsight::parse_stl(text, "link.stl")
                                                    : handsight::parse_collada(text, "link.dae");
    for (const auto& point : mesh.points) handsight::demand(point.allFinite(), "points are finite");
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle)
        handsight::demand(corner < mesh.points.size(), "triangles have the corners of points that are there");
  } catch (const handsight::InputError& error) {
    handsight::demand_sentence(error);
  }
  return 0;
}
