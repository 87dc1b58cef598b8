// SPDX-License-Identifier: Apache-2.0
#include "widgets/scene/robot_view.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QHBoxLayout>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "base/files.h"
#include "robot/urdf.h"
#include "widgets/base/apply_theme.h"
#include "widgets/base/theme.h"
#include "widgets/mouse.h"
#include "widgets/sample_data.h"

namespace handsight::widgets {
namespace {

/// How many of the picture's pixels are neither ground nor nearly so.
double share_of_marks(const QImage& image) {
  const QColor ground = colors().panel;
  int count = 0, all = 0;
  for (int y = 0; y < image.height(); y += 3) {
    for (int x = 0; x < image.width(); x += 3, ++all) {
      const QColor c = image.pixelColor(x, y);
      if (std::abs(c.red() - ground.red()) + std::abs(c.green() - ground.green()) > 60) ++count;
    }
  }
  return static_cast<double>(count) / all;
}

class RobotViewTest : public testing::Test {
 protected:
  void SetUp() override {
    data_ = test::read_sample("hundred_poses");
    view_.set_robot(data_.session.robot, folder(data_.session));
    view_.set_posture(data_.posture(0));
    view_.set_tcp(data_.root_from_tcp(0));
    view_.set_cameras(data_.cameras(0));
  }
  test::SampleData data_;
  RobotView view_;
};

TEST_F(RobotViewTest, ShowsTheRobotInBothThemesAndAfterReparenting) {
  test::show(view_, {500, 400});
  QTest::qWait(200);
  EXPECT_GT(share_of_marks(view_.picture()), 0.02);
  EXPECT_EQ(view_.picture().pixelColor(3, 3).alpha(), 255);
  QWidget window;
  auto* layout = new QHBoxLayout(&window);
  layout->addWidget(&view_);
  test::show(window, {600, 500});
  QTest::qWait(200);
  EXPECT_GT(share_of_marks(view_.picture()), 0.02);
  apply_theme(*qApp, ThemeKind::dark);
  QTest::qWait(200);
  EXPECT_EQ(view_.picture().pixelColor(3, 60), theme_colors(ThemeKind::dark).panel);
  apply_theme(*qApp, ThemeKind::light);
  view_.setParent(nullptr);
}

/// The links between what carries the cameras and the TCP: what is calibrated.
std::vector<int> links_of_the_chain(const Session& session) {
  const std::vector<int> to_tcp = joints_to(session.robot, find_link(session.robot, session.tcp));
  const std::vector<int> to_mount = joints_to(session.robot, find_link(session.robot, session.mount.link));
  std::vector<int> links;
  for (const auto& [path, other] : {std::pair(to_tcp, to_mount), std::pair(to_mount, to_tcp)})
    for (const int joint : path)
      if (std::find(other.begin(), other.end(), joint) == other.end())
        links.push_back(session.robot.joints[static_cast<std::size_t>(joint)].child_link);
  return links;
}

void expect_in_sight(RobotView& view, const QSize& size, const std::vector<Vector3>& places) {
  constexpr double most = 0.95;
  for (const Vector3& place : places) {
    const auto at = view.to_screen(place);
    ASSERT_TRUE(at);
    EXPECT_GT(at->x(), (1 - most) * size.width());
    EXPECT_LT(at->x(), most * size.width());
    EXPECT_GT(at->y(), (1 - most) * size.height());
    EXPECT_LT(at->y(), most * size.height());
  }
}

constexpr QSize shapes[] = {QSize(370, 178), QSize(460, 400), QSize(300, 600)};
constexpr StandardView far_views[] = {StandardView::all, StandardView::front, StandardView::left, StandardView::top};

TEST_F(RobotViewTest, ArmAndCamerasAreSeenInViewsOfAnyShapeBelowTheButtons) {
  std::vector<Vector3> places{data_.root_from_tcp(0).translation};
  for (const SceneCamera& camera : data_.cameras(0)) places.push_back(camera.root_from_camera.translation);
  const std::vector<int> chain = links_of_the_chain(data_.session);
  ASSERT_GE(chain.size(), 9U);
  for (const int link : chain) places.push_back(data_.posture(0)[static_cast<std::size_t>(link)].translation);
  for (const QSize& size : shapes) {
    test::show(view_, size);
    for (const StandardView view : far_views) {
      view_.look(view);
      view_.picture();
      expect_in_sight(view_, size, places);
    }
  }
}

TEST_F(RobotViewTest, ARobotThatLeavesThePictureIsFollowedUntilTheUserMovesTheEye) {
  test::show(view_, {430, 170});
  view_.picture();
  const auto moved = [&](double metres) {
    std::vector<Rigid> links = data_.posture(0);
    for (Rigid& link : links) link.translation.z() += metres;
    Rigid tcp = data_.root_from_tcp(0);
    tcp.translation.z() += metres;
    std::vector<SceneCamera> cameras = data_.cameras(0);
    for (SceneCamera& camera : cameras) camera.root_from_camera.translation.z() += metres;
    view_.set_posture(links);
    view_.set_tcp(tcp);
    view_.set_cameras(cameras);
    view_.picture();
    return view_.to_screen(tcp.translation);
  };
  const QRectF sight(QPointF(0, 0), QSizeF(view_.size()));
  const auto before = view_.to_screen(data_.root_from_tcp(0).translation), near_by = moved(0.02);
  ASSERT_TRUE(before && near_by);
  EXPECT_GT(std::abs(near_by->y() - before->y()), 0.5) << "what stays in the picture does not move the eye";
  const auto far = moved(3);
  ASSERT_TRUE(far);
  EXPECT_TRUE(sight.contains(*far));
  QTest::keyClick(&view_, Qt::Key_Left);
  const auto away = moved(0);
  EXPECT_FALSE(away && sight.contains(*away)) << "the user has looked there";
}

TEST_F(RobotViewTest, WithoutThemTheWholeRobotIsSeen) {
  std::vector<Vector3> places;
  for (const Rigid& link : data_.posture(0)) places.push_back(link.translation);
  view_.set_tcp(std::nullopt);
  view_.set_cameras({});
  for (const QSize& size : shapes) {
    test::show(view_, size);
    for (const StandardView view : far_views) {
      view_.look(view);
      view_.picture();
      expect_in_sight(view_, size, places);
    }
  }
}

/// Places that differ between two pictures.
std::vector<QPoint> changes(const QImage& a, const QImage& b) {
  std::vector<QPoint> places;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.pixel(x, y) != b.pixel(x, y)) places.emplace_back(x, y);
  return places;
}

/// How much of the box round these pixels was drawn on before: robot, cameras' cones.
double share_drawn_on(const QImage& before, const QRect& box) {
  const QColor ground = colors().panel;
  int drawn = 0;
  for (int y = box.top(); y <= box.bottom(); ++y)
    for (int x = box.left(); x <= box.right(); ++x) {
      const QColor c = before.pixelColor(x, y);
      if (std::abs(c.red() - ground.red()) + std::abs(c.green() - ground.green()) + std::abs(c.blue() - ground.blue()) >
          120)
        ++drawn;
    }
  return drawn / (1.0 * box.width() * box.height());
}

TEST_F(RobotViewTest, TheCamerasNamesStandBesideTheRobotOnLeaders) {
  const auto with_names = [&](bool first, bool second) {
    std::vector<SceneCamera> cameras = data_.cameras(0);
    cameras[0].name = first ? "left" : "";
    cameras[1].name = second ? "right" : "";
    view_.set_cameras(cameras);
    return view_.picture(1);
  };
  for (const QSize& size : {QSize(370, 260), QSize(460, 400)}) {
    test::show(view_, size);
    const QImage bare = with_names(false, false);
    for (const bool is_first : {true, false}) {
      // The plate is where most changes lie close together: the leader is thin.
      const std::vector<QPoint> places = changes(bare, with_names(is_first, !is_first));
      ASSERT_GT(places.size(), 30U);
      QRect plate;
      std::size_t most = 0;
      for (const QPoint& at : places) {
        const QRect box(at.x(), at.y() - 7, 26, 14);
        const auto inside = static_cast<std::size_t>(
            std::count_if(places.begin(), places.end(), [&](const QPoint& p) { return box.contains(p); }));
        if (inside > most) most = inside, plate = box;
      }
      EXPECT_LT(share_drawn_on(bare, plate & bare.rect()), 0.15) << is_first << " at " << size.width();
    }
  }
}

TEST_F(RobotViewTest, AnArrowIsThickEnoughToBeSeenFromAfar) {
  test::show(view_, {360, 270});
  const QImage before = view_.picture(1);
  const Vector3 from = data_.root_from_tcp(0).translation + Vector3(0, 0, 0.25);
  view_.set_arrow_magnification(1);
  view_.set_arrows({{17, from, Vector3(0, 0, 0.1), 30.0, 12}});
  const QImage after = view_.picture(1);
  const QPointF a = *view_.to_screen(from), b = *view_.to_screen(*view_.arrow_tip(17));
  const double length = std::hypot(a.x() - b.x(), a.y() - b.y());
  ASSERT_GT(length, 6);
  int dark = 0;
  for (const QPoint& p : changes(before, after))
    if (QRectF(a, b).normalized().adjusted(-5, -5, 5, 5).contains(p) && after.pixelColor(p).lightness() < 120) ++dark;
  EXPECT_GT(dark, 1.5 * length);
}

/// What does not differ by more than a few px is no second robot in the first one's skin.
TEST_F(RobotViewTest, TheGhostIsDrawnOnlyWhereItDiffers) {
  test::show(view_, {460, 400});
  const QImage before = view_.picture(1);
  std::vector<Rigid> bent = data_.posture(0);
  for (Rigid& link : bent) link.translation.x() += 0.0002;
  view_.set_ghost_magnification(1);
  view_.set_ghost(bent);
  const QRect robot(60, 40, 340, 300);  // without the legend, which names the ghost
  EXPECT_EQ(before.copy(robot), view_.picture(1).copy(robot));
  bent.back().translation.x() += 0.3;
  view_.set_ghost(bent);
  EXPECT_NE(before.copy(robot), view_.picture(1).copy(robot));
}

/// What is behind it stays in sight: it covers a few lines, not the room of a second body.
TEST_F(RobotViewTest, TheGhostIsAnOutline) {
  test::show(view_, {460, 400});
  const QImage before = view_.picture(1);
  std::vector<Rigid> bent = data_.posture(0);
  for (Rigid& link : bent) link.translation.y() += 0.25;
  view_.set_ghost_magnification(1);
  view_.set_ghost(bent);
  const QRect robot(60, 40, 340, 300);
  std::vector<QPoint> places = changes(before, view_.picture(1));
  std::erase_if(places, [&](const QPoint& at) { return !robot.contains(at); });
  QRect reach;
  for (const QPoint& at : places) reach |= QRect(at, QSize(1, 1));
  EXPECT_GT(places.size(), 1000U) << "it is seen";
  EXPECT_GT(reach.width() * reach.height(), 40000) << "as large as the robot";
  EXPECT_LT(static_cast<double>(places.size()), 0.15 * reach.width() * reach.height());
}

TEST_F(RobotViewTest, EdgesAreSmoothOnceNothingMoves) {
  test::show(view_, {460, 400});
  const auto shown = [&] { return view_.grab().toImage().convertToFormat(QImage::Format_RGB32); };
  const QRect robot(60, 40, 340, 300);
  const auto greys = [&](const QImage& image) { return share_of_marks(image.copy(robot)); };
  const QImage smooth = view_.picture(1).convertToFormat(QImage::Format_RGB32);
  ASSERT_GT(greys(smooth), 0.02);
  view_.look(StandardView::front);
  view_.look(StandardView::all);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown().copy(robot) == smooth.copy(robot); }, 5000));
}

