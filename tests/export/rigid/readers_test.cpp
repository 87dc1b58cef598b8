// SPDX-License-Identifier: Apache-2.0
// Robot descriptions in the eyes of those who read them: MuJoCo, libsdformat and urdfdom load the files, and their
// forward kinematics are those of predict_tcp. Each is skipped where its library is not installed (CONTRIBUTING.md).
#include <gtest/gtest.h>

#include <fstream>

#include "export/exported.h"
#include "export/rigid/described_robot.h"
#include "fixtures/exported_robots.h"
#ifdef HANDSIGHT_MUJOCO
#include <mujoco/mujoco.h>
#endif
#ifdef HANDSIGHT_SDFORMAT
#include <sdf/sdf.hh>
#endif
#ifdef HANDSIGHT_URDFDOM
#include <urdf_parser/urdf_parser.h>
#endif

namespace handsight {
namespace {

constexpr double agreement = 1e-6;  // m and rad

/// Where a reader has a link, with all joints of the file at these values.
using Reader = std::function<Rigid(const Robot& read, const Eigen::VectorXd& values, const std::string& link)>;

/// `rest`: what the file says that it misses, m.
void expect_predictions(const CalibratedRobot& robot, const Reader& reader, double rest, std::mt19937_64& random) {
  const DescribedRobot d = described_robot(robot);
  for (int i = 0; i < 12; ++i) {
    const Eigen::VectorXd position =
        rest > 0 ? robot.positions[static_cast<std::size_t>(i)] : fixture::random_position(robot.chain, random);
    const TcpPrediction wanted = predict_tcp(robot.chain, position, robot.model);
    const Eigen::VectorXd values = fixture::values_in(d.robot, robot.joint_names, position);
    EXPECT_LT((wanted.root_from_tcp_est.translation - reader(d.robot, values, d.urdf.hand_link).translation).norm(),
              rest + agreement);
    if (rest > 0) continue;
    EXPECT_LT(small_motion_between(wanted.root_from_tcp_est, reader(d.robot, values, d.urdf.hand_link)).norm(),
              agreement);
    EXPECT_LT(small_motion_between(wanted.root_from_body_est, reader(d.robot, values, d.urdf.body_link)).norm(),
              agreement);
    EXPECT_LT(small_motion_between(*wanted.root_from_sensor_est, reader(d.robot, values, d.urdf.sensor_link)).norm(),
              agreement);
  }
}

/// A robot with a slide, followers and fixed links, an arm, and a springy arm that no file of rigid links holds.
void expect_of_all_robots(const std::string& kind, const std::function<Reader(const std::string& text)>& open) {
  std::mt19937_64 random(21);
  for (const Session& session : {fixture::rigid_torso(), fixture::stand_session()}) {
    const CalibratedRobot robot =
        fixture::exported_robot(session, fixture::sayable_terms(make_chain(session), random), random, 12);
    expect_predictions(robot, open(exported_file(robot, kind).text), 0, random);
  }
  const Session springy = fixture::seven_axis_session();
  const CalibratedRobot robot =
      fixture::exported_robot(springy, fixture::unsayable_terms(make_chain(springy)), random, 40);
  const ExportedFile file = exported_file(robot, kind);
  EXPECT_GT(*file.left, 1e-5);
  EXPECT_LT(*file.left, 0.5 * *file.nominal);
  expect_predictions(robot, open(file.text), *file.largest_left, random);
}

#ifdef HANDSIGHT_MUJOCO
Reader mujoco_reader(const std::string& text) {
  const TemporaryFolder folder;
  const std::string file = (folder.path / "robot.xml").string();
  std::ofstream(file) << text;
  char error[1000] = "";
  std::shared_ptr<mjModel> model(mj_loadXML(file.c_str(), nullptr, error, sizeof error), mj_deleteModel);
  EXPECT_TRUE(model) << error;
  if (!model) throw std::runtime_error(error);
  std::shared_ptr<mjData> data(mj_makeData(model.get()), mj_deleteData);
  return [model, data](const Robot& read, const Eigen::VectorXd& values, const std::string& link) {
    for (std::size_t j = 0; j < read.joints.size(); ++j) {
      if (!read.joints[j].moves()) continue;
      const int id = mj_name2id(model.get(), mjOBJ_JOINT, read.joints[j].name.c_str());
      EXPECT_GE(id, 0);
      data->qpos[model->jnt_qposadr[id]] = values[static_cast<Eigen::Index>(j)];
    }
    mj_kinematics(model.get(), data.get());
    const int body = mj_name2id(model.get(), mjOBJ_BODY, link.c_str());
    EXPECT_GE(body, 0) << link;
    const mjtNum *x = data->xpos + 3 * body, *m = data->xmat + 9 * body;
    return Rigid{Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(m), Vector3(x)};
  };
}

TEST(Mjcf, IsReadByMuJoCoAsPredicted) { expect_of_all_robots("mjcf", mujoco_reader); }

/// MuJoCo itself moves a follower to where the equality wants it.
TEST(Mjcf, HoldsFollowersLimitsMassesAndGravity) {
  std::mt19937_64 random(2);
  Session session = fixture::rigid_torso();
  session.gravity = {0, 1, -9.7};
  session.robot.joints[1].upper = 1.25;
  const CalibratedRobot robot = fixture::exported_robot(session, {}, random);
  const TemporaryFolder folder;
  const std::string file = (folder.path / "robot.xml").string();
  std::ofstream(file) << exported_file(robot, "mjcf").text;
  char error[1000] = "";
  const std::shared_ptr<mjModel> model(mj_loadXML(file.c_str(), nullptr, error, sizeof error), mj_deleteModel);
  ASSERT_TRUE(model) << error;
  EXPECT_EQ(model->opt.gravity[1], 1);
  ASSERT_EQ(model->neq, 1);
  const int follower = mj_name2id(model.get(), mjOBJ_JOINT, "t3"), leader = mj_name2id(model.get(), mjOBJ_JOINT, "t1");
  EXPECT_EQ(model->eq_obj1id[0], follower);
  EXPECT_EQ(model->eq_obj2id[0], leader);
  EXPECT_EQ(model->eq_data[1], -1);
  EXPECT_EQ(model->jnt_range[2 * mj_name2id(model.get(), mjOBJ_JOINT, "t2") + 1], 1.25);
  EXPECT_NEAR(model->body_mass[mj_name2id(model.get(), mjOBJ_BODY, "chest")], 8, 1e-12);
}

/// Meshes are named from the file's folder; one that is not there must not keep MuJoCo from opening the model.
TEST(Mjcf, NamesMeshesThatAreThere) {
  std::mt19937_64 random(2);
  CalibratedRobot robot = fixture::exported_robot(fixture::stand_session(), {}, random);
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path / "robot" / "meshes");
  std::ofstream(folder.path / "robot" / "meshes" / "arm.obj")
      << "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const std::string box = "<box size=\"0.1 0.1 0.1\"/>";
  for (const char* mesh :
       {"<mesh filename=\"meshes/arm.obj\" scale=\"2 2 2\"/>", "<mesh filename=\"meshes/gone.stl\"/>"})
    robot.urdf_text.replace(robot.urdf_text.find(box), box.size(), mesh);
  robot.robot_folder = folder.path / "robot";
  const std::filesystem::path file = folder.path / "robot.xml";
  const ExportedFile made = exported_file(robot, "mjcf", {file, ""});
  std::ofstream(file) << made.text;
  char error[1000] = "";
  const std::shared_ptr<mjModel> model(mj_loadXML(file.c_str(), nullptr, error, sizeof error), mj_deleteModel);
  ASSERT_TRUE(model) << error;
  EXPECT_EQ(model->nmesh, 1);
  ASSERT_FALSE(made.notes.empty());
  EXPECT_NE(made.notes[0].find("1 meshes are not in the file"), std::string::npos);
}
#else
TEST(Mjcf, IsReadByMuJoCoAsPredicted) { GTEST_SKIP() << "libmujoco-dev is not installed"; }
#endif

#ifdef HANDSIGHT_SDFORMAT
Rigid make_rigid(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  return {Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).toRotationMatrix(),
          Vector3(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z())};
}

