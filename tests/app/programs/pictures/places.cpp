// SPDX-License-Identifier: Apache-2.0
// Pictures of what follows a place: the distance from the sensor, or the place in the image.
#include <gtest/gtest.h>

#include "app/programs/pictures/photographer.h"
#include "diagnosis/curves/place_formulas.h"
#include "effects/own_effect.h"
#include "session/session_xml.h"
#include "simulation/simulated_session.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

/// A sample's robot whose hand is off by a bow over that place: 1.2 mm at its ends.
std::filesystem::path bent_session(const std::filesystem::path& folder, bool is_distance) {
  const auto copy = copy_of_sample(folder, "hidden_2");
  const Session like = read_session(copy);
  const Problem problem = make_problem(like, make_chain(like), {}, {});
  const Rigid& mount = like.mount.mount_from_sensor;
  const PlaceFormula place = is_distance ? distance_formula(problem, tcp_places(problem), mount)
                                         : image_formula(problem, tcp_places(problem), mount, 0);
  const double reach = (place.values.maxCoeff() - place.values.minCoeff()) / 2;
  EffectDefinition d;
  d.id = "hidden_bow";
  d.scope = "session";
  d.parameters = {{"size", "m", 1e-3}};
  d.moves = {{"hand_x", fmt::format("size*(({} - {:.3f})/{:.3f})^2", place.text, place.values.mean(), reach), 0}};
  const auto effect = own_effect(d, like.robot);
  SimulationOptions o;
  o.effects = {term_of(*effect, -1, effect)};
  o.effects.front().values[0] = 1.2e-3;
  o.observations = 80;
  o.seed = 41;
  o.title = is_distance ? "A bow over the distance" : "A bow over the image";
  Session s = simulate_session(like, o).session;
  s.file = copy / "session.xml";
  s.robot_file = like.robot_file;
  s.source.reset();
  replace_session(s);
  return copy;
}

class Places : public testing::TestWithParam<const char*> {};

TEST_P(Places, ACurveFromItsCardToTheExport) {
  const TemporaryFolder folder;
  const std::string name = GetParam();
  Desk desk;
  desk.window.resize(window_size());
  Photographer photo{desk};
  ExplainPage explain{desk};
  ASSERT_TRUE(desk.window.open(QString::fromStdString(bent_session(folder.path, name == "distance").string())));
  ASSERT_TRUE(desk.settle());
  ASSERT_TRUE(explain.open());
  photo.take_now("place_" + name);
  explain.look_at(0);
  photo.take_now("place_" + name + "_proof");
  ASSERT_TRUE(explain.can_add_first());
  explain.press_add();
  ASSERT_TRUE(explain.is_settled());
  photo.take_now("place_" + name + "_added");
  desk.key(Qt::Key_5, Qt::ControlModifier);
  photo.take(("place_" + name + "_export").c_str());
}

INSTANTIATE_TEST_SUITE_P(Pictures, Places, testing::Values("distance", "image"),
                         [](const auto& place) { return std::string(place.param); });

}  // namespace
}  // namespace handsight::test
