// SPDX-License-Identifier: Apache-2.0
// Images mirrored or turned, width and height exchanged, gravity along another axis: named where they were made, and
// the session that is put right fits.
#include <fstream>

#include "base/error.h"
#include "blunder_fixture.h"
#include "blunders/blunders_in_files.h"
#include "blunders/mended.h"
#include "blunders/picture_turns.h"
#include "detection/target_finding.h"
#include "fixtures/robot_texts.h"
#include "session/session_xml.h"
#include "simulation/simulated_files.h"
#include "temporary_folder.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

using fixture::blunders_in;
using fixture::six_axes;
using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Every image point of a camera (-1: of all), changed as a change of its image would.
template <class Change>
Session with_pixels(Session s, int camera, const Change& change) {
  for (Observation& o : s.observations)
    for (Sighting& seen : o.sightings)
      for (CameraPoint& p : seen.in_cameras)
        if (camera < 0 || p.camera == camera) {
          const Camera& c = s.rig->at(p.camera).camera;
          p.pixel = change(p.pixel, c.width, c.height);
        }
  return s;
}

Vector2 mirrored(const Vector2& p, int width, int) { return {width - 1 - p.x(), p.y()}; }
Vector2 flipped(const Vector2& p, int, int height) { return {p.x(), height - 1 - p.y()}; }
Vector2 upside_down(const Vector2& p, int width, int height) { return {width - 1 - p.x(), height - 1 - p.y()}; }
/// Its top is on the right afterwards.
Vector2 turned_right(const Vector2& p, int, int height) { return {height - 1 - p.y(), p.x()}; }
Vector2 turned_left(const Vector2& p, int width, int) { return {p.y(), width - 1 - p.x()}; }

double compute_picture_rms(const Session& s) { return fit(s).residual_rms; }

Session two_cameras(std::uint64_t seed) {
  return fixture::simulated_right(fixture::with_free_mount(fixture::target_session(fixture::charuco(), 2)), seed);
}

TEST(PictureBlunders, MirroredImages) {
  const Session s = six_axes(21);
  EXPECT_THAT(blunders_in(with_pixels(s, -1, mirrored)), ElementsAre("image_mirrored"));
  EXPECT_THAT(blunders_in(with_pixels(s, 1, mirrored)), ElementsAre("image_mirrored:right"));
  EXPECT_THAT(blunders_in(with_pixels(s, 0, flipped)), ElementsAre("image_mirrored:left=vertical"));
  const Session board = two_cameras(22);
  EXPECT_THAT(blunders_in(with_pixels(board, 1, mirrored)), ElementsAre("image_mirrored:" + board.rig->at(1).name));
}

TEST(PictureBlunders, OneCameraMirroredBeforeABoard) {
  // Mirrored left and right, or top and bottom: half a turn of a camera whose place nobody knows lies between them.
  const Session s = fixture::simulated_right(fixture::with_free_mount(fixture::target_session()), 23);
  EXPECT_THAT(blunders_in(with_pixels(s, -1, mirrored)),
              ElementsAre(AnyOf("image_mirrored", "image_mirrored:vertical")));
  Session known = s;
  known.mount.estimate = false;
  EXPECT_THAT(blunders_in(with_pixels(known, -1, mirrored)), ElementsAre("image_mirrored"));
}

TEST(PictureBlunders, TurnedImages) {
  Session s = six_axes(24);
  s.mount.estimate = false;  // else both cameras turned are two that were exchanged on a turned mount
  EXPECT_THAT(blunders_in(with_pixels(s, -1, upside_down)), ElementsAre("image_turned"));
  EXPECT_THAT(blunders_in(with_pixels(s, -1, turned_right)), ElementsAre("image_turned:90"));
  EXPECT_THAT(blunders_in(with_pixels(s, -1, turned_left)), ElementsAre("image_turned:270"));
  EXPECT_THAT(blunders_in(with_pixels(six_axes(25), 1, upside_down)), ElementsAre("image_turned:right"));
  EXPECT_THAT(blunders_in(with_pixels(six_axes(25), 0, turned_right)), ElementsAre("image_turned:left=90"));
}

