// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's objects from Handsight's plain ones.
#pragma once

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QColor>

#include "geometry/rigid.h"

namespace handsight::widgets {

vtkSmartPointer<vtkMatrix4x4> vtk_matrix(const Rigid& motion);

/// An actor of that surface; soft light, no highlights.
vtkSmartPointer<vtkActor> make_actor(vtkPolyData* surface, const QColor& color, double opacity = 1);

void set_color(vtkActor& actor, const QColor& color, double opacity = 1);

/// A cylinder from one point to another (m).
vtkSmartPointer<vtkPolyData> rod(const Vector3& from, const Vector3& to, double radius);

vtkSmartPointer<vtkPolyData> ball(const Vector3& center, double radius);

/// A cone with its tip at `tip`, its base towards `from`.
vtkSmartPointer<vtkPolyData> cone_tip(const Vector3& from, const Vector3& tip, double length, double radius);

}  // namespace handsight::widgets
