// SPDX-License-Identifier: Apache-2.0
// Robots with everything that may be wrong with them, and exported programs run as a user would.
#pragma once

#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include "effects/own_effect.h"
#include "fixtures/arms.h"
#include "fixtures/random_robot.h"
#include "temporary_folder.h"
#include "ways/calibrated_robot.h"

namespace handsight::fixture {

/// Effects of a user's own: every scope, site and function that formulas have.
inline std::vector<EffectDefinition> own_definitions(const Robot& robot) {
  std::vector<std::string> moving;
  for (const Joint& j : robot.joints)
    if (j.moves()) moving.push_back(formula_name(j.name));
  const std::string first = moving.front(), last = moving.back();
  EffectDefinition wave;
  wave.id = "belt_wave";
  wave.parameters = {{"sine", "rad", 1e-3}, {"cosine", "rad", 1e-3}, {"pull", "rad", 1e-3}};
  wave.moves = {{"angle", "sine*sin(7*q) + cosine*cos(7*q) - -pull*tanh(tau/5)^3", 1},
                {"before_y", "pull*(q > 0.2 && velocity <= 0 || approach == 1 ? 2 : -1/2)", 2},
                {"after_rz", "pull*exp(-q^2)/4", 3},
                {"compliance", "1e-2*pull*abs(q)", 4},
                {"bend_compliance", "1e-2*cosine*max(q, 0.1)", 5}};
  EffectDefinition shift;
  shift.id = "curve_1";
  shift.scope = "session";
  shift.unnamed = true;
  shift.parameters = {{"a", "m", 1e-3}, {"b", "m", 1e-3}};
  shift.moves = {{"hand_x", "a*sin(3.3*q_" + last + "+0.7)", 1},
                 {"hand_rz", "b*sign(q_" + first + ")*sqrt(1+time)*log(2+seconds)", 2},
                 {"gravity_rx", "3*a*min(order,2)", 3},
                 {"body_z", "a*tan(0.3*tau_" + first + "/100)*pi", 4},
                 {"mount_x", "a*time", 5}};
  EffectDefinition place;
  place.id = "curve_2";
  place.scope = "session";
  place.unnamed = true;
  place.parameters = {{"slope", "m", 1e-3}, {"bow", "m", 1e-3}};
  place.moves = {
      {"hand_y", "slope*(0.3 + tcp_x - 0.5*tcp_z)/max(0.1, 1 + tcp_y) + bow*sqrt(tcp_x^2 + tcp_y^2 + tcp_z^2)", 1}};
  return {wave, shift, place};
}

/// Terms of every effect of the catalogue and of some by formula, sizes drawn from what is plausible.
inline std::vector<EffectTerm> everything_wrong(const Chain& chain, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<EffectTerm> terms;
  const auto add = [&](const Effect& e, std::shared_ptr<const Effect> own) {
    const std::vector<int> places = effect_places(e, chain);
    for (std::size_t n = 0; n < std::min<std::size_t>(2, places.size()); ++n) {
      EffectTerm t = term_of(e, places[random() % places.size()], own);
      for (std::size_t p = 0; p < t.values.size(); ++p)
        t.values[p] = e.parameters[p].is_choice ? (e.parameters[p].choices.empty() ? 7.0 : e.parameters[p].choices[0])
                                                : e.parameters[p].sigma * normal(random);
      if (e.id.find("elasticity") != std::string::npos) t.values[0] = std::abs(t.values[0]);
      terms.push_back(t);
    }
  };
  for (const Effect& e : catalogue()) add(e, nullptr);
  for (const EffectDefinition& d : own_definitions(chain.robot)) {
    const auto own = own_effect(d, chain.robot);
    add(*own, own);
  }
  return terms;
}

/// A robot whose model is these terms, as a fit would leave it; nothing is known of the errors.
inline CalibratedRobot robot_with(const Session& session, const std::vector<EffectTerm>& terms,
                                  std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  CalibratedRobot robot;
  robot.chain = chain_of(session);
  robot.joint_names = session.joints;
  robot.tcp = session.tcp;
  robot.mount = session.mount.link;
  robot.model.effects = terms;
  robot.model.tcp_from_body = {rotation_from_rpy({normal(random), 0.2 * normal(random), normal(random)}),
                               Vector3(0.05, -0.03, 0.1)};
  robot.model.mount_from_sensor = session.mount.mount_from_sensor;
  robot.calibration.session = "everything \"wrong\"";
  robot.calibration.created = "2026-11-22T10:00:00Z";
  robot.calibration.tcp = session.tcp;
  robot.calibration.joints = session.joints;
  robot.calibration.tcp_from_body.motion = robot.model.tcp_from_body;
  Eigen::Index numbers = 6;
  for (const EffectTerm& t : terms) numbers += static_cast<Eigen::Index>(t.values.size());
  robot.model.covariance = Eigen::MatrixXd::Zero(numbers, numbers);
  return robot;
}

/// The coupled torso with springs, a slide, a link fixed to the root and one fixed to the hand, which is the TCP.
inline Session torso_with_all_kinds() {
  Session s = stand_session();
  s.robot = coupled_torso();
  for (Joint& joint : s.robot.joints) joint.stiffness = 5000;
  s.robot.joints[3].kind = JointKind::prismatic;
  s.robot.joints[3].stiffness = 2e5;
  const auto add_fixed = [&](const std::string& name, int parent, double mass) {
    const int link = static_cast<int>(s.robot.links.size()), joint = static_cast<int>(s.robot.joints.size());
    s.robot.links.push_back(make_link(name, mass, {0.02, 0.01, 0.03}, joint));
    Joint j = make_joint(name + "_joint", parent, link, {0.1, 0.02, -0.03}, {0.3, 0.2, -0.1}, {0, 0, 1});
    j.kind = JointKind::fixed;
    s.robot.joints.push_back(j);
  };
  add_fixed("box", 0, 12);
  add_fixed("flange", 5, 0.7);
  s.robot.links[0].mass = 30;
  s.robot.links[0].center_of_mass = {0.1, 0.02, 0};
  s.tcp = "flange";
  s.mount.link = "base";
  s.joints = {"t1", "t2", "arm_1", "arm_2"};
  s.observations[0].position = Eigen::VectorXd::Zero(4);
  return s;
}

inline Eigen::VectorXd random_position(const Chain& chain, std::mt19937_64& random, double size = 1) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Eigen::VectorXd position(static_cast<Eigen::Index>(chain.joints.size()));
  for (double& q : position) q = uniform(random);
  return position;
}