TEST(PictureBlunders, AreMendedByName) {
  Session known = six_axes(26);
  known.mount.estimate = false;
  EXPECT_LT(compute_picture_rms(mended(with_pixels(known, -1, mirrored), "image_mirrored")), 0.5);
  EXPECT_LT(compute_picture_rms(mended(with_pixels(known, 1, flipped), "image_mirrored:right=vertical")), 0.5);
  EXPECT_LT(compute_picture_rms(mended(with_pixels(known, -1, upside_down), "image_turned")), 0.5);
  EXPECT_LT(compute_picture_rms(mended(with_pixels(known, -1, turned_left), "image_turned:270")), 0.5);
  EXPECT_THROW(mended(known, "image_turned:45"), InputError);
  EXPECT_THROW(mended(known, "image_turned:middle=90"), InputError);
  EXPECT_THROW(mended(known, "size_swapped:middle"), InputError);
  EXPECT_THROW(mended(known, "gravity_turned:down"), InputError);
}

TEST(PictureTurns, ImagesAndPointsAreTurnedAlike) {
  Image image(7, 5);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::uint8_t>(3 * i);
  for (const PictureTurn turn : {PictureTurn::mirrored, PictureTurn::flipped, PictureTurn::half,
                                 PictureTurn::quarter_right, PictureTurn::quarter_left}) {
    const Image before = turned_back(image, turn);
    Camera camera;
    camera.width = before.width;
    camera.height = before.height;
    for (int v = 0; v < image.height; ++v)
      for (int u = 0; u < image.width; ++u) {
        const CameraPoint point = turned_back({0, Vector2(u, v), PixelSigma{1, 2, 0.5}}, turn, camera);
        EXPECT_EQ(before.row(static_cast<int>(point.pixel.y()))[static_cast<int>(point.pixel.x())], image.row(v)[u]);
      }
  }
}

TEST(SizeSwapped, ShowsInThePointsAndIsMended) {
  for (const bool centre_too : {false, true}) {
    Session wrong = six_axes(27);
    for (RigCamera& c : wrong.rig->cameras) {
      std::swap(c.camera.width, c.camera.height);
      if (centre_too) std::swap(c.camera.cx, c.camera.cy);
    }
    const auto found = blunders_in_files(wrong);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(display_name(found[0]), "size_swapped");
    EXPECT_FALSE(found[0].is_by_fit);
    EXPECT_THAT(found[0].fix, HasSubstr(fmt::format("width=\"{}\"", six_axes(27).rig->at(0).camera.width)));
    const Session right = mended(wrong, "size_swapped");
    EXPECT_EQ(right.rig->at(0).camera.width, six_axes(27).rig->at(0).camera.width);
    EXPECT_EQ(right.rig->at(1).camera.cx, six_axes(27).rig->at(1).camera.cx);
    EXPECT_LT(compute_picture_rms(right), 0.5);
    EXPECT_THAT(blunders_in_files(right), IsEmpty());
  }
}

TEST(SizeSwapped, OfOneCameraIsTold) {
  Session wrong = six_axes(27);
  Camera& right = wrong.rig->cameras[1].camera;
  std::swap(right.width, right.height);
  const auto found = blunders_in_files(wrong);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(display_name(found[0]), "size_swapped:right");
}

TEST(BlundersInFiles, NothingWhereNothingIsWrong) {
  EXPECT_THAT(blunders_in_files(six_axes(28)), IsEmpty());
  EXPECT_THAT(blunders_in_files(fixture::pose_session(2)), IsEmpty());
  EXPECT_THAT(blunders_in_files(two_cameras(3)), IsEmpty());
}

/// A session with images of a board, written to a folder.
Session with_images(const std::filesystem::path& folder, const Target& target) {
  Session like = fixture::with_free_mount(fixture::target_session(target));
  for (RigCamera& c : like.rig->cameras) {  // small images: the test shall not wait for the renderer
    c.camera.fx *= 0.8, c.camera.fy *= 0.8, c.camera.cx *= 0.8, c.camera.cy *= 0.8;
    c.camera.width = c.camera.width * 4 / 5, c.camera.height = c.camera.height * 4 / 5;
  }
  std::filesystem::create_directories(folder);
  const std::filesystem::path robot = folder / "arm.urdf";
  std::ofstream(robot) << fixture::urdf_text(like.robot);
  SimulationOptions o;
  o.observations = 12;
  o.seed = 4;
  o.farthest = 1.1;
  write_simulated(simulate_session(like, o), o, robot, {.observations = 12}, folder / "session");
  return read_session(folder / "session");
}

