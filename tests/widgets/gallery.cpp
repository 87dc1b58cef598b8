// SPDX-License-Identifier: Apache-2.0
// widget_gallery FOLDER [light|dark] [all|explain|times]: shows every widget with a sample session and writes a picture
// of each; explain: those of the Explain workspace alone; times: how long they take to paint, no pictures.
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QTest>
#include <functional>

#include "widgets/base/apply_theme.h"
#include "widgets/base/read_out_line.h"
#include "widgets/base/theme.h"
#include "widgets/gallery_explain.h"
#include "widgets/images/loupe.h"
#include "widgets/images/triangle_panel.h"
#include "widgets/lists/attribution_bar.h"
#include "widgets/lists/decision_list.h"
#include "widgets/lists/model_panel.h"
#include "widgets/lists/observation_strip.h"
#include "widgets/lists/three_numbers.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/plots/scatter_plot.h"
#include "widgets/sample_data.h"

namespace {

using namespace handsight;
using namespace handsight::widgets;
using handsight::test::SampleData;

QString folder_of_pictures;

void keep(QWidget& widget, const QString& name, const QSize& size, bool is_scene = false) {
  widget.resize(size);
  widget.show();
  if (!QTest::qWaitForWindowExposed(&widget)) qFatal("no display");
  QTest::qWait(is_scene ? 400 : 120);
  const QImage image = is_scene ? static_cast<RobotView&>(widget).picture() : widget.grab().toImage();
  image.save(folder_of_pictures + "/" + name + ".png");
  widget.hide();
}

void strips(const SampleData& data) {
  ObservationStrip strip;
  strip.set_cells(data.cells());
  strip.set_selected(37);
  strip.set_highlighted({50, 51, 52});
  keep(strip, "strip_100", {1152, 72});
  ObservationStrip many;
  many.set_cells(test::many_cells(10000));
  many.set_selected(4321);
  keep(many, "strip_10000", {1152, 72});
  ObservationStrip empty;
  keep(empty, "strip_empty", {1152, 72});
}

void numbers(const SampleData& data) {
  ThreeNumbers three;
  ErrorNumbers n;
  n.now = data.report.held_out.rms_pixel;
  n.noise = data.noise;
  n.excluded_note = "7 excluded: 9.4 px";
  n.versions = {{"TCP->Body", 9.0, 9.4, false, {}},
                {"+ joint_elasticity", 1.2, 1.4, false, {}},
                {"+ payload", 1.2, 1.5, true, "on unseen observations the error would rise"},
                {"+ joint_offset", 0.21, 0.24, false, {}}};
  three.set_numbers(n);
  keep(three, "three_numbers", three.sizeHint());
  ThreeNumbers none;
  keep(none, "three_numbers_empty", none.sizeHint());
}

void panels(const SampleData& data) {
  ModelPanel panel;
  panel.set_headline("9.1 px");
  ModelEffect body{"tcp", "TCP→Body", {}, true, true};
  body.parameters = {
      {"", "x", 12.3456, 0.0512, "mm", {}}, {"", "y", -103.2, 0.06, "mm", {}}, {"", "rz", -0.0004, 0.02, "deg", {}}};
  ModelEffect elastic{"joint_elasticity", "Joint elasticity", "The joint gives way", true};
  elastic.parameters = {{"right_arm_2", "compliance", 1.18e-4, 3e-6, "rad/(N m)", 1e-4},
                        {"right_arm_4", "compliance", -4.1e-4, 3e-5, "rad/(N m)", 1e-4}};
  elastic.note = "The fit wants -4.1e-4; 1e-4 is plausible. Probably another cause.";
  elastic.note_is_warning = true;
  ModelEffect payload{"payload", "Payload"};
  payload.note = "Cannot be seen on these poses.";
  payload.can_change = false;
  panel.set_effects({body, elastic, payload, {"base_tilt", "Base tilt"}});
  panel.set_selected_joint("right_arm_2");
  keep(panel, "model_panel", {288, 520});
  ObservationTable table;
  table.set_rows(data.rows());
  table.set_selected(10);
  keep(table, "table", {420, 420});
  table.set_filter(RowFilter::excluded);
  table.set_filter(RowFilter::rejected);
  keep(table, "table_filtered", {420, 300});
  AttributionBar attribution;
  attribution.set_attribution(ErrorAttribution{0.06, 0.04, 0.9});
  attribution.set_sentence("Marker 2, right image, 3.4 px further left. An error under 0.9 px here could not be seen.");
  keep(attribution, "blame", {420, attribution.heightForWidth(420)});
  DecisionList list;
  list.set_entries(
      {{21, CellState::used, {}, {0.41, SizeUnit::pixel}, 2.0, 12},
       {22, CellState::rejected, "joints moved 0.7 deg since observation 21; 2 deg count as new", {}, {}, 12},
       {23, CellState::used, {}, {0.2, SizeUnit::pixel}, 1.0, 12}});
  list.set_selected(22);
  keep(list, "decisions", {328, 160});
  DecisionList no_decisions;
  keep(no_decisions, "decisions_empty", {328, 100});
  ReadOutLine line;
  line.set_crumbs({"obs 37", "marker 2", "left 6.4 px"});
  line.set_pointer("q4 1.31 rad, 2.1 px");
  keep(line, "read_out", {900, 24});
}

void triangle() {
  TrianglePanel panel;
  TriangleState state;
  state.markers = {{0, true, true, Vector3(0.02, 0.01, 0.84), 0.0008, 0.2},
                   {1, true, true, Vector3(0.07, 0.02, 0.85), 0.0009, 0.3},
                   {2, true, true, Vector3(0.04, 0.06, 0.83), 0.0008, 0.1}};
  state.sides = {{0, 1, 52.0, 0.4}, {1, 2, 53.9, 0.5}, {2, 0, 54.8, 0.5}};
  state.verdict = TriangleVerdict::good;
  state.sentence = "The triangle will do: the hand's rotation would be known to 0.3 deg.";
  state.can_use = true;
  state.selected_marker = 1;
  panel.set_state(state);
  panel.set_candidates(1, {{4, 0.3, 0.851, "fits", true}, {9, 1.1, 0.62, "−14 mm", false}});
  keep(panel, "triangle", {288, 640});
  TrianglePanel empty;
  TriangleState none;
  none.sentence = "Click a marker's corner in the left image.";
  empty.set_state(none);
  keep(empty, "triangle_empty", {288, 400});
}

void plots(const SampleData& data) {
  ConvergenceBoard board;
  board.set_points(data.convergence());
  board.set_selected(20);
  keep(board, "convergence", {980, 324});
  HistogramPlot histogram;
  histogram.set_title("Residuals");
  histogram.set_cells(data.cells());
  histogram.set_noise(data.noise, "px");
  histogram.set_threshold(20);
  keep(histogram, "histogram", {420, 320});
  HistogramPlot empty;
  empty.set_title("Residuals");
  empty.set_empty_text("No fit yet.");
  keep(empty, "histogram_empty", {332, 240});
  ResidualMap map;
  map.set_title("Over the image");
  map.set_points(data.map_points());
  map.set_selected(30);
  keep(map, "map_arrows", {420, 340});
  map.set_lens(MapLens::direction);
  keep(map, "map_direction", {420, 340});
  map.set_lens(MapLens::size);
  keep(map, "map_size", {420, 340});
  ScatterPlot repeatability;
  repeatability.set_title("Residual down against the torque of arm_2");
  repeatability.set_axes("torque of arm_2", "N m", "residual down", "px");
  std::vector<ScatterPoint> points;
  std::vector<TrendPoint> trend;
  for (int i = 0; i < 100; ++i) {
    const double x = -40 + 0.8 * i, y = 0.2 * x + 1.5 * std::sin(7.0 * i);
    points.push_back({i, x, y, std::abs(y) / 0.6, 4});
    trend.push_back({x, 0.2 * x, 0.2 * x - 0.8, 0.2 * x + 0.8});
  }
  repeatability.set_points(points);
  repeatability.set_trend(trend);
  for (TrendPoint& p : trend) p.y = 0.19 * p.x;
  repeatability.set_candidate(trend);
  repeatability.set_noise_band(0.6);
  repeatability.set_selected(80);
  keep(repeatability, "scatter", {592, 290});
}

void pictures_and_scene(const SampleData& data) {
  int with_image = 0;
  while (data.session.observations[static_cast<std::size_t>(with_image)].images[0].empty()) ++with_image;
  ImageView view;
  data.show_in(view, with_image);
  view.set_magnification(5);
  view.set_selected_marker(1);
  view.set_candidates(
      {{0, Vector2(320, 200), "0.3 px, 1.24 m", true}, {1, Vector2(380, 190), "1.1 px, 1.02 m", false}});
  view.set_epipolar_line({Vector2(0, 220), Vector2(640, 170)});
  keep(view, "image", {524, 430});
  ImageView none;
  none.set_title("Right");
  none.clear("This observation has no images.");
  keep(none, "image_empty", {300, 240});
  Loupe loupe;
  loupe.set_title("Left");
  loupe.set_image(view.image());
  loupe.set_center(view.marks().empty() ? Vector2(320, 240) : view.marks()[0].position);
  loupe.set_mark(view.marks().empty() ? Vector2(320, 240) : view.marks()[0].position);
  keep(loupe, "loupe", {260, 280});
  RobotView scene;
  scene.set_robot(data.session.robot, folder(data.session));
  scene.set_posture(data.posture(with_image));
  auto bent = data.posture(with_image);
  for (std::size_t i = 8; i < bent.size(); ++i) bent[i].translation.z() -= 0.002;
  scene.set_ghost(bent);
  scene.set_ghost_magnification(30);
  scene.set_cameras(data.cameras(with_image));
  const Rigid tcp = data.root_from_tcp(with_image);
  scene.set_tcp(tcp);
  scene.set_tcp_est(tcp * Rigid{Matrix3::Identity(), Vector3(0.01, 0.02, 0.01)});
  scene.set_markers({{0, tcp * Vector3(0.03, 0, 0.1), SceneMarkerRole::measured, 2.0},
                     {0, tcp * Vector3(0.035, 0, 0.1), SceneMarkerRole::predicted, {}}});
  scene.set_arrows(data.arrows());
  scene.set_arrow_magnification(10);
  scene.set_ellipsoid(SceneEllipsoid{tcp * Vector3(0, 0.1, 0), Matrix3::Identity() * 1e-4, 0.95});
  scene.set_selected_observation(data.arrows()[5].observation);
  keep(scene, "scene_all", {640, 480}, true);
  const QImage whole = scene.grab().toImage();  // with its buttons
  whole.save(folder_of_pictures + "/scene_grabbed.png");
  scene.look(StandardView::tcp);
  keep(scene, "scene_tcp", {640, 480}, true);
  scene.look(StandardView::camera);
  keep(scene, "scene_camera", {460, 400}, true);
  RobotView empty;
  keep(empty, "scene_empty", {320, 240}, true);
}

}  // namespace

int main(int argc, char** argv) {
  set_surface_format();
  QApplication application(argc, argv);
  const bool is_dark = argc > 2 && QString(argv[2]) == "dark";
  apply_theme(application, is_dark ? ThemeKind::dark : ThemeKind::light);
  folder_of_pictures = argc > 1 ? argv[1] : "gallery";
  const QString part = argc > 3 ? argv[3] : "all";
  if (part == "times") {
    test::explain_times();
    return 0;
  }
  QDir().mkpath(folder_of_pictures);
  test::explain_pictures([](QWidget& widget, const QString& name, const QSize& size) { keep(widget, name, size); });
  if (part == "explain") return 0;
  const SampleData data = test::read_sample("hundred_poses");
  strips(data);
  numbers(data);
  panels(data);
  triangle();
  plots(data);
  pictures_and_scene(data);
  return 0;
}
