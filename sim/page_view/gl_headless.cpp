#include "sim/page_view/gl_headless.h"

#include "textures/base/error.h"

#ifdef MOONTRACE_HAVE_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_EGL

struct HeadlessGl::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~State() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    // The display is the process's, and stays: eglTerminate would take every other context with it,
    // and Mesa's loses a block of memory each time its driver is unloaded.
  }
};

namespace {

/// Mesa's surfaceless platform needs neither display nor graphics card; otherwise the default one.
EGLDisplay FindDisplay() {
  const auto platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (platform_display != nullptr) {
    EGLDisplay display =
        platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) {
      return display;
    }
  }
  EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) {
    return display;
  }
  return EGL_NO_DISPLAY;
}

}  // namespace

HeadlessGl::HeadlessGl() : state_(std::make_unique<State>()) {
  const char* const refused =
      "no OpenGL for pictures of the view here: install a driver (libgl1-mesa-dri)";
  state_->display = FindDisplay();
  if (state_->display == EGL_NO_DISPLAY) throw LackError(refused);
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           0,
                           EGL_RED_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           24,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE ||
      eglChooseConfig(state_->display, wanted, &config, 1, &count) != EGL_TRUE || count < 1) {
    throw LackError(refused);
  }
  state_->context = eglCreateContext(state_->display, config, EGL_NO_CONTEXT, nullptr);
  if (state_->context == EGL_NO_CONTEXT ||
      eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context) !=
          EGL_TRUE) {
    throw LackError(refused);
  }
}

#else

struct HeadlessGl::State {};

HeadlessGl::HeadlessGl() {
  throw LackError(
      "this build cannot draw the view without a display: install libegl-dev and build again");
}

#endif

HeadlessGl::~HeadlessGl() = default;

}  // namespace moontrace
