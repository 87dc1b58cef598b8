// SPDX-License-Identifier: Apache-2.0
// A kind of fixture that is none of the program's: a round post. A touch reads how far the tip is from its axis.
#include "session/fixtures/fixture_frame.h"
#include "session/fixtures/list.h"

namespace handsight {
namespace fixtures {
extern const FixtureKind post;
}
namespace {

std::optional<Rigid> read_post(const XmlNode& node) {
  const auto xyz = find_place(node, "xyz");
  const auto axis = find_direction(node, "axis");
  if (!xyz || !axis) return std::nullopt;
  return Rigid{with_z_along(*axis), *xyz};
}

void write_post(tinyxml2::XMLElement& element, const Rigid& frame) {
  set_vector(element, "xyz", frame.translation);
  set_vector(element, "axis", frame.rotation.col(2));
}

double radius_of(const Vector3& tip) { return tip.head<2>().norm(); }

Vector3 outwards(const Vector3& tip) {
  const double radius = radius_of(tip);
  return radius > 0 ? Vector3(tip.x() / radius, tip.y() / radius, 0) : Vector3(Vector3::UnitX());
}

constexpr Reading radius{"radius", radius_of, outwards};

constexpr const char* attributes[] = {"xyz", "axis"};
constexpr const char* called[] = {"post"};
constexpr TouchNumber numbers[] = {{.reading = &radius}};
constexpr SketchStroke sketch[] = {{.kind = SketchStroke::Kind::rectangle, .x = 16, .y = 14, .to_x = 8, .to_y = 12},
                                   {.kind = SketchStroke::Kind::probe, .x = 26, .y = 20}};

}  // namespace

constinit const FixtureKind fixtures::post{
    .tag = "post",
    .place = FixturePlace::axis,
    .attributes = attributes,
    .direction = "axis",
    .read_frame = read_post,
    .write_frame = write_post,
    .example = "xyz=0.5,0,0.3 axis=0,0,1",
    .numbers = numbers,
    .value = TouchValue::whole,
    .tells_length = true,
    .simulated = {.first = 0.05},
    .called = called,
    .perhaps = called,
    .name = [] { return Message("post"); },
    .title = [] { return Message("Post"); },
    .what = [] { return Message("The tip touches it all round."); },
    .touched = [](const std::string& fixture, const std::string& value_mm,
                  bool /*is_zero*/) { return message("Post {}: {} mm from its axis.", fixture, value_mm); },
    .shape = FixtureShape::rod,
    .picture = "touch_edge",
    .sketch = sketch,
    .how_to = "A round post. Touch it all round, high and low. Write down its radius and the ball's.",
};

}  // namespace handsight