/// Writes positions a line each; runs `command < positions > answers`; the numbers of each line, the last word apart.
struct Answer {
  std::vector<double> numbers;
  std::string word;
};
inline std::vector<Answer> answers(const std::filesystem::path& folder, const std::string& command,
                                   const std::vector<Eigen::VectorXd>& positions) {
  std::ofstream in(folder / "positions.txt");
  in.precision(17);
  for (const Eigen::VectorXd& p : positions) in << p.transpose() << '\n';
  in.close();
  const std::string line = command + " < '" + (folder / "positions.txt").string() + "' > '" +
                           (folder / "answers.txt").string() + "' 2> '" + (folder / "errors.txt").string() + "'";
  if (std::system(line.c_str()) != 0) return {};
  std::vector<Answer> all;
  std::ifstream out(folder / "answers.txt");
  for (std::string text; std::getline(out, text);) {
    std::istringstream words(text);
    Answer a;
    for (std::string w; words >> w;) {
      try {
        a.numbers.push_back(std::stod(w));
      } catch (const std::exception&) {
        a.word = w;
      }
    }
    all.push_back(a);
  }
  return all;
}

inline std::string text_of_file(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// "" where the compiler has nothing to say; else what it says.
inline std::string compiled(const std::filesystem::path& source, const std::filesystem::path& program,
                            const std::string& options = "-DHANDSIGHT_HAND_MAIN") {
  const std::string said = program.string() + ".txt";
  const std::string command = "c++ -std=c++17 -O2 -Wall -Wextra -Werror " + options + " -o '" + program.string() +
                              "' -x c++ '" + source.string() + "' 2> '" + said + "'";
  if (std::system(command.c_str()) == 0) return "";
  return "does not compile: " + text_of_file(said).substr(0, 3000);
}

}  // namespace handsight::fixture