template <class Change>
void change_images(const Session& s, const Change& change) {
  for (const Observation& o : s.observations)
    for (int c = 0; c < s.rig->count(); ++c) {
      const std::string& file = o.images[static_cast<std::size_t>(c)];
      if (!file.empty()) write_png(change(read_image(folder(s) / file)), folder(s) / file);
    }
}

TEST(BlundersInFiles, MirroredImagesOfTagsAreFoundAndPutRight) {
  const TemporaryFolder folder;
  Session s = with_images(folder.path, fixture::charuco(6, 5, 0.04));
  change_images(s, [](const Image& image) { return turned_back(image, PictureTurn::mirrored); });
  find_targets(s);
  const auto found = blunders_in_files(s);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(display_name(found[0]), "image_mirrored");
  Session right = write_mended(s, {"image_mirrored"}, folder.path / "mended");
  EXPECT_EQ(find_targets(right).found, 12);
  EXPECT_LT(compute_picture_rms(right), 0.5);
}

TEST(BlundersInFiles, ImagesOfTheOtherSizeAreFoundAndPutRight) {
  const TemporaryFolder folder;
  Session s = with_images(folder.path, fixture::charuco(6, 5, 0.04));
  Camera& camera = s.rig->cameras[0].camera;
  std::swap(camera.width, camera.height);
  EXPECT_EQ(find_targets(s).found, 0) << "images of another size are not read";
  const auto found = blunders_in_files(s);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(display_name(found[0]), "size_swapped");
  Session right = write_mended(s, {"size_swapped"}, folder.path / "mended");
  EXPECT_EQ(find_targets(right).found, 12);
  EXPECT_LT(compute_picture_rms(right), 0.5);
}

/// The arm with soft joints, simulated where gravity pulls along `down`.
Session soft_arm(const Vector3& down, std::uint64_t seed) {
  Session like = fixture::with_free_mount(fixture::stand_session(4));
  for (Joint& joint : like.robot.joints)
    if (joint.moves()) joint.stiffness = 1500;
  like.gravity = 9.81 * down;
  return fixture::simulated_right(like, seed);
}

TEST(GravityTurned, IsNamedWhereSpringsShowIt) {
  Session wrong = soft_arm(-Vector3::UnitZ(), 31);
  EXPECT_THAT(blunders_in(wrong), IsEmpty());
  wrong.gravity = {0, 0, 9.81};
  EXPECT_THAT(blunders_in(wrong), ElementsAre("gravity_turned:-z"));
  Session on_the_wall = soft_arm(Vector3::UnitX(), 32);
  on_the_wall.gravity = {0, 0, -9.81};
  EXPECT_THAT(blunders_in(on_the_wall), ElementsAre("gravity_turned:x"));
  EXPECT_LT(compute_picture_rms(mended(on_the_wall, "gravity_turned:x")), 0.5);
}

TEST(GravityTurned, IsNamedWhereMeasuredTorquesShowIt) {
  Session s = fixture::simulated_right(fixture::with_free_mount(fixture::stand_session(4)), 33);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Chain chain = make_chain(s);
  chain.gravity = {0, 9.81, 0};  // how it hangs
  for (Observation& o : s.observations) {
    const Posture posture =
        solve_posture(chain.robot, joint_values(chain.robot, chain.joints, o.position), chain.gravity);
    o.torque.resize(o.position.size());
    for (Eigen::Index j = 0; j < o.torque.size(); ++j)
      o.torque[j] =
          -posture.torque[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])] + 0.3 * normal(random);
  }
  const auto found = blunders_in_files(s);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(display_name(found[0]), AnyOf("gravity_turned:y", "gravity_turned:-y"))
      << "a driver may count either way";
  s.gravity = chain.gravity;
  EXPECT_THAT(blunders_in_files(s), IsEmpty());
}

}  // namespace
}  // namespace handsight
