// SPDX-License-Identifier: Apache-2.0
// The names of fixtures stand where they can be read: beside the 3D view's buttons and legend, not under them.
#include <gtest/gtest.h>

#include <QToolButton>

#include "widgets/mouse.h"
#include "widgets/sample_data.h"
#include "widgets/scene/robot_view.h"

namespace handsight::widgets {
namespace {

class FixtureLabels : public testing::Test {
 protected:
  void SetUp() override {
    data_ = test::read_sample("hundred_poses");
    view_.set_robot(data_.session.robot, folder(data_.session));
    view_.set_posture(data_.posture(0));
    view_.set_tcp(data_.root_from_tcp(0));
    test::show(view_, {500, 400});
    view_.picture(1);
  }
  /// Places (m, root frame) that are seen within a part of the view.
  std::vector<Vector3> places_seen_in(const QRect& part) {
    std::vector<Vector3> places;
    for (double x = -2; x <= 2; x += 0.1)
      for (double y = -2; y <= 2; y += 0.1)
        for (double z = -0.5; z <= 2.5; z += 0.1)
          if (const auto at = view_.to_screen({x, y, z}); at && part.contains(at->toPoint()))
            places.emplace_back(x, y, z);
    return places;
  }
  QImage with_a_fixture_called(const QString& name, const Vector3& at) {
    SceneFixture socket{.name = name, .shape = FixtureShape::ring};
    socket.root_from_fixture.translation = at;
    view_.set_fixtures({socket});
    return view_.picture(1);
  }
  /// What its name alone changes in the picture.
  QRegion find_label(const Vector3& at) {
    const QImage bare = with_a_fixture_called("", at), named = with_a_fixture_called("plate_2", at);
    QRegion changed;
    for (int y = 0; y < bare.height(); ++y)
      for (int x = 0; x < bare.width(); ++x)
        if (bare.pixel(x, y) != named.pixel(x, y)) changed += QRect(x, y, 1, 1);
    return changed;
  }
  void expect_beside(const QRect& covered, const QRect& near_by) {
    const std::vector<Vector3> places = places_seen_in(near_by);
    ASSERT_GT(places.size(), 3U);
    for (std::size_t i = 0; i < places.size(); i += places.size() / 3) {
      const QRegion label = find_label(places[i]);
      EXPECT_FALSE(label.isEmpty());
      EXPECT_TRUE((label & covered).isEmpty()) << "a name lies under what has its fixed place";
    }
  }
  test::SampleData data_;
  RobotView view_;
};

TEST_F(FixtureLabels, DoNotLieUnderTheButtons) {
  const QRect buttons = view_.findChild<QToolButton*>()->parentWidget()->geometry();
  expect_beside(buttons, QRect(buttons.left(), buttons.bottom() + 2, buttons.width() - 60, 12));
}

TEST_F(FixtureLabels, DoNotLieUnderTheCubeAndTheTriad) {
  const QRect corner(0, view_.height() - 60, 112, 60);
  expect_beside(corner, QRect(0, view_.height() - 70, 100, 10));
}

}  // namespace
}  // namespace handsight::widgets
