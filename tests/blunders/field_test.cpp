// SPDX-License-Identifier: Apache-2.0
// Mistakes as they came from the field, and real sessions in which there is none.
#include "blunder_fixture.h"
#include "convert/convert.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using fixture::blunders_in;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const fs::path shared = HANDSIGHT_SHARED_DIR;

Session converted(const TemporaryFolder& folder, const std::string& name, const std::vector<const char*>& files,
                  const std::string& tcp = "", const std::string& angles = "") {
  std::vector<fs::path> paths;
  for (const char* file : files) paths.push_back(shared / "field/robots" / name / file);
  ConvertOptions options;
  options.out = folder.path / name;
  options.tcp = tcp;
  options.angles = angles;
  return convert(paths, options).session;
}

TEST(FieldBlunders, AreNamed) {
  if (!fs::exists(shared / "field/robots")) GTEST_SKIP() << "no field sets on this machine";
  const TemporaryFolder folder;
  EXPECT_THAT(blunders_in(converted(folder, "target_the_other_way", {"flange.csv", "target.csv"})),
              ElementsAre("pose_inverted:target"));
  EXPECT_THAT(blunders_in(converted(folder, "hand_eye_export", {"flange.csv", "target.csv"})), IsEmpty());
  EXPECT_THAT(
      blunders_in(converted(folder, "joint_counts_backwards", {"joints.csv", "target.csv", "arm.urdf"}, "tool")),
      UnorderedElementsAre("joint_sense:elbow", "joint_sense:roll"));
}

TEST(FieldBlunders, RotationVectorsThatWereReadAsAnglesAreNamed) {
  if (!fs::exists(shared / "field/robots")) GTEST_SKIP() << "no field sets on this machine";
  const TemporaryFolder folder;
  const Session s = converted(folder, "rotation_vectors", {"flange.csv", "target.csv"}, "", "rpy");
  EXPECT_THAT(blunders_in(s), ElementsAre("euler_convention:both=rotation_vector"));
}

TEST(FieldBlunders, GoodSessionsAreNotAccused) {
  if (!fs::exists(shared / "real")) GTEST_SKIP() << "no real sets on this machine";
  for (const auto& entry : fs::directory_iterator(shared / "real")) {
    if (!fs::exists(entry.path() / "session.xml")) continue;
    const Session s = read_session(entry.path());
    try {
      const Fit f = fit(s);
      std::vector<std::string> names;
      for (const Blunder& b : find_blunders(s, f))
        names.push_back(display_name(b) + fmt::format(" {} -> {}", b.rms_before, b.rms_after));
      EXPECT_THAT(names, IsEmpty()) << entry.path();
    } catch (const InputError&) {  // nothing is labelled
    }
  }
}

}  // namespace
}  // namespace handsight
