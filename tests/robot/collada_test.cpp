// SPDX-License-Identifier: Apache-2.0
// Collada meshes as modelling programs write them: where the scene puts them, in metres; what lies is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "robot/collada_text.h"
#include "robot/mesh.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

std::string source(const std::string& points) {
  return "<source id='s'><float_array id='a' count='12'>" + points +
         "</float_array><technique_common><accessor source='#a' count='4' stride='3'/></technique_common></source>"
         "<vertices id='v'><input semantic='POSITION' source='#s'/></vertices>";
}
const std::string square = source("0 0 0 1 0 0 1 1 0 0 1 0");
const std::string with_normals =
    "<input semantic='VERTEX' source='#v' offset='0'/><input semantic='NORMAL' source='#n' offset='1'/>";

std::string file(const std::string& mesh, const std::string& nodes = "<node><instance_geometry url='#g'/></node>",
                 const std::string& unit = "<unit name='metre' meter='1'/>") {
  return "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>" + unit +
         "<up_axis>Y_UP</up_axis></asset><library_geometries><geometry id='g'><mesh>" + mesh +
         "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id='scene'>" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#scene'/></scene></COLLADA>";
}
const std::string two_triangles =
    square + "<triangles count='2'>" + with_normals + "<p>0 0 1 0 2 0 0 1 2 1 3 1</p></triangles>";

std::string refusal(const std::string& text) {
  try {
    parse_collada(text, "link.dae");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Collada, TrianglesTakeTheirPointsFromAmongOtherIndices) {
  const Mesh mesh = parse_collada(file(two_triangles), "link.dae");
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.points[mesh.triangles[1][1]], Eigen::Vector3f(1, 1, 0)) << "whatever up_axis says";
  EXPECT_EQ(mesh.points[mesh.triangles[1][2]], Eigen::Vector3f(0, 1, 0));
}

TEST(Collada, PolygonsAreFans) {
  const std::string vertex = "<input semantic='VERTEX' source='#v' offset='0'/>";
  const Mesh list = parse_collada(
      file(square + "<polylist count='2'>" + vertex + "<vcount>4 3</vcount><p>0 1 2 3 0 1 2</p></polylist>"), "a.dae");
  EXPECT_EQ(list.triangles.size(), 3u);
  const Mesh polygons =
      parse_collada(file(square + "<polygons count='2'>" + vertex + "<p>0 1 2 3</p><p>0 1 2</p></polygons>"), "a.dae");
  EXPECT_EQ(polygons.triangles, list.triangles);
}

TEST(Collada, TheSceneAndTheUnitSayWhere) {
  const Mesh mesh =
      parse_collada(file(two_triangles,
                         "<node><translate>100 0 0</translate><rotate>0 0 1 90</rotate><node><scale>2 2 2</scale>"
                         "<instance_geometry url='#g'/></node></node>"
                         "<node><matrix>1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1</matrix><instance_geometry url='#g'/></node>",
                         "<unit name='millimetre' meter='0.001'/>"),
                    "link.dae");
  ASSERT_EQ(mesh.points.size(), 8u);
  EXPECT_TRUE(mesh.points[1].isApprox(Eigen::Vector3f(0.1f, 0.002f, 0), 1e-5f));
  EXPECT_TRUE(mesh.points[5].isApprox(Eigen::Vector3f(0.006f, 0.006f, 0.007f), 1e-5f));
}

TEST(Collada, WhatLiesAboutItsContentIsRefusedWithItsLine) {
  const std::string vertex = "<input semantic='VERTEX' source='#v' offset='0'/>";
  const auto triangles = [&](const std::string& p) {
    return file(square + "<triangles>" + vertex + p + "</triangles>");
  };
  EXPECT_THAT(refusal(triangles("<p>0 1 99999999</p>")), HasSubstr("one of the 4 points"));
  EXPECT_THAT(refusal(triangles("<p>0 1 -5</p>")), HasSubstr("one of the 4 points"));
  EXPECT_THAT(refusal(triangles("<p>0 1 x</p>")), HasSubstr("line 1"));
  EXPECT_THAT(refusal(file(square + "<polylist>" + vertex + "<vcount>9</vcount><p>0 1 2</p></polylist>")),
              HasSubstr("as many as its faces"));
  EXPECT_THAT(refusal(file(source("0 0 1e300") + "<triangles>" + vertex + "<p>0 0 0</p></triangles>")),
              HasSubstr("too far away"));
  EXPECT_THAT(refusal(file("<triangles><p>0 0 0</p></triangles>")), HasSubstr("has no points"));
  EXPECT_THAT(refusal(file(two_triangles, "<node><instance_geometry url='#h'/></node>")), HasSubstr("<geometry>"));
  EXPECT_THAT(refusal(file(two_triangles, "<node id='n'><instance_node url='#n'/></node>")), HasSubstr("50 deep"));
  EXPECT_THAT(refusal("<robot/>"), HasSubstr("COLLADA"));
}

TEST(Collada, IsReadByItsEnding) {
  const TemporaryFolder folder;
  replace_file(folder.path / "link.DAE", file(two_triangles));
  EXPECT_EQ(read_mesh(folder.path / "link.DAE").triangles.size(), 2u);
}

}  // namespace
}  // namespace handsight
