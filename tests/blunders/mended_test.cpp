// SPDX-License-Identifier: Apache-2.0
// Sessions put right by name, in memory and as a new folder.
#include "blunders/mended.h"

#include <fstream>

#include "base/error.h"
#include "blunder_fixture.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using fixture::six_axes;
using fixture::turned;
using testing::HasSubstr;

std::string refusal(const Session& s, const std::string& id) {
  try {
    mended(s, id);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

double compute_rms(const Session& s) { return fit(s).residual_rms; }

TEST(Mended, PutsRightWhatItsNameSays) {
  EXPECT_LT(compute_rms(mended(turned(six_axes(), "a3"), "joint_sense:a3")), 0.5);
  const Session zero = fixture::with_joint(six_axes(), "a3", [](const auto&, double q) { return q - 0.5; });
  EXPECT_LT(compute_rms(mended(zero, "joint_zero:a3=0.5")), 0.5);
  EXPECT_LT(compute_rms(mended(zero, "joint_zero:a3")), 2) << "its value is found";
  const Session poses = fixture::with_flange_poses(fixture::pose_session(1), [](const Rigid& p) {
    return Rigid{rotation_from_rpy(vector_from_rotation(p.rotation)), p.translation};
  });
  EXPECT_LT(compute_rms(mended(poses, "euler_convention:flange")), 2e-3) << "the convention is found";
}

TEST(Mended, RefusesWhatIsNotThere) {
  const Session s = six_axes();
  EXPECT_THAT(refusal(s, "joint_sens:a3"), HasSubstr("joint_sense"));
  EXPECT_THAT(refusal(s, "joint_sense:elbow"), HasSubstr("a1 a2 a3"));
  EXPECT_THAT(refusal(s, "joint_sense"), HasSubstr("a1 a2 a3"));
  EXPECT_THAT(refusal(s, "joint_swap:a1"), HasSubstr("FIRST,SECOND"));
  EXPECT_THAT(refusal(s, "joint_zero:a3=much"), HasSubstr("no number"));
  EXPECT_THAT(refusal(s, "pose_inverted:target"), HasSubstr("nothing"));
  EXPECT_THAT(refusal(s, "board_transposed"), HasSubstr("nothing"));
  EXPECT_THAT(refusal(s, "wrong_link:elbow"), HasSubstr("no link"));
  EXPECT_THAT(refusal(s, "pairing_shift:0"), HasSubstr("places"));
  EXPECT_THAT(refusal(s, "pairing_shift:900"), HasSubstr("observations"));
  EXPECT_THAT(refusal(fixture::pose_session(1), "euler_convention:flange=xzx"), HasSubstr("rotation_vector"));
}

TEST(Mended, IsWrittenAsASessionOfItsOwn) {
  const TemporaryFolder folder;
  Session s = turned(turned(six_axes(), "a3"), "a5");
  std::filesystem::create_directories(folder.path / "old");
  std::ofstream(folder.path / "old" / "robot.urdf") << fixture::urdf_text(s.robot);
  s.file = folder.path / "old" / "session.xml";
  save_session(s);
  const Session read = read_session(folder.path / "old");
  const Session made = write_mended(read, {"joint_sense:a3", "joint_sense:a5"}, folder.path / "new");
  EXPECT_EQ(made.observations.size(), s.observations.size());
  EXPECT_LT(compute_rms(read_session(folder.path / "new")), 0.5);
  EXPECT_GT(compute_rms(read_session(folder.path / "old")), 10) << "the old one stays as it is";
  EXPECT_THROW(write_mended(read, {"joint_sense:a3"}, folder.path / "new"), InputError);
}

}  // namespace
}  // namespace handsight
