// SPDX-License-Identifier: Apache-2.0
// Tables of touches: joint angles, what was touched, what it read; with a header or by columns, units told or refused.
#include "convert/convert_fixture.h"
#include "fixtures/touch_session.h"
#include "session/fixtures/list.h"

namespace handsight {
namespace {

using testing::Contains;
using testing::HasSubstr;

class TouchTables : public Convert {
 protected:
  TouchTables() {
    Session like = fixture::probe_session();
    fixture::add_plates(like);
    fixture::add_sockets(like);
    made = fixture::simulated_touches(like, 100, 6).session;
    options_.mount.clear();
    options_.sigma = 2e-5;
    options_.apart = {fmt::format("socket_left socket_right by={} sigma=1e-5", made.distances.front().by)};
  }

  /// A line a touch; `unit` of the angles.
  std::string table(const std::string& header, double unit = 1, bool with_fixture = true, int only = -1) const {
    std::string text = header.empty() ? "" : header + "\n";
    for (const Observation& o : made.observations) {
      if (only >= 0 && o.part != only) continue;
      text += fmt::format("{}", o.id);
      for (const double q : o.position) text += fmt::format(",{}", q * unit);
      text += with_fixture ? "," + made.fixtures[static_cast<std::size_t>(o.part)].id + "\n" : "\n";
    }
    return text;
  }

  void expect_as_made(const Session& s) {
    ASSERT_EQ(s.observations.size(), made.observations.size());
    ASSERT_TRUE(s.is_touch());
    const Fit f = fit(s);
    EXPECT_TRUE(f.converged());
    ASSERT_TRUE(f.chi2_per_dof);
    EXPECT_NEAR(*f.chi2_per_dof, 1, 0.5);
  }

