// SPDX-License-Identifier: Apache-2.0
// The sigma that a measurement may bring: read, refused, kept by what is written.
#include <gmock/gmock.h>

#include <cmath>

#include "base/files.h"
#include "session_texts.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

Session read_text(const TemporaryFolder& folder, const std::string& text) {
  replace_file(folder.path / "robot.urdf", small_robot);
  replace_file(folder.path / "session.xml", text);
  return read_session(folder.path);
}

TEST(MeasurementSigma, IsReadAndSurvivesSaving) {
  const TemporaryFolder folder;
  Session session =
      read_text(folder, changed(small_session, R"(right="110 210" by="hand")",
                                R"(right="110 210" left_sigma="0.1 0.2 -0.01" right_sigma="0.3 0.4 0.02" by="hand")"));
  EXPECT_TRUE(session.notes.empty());
  const auto marked = [](const Session& s) {
    for (const Observation& o : s.observations)
      for (const Sighting& one : o.sightings)
        if (one.marker == 2) return one;
    return Sighting{};
  };
  const auto sigma = [&](const Session& s, int camera) { return seen_by(marked(s), camera)->sigma; };
  ASSERT_TRUE(sigma(session, 0) && sigma(session, 1));
  EXPECT_EQ(sigma(session, 0)->uv, -0.01);
  EXPECT_EQ(usual_sigma(session), 0.2) << "the session's declared one";
  session.sigma_pixel.reset();
  EXPECT_NEAR(usual_sigma(session), std::sqrt(0.125), 1e-12) << "the larger of the two that are told";
  for (Observation& o : session.observations)
    for (Sighting& s : o.sightings)
      if (s.marker == 0) seen_by(s, 0)->sigma = PixelSigma{0.5, 0.6, 0};
  save_session(session);
  const Session again = read_session(folder.path);
  ASSERT_TRUE(sigma(again, 1));
  EXPECT_EQ(sigma(again, 1)->v, 0.4);
  EXPECT_THAT(read_file(folder.path / "session.xml"), HasSubstr(R"(left_sigma="0.5 0.6 0")"));
}

TEST(MeasurementSigma, OfATrackersPoint) {
  const TemporaryFolder folder;
  const Session session =
      read_text(folder, changed(small_tracker_session, R"(point="1 2 3")", R"(point="1 2 3" sigma="1e-4")"));
  EXPECT_EQ(*session.observations[0].sightings[0].point_sigma, 1e-4);
  const std::string negative = changed(small_tracker_session, R"(point="1 2 3")", R"(point="1 2 3" sigma="-1")");
  EXPECT_THAT(find_refusal([&] { read_text(folder, negative); }), HasSubstr("sigma"));
}

TEST(MeasurementSigma, ThatIsNoneIsRefusedInASentence) {
  const TemporaryFolder folder;
  for (const std::string wrong : {"0 0.2 0", "0.1 -0.2 0", "0.1 0.2 0.021", "0.1 0.2"}) {
    const std::string text = changed(small_session, R"(left="10 20")", R"(left="10 20" left_sigma=")" + wrong + "\"");
    const std::string why = find_refusal([&] { read_text(folder, text); });
    EXPECT_THAT(why, HasSubstr("left_sigma")) << wrong;
    EXPECT_THAT(why, HasSubstr("line 21")) << wrong;
  }
  const std::string unseen = changed(small_session, R"(left="10 20")", R"(left="10 20" right_sigma="0.1 0.1 0")");
  EXPECT_THAT(find_refusal([&] { read_text(folder, unseen); }), HasSubstr("did not see the marker"));
}

}  // namespace
}  // namespace handsight
