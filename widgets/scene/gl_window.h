// SPDX-License-Identifier: GPL-3.0-or-later
// VTK rendering into a picture, on an OpenGL context of its own that is never shown.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QImage>
#include <memory>

class QOffscreenSurface;
class QOpenGLContext;

namespace handsight::widgets {

/// Debian's VTK-Qt module is built for Qt 5; this is what of it is needed. The widget paints the picture as any other:
/// were it a QOpenGLWidget, Qt would compose the whole window by OpenGL at every change of any of its widgets, which
/// costs three times the scene itself where the processor draws. For the window's thread.
class GlWindow {
 public:
  GlWindow();
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  /// Makes the context current, at the first call also the context itself. False where the display has no OpenGL 3.2.
  bool make_ready();
  bool is_ready() const { return is_ready_; }
  /// The scene in this many device px; null where make_ready() is false.
  QImage picture(const QSize& size);
  /// Does one picture have smooth edges by itself?
  bool is_smooth() const { return window_->GetMultiSamples() > 0; }
  void release();

  vtkGenericOpenGLRenderWindow* window() { return window_; }

 private:
  void make_current();
  void tell_whether_current(vtkObject*, unsigned long, void* answer);
  QImage read_pixels() const;

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  std::unique_ptr<QOffscreenSurface> surface_;
  std::unique_ptr<QOpenGLContext> context_;
  bool is_ready_ = false, has_failed_ = false;
};

}  // namespace handsight::widgets
