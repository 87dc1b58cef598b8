// SPDX-License-Identifier: GPL-3.0-or-later
// VTK rendering into a QOpenGLWidget: VTK draws into framebuffers of its own, which are then copied into Qt's.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QOpenGLWidget>

namespace handsight::widgets {

/// Debian's VTK-Qt module is built for Qt 5; this is what of it is needed. The widget calls initialize(), resize() and
/// paint() from its own, and release() in its destructor.
class GlWindow {
 public:
  explicit GlWindow(QOpenGLWidget& widget);
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  void initialize();  // again after each reparenting: the context is a new one then
  void resize();
  void paint();
  void release();

  vtkGenericOpenGLRenderWindow* window() { return window_; }

 private:
  void make_current();
  void tell_whether_current(vtkObject*, unsigned long, void* answer);
  void copy_to_widget();

  QOpenGLWidget& widget_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  QMetaObject::Connection context_dies_;
  bool is_ready_ = false;
};

}  // namespace handsight::widgets