  Session made;
};

TEST_F(TouchTables, AHeaderTellsAll) {
  const Conversion c = converted({write("t.csv", table("time,a1,a2,a3,a4,a5,a6,fixture"))});
  expect_as_made(c.session);
  EXPECT_EQ(c.session.fixtures.size(), 5u);
  EXPECT_EQ(c.session.fixtures[3].kind, &fixtures::point);
  EXPECT_THAT(c.took, Contains(HasSubstr("t.csv: a table of touches")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("taken for a plane by its name")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("Fixture socket_left: 20 touches")));
}

TEST_F(TouchTables, DegreesAreReadWhereTheyAreToldAndRefusedElsewhere) {
  constexpr double degrees = 180 / 3.14159265358979323846;
  expect_as_made(
      converted({write("t.csv", table("time,a1_deg,a2_deg,a3_deg,a4_deg,a5_deg,a6_deg,fixture", degrees))}).session);
  EXPECT_THAT(refusal({write("t.csv", table("time,a1,a2,a3,a4,a5,a6,fixture", degrees))}), HasSubstr("--degrees"));
}

TEST_F(TouchTables, ATableWithoutAHeaderGoesByColumns) {
  options_.columns = {"-", "a1", "a2", "a3", "a4", "a5", "a6", "fixture"};
  expect_as_made(converted({write("t.csv", table(""))}).session);
}

TEST_F(TouchTables, ATableAFixtureIsNamedAfterItsFile) {
  std::vector<std::filesystem::path> files;
  for (int f = 0; f < 5; ++f)
    files.push_back(
        write(made.fixtures[static_cast<std::size_t>(f)].id + ".csv", table("time,a1,a2,a3,a4,a5,a6", 1, false, f)));
  options_.fixtures = {"plane plate_front", "plane plate_left", "plane plate_high", "point socket_left",
                       "point socket_right"};
  expect_as_made(converted(files).session);
}

TEST_F(TouchTables, FilesOfOneNameInTwoFoldersAreTwoFixturesAndNeedNoHeader) {
  const auto joints = [&](int fixture) {
    std::string text;
    for (const Observation& o : made.observations)
      if (o.part == fixture) text += fmt::format("{:.18e}\n", fmt::join(o.position, ","));
    return text;
  };
  options_.apart.clear();
  const Conversion c = converted({write("left/hole_0.csv", joints(3)), write("right/hole_0.csv", joints(4))});
  ASSERT_EQ(c.session.fixtures.size(), 2u);
  EXPECT_EQ(c.session.fixtures[0].id, "left_hole_0");
  EXPECT_EQ(c.session.fixtures[1].id, "right_hole_0");
  EXPECT_EQ(c.session.fixtures[1].kind, &fixtures::point);
  EXPECT_THAT(c.took, Contains(HasSubstr("right/hole_0.csv: a table of touches")));
  EXPECT_THAT(c.notes, Contains(HasSubstr("its columns are taken for a1 a2 a3 a4 a5 a6")));
  EXPECT_LT(fit(c.session).residual_rms, 1e-4);
}

TEST_F(TouchTables, LinesOfOneTouchCountOnce) {
  std::string text = "pose,a1,a2,a3,a4,a5,a6,fixture\n";
  for (const Observation& o : made.observations)
    for (int copy = 0; copy < 3; ++copy) {  // a line for every marker that a camera saw meanwhile
      text += fmt::format("{}", o.id);
      for (const double q : o.position) text += fmt::format(",{}", q);
      text += "," + made.fixtures[static_cast<std::size_t>(o.part)].id + "\n";
    }
  const Conversion c = converted({write("t.csv", text)});
  expect_as_made(c.session);
  EXPECT_THAT(c.notes, Contains(HasSubstr("200 lines are of a touch that the line before is of too")));
}

TEST_F(TouchTables, ReadingsHaveUnitsOrAreRefused) {
  options_.apart.clear();
  options_.fixtures = {"gauge dial xyz=0.5,0,0.3 axis=0,0,1 sigma=5e-6"};
  const auto with = [&](const std::string& column, const std::string& value) {
    return write("g.csv", "a1,a2,a3,a4,a5,a6,fixture," + column + "\n0,0.1,0.2,0,0.3,0,dial," + value +
                              "\n0,0.2,0.2,0,0.3,0,dial," + value + "\n");
  };
  EXPECT_NEAR(converted({with("value [mm]", "3.25")}).session.observations[0].sightings[0].point->z(), 3.25e-3, 1e-15);
  EXPECT_NEAR(converted({with("reading [um]", "120")}).session.observations[0].sightings[0].point->z(), 1.2e-4, 1e-15);
  EXPECT_THAT(refusal({with("value", "3.25")}), HasSubstr("have no unit"));
  EXPECT_THAT(refusal({with("value [yd]", "3.25")}), HasSubstr("none of mm, um and m"));
  EXPECT_THAT(refusal({with("value [mm]", "")}), HasSubstr("has no reading"));
  options_.fixtures = {"length bar to=0.2,0.1,0.2 value=0.3"};
  EXPECT_EQ(converted({write("b.csv", "a1,a2,a3,a4,a5,a6\n0,0.1,0.2,0,0.3,0\n0,0.2,0.2,0,0.3,0\n")})
                .session.observations[1]
                .sightings[0]
                .point->x(),
            0.3);
}

TEST_F(TouchTables, WhatIsMissingIsNamed) {
  options_.apart.clear();
  const std::string header = "a1,a2,a3,a4,a5,a6,fixture\n", row = "0,0.1,0.2,0,0.3,0,";
  EXPECT_THAT(refusal({write("t.csv", header + row + "thing\n" + row + "thing\n")}),
              HasSubstr("nothing says what the fixture \"thing\" is"));
  options_.fixtures = {"sphere ball"};
  EXPECT_THAT(refusal({write("t.csv", header + row + "ball\n" + row + "ball\n")}), HasSubstr("write what it is"));
  options_.fixtures = {"gauge dial"};
  EXPECT_THAT(refusal({write("t.csv", header + row + "dial\n" + row + "dial\n")}),
              HasSubstr("does not say where it is"));
  options_.fixtures = {"plane plate"};
  EXPECT_THAT(refusal({write("t.csv", "a,b,fixture\n1,2,plate\n1,2,plate\n")}), HasSubstr("has the name of a joint"));
  EXPECT_FALSE(std::filesystem::exists(options_.out)) << "nothing half made stays";
}

}  // namespace
}  // namespace handsight