Rigid resolved(const sdf::SemanticPose& pose, const std::string& to) {
  ignition::math::Pose3d found;
  const sdf::Errors errors = pose.Resolve(found, to);
  EXPECT_TRUE(errors.empty()) << to << ": " << (errors.empty() ? "" : errors[0].Message());
  return make_rigid(found);
}

/// libsdformat says where frames are with all joints at zero; the product over the joints is the test's own.
Rigid sdf_link(const sdf::Model& model, const Robot& read, const Eigen::VectorXd& values, const std::string& name) {
  const sdf::Link* link = model.LinkByName(name);
  if (!link) {  // a frame on a link
    const sdf::Frame* frame = model.FrameByName(name);
    if (!frame) throw std::runtime_error("no link or frame " + name);
    return sdf_link(model, read, values, frame->AttachedTo()) * resolved(frame->SemanticPose(), frame->AttachedTo());
  }
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
    const sdf::Joint& joint = *model.JointByIndex(i);
    if (joint.ChildLinkName() != name) continue;
    if (joint.ParentLinkName() == "world") return resolved(link->SemanticPose(), "__model__");
    const Rigid parent_from_joint = resolved(joint.SemanticPose(), joint.ParentLinkName());
    Rigid motion;
    if (joint.Type() != sdf::JointType::FIXED) {
      ignition::math::Vector3d xyz;
      EXPECT_TRUE(joint.Axis()->ResolveXyz(xyz, joint.Name()).empty());
      const Vector3 axis(xyz.X(), xyz.Y(), xyz.Z());
      const int link_index = find_link(read, name);
      const double value = values[read.links.at(static_cast<std::size_t>(link_index)).parent_joint];
      if (joint.Type() == sdf::JointType::PRISMATIC)
        motion.translation = value * axis;
      else
        motion.rotation = Eigen::AngleAxisd(value, axis).toRotationMatrix();
    }
    return sdf_link(model, read, values, joint.ParentLinkName()) * parent_from_joint * motion *
           resolved(link->SemanticPose(), joint.Name());
  }
  throw std::runtime_error("nothing carries " + name);
}