TEST_F(RobotViewTest, ClickOnAnArrowChoosesItsObservation) {
  const Vector3 from = data_.root_from_tcp(0).translation + Vector3(0, 0, 0.5);
  view_.set_arrows(
      {{17, from, Vector3(0, 0, 0.01), 3.0, 12}, {18, from + Vector3(0, 0.4, 0), Vector3(0, 0, 0.01), 3.0, 12}});
  view_.set_arrow_magnification(20);
  test::show(view_, {500, 400});
  QTest::qWait(200);
  QSignalSpy selected(&view_, &RobotView::observation_selected), hovered(&view_, &RobotView::observation_hovered);
  const Vector3 tip = *view_.arrow_tip(17);
  EXPECT_NEAR((tip - from).norm(), 0.2, 1e-9);
  const QPointF middle = (*view_.to_screen(from) + *view_.to_screen(tip)) / 2;
  test::hover(&view_, middle);
  ASSERT_EQ(hovered.size(), 1);
  EXPECT_EQ(hovered[0][0].toLongLong(), 17);
  test::click(&view_, middle);
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected[0][0].toLongLong(), 17);
}

TEST_F(RobotViewTest, WhereAPointIsSaidToBeItIsDrawn) {
  const Vector3 at = data_.root_from_tcp(0).translation + Vector3(0.3, 0, 0.6);
  test::show(view_, {500, 400});
  QTest::qWait(200);
  const QImage before = view_.picture();
  SceneMarker marker{0, at, SceneMarkerRole::measured, 30.0};
  view_.set_markers({marker});
  view_.look(StandardView::tcp);
  view_.look(StandardView::all);
  QTest::qWait(200);
  const QImage after = view_.picture();
  const QPointF where = *view_.to_screen(at) * view_.devicePixelRatioF();
  int nearest = 1000;
  for (int y = 0; y < after.height(); ++y)
    for (int x = 0; x < after.width(); ++x)
      if (after.pixelColor(x, y).red() < 110 && after.pixelColor(x, y) != before.pixelColor(x, y))
        nearest = std::min(nearest, static_cast<int>(std::hypot(x - where.x(), y - where.y())));
  EXPECT_LE(nearest, 3);
}

