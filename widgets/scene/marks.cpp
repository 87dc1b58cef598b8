// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/marks.h"

#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

using Segment = std::pair<Vector3, Vector3>;

vtkSmartPointer<vtkActor> lines_actor(const std::vector<Segment>& segments, const QColor& color, double width) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const auto& [from, to] : segments) {
    const vtkIdType ids[2] = {points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data())};
    cells->InsertNextCell(2, ids);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  auto actor = make_actor(data, color);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  return actor;
}

/// The direction (z = 1) in which a pixel looks; the pinhole's where the distortion cannot be undone there.
Vector3 ray(const Camera& camera, double u, double v) {
  const auto xy = undistort(camera, {u, v});
  return xy ? Vector3(xy->x(), xy->y(), 1) : Vector3((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1);
}

}  // namespace

void ActorGroup::clear(vtkRenderer& renderer) {
  for (const auto& actor : actors) renderer.RemoveActor(actor);
  actors.clear();
}

void ActorGroup::add(vtkRenderer& renderer, const vtkSmartPointer<vtkActor>& actor) {
  renderer.AddActor(actor);
  actors.push_back(actor);
}

void show_axes(vtkRenderer& renderer, ActorGroup& group, const Rigid& root_from_frame, bool is_estimate) {
  for (std::size_t i = 0; i < 3; ++i) {
    const QColor color = is_estimate ? colors().tcp_est_axes[i] : colors().tcp_axes[i];
    const Vector3 origin = root_from_frame.translation;
    const Vector3 tip = root_from_frame * Vector3(axis_length * Vector3::Unit(static_cast<Eigen::Index>(i)));
    const auto add = [&](const vtkSmartPointer<vtkPolyData>& surface) {
      auto actor = make_actor(surface, color);
      actor->GetProperty()->LightingOff();
      actor->PickableOff();
      group.add(renderer, actor);
    };
    add(rod(origin, tip, 0.0035));
    if (is_estimate)
      add(ball(tip, 0.009));
    else
      add(cone_tip(origin, tip, 0.03, 0.010));
  }
}

void show_camera(vtkRenderer& renderer, ActorGroup& group, const SceneCamera& camera) {
  constexpr double reach = 0.6;  // m, of the view cone
  const double w = camera.camera.width - 0.5, h = camera.camera.height - 0.5;
  const std::array<Vector3, 4> corners = {ray(camera.camera, -0.5, -0.5), ray(camera.camera, w, -0.5),
                                          ray(camera.camera, w, h), ray(camera.camera, -0.5, h)};
  std::vector<Segment> segments;
  const Vector3 eye = camera.root_from_camera.translation;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3 here = camera.root_from_camera * Vector3(reach * corners[i]);
    segments.emplace_back(eye, here);
    segments.emplace_back(here, camera.root_from_camera * Vector3(reach * corners[(i + 1) % 4]));
  }
  group.add(renderer, lines_actor(segments, colors().attribution_to_cameras, 1.5));
  auto body = make_actor(rod(camera.root_from_camera * Vector3(0, 0, -0.05), eye, 0.018), colors().ink2);
  body->PickableOff();
  group.add(renderer, body);
}

void show_markers(vtkRenderer& renderer, ActorGroup& group, const std::vector<SceneMarker>& markers) {
  for (const SceneMarker& marker : markers) {
    if (marker.role == SceneMarkerRole::predicted) {
      std::vector<Segment> cross;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3 arm = 0.014 * Vector3::Unit(axis);
        cross.emplace_back(marker.in_root - arm, marker.in_root + arm);
      }
      group.add(renderer, lines_actor(cross, colors().ink1, 2));
    } else {
      const QColor color = marker.rms_over_sigma ? residual_color(marker.rms_over_sigma, 4) : colors().ink2;
      auto actor = make_actor(ball(marker.in_root, 0.008), color);
      actor->PickableOff();
      group.add(renderer, actor);
    }
  }
}

