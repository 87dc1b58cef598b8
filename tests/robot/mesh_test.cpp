// SPDX-License-Identifier: Apache-2.0
// Meshes of links: read as they are written, and refused where they lie about themselves.
#include "robot/mesh.h"

#include <gmock/gmock.h>

#include <cstring>

#include "base/error.h"
#include "base/files.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string find_refusal(auto&& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string refused_obj(const std::string& faces) {
  return find_refusal([&] { parse_obj(three_points + faces, "link.obj"); });
}

std::string bytes_of(float number) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &number, 4);
  return bytes;
}

/// A binary STL file of triangles with corners (0, 0, 0), (1, 0, 0), (0, 1, i) whose head speaks of `told`.
std::string binary_stl(std::uint32_t triangles, std::uint32_t reported) {
  std::string bytes(80, 's');
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(reported >> (8 * i) & 0xff);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const auto height = static_cast<float>(t);
    for (const float number : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, height})
      bytes += bytes_of(number);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(Mesh, FacesOfAnObjNameTheirPoints) {
  const Mesh mesh =
      parse_obj("# a square\n" + three_points + "v 1 1 0\nvn 0 0 1\nf 1//1 2//1 4//1 3//1\nf -4/2 -3 -2\n", "a.obj");
  EXPECT_EQ(mesh.points.size(), 4u);
  ASSERT_EQ(mesh.triangles.size(), 3u);
  EXPECT_THAT(mesh.triangles[0], ElementsAre(0, 1, 3));
  EXPECT_THAT(mesh.triangles[1], ElementsAre(0, 3, 2));
  EXPECT_THAT(mesh.triangles[2], ElementsAre(0, 1, 2));
}

TEST(Mesh, PointsThatAreNotThereAreRefused) {
  EXPECT_EQ(refused_obj("f 1 2 99999999\n"),
            "link.obj, line 4: the face names the point \"99999999\", expected one of the 3 points before it.");
  EXPECT_THAT(refused_obj("f -5 -6 -7\n"), HasSubstr("line 4"));
  EXPECT_THAT(refused_obj("f 0 1 2\n"), HasSubstr("line 4"));
  EXPECT_THAT(refused_obj("f 1 2 99999999999999999999\n"), HasSubstr("line 4"));
  EXPECT_THAT(refused_obj("f -9223372036854775808 1 2\n"), HasSubstr("line 4"));
  EXPECT_THAT(refused_obj("f a b c\n"), HasSubstr("\"a\""));
  EXPECT_THAT(refused_obj("f 1 2\n"), HasSubstr("2 corners"));
  EXPECT_THAT(refused_obj("v 1 nan 2\n"), HasSubstr("\"nan\""));
  EXPECT_THAT(refused_obj("v 1 1e160 2\n"), HasSubstr("1e160"));
  EXPECT_THAT(refused_obj("v 1 2\n"), HasSubstr("2 numbers"));
  // Indices of normals and textures are not looked at: nothing is taken from them.
  EXPECT_EQ(refused_obj("f 1//1 2//1 3//9999999\n"), "nothing was refused");
}

TEST(Mesh, StlFilesAreReadInBothForms) {
  const Mesh binary = parse_stl(binary_stl(2, 2), "a.stl");
  EXPECT_EQ(binary.points.size(), 4u) << "equal points are one";
  ASSERT_EQ(binary.triangles.size(), 2u);
  EXPECT_THAT(binary.triangles[1], ElementsAre(0, 1, 3));
  const Mesh text = parse_stl(
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "2e-1\nendloop\nendfacet\nendsolid",
      "a.stl");
  ASSERT_EQ(text.triangles.size(), 1u);
  EXPECT_FLOAT_EQ(text.points[2].z(), 0.2f);
}

TEST(Mesh, StlFilesThatAreNotWholeAreRefused) {
  EXPECT_THAT(find_refusal([] { parse_stl(binary_stl(1, 400000000), "a.stl"); }), HasSubstr("whole STL"));
  EXPECT_THAT(find_refusal([] { parse_stl("", "a.stl"); }), HasSubstr("0 bytes"));
  EXPECT_THAT(find_refusal([] { parse_stl("solid\nvertex 0 0 0\n", "a.stl"); }), HasSubstr("cut off"));
}

TEST(Mesh, OnlyFilesInTheRobotsOrTheSessionsFolderAreFound) {
  const TemporaryFolder temporary;
  const auto session = temporary.path / "session", urdf = session / "robot";
  std::filesystem::create_directories(urdf / "meshes");
  std::filesystem::create_directories(session / "meshes");
  replace_file(temporary.path / "secret.stl", "x");
  replace_file(session / "session.xml", "x");
  replace_file(urdf / "meshes" / "a.stl", "x");
  replace_file(session / "meshes" / "b.stl", "x");
  EXPECT_TRUE(find_mesh("meshes/a.stl", urdf));
  EXPECT_TRUE(find_mesh("package://arm/meshes/a.stl", urdf));
  EXPECT_TRUE(find_mesh("../meshes/b.stl", urdf)) << "the session's folder is above the robot's";
  EXPECT_TRUE(find_mesh((urdf / "meshes/a.stl").string(), urdf)) << "an absolute path inside";
  EXPECT_FALSE(find_mesh("../../secret.stl", urdf));
  EXPECT_FALSE(find_mesh("file://" + (temporary.path / "secret.stl").string(), urdf));
  EXPECT_FALSE(find_mesh("package://../../secret.stl", urdf));
  std::filesystem::create_symlink(temporary.path / "secret.stl", urdf / "link.stl");
  EXPECT_FALSE(find_mesh("link.stl", urdf));
  std::filesystem::remove(session / "session.xml");
  EXPECT_FALSE(find_mesh("../meshes/b.stl", urdf));
}

TEST(Mesh, KindsThatAreNotReadSaySo) {
  const TemporaryFolder folder;
  replace_file(folder.path / "a.ply", "x");
  EXPECT_THAT(find_refusal([&] { read_mesh(folder.path / "a.ply"); }),
              HasSubstr("expected an STL, an OBJ or a Collada"));
  replace_file(folder.path / "a.OBJ", three_points);
  EXPECT_THAT(find_refusal([&] { read_mesh(folder.path / "a.OBJ"); }), HasSubstr("no triangle"));
}

}  // namespace
}  // namespace handsight
