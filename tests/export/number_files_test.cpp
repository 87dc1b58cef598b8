// SPDX-License-Identifier: Apache-2.0
// Exports read back by other readers: the same hand pose where the format can say it, and a word where it cannot.
#include "export/number_files.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <opencv2/core.hpp>

#include "export/exported.h"
#include "export/rigid/urdf_file.h"
#include "fixtures/exported_robots.h"

namespace handsight {
namespace {

using fixture::sayable_terms;
using fixture::urdf_text;

/// Fills the numbers of a calibration as a fit would: what files of numbers are written from.
void write_down(CalibratedRobot& robot) {
  for (const EffectTerm& t : robot.model.effects) {
    const Effect& e = term_effect(t);
    CalibrationEffect written{e.id, {}};
    for (std::size_t p = 0; p < t.values.size(); ++p)
      written.parameters.push_back(
          {place_name(e, t.place, robot.chain.robot), e.parameters[p].name, t.values[p], 1e-5, e.parameters[p].unit});
    robot.calibration.effects.push_back(written);
    if (e.definition && std::none_of(robot.calibration.definitions.begin(), robot.calibration.definitions.end(),
                                     [&](const EffectDefinition& d) { return d.id == e.id; }))
      robot.calibration.definitions.push_back(*e.definition);
  }
  robot.calibration.markers = {{0.01, 0, 0}, {0, 0.02, 0}};
}

CalibratedRobot robot_from(const Session& session, const std::vector<EffectTerm>& terms, std::mt19937_64& random) {
  CalibratedRobot robot = fixture::exported_robot(session, terms, random);
  write_down(robot);
  return robot;
}

/// The calibrated URDF in another reader's eyes: forward kinematics and nothing else.
void expect_urdf(const CalibratedRobot& robot, std::mt19937_64& random) {
  const UrdfFile file = urdf_file(robot);
  const Robot read = parse_urdf(file.text, "calibrated.urdf", nullptr);
  std::vector<int> joints;
  for (const std::string& name : robot.joint_names) joints.push_back(find_joint(read, name));
  for (int i = 0; i < 10; ++i) {
    const Eigen::VectorXd position = fixture::random_position(robot.chain, random);
    const TcpPrediction wanted = predict_tcp(robot.chain, position, robot.model);
    const Posture p = solve_posture(read, joint_values(read, joints, position), robot.chain.gravity);
    const auto link = [&](const std::string& name) {
      const int index = find_link(read, name);
      EXPECT_GE(index, 0) << name;
      return p.root_from_link[static_cast<std::size_t>(index)];
    };
    EXPECT_LT(small_motion_between(wanted.root_from_tcp_est, link(file.hand_link)).norm(), 1e-9);
    EXPECT_LT(small_motion_between(wanted.root_from_body_est, link(file.body_link)).norm(), 1e-9);
    ASSERT_TRUE(wanted.root_from_sensor_est);
    EXPECT_LT(small_motion_between(*wanted.root_from_sensor_est, link(file.sensor_link)).norm(), 1e-9);
  }
}

TEST(UrdfFile, SaysOffsetsGeometryMountAndBody) {
  std::mt19937_64 random(2);
  Session session = fixture::torso_with_all_kinds();
  for (Joint& j : session.robot.joints) j.stiffness = 0;
  for (const char* tcp : {"flange", "hand"}) {
    session.tcp = tcp;
    session.robot = parse_urdf(urdf_text(session.robot), "robot.urdf", nullptr);
    const std::vector<EffectTerm> terms = sayable_terms(make_chain(session), random);
    expect_urdf(robot_from(session, terms, random), random);
  }
  const Session arm = fixture::stand_session();
  expect_urdf(robot_from(arm, sayable_terms(make_chain(arm), random), random), random);
}

TEST(UrdfFile, SaysDenavitHartenbergJointsSoThatAnyReaderOpensThem) {
  std::mt19937_64 random(2);
  const std::string text = R"(<robot name="dh"><link name="base"/>
    <link name="l1"><inertial><origin xyz="0.1 0 0"/><mass value="2"/></inertial></link><link name="l2"/><link name="l3"/>
    <joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><dh a="0.1" alpha="0.5" d="0.3" theta="0.2"/>
      <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
    <joint name="j2" type="prismatic"><parent link="l1"/><child link="l2"/><dh a="0.2" alpha="-0.7" d="0.1" theta="1"/>
      <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
    <joint name="j3" type="revolute"><parent link="l2"/><child link="l3"/><dh a="0.4" alpha="1.2" d="-0.2" theta="-0.4"/>
      <limit lower="-2" upper="2" effort="1" velocity="1"/></joint></robot>)";
  Session session = fixture::stand_session();
  session.robot = parse_urdf(text, "dh.urdf", nullptr);
  session.tcp = "l3";
  session.mount.link = "l1";
  session.joints = {"j1", "j2", "j3"};
  session.observations[0].position = Eigen::VectorXd::Zero(3);
  CalibratedRobot robot = fixture::robot_with(session, sayable_terms(make_chain(session), random), random);
  robot.urdf_text = text;
  EXPECT_EQ(urdf_file(robot).text.find("<dh"), std::string::npos);
  expect_urdf(robot, random);
}

TEST(UrdfFile, NamesWhatItCannotSay) {
  std::mt19937_64 random(4);
  const Session arm = fixture::stand_session();
  const Chain chain = make_chain(arm);
  const std::vector<EffectTerm> terms = {{"joint_offset", chain.joints[0], {0.01}},
                                         {"joint_elasticity", chain.joints[1], {2e-4}},
                                         {"encoder_eccentricity", chain.joints[2], {1e-3, 2e-3}},
                                         {"payload", -1, {1, 0, 0, 0}}};
  const UrdfFile file = urdf_file(robot_from(arm, terms, random));
  ASSERT_EQ(file.not_said.size(), 3u);
  for (const char* what : {"joint_elasticity of a2", "encoder_eccentricity of a3", "payload"})
    EXPECT_NE(file.text.find(what), std::string::npos) << what;
  EXPECT_EQ(file.text.find("joint_offset of a1"), std::string::npos);
  // The comment stands inside the robot, before the first link, and is one: no "--" in it.
  const std::size_t begin = file.text.find("<!--"), end = file.text.find("-->");
  ASSERT_LT(begin, file.text.find("<link"));
  EXPECT_EQ(file.text.substr(begin + 4, end - begin - 4).find("--"), std::string::npos);
}

TEST(UrdfFile, LinksOfTheSameNameAreNotDoubled) {
  std::mt19937_64 random(4);
  Session arm = fixture::stand_session();
  arm.robot.links[6].name = "body";
  arm.tcp = "body";
  const UrdfFile file = urdf_file(robot_from(arm, {}, random));
  EXPECT_EQ(file.body_link, "handsight_body");
  expect_urdf(robot_from(arm, {}, random), random);
}

Rigid make_motion(const std::vector<double>& xyz, const std::vector<double>& q) {
  return {Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix(), Vector3(xyz[0], xyz[1], xyz[2])};
}

void expect_same_predictions(const CalibratedRobot& robot, const Calibration& read, std::mt19937_64& random) {
  const PredictionModel model = prediction_model(read, robot.chain.robot);
  for (int i = 0; i < 10; ++i) {
    const Eigen::VectorXd position = fixture::random_position(robot.chain, random);
    const TcpPrediction wanted = predict_tcp(robot.chain, position, robot.model),
                        found = predict_tcp(robot.chain, position, model);
    EXPECT_LT(small_motion_between(wanted.root_from_tcp_est, found.root_from_tcp_est).norm(), 1e-9);
    EXPECT_LT(small_motion_between(wanted.root_from_body_est, found.root_from_body_est).norm(), 1e-9);
  }
}

/// One effect a term: a file says each on its own.
std::vector<EffectTerm> one_of_each(const Chain& chain, std::mt19937_64& random) {
  std::vector<EffectTerm> terms;
  for (const EffectTerm& t : fixture::everything_wrong(chain, random))
    if (std::none_of(terms.begin(), terms.end(), [&](const EffectTerm& o) { return o.id == t.id; })) terms.push_back(t);
  return terms;
}

TEST(NumberFiles, YamlSaysEverything) {
  std::mt19937_64 random(6);
  const Session session = fixture::torso_with_all_kinds();
  CalibratedRobot robot = fixture::robot_with(session, one_of_each(make_chain(session), random), random);
  write_down(robot);
  const YAML::Node yaml = YAML::Load(exported_file(robot, "yaml").text);
  Calibration read;
  const YAML::Node body = yaml["tcp_from_body"];
  read.tcp_from_body.motion =
      make_motion(body["xyz"].as<std::vector<double>>(), body["quaternion_xyzw"].as<std::vector<double>>());
  EXPECT_EQ(body["matrix"].as<std::vector<double>>().size(), 16u);
  EXPECT_EQ(body["covariance"].as<std::vector<double>>().size(), 36u);
  for (const YAML::Node& e : yaml["effects"]) {
    CalibrationEffect effect{e["id"].as<std::string>(), {}};
    for (const YAML::Node& p : e["parameters"])
      effect.parameters.push_back({p["of"].as<std::string>(), p["name"].as<std::string>(), p["value"].as<double>(),
                                   p["sigma"].as<double>(), p["unit"].as<std::string>()});
    read.effects.push_back(effect);
  }
  for (const YAML::Node& d : yaml["effect_definitions"])
    for (const EffectDefinition& one : parse_effect_definitions(
             "<handsight_effects version=\"1\">" + d.as<std::string>() + "</handsight_effects>", "yaml"))
      read.definitions.push_back(one);
  expect_same_predictions(robot, read, random);
  EXPECT_EQ(yaml["joints"].as<std::vector<std::string>>(), robot.joint_names);
}

/// Fields of a line of CSV, quotes undone.
std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> all{""};
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      all.back() += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      all.emplace_back();
    else
      all.back() += line[i];
  }
  return all;
}

