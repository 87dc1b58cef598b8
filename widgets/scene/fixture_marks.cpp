// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/fixture_marks.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <vector>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

void add(vtkRenderer& renderer, ActorGroup& group, vtkPolyData* surface, const QColor& color, double opacity = 1) {
  auto actor = make_actor(surface, color, opacity);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  group.add(renderer, actor);
}

std::vector<Vector3> corners_of(const SceneFixture& f) {
  const auto corner = [&](double x, double y) { return f.root_from_fixture * Vector3(x, y, 0); };
  return {corner(f.from.x(), f.from.y()), corner(f.to.x(), f.from.y()), corner(f.to.x(), f.to.y()),
          corner(f.from.x(), f.to.y())};
}

/// A round of points (m, root frame), as a filled patch or as a tube along it.
vtkSmartPointer<vtkPolyData> patch(const std::vector<Vector3>& round) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(round.size()));
  for (const Vector3& at : round) cells->InsertCellPoint(points->InsertNextPoint(at.data()));
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> tube_along(const std::vector<Vector3>& round, double radius) {
  vtkNew<vtkPolyData> line;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Vector3& at : round) points->InsertNextPoint(at.data());
  const auto count = static_cast<vtkIdType>(round.size());
  cells->InsertNextCell(static_cast<int>(count) + 1);
  for (vtkIdType i = 0; i <= count; ++i) cells->InsertCellPoint(i % count);
  line->SetPoints(points);
  line->SetLines(cells);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line);
  tube->SetRadius(radius);
  tube->SetNumberOfSides(10);
  tube->Update();
  return tube->GetOutput();
}

std::vector<Vector3> ring(const Vector3& middle, double radius) {
  constexpr int sides = 32;
  std::vector<Vector3> round;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    round.emplace_back(middle + radius * Vector3(std::cos(angle), std::sin(angle), 0));
  }
  return round;
}

}  // namespace

Vector3 find_middle(const SceneFixture& f) {
  if (f.shape == FixtureShape::bar) return f.root_from_fixture.translation;
  return f.root_from_fixture * Vector3((f.from + f.to) / 2);
}

void show_fixture(vtkRenderer& renderer, ActorGroup& group, const SceneFixture& f) {
  const QColor color = f.is_touched ? colors().accent : colors().attribution_to_cameras;
  const double thick = f.is_touched ? 0.004 : 0.0025;  // m
  const Vector3 from = f.root_from_fixture * f.from, to = f.root_from_fixture * f.to;
  switch (f.shape) {
    case FixtureShape::patch: {
      const auto corners = corners_of(f);
      add(renderer, group, patch(corners), color, f.is_touched ? 0.45 : 0.25);
      return add(renderer, group, tube_along(corners, thick), color);
    }
    case FixtureShape::ring: {
      constexpr double radius = 0.025;  // m
      return add(renderer, group, tube_along(ring(f.root_from_fixture.translation, radius), 1.4 * thick), color);
    }
    case FixtureShape::rod:
      return add(renderer, group, rod(from, to, 1.2 * thick), color);
    case FixtureShape::arrow:
      add(renderer, group, rod(from, to, 1.2 * thick), color);
      return add(renderer, group, cone_tip(from, to, 0.025, 3 * thick), color);
    case FixtureShape::bar:
      add(renderer, group, rod(from, to, thick), color);
      add(renderer, group, ball(from, 3 * thick), color);
      return add(renderer, group, ball(to, 2 * thick), color);
  }
}

}  // namespace handsight::widgets