Reader sdf_reader(const std::string& text) {
  const auto root = std::make_shared<sdf::Root>();
  const sdf::Errors errors = root->LoadSdfString(text);
  EXPECT_TRUE(errors.empty()) << (errors.empty() ? "" : errors[0].Message());
  if (!root->Model()) throw std::runtime_error("no model");
  return [root](const Robot& read, const Eigen::VectorXd& values, const std::string& link) {
    return sdf_link(*root->Model(), read, values, link);
  };
}

TEST(Sdf, IsReadByLibsdformatAsPredicted) { expect_of_all_robots("sdf", sdf_reader); }

TEST(Sdf, HoldsLimitsAndMasses) {
  std::mt19937_64 random(2);
  Session session = fixture::rigid_torso();
  session.robot.joints[1].upper = 1.25;
  sdf::Root root;
  ASSERT_TRUE(root.LoadSdfString(exported_file(fixture::exported_robot(session, {}, random), "sdf").text).empty());
  EXPECT_EQ(root.Model()->JointByName("t2_joint")->Axis()->Upper(), 1.25);
  EXPECT_EQ(root.Model()->LinkByName("chest")->Inertial().MassMatrix().Mass(), 8);
}
#else
TEST(Sdf, IsReadByLibsdformatAsPredicted) { GTEST_SKIP() << "libsdformat-dev is not installed"; }
#endif

#ifdef HANDSIGHT_URDFDOM
Rigid make_rigid(const urdf::Pose& pose) {
  return {Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z).toRotationMatrix(),
          Vector3(pose.position.x, pose.position.y, pose.position.z)};
}

Reader urdfdom_reader(const std::string& text) {
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text);
  EXPECT_TRUE(model);
  if (!model) throw std::runtime_error("urdfdom does not read it");
  return [model](const Robot& read, const Eigen::VectorXd& values, const std::string& name) {
    Rigid root_from_link;
    for (auto link = model->getLink(name); link->parent_joint; link = link->getParent()) {
      const urdf::Joint& joint = *link->parent_joint;
      const Vector3 axis(joint.axis.x, joint.axis.y, joint.axis.z);
      const double value = values[find_joint(read, joint.name)];
      Rigid motion;
      if (joint.type == urdf::Joint::PRISMATIC) motion.translation = value * axis;
      if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS)
        motion.rotation = Eigen::AngleAxisd(value, axis).toRotationMatrix();
      root_from_link = make_rigid(joint.parent_to_joint_origin_transform) * motion * root_from_link;
    }
    return root_from_link;
  };
}

TEST(Urdf, IsReadByUrdfdomAsPredicted) { expect_of_all_robots("urdf", urdfdom_reader); }
#else
TEST(Urdf, IsReadByUrdfdomAsPredicted) { GTEST_SKIP() << "liburdfdom-dev is not installed"; }
#endif

}  // namespace
}  // namespace handsight