TEST(NumberFiles, CsvSaysEverything) {
  std::mt19937_64 random(7);
  const Session session = fixture::torso_with_all_kinds();
  CalibratedRobot robot = fixture::robot_with(session, one_of_each(make_chain(session), random), random);
  write_down(robot);
  std::istringstream lines(exported_file(robot, "csv").text);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "quantity,of,name,value,sigma,unit");
  Calibration read;
  std::map<std::string, double> body;
  while (std::getline(lines, line)) {
    const std::vector<std::string> f = fields(line);
    ASSERT_EQ(f.size(), 6u) << line;
    if (f[0] == "tcp_from_body") body[f[2]] = std::stod(f[3]);
    if (f[0] == "definition")
      read.definitions.push_back(
          parse_effect_definitions("<handsight_effects version=\"1\">" + f[3] + "</handsight_effects>", "csv").at(0));
    if (f[0] == "tcp_from_body" || f[0] == "mount_from_sensor" || f[0] == "marker" || f[0] == "definition") continue;
    if (read.effects.empty() || read.effects.back().id != f[0]) read.effects.push_back({f[0], {}});
    read.effects.back().parameters.push_back({f[1], f[2], std::stod(f[3]), std::stod(f[4]), f[5]});
  }
  read.tcp_from_body.motion =
      make_motion({body["x"], body["y"], body["z"]}, {body["qx"], body["qy"], body["qz"], body["qw"]});
  expect_same_predictions(robot, read, random);
}

