// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/gl_window.h"

#include <vtkCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions_3_2_Core>
#include <QOpenGLVersionFunctionsFactory>

namespace handsight::widgets {

GlWindow::GlWindow() {
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

GlWindow::~GlWindow() { release(); }

void GlWindow::make_current() {
  if (!context_ || QOpenGLContext::currentContext() == context_.get()) return;
  context_->makeCurrent(surface_.get());
}

void GlWindow::tell_whether_current(vtkObject*, unsigned long, void* answer) {
  const bool is_current = context_ && QOpenGLContext::currentContext() == context_.get();
  window_->SetIsCurrent(is_current);
  if (answer) *static_cast<bool*>(answer) = is_current;
}

bool GlWindow::make_ready() {
  if (is_ready_) {
    make_current();
    return true;
  }
  if (has_failed_) return false;
  surface_ = std::make_unique<QOffscreenSurface>();
  surface_->create();
  context_ = std::make_unique<QOpenGLContext>();
  const bool is_made = context_->create() && context_->makeCurrent(surface_.get()) &&
                       QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_2_Core>(context_.get());
  if (!is_made) {
    has_failed_ = true;
    context_.reset();
    surface_.reset();
    return false;
  }
  window_->SetReadyForRendering(true);
  window_->SetMapped(true);
  window_->SetIsCurrent(true);
  window_->OpenGLInit();
  is_ready_ = true;
  return true;
}

QImage GlWindow::picture(const QSize& size) {
  if (size.isEmpty() || !make_ready()) return {};
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->Push();
  state->ResetFramebufferBindings();
  window_->SetSize(size.width(), size.height());
  window_->Render();
  QImage image = read_pixels();
  state->Pop();
  return image;
}

QImage GlWindow::read_pixels() const {
  auto* gl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_2_Core>(context_.get());
  vtkOpenGLFramebufferObject* source = window_->GetDisplayFramebuffer();
  const int* size = window_->GetSize();
  QImage image(size[0], size[1], QImage::Format_RGB32);
  source->Bind(GL_FRAMEBUFFER);
  // Alpha must be 1 everywhere, or what lies behind the widget shines through.
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl->glReadBuffer(GL_COLOR_ATTACHMENT0);
  gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl->glReadPixels(0, 0, size[0], size[1], GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, image.bits());
  return std::move(image).mirrored(false, true);  // OpenGL begins below
}

void GlWindow::release() {
  if (!is_ready_) return;
  is_ready_ = false;
  make_current();
  window_->SetReadyForRendering(false);
  window_->Finalize();
  context_->doneCurrent();
}

}  // namespace handsight::widgets