TEST_F(RobotViewTest, ClickOnALinkNamesTheJointThatMovesIt) {
  test::show(view_, {500, 400});
  view_.look(StandardView::tcp);
  QTest::qWait(200);
  QSignalSpy joint(&view_, &RobotView::joint_selected);
  for (int y = 380; y > 20 && joint.isEmpty(); y -= 20)
    for (int x = 20; x < 480 && joint.isEmpty(); x += 20) test::click(&view_, QPointF(x, y));
  ASSERT_FALSE(joint.isEmpty());
  const int index = find_joint(data_.session.robot, joint[0][0].toString().toStdString());
  ASSERT_GE(index, 0);
  EXPECT_TRUE(data_.session.robot.joints[static_cast<std::size_t>(index)].moves());
}

TEST_F(RobotViewTest, DraggingOrbitsAndNeverRolls) {
  test::show(view_, {500, 400});
  const Vector3 low(0, 0, 0), high(0, 0, 1);
  test::drag(&view_, {250, 200}, {330, 160});
  const QPointF a = *view_.to_screen(low), b = *view_.to_screen(high);
  EXPECT_LT(b.y(), a.y());
  QSignalSpy selected(&view_, &RobotView::observation_selected);
  test::drag(&view_, {250, 200}, {280, 260});
  EXPECT_TRUE(selected.isEmpty());
}