TEST(NumberFiles, OpenCvReadsBodyMountAndCameras) {
  std::mt19937_64 random(8);
  const Session session = fixture::stand_session();
  CalibratedRobot robot =
      fixture::robot_with(session, {{"camera_mount", -1, {0.001, 0.002, 0.01, 0.01, 0, 0.02}}}, random);
  robot.rig = session.rig;
  const cv::FileStorage storage(exported_file(robot, "opencv").text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
  const auto matrix = [&](const char* name) {
    cv::Mat m;
    storage[name] >> m;
    Matrix4 out;
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) out(r, c) = m.at<double>(r, c);
    return out;
  };
  EXPECT_LT((matrix("tcp_from_body") - matrix_from_rigid(robot.model.tcp_from_body)).norm(), 1e-15);
  const TcpPrediction p = predict_tcp(robot.chain, Eigen::VectorXd::Zero(6), robot.model);
  EXPECT_LT((matrix("mount_from_sensor") - matrix_from_rigid(*p.root_from_sensor_est)).norm(), 1e-12);  // on the root
  cv::Mat camera, distortion, shift;
  storage["M2"] >> camera;
  storage["D1"] >> distortion;
  storage["T"] >> shift;
  EXPECT_EQ(camera.at<double>(1, 1), session.rig->at(1).camera.fy);
  EXPECT_EQ(distortion.at<double>(0, 1), session.rig->at(0).camera.k2);
  EXPECT_EQ(shift.at<double>(0, 0), session.rig->at(1).camera_from_first.translation.x());
  EXPECT_EQ(static_cast<int>(storage["image_width"]), 800);
}

