// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/gl_window.h"

#include <vtkCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions_3_2_Core>
#include <QOpenGLVersionFunctionsFactory>
#include <cmath>

namespace handsight::widgets {

GlWindow::GlWindow(QOpenGLWidget& widget) : widget_(widget) {
  window_->SetReadyForRendering(false);
  window_->SetOwnContext(false);
  // Smooth edges cost three times as much where the processor draws.
  window_->SetMultiSamples(qEnvironmentVariableIsSet("LIBGL_ALWAYS_SOFTWARE") ? 0 : 4);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetIsDirect(1);
  window_->SetSupportsOpenGL(1);
  window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &GlWindow::make_current);
  window_->AddObserver(vtkCommand::WindowIsCurrentEvent, this, &GlWindow::tell_whether_current);
}

void GlWindow::make_current() {
  // Where the context is current already nothing may be done: makeCurrent would bind Qt's framebuffer under VTK.
  if (!widget_.context() || QOpenGLContext::currentContext() == widget_.context()) return;
  widget_.makeCurrent();
}

void GlWindow::tell_whether_current(vtkObject*, unsigned long, void* answer) {
  const bool is_current = widget_.context() && QOpenGLContext::currentContext() == widget_.context();
  window_->SetIsCurrent(is_current);
  if (answer) *static_cast<bool*>(answer) = is_current;
}

void GlWindow::initialize() {
  QObject::disconnect(context_dies_);
  context_dies_ =
      QObject::connect(widget_.context(), &QOpenGLContext::aboutToBeDestroyed, &widget_, [this] { release(); });
  window_->SetReadyForRendering(true);
  window_->SetMapped(true);
  window_->SetIsCurrent(true);
  window_->OpenGLInit();
  is_ready_ = true;
}

void GlWindow::resize() {
  const double ratio = widget_.devicePixelRatioF();
  window_->SetSize(static_cast<int>(std::ceil(widget_.width() * ratio)),
                   static_cast<int>(std::ceil(widget_.height() * ratio)));
}

void GlWindow::paint() {
  if (!is_ready_) return;
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->Push();
  state->ResetFramebufferBindings();
  resize();
  window_->Render();
  copy_to_widget();
  state->Pop();
}

void GlWindow::copy_to_widget() {
  widget_.makeCurrent();
  auto* gl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_2_Core>(widget_.context());
  vtkOpenGLFramebufferObject* source = window_->GetDisplayFramebuffer();
  if (!gl || !source) return;
  const int* size = window_->GetSize();
  source->Bind(GL_READ_FRAMEBUFFER);
  gl->glReadBuffer(GL_COLOR_ATTACHMENT0);
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, widget_.defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl->glBindFramebuffer(GL_FRAMEBUFFER, widget_.defaultFramebufferObject());
  // Alpha must be 1 everywhere, or what lies behind the widget shines through in pictures of it.
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void GlWindow::release() {
  if (!is_ready_) return;
  is_ready_ = false;
  QObject::disconnect(context_dies_);
  widget_.makeCurrent();
  window_->SetReadyForRendering(false);
  window_->Finalize();
  widget_.doneCurrent();
}

}  // namespace handsight::widgets