void show_arrows(vtkRenderer& renderer, ActorGroup& group, const std::vector<SceneArrow>& arrows, double times,
                 double metres_per_px) {
  if (arrows.empty()) return;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("residual");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("size");
  sizes->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> shades;
  shades->SetName("color");
  shades->SetNumberOfComponents(3);
  for (const SceneArrow& arrow : arrows) {
    points->InsertNextPoint(arrow.from.data());
    const Vector3 shown = times * arrow.residual;
    vectors->InsertNextTuple(shown.data());
    // A long one is not thicker: it would hide what it points from, and itself when it is selected.
    constexpr double shaft = 0.035, least_px = 0.9, pointed = 4;
    const double length = shown.norm(), least = std::min(least_px / shaft * metres_per_px, pointed * length);
    const double thickness = std::max(std::clamp(length, 0.02, 0.18), least);
    sizes->InsertNextTuple3(length, thickness, thickness);
    const QColor color = residual_color(arrow.rms_over_sigma, arrow.coordinates);
    shades->InsertNextTuple3(color.red(), color.green(), color.blue());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(vectors);
  data->GetPointData()->AddArray(sizes);
  data->GetPointData()->SetScalars(shades);
  vtkNew<vtkArrowSource> source;
  source->SetTipResolution(10);
  source->SetShaftResolution(8);
  source->SetTipRadius(0.09);
  source->SetShaftRadius(0.035);
  source->SetTipLength(0.28);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceConnection(source->GetOutputPort());
  mapper->SetOrientationArray("residual");
  mapper->SetOrientationModeToDirection();
  mapper->SetScaleArray("size");
  mapper->SetScaleModeToScaleByVectorComponents();
  mapper->SetScaleFactor(1);
  mapper->SetColorModeToDefault();
  mapper->ScalarVisibilityOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.4);
  actor->GetProperty()->SetDiffuse(0.6);
  actor->PickableOff();
  group.add(renderer, actor);
}

void show_arrow(vtkRenderer& renderer, ActorGroup& group, const SceneArrow& arrow, double times, double metres_per_px,
                const QColor& color) {
  const Vector3 tip = arrow.from + times * arrow.residual;
  const double length = (tip - arrow.from).norm();
  if (length < 1e-6) return;
  const double radius = std::max(std::clamp(0.05 * length, 0.003, 0.012), 1.2 * metres_per_px);
  for (const auto& surface : {rod(arrow.from, tip, radius), cone_tip(arrow.from, tip, 0.3 * length, 2.6 * radius)}) {
    auto actor = make_actor(surface, color);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    group.add(renderer, actor);
  }
}

void show_ellipsoid(vtkRenderer& renderer, ActorGroup& group, const SceneEllipsoid& ellipsoid) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(ellipsoid.covariance);
  if (solver.info() != Eigen::Success) return;
  const boost::math::chi_squared distribution(3);
  const double radii = std::sqrt(boost::math::quantile(distribution, std::clamp(ellipsoid.probability, 0.01, 0.9999)));
  const auto surface = ball(Vector3::Zero(), 1);
  auto actor = make_actor(surface, colors().candidate, 0.4);
  vtkNew<vtkMatrix4x4> matrix;
  for (int column = 0; column < 3; ++column) {
    const double radius = std::max(radii * std::sqrt(std::max(solver.eigenvalues()[column], 0.0)), 1e-5);
    for (int row = 0; row < 3; ++row) matrix->SetElement(row, column, radius * solver.eigenvectors()(row, column));
  }
  for (int row = 0; row < 3; ++row) matrix->SetElement(row, 3, ellipsoid.center[row]);
  actor->SetUserMatrix(matrix);
  actor->PickableOff();
  group.add(renderer, actor);
}

void show_path(vtkRenderer& renderer, ActorGroup& group, const ScenePath& path) {
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < path.points.size(); ++i) segments.emplace_back(path.points[i - 1], path.points[i]);
  if (segments.empty()) return;
  const QColor color = path.is_now ? colors().accent : colors().ink2;
  group.add(renderer, lines_actor(segments, color, path.is_now ? 4 : 2));
  auto end = make_actor(ball(path.points.back(), path.is_now ? 0.014 : 0.009), color);
  end->PickableOff();
  group.add(renderer, end);
}

void show_floor(vtkRenderer& renderer, ActorGroup& group, double height) {
  std::vector<Segment> segments;
  constexpr int half = 4;
  constexpr double cell = 0.5;
  for (int i = -half; i <= half; ++i) {
    segments.emplace_back(Vector3(i * cell, -half * cell, height), Vector3(i * cell, half * cell, height));
    segments.emplace_back(Vector3(-half * cell, i * cell, height), Vector3(half * cell, i * cell, height));
  }
  group.add(renderer, lines_actor(segments, colors().hairline, 1));
}

}  // namespace handsight::widgets