TEST_F(RobotViewTest, TheRightButtonZooms) {
  test::show(view_, {500, 400});
  view_.picture();
  const Vector3 low(0, 0, 0), high(0, 0, 1);
  const auto height = [&] { return view_.to_screen(low)->y() - view_.to_screen(high)->y(); };
  const double before = height();
  test::drag(&view_, {250, 200}, {250, 140}, {}, Qt::RightButton);
  EXPECT_GT(height(), 1.2 * before);
  test::drag(&view_, {250, 140}, {250, 260}, {}, Qt::RightButton);
  EXPECT_LT(height(), before);
}

TEST(RobotViewMeshes, ThatLieAboutTheirPointsAreASentence) {
  QTemporaryDir folder;
  const std::filesystem::path home = folder.path().toStdString();
  replace_file(home / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999\n");
  replace_file(home / "b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -5 -6 -7\n");
  replace_file(home / "good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//9999999\n");
  std::string links;
  for (const char* mesh : {"a.obj", "b.obj", "good.obj", "../elsewhere.obj"})
    links += std::string("<visual><geometry><mesh filename=\"") + mesh + "\"/></geometry></visual>";
  RobotView view;
  view.set_robot(parse_urdf("<robot name=\"r\"><link name=\"l\">" + links + "</link></robot>", "r.urdf", nullptr),
                 home);
  view.set_posture({Rigid{}});
  test::show(view, {300, 200});
  QTest::qWait(100);
  ASSERT_EQ(view.notes().size(), 3u);
  EXPECT_TRUE(view.notes()[0].contains("a.obj, line 4")) << view.notes()[0].toStdString();
  EXPECT_TRUE(view.notes()[1].contains("b.obj, line 4"));
  EXPECT_TRUE(view.notes()[2].contains("is not in the robot's folder"));
}

/// A large mesh does not hold up the window: the robot stands there without it, and has it when it has been read.
TEST(RobotViewMeshes, ThatAreLargeComeLater) {
  QTemporaryDir folder;
  const std::filesystem::path home = folder.path().toStdString();
  std::string mesh;
  for (int i = 0; i < 300000; ++i) mesh += fmt::format("v {} 0.125 0.25\n", i % 100);
  for (int i = 3; i < 300000; ++i) mesh += fmt::format("f {} {} {}\n", i - 2, i - 1, i);
  replace_file(home / "large.obj", mesh + "f 1 2 99999999\n");
  RobotView view;
  QSignalSpy reported(&view, &RobotView::notes_changed);
  view.set_robot(parse_urdf("<robot name=\"r\"><link name=\"l\"><visual><geometry><mesh filename=\"large.obj\"/>"
                            "</geometry></visual></link></robot>",
                            "r.urdf", nullptr),
                 home);
  EXPECT_TRUE(view.is_reading());
  EXPECT_TRUE(view.notes().empty());
  view.set_posture({Rigid{}});
  test::show(view, {300, 200});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !view.is_reading(); }, 60000));
  EXPECT_EQ(reported.size(), 1);
  ASSERT_EQ(view.notes().size(), 1u);
  EXPECT_TRUE(view.notes()[0].contains("large.obj, line")) << view.notes()[0].toStdString();
}

}  // namespace
}  // namespace handsight::widgets
