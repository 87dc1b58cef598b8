// SPDX-License-Identifier: Apache-2.0
// The contract that every effect of the catalogue keeps; a new effect is covered the moment it is listed.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "effects/target_effects.h"
#include "effects/units.h"
#include "fixtures/arms.h"
#include "robot/urdf.h"

namespace handsight {
namespace {

/// The coupled torso before a camera on the floor: mimic joints, springs that carry loads, markers.
Chain chain() {
  Session session = fixture::stand_session();
  session.robot = fixture::coupled_torso();
  for (Joint& joint : session.robot.joints) joint.stiffness = 5000;
  session.tcp = "hand";
  session.mount.link = "base";
  session.joints = {"t1", "t2", "arm_1", "arm_2"};
  return make_chain(session);
}

ObservationState moving(const Chain& c) {
  Eigen::VectorXd position(4);
  position << 0.3, 0.8, -0.7, 0.4;
  ObservationState here = states_at(c, position);
  here.velocity = Eigen::VectorXd::LinSpaced(here.sensor.size(), 0.1, 0.3);
  here.approach.setOnes();
  return here;
}

/// Everything that a camera could see of what an effect does: motions of hand, mount, rig, body, markers, numbers.
Eigen::VectorXd seen_change(const ObservationState& c, const Sites& sites) {
  const ObservedEnds nominal = observed_ends(c, Sites{}), moved = observed_ends(c, sites);
  const Rig rig = *c.chain->rig, moved_one = moved_rig(rig, sites);
  Eigen::VectorXd all(6 + 6 + 6 + 6 + 16 + 9);
  all << small_motion_between(nominal.ends.root_from_tcp, moved.ends.root_from_tcp),
      small_motion_between(Rigid{}, moved.mount_motion),
      small_motion_between(rig.at(1).camera_from_first, moved_one.at(1).camera_from_first), sites.body,
      sites.cameras[0].numbers, sites.cameras[1].numbers, sites.markers.empty() ? Vector3::Zero() : sites.markers[0],
      sites.markers.empty() ? Vector3::Zero() : sites.markers[1],
      sites.markers.empty() ? Vector3::Zero() : sites.markers[2];
  return all;
}

TEST(Catalogue, EveryEffectDescribesItself) {
  std::set<std::string> ids;
  for (const Effect& e : catalogue()) {
    EXPECT_TRUE(ids.insert(e.id).second) << e.id << " is listed twice";
    for (const std::string& text : {e.title, e.cause, e.visibility, e.check, e.source})
      EXPECT_GT(text.size(), 5u) << e.id;
    EXPECT_FALSE(e.parameters.empty()) << e.id;
    for (const EffectParameter& p : e.parameters) {
      EXPECT_FALSE(p.name.empty());
      EXPECT_GT(p.sigma, 0) << e.id << " " << p.name;
    }
    EXPECT_EQ(find_effect(e.id), &e);
  }
  EXPECT_EQ(find_effect("no_such_effect"), nullptr);
}

TEST(Catalogue, NominalMovesNothing) {
  const Chain c = chain();
  const ObservationState here = moving(c);
  for (const Effect& e : catalogue())
    for (const int place : effect_places(e, c))
      EXPECT_LT(
          seen_change(here, moved_sites(here, {{e.id, place, std::vector<double>(e.parameters.size(), 0.0)}})).norm(),
          1e-14)
          << e.id;
}

TEST(Catalogue, EveryParameterMovesSomethingAndStaysFinite) {
  const Chain c = chain();
  const ObservationState here = moving(c);
  for (const Effect& e : catalogue()) {
    if (e.scope == EffectScope::camera) continue;  // of rigs of three cameras and more: rig_effects_test.cpp
    if (has_no_target(e)) continue;                // of targets: target_effects_test.cpp
    ASSERT_FALSE(effect_places(e, c).empty()) << e.id;
    for (std::size_t p = 0; p < e.parameters.size(); ++p) {
      if (e.parameters[p].is_choice) continue;
      double largest = 0;
      for (const int place : effect_places(e, c)) {
        std::vector<double> values = term_of(e, place).values;
        values[p] = e.parameters[p].sigma;
        const Eigen::VectorXd change = seen_change(here, moved_sites(here, {{e.id, place, values}}));
        ASSERT_TRUE(change.allFinite()) << e.id;
        largest = std::max(largest, change.norm());
      }
      EXPECT_GT(largest, 1e-6) << e.id << " " << e.parameters[p].name;
    }
  }
}

TEST(Catalogue, EffectsAddAndAreLinearInTheirSites) {
  const Chain c = chain();
  const ObservationState here = moving(c);
  for (const Effect& e : catalogue()) {
    if (effect_places(e, c).empty()) continue;  // of rigs of three cameras and more
    std::vector<double> once = term_of(e, 0).values, twice = once;
    for (std::size_t p = 0; p < once.size(); ++p) {
      if (e.parameters[p].is_choice) continue;
      once[p] = e.parameters[p].sigma;
      twice[p] = 2 * e.parameters[p].sigma;
    }
    const int place = effect_places(e, c).back();
    const Sites sum = moved_sites(here, {{e.id, place, once}, {e.id, place, once}}),
                doubled = moved_sites(here, {{e.id, place, twice}});
    EXPECT_LT((seen_change(here, sum) - seen_change(here, doubled)).norm(), 1e-12) << e.id;
  }
}

TEST(Catalogue, EffectsOfJointScopeMoveTheirOwnJointAlone) {
  const Chain c = chain();
  const ObservationState here = moving(c);
  for (const Effect& e : catalogue()) {
    if (!moves_one_joint(e)) continue;
    for (const int place : effect_places(e, c)) {
      EffectTerm term = term_of(e, place);
      for (std::size_t p = 0; p < term.values.size(); ++p)
        if (!e.parameters[p].is_choice) term.values[p] = 0.01;
      Sites sites = moved_sites(here, {term});
      sites.robot.joints[static_cast<std::size_t>(place)] = JointChange{};
      EXPECT_LT(seen_change(here, sites).norm(), 1e-15) << e.id;
    }
  }
}

TEST(Catalogue, SlipsBeginAtTheirObservation) {
  const Chain c = chain();
  ObservationState here = moving(c);
  const EffectTerm body{"body_slip", -1, {1e-3, 0, 0, 0, 0, 0, 40}}, marker{"marker_slip", 1, {0, 1e-3, 0, 40}};
  for (const int order : {39, 40, 41}) {
    here.order = order;
    const Sites sites = moved_sites(here, {body, marker});
    EXPECT_EQ(sites.body[0], order >= 40 ? 1e-3 : 0.0);
    EXPECT_EQ(sites.markers[1].y(), order >= 40 ? 1e-3 : 0.0);
  }
}

TEST(Catalogue, ApproachIsTheSignOfTheLastMotion) {
  Session session = fixture::stand_session();
  session.observations.clear();
  for (int k = 0; k < 3; ++k) {
    Observation o;
    o.id = k;
    o.time = k;
    o.position = Eigen::VectorXd::Constant(6, k == 1 ? 0.5 : 0.1);
    if (k == 2) o.velocity = (Eigen::VectorXd(6) << 0.2, 0, 0, 0, 0, 0).finished();
    session.observations.push_back(o);
  }
  const Chain c = make_chain(session);
  const auto all = observation_states(session, c);
  EXPECT_EQ(all[0].approach[0], 0);
  EXPECT_EQ(all[1].approach[0], 1);
  EXPECT_EQ(all[2].approach[0], 1);   // its velocity says so
  EXPECT_EQ(all[2].approach[1], -1);  // at rest: against the observation before
  EXPECT_EQ(all[2].elapsed, 2);
}

TEST(Catalogue, JointsThatTheMeasurementCannotDependOnAreNoPlaces) {
  // base - turn - arm (TCP); base - wheel; arm - gripper; turn - counterweight; base - driver, which turn follows.
  const auto robot = [](const std::string& of_turn) {
    const auto joint = [](const char* name, const char* parent, const char* child, const std::string& inside = "") {
      return fmt::format(
          "<link name=\"{2}\"><inertial><mass value=\"1\"/></inertial></link><joint name=\"{0}\" "
          "type=\"continuous\"><parent link=\"{1}\"/><child link=\"{2}\"/>{3}</joint>",
          name, parent, child, inside);
    };
    return parse_urdf("<robot name=\"r\"><link name=\"base\"/>" + joint("turn", "base", "column", of_turn) +
                          joint("bend", "column", "arm") + joint("wheel", "base", "tyre") +
                          joint("grip", "arm", "finger") + joint("swing", "column", "weight") +
                          joint("drive", "base", "motor") + "</robot>",
                      "r.urdf", nullptr);
  };
  const auto places = [&](const std::string& of_turn) {
    Chain chain;
    chain.robot = robot(of_turn);
    chain.tcp_link = find_link(chain.robot, "arm");
    std::set<std::string> names;
    for (const int j : effect_places(*find_effect("joint_offset"), chain))
      names.insert(chain.robot.joints[static_cast<std::size_t>(j)].name);
    return names;
  };
  EXPECT_EQ(places(""), (std::set<std::string>{"turn", "bend"}));
  EXPECT_EQ(places("<stiffness value=\"100\"/>"), (std::set<std::string>{"turn", "bend", "grip", "swing"}));
  EXPECT_EQ(places("<mimic joint=\"drive\"/>"), (std::set<std::string>{"turn", "bend", "drive"}));
}

TEST(Catalogue, NumbersOfSlidingJointsAreInMetres) {
  Robot robot = fixture::six_axis_arm();
  const int slides = find_joint(robot, "a2"), turns = find_joint(robot, "a3");
  robot.joints[static_cast<std::size_t>(slides)].kind = JointKind::prismatic;
  const auto unit = [&](const char* id, const char* number, int place) {
    const Effect& effect = *find_effect(id);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (effect.parameters[p].name == number) return unit_at(effect, p, place, robot);
    return std::string("no such number");
  };
  EXPECT_EQ(unit("joint_offset", "offset", turns), "rad");
  EXPECT_EQ(unit("joint_offset", "offset", slides), "m");
  EXPECT_EQ(unit("joint_elasticity", "compliance", turns), "rad/(N m)");
  EXPECT_EQ(unit("joint_elasticity", "compliance", slides), "m/N");
  EXPECT_EQ(unit("backlash", "gap", slides), "m");
  EXPECT_EQ(unit("friction_hysteresis", "gap", slides), "m");
  // What turns or bends beside the joint stays what it is.
  EXPECT_EQ(unit("link_geometry", "ru", slides), "rad");
  EXPECT_EQ(unit("link_elasticity", "compliance", slides), "rad/(N m)");
}

TEST(EffectText, IsReadWithItsPlaceAndValue) {
  const Robot robot = fixture::six_axis_arm();
  std::vector<EffectTerm> terms;
  add_effect_value("joint_elasticity:a2.compliance=1e-4", robot, terms);
  add_effect_value("joint_elasticity:a3.compliance=2.5e-5", robot, terms);
  ASSERT_EQ(terms.size(), 2u);
  EXPECT_EQ(terms[0].place, 1);
  EXPECT_EQ(terms[1].values, std::vector<double>{2.5e-5});
}

TEST(EffectText, IsRefusedWithWhatWouldBeRight) {
  const Robot robot = fixture::six_axis_arm();
  std::vector<EffectTerm> terms;
  const auto refusal = [&](const std::string& text) -> std::string {
    try {
      add_effect_value(text, robot, terms);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(refusal("joint_elasticty:a2.compliance=1").find("which has: joint_offset, "), std::string::npos);
  EXPECT_NE(refusal("joint_elasticity:a9.compliance=1").find("no moving joint \"a9\"; it has: a1, a2, a3"),
            std::string::npos);
  EXPECT_NE(refusal("joint_elasticity:a2.softness=1").find("no parameter \"softness\""), std::string::npos);
  EXPECT_NE(refusal("joint_elasticity:a2.compliance=soft").find("not a finite number"), std::string::npos);
  EXPECT_NE(refusal("joint_elasticity:a2.compliance=nan").find("not a finite number"), std::string::npos);
  EXPECT_NE(refusal("joint_elasticity").find("id:joint.parameter=value"), std::string::npos);
  EXPECT_TRUE(terms.empty());
}

}  // namespace
}  // namespace handsight
