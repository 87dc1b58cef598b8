// SPDX-License-Identifier: Apache-2.0
// A tracker that sees one reflector at a time: a file for each, several lines for each pose, or a number in each line.
#include "convert/convert_fixture.h"

namespace handsight {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class OneByOne : public Convert {
 protected:
  std::string point(std::size_t observation, std::size_t marker) const {
    const Vector3 p = 1000 * *truth.session.observations[observation].sightings[marker].point;
    return fmt::format("{:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
  }
  std::string readings(bool with_marker) const {
    std::string text;
    for (std::size_t i = 0; i < truth.session.observations.size(); ++i) {
      for (Eigen::Index j = 0; j < 6; ++j) text += fmt::format("{:.12g}\t", truth.session.observations[i].position[j]);
      text += with_marker ? fmt::format("{}\n", 1 + i % 3) : "\n";
    }
    return text;
  }
  std::size_t count() const { return truth.session.observations.size(); }
};

TEST_F(OneByOne, AFileForEachReflector) {
  std::vector<std::filesystem::path> files{write("joints.txt", readings(false))};
  for (std::size_t m = 0; m < 3; ++m) {
    std::string text;
    for (std::size_t i = 0; i < count(); ++i) text += point(i, m);
    files.push_back(write(fmt::format("position_{}.txt", m + 1), text));
  }
  const Conversion c = converted(files);
  EXPECT_EQ(c.session.marker_count, 3);
  expect_good(c.session);
  EXPECT_THAT(c.notes, Contains(AllOf(HasSubstr("position_3.txt"), HasSubstr("keep their distances"))));
}

TEST_F(OneByOne, FilesOfDifferentThingsAreRefused) {
  std::string first, other;
  for (std::size_t i = 0; i < count(); ++i) first += point(i, 0), other += point(count() - 1 - i, 1);
  EXPECT_THAT(refusal({write("joints.txt", readings(false)), write("a.txt", first), write("b.txt", other)}),
              HasSubstr("b.txt is a table of points, and a.txt is one too"));
}

TEST_F(OneByOne, SeveralLinesForEachPose) {
  std::string text;
  for (std::size_t i = 0; i < count(); ++i)
    for (std::size_t m = 0; m < 3; ++m) text += point(i, m);
  const Conversion c = converted({write("joints.txt", readings(false)), write("points.txt", text)});
  EXPECT_EQ(c.session.marker_count, 3);
  expect_good(c.session);
  EXPECT_THAT(c.notes, Contains(HasSubstr("3 measurements for each line")));
}

TEST_F(OneByOne, ANumberInEachLineOfJoints) {
  std::string text;
  for (std::size_t i = 0; i < count(); ++i) text += point(i, i % 3);
  const std::vector<std::filesystem::path> files{write("joints.txt", readings(true)), write("points.txt", text)};
  // Taken for a time the first joint would put the rows in another order.
  EXPECT_THAT(refusal(files), AllOf(HasSubstr("--table-columns"), HasSubstr("marker")));
  options_.columns = {"a1", "a2", "a3", "a4", "a5", "a6", "marker"};
  const Conversion c = converted(files);
  EXPECT_EQ(c.session.marker_count, 3);
  expect_good(c.session);
  EXPECT_THAT(c.notes, Contains(HasSubstr("one of 3 markers")));
  EXPECT_THAT(c.notes, Not(Contains(HasSubstr("left out"))));
}

}  // namespace
}  // namespace handsight