/// The launch file runs against stand-ins of the two modules that it needs; they print what ROS 2 would be told.
TEST(NumberFiles, LaunchFilePublishesBodyAndMount) {
  std::mt19937_64 random(9);
  const CalibratedRobot robot = fixture::robot_with(fixture::stand_session(), {}, random);
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path / "launch_ros");
  std::ofstream(folder.path / "launch.py") << "class LaunchDescription(list):\n    pass\n";
  std::ofstream(folder.path / "launch_ros/__init__.py") << "";
  std::ofstream(folder.path / "launch_ros/actions.py")
      << "class Node:\n    def __init__(self, package, executable, name, arguments):\n        assert package == "
         "'tf2_ros' and executable == 'static_transform_publisher'\n        self.named = "
         "dict(zip(arguments[::2], arguments[1::2]))\n";
  std::ofstream(folder.path / "calibration.launch.py") << exported_file(robot, "static_tf").text;
  std::ofstream(folder.path / "run.py") << "import runpy, sys\nsys.path.insert(0, '" << folder.path.string()
                                        << "')\nfor n in runpy.run_path('"
                                        << (folder.path / "calibration.launch.py").string()
                                        << "')['generate_launch_description']():\n    d = n.named\n    print(*[d['--' "
                                           "+ k] for k in ('x', 'y', 'z', 'qx', "
                                           "'qy', 'qz', 'qw')], d['--frame-id'] + '/' + d['--child-frame-id'])\n";
  const auto found = fixture::answers(folder.path, "python3 '" + (folder.path / "run.py").string() + "'", {});
  ASSERT_EQ(found.size(), 2u) << fixture::text_of_file(folder.path / "errors.txt");
  const auto read = [&](std::size_t i) {
    const std::vector<double>& n = found[i].numbers;
    return make_motion({n[0], n[1], n[2]}, {n[3], n[4], n[5], n[6]});
  };
  EXPECT_EQ(found[0].word, "hand/handsight_body");
  EXPECT_LT(small_motion_between(read(0), robot.model.tcp_from_body).norm(), 1e-9);
  EXPECT_EQ(found[1].word, "stand/handsight_sensor");
  EXPECT_LT(small_motion_between(read(1), *robot.model.mount_from_sensor).norm(), 1e-9);
}

TEST(NumberFiles, SayThatEffectsAreNotInFixedTransforms) {
  std::mt19937_64 random(10);
  const CalibratedRobot robot =
      fixture::robot_with(fixture::stand_session(), {{"joint_elasticity", 1, {1e-4}}}, random);
  for (const char* kind : {"opencv", "static_tf"}) EXPECT_EQ(exported_file(robot, kind).notes.size(), 1u) << kind;
  EXPECT_THROW(exported_file(robot, "excel"), InputError);
}

}  // namespace
}  // namespace handsight
