#include "sim/view/view_window.h"

#include <fmt/core.h>

#include <cstdlib>
#include <utility>

#include "textures/base/error.h"
#include "textures/base/text_file.h"

#ifdef MOONTRACE_HAVE_GLFW
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_GLFW

struct ViewWindow::State {
  GLFWwindow* window = nullptr;
  std::function<void()> lost;
  std::vector<WindowEvent> events;
  glm::dvec2 mouse{0, 0};
  int width = 0, height = 0;

  ~State();
  void Open(const std::string& title, int wanted_width, int wanted_height);
  void Listen();
  void Add(WindowEvent event) {
    event.at = mouse;
    events.push_back(event);
  }
};

namespace {

constexpr int kLeastWidth = 320, kLeastHeight = 240;

/// The one whose window is open, for Xlib's handlers.
std::function<void()>* told_when_lost = nullptr;
/// A display was lost: what holds its connection stands still, and GLFW knows no other.
std::atomic<bool> display_lost{false};

/// Xlib ends the program after this returns: so it never does.
int DisplayLost(void* /*display*/) {
  display_lost = true;
  if (told_when_lost != nullptr && *told_when_lost) (*told_when_lost)();
  for (;;) pause();
}

/// Errors of single requests, on a display that goes away or a window that closes, do not matter.
int RequestFailed(void* /*display*/, void* /*error*/) { return 0; }

/// Xlib's own handlers end the program. Found where GLFW brought it in: no other needs Xlib.
void HoldXlib() {
  void* xlib = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  if (xlib == nullptr) return;  // not on X11
  using LostHandler = int (*)(void*);
  using FailedHandler = int (*)(void*, void*);
  using SetLost = LostHandler (*)(LostHandler);
  using SetFailed = FailedHandler (*)(FailedHandler);
  if (const auto set = reinterpret_cast<SetLost>(dlsym(xlib, "XSetIOErrorHandler"))) {
    set(&DisplayLost);
  }
  if (const auto set = reinterpret_cast<SetFailed>(dlsym(xlib, "XSetErrorHandler"))) {
    set(&RequestFailed);
  }
  dlclose(xlib);
}

WindowEvent::Key KeyOf(int key) {
  using Key = WindowEvent::Key;
  switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return Key::kEnter;
    case GLFW_KEY_ESCAPE:
      return Key::kEscape;
    case GLFW_KEY_BACKSPACE:
      return Key::kBackspace;
    case GLFW_KEY_TAB:
      return Key::kTab;
    case GLFW_KEY_UP:
      return Key::kUp;
    case GLFW_KEY_DOWN:
      return Key::kDown;
    case GLFW_KEY_LEFT:
      return Key::kLeft;
    case GLFW_KEY_RIGHT:
      return Key::kRight;
    case GLFW_KEY_PAGE_UP:
      return Key::kPageUp;
    case GLFW_KEY_PAGE_DOWN:
      return Key::kPageDown;
    case GLFW_KEY_HOME:
      return Key::kHome;
    default:
      return Key::kNone;
  }
}

WindowEvent::Button ButtonOf(int button) {
  if (button == GLFW_MOUSE_BUTTON_LEFT) return WindowEvent::Button::kLeft;
  if (button == GLFW_MOUSE_BUTTON_RIGHT) return WindowEvent::Button::kRight;
  if (button == GLFW_MOUSE_BUTTON_MIDDLE) return WindowEvent::Button::kMiddle;
  return WindowEvent::Button::kNone;
}

bool IsDown(GLFWwindow* window, int left, int right) {
  return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
}

}  // namespace

void ViewWindow::RequireDisplayNamed() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* display = std::getenv(name);
    if (display != nullptr && *display != '\0') return;
  }
  throw LackError("no display for a window: set DISPLAY, or write pictures instead");
}

void ViewWindow::State::Open(const std::string& title, int wanted_width, int wanted_height) {
  if (glfwInit() != GLFW_TRUE) {
    RequireDisplayNamed();
    const char* display = std::getenv("DISPLAY");
    throw LackError(fmt::format(
        "no display answers at {}: set DISPLAY anew, or write pictures instead",
        OneLine(display == nullptr || *display == '\0' ? "WAYLAND_DISPLAY" : display, 30)));
  }
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_DOUBLEBUFFER, GLFW_TRUE);
  window = glfwCreateWindow(wanted_width, wanted_height, title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    throw LackError("no OpenGL in a window here: install a driver (libgl1-mesa-dri)");
  }
  glfwSetWindowSizeLimits(window, kLeastWidth, kLeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window);
  if (glfwExtensionSupported("GL_ARB_framebuffer_object") != GLFW_TRUE ||
      glfwExtensionSupported("GL_ARB_vertex_buffer_object") != GLFW_TRUE) {
    throw LackError("OpenGL is too old here for the view: install a driver (libgl1-mesa-dri)");
  }
  glfwSwapInterval(0);  // the viewer keeps its own time
  glfwGetFramebufferSize(window, &width, &height);
}

/// GLFW's calls become plain values.
void ViewWindow::State::Listen() {
  glfwSetWindowUserPointer(window, this);
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    State& s = *static_cast<State*>(glfwGetWindowUserPointer(w));
    int wide = 1, high = 1;
    glfwGetWindowSize(w, &wide, &high);
    // points of the picture, from the lower left, on displays of any density
    s.mouse = {x * s.width / (wide > 0 ? wide : 1),
               s.height - y * s.height / (high > 0 ? high : 1)};
    WindowEvent event;
    event.kind = WindowEvent::Kind::kMove;
    s.Add(event);
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (entered == GLFW_TRUE) return;
    WindowEvent event;
    event.kind = WindowEvent::Kind::kLeave;
    static_cast<State*>(glfwGetWindowUserPointer(w))->Add(event);
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int /*mods*/) {
    WindowEvent event;
    event.kind = action == GLFW_PRESS ? WindowEvent::Kind::kPress : WindowEvent::Kind::kRelease;
    event.button = ButtonOf(button);
    static_cast<State*>(glfwGetWindowUserPointer(w))->Add(event);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double /*x*/, double y) {
    WindowEvent event;
    event.kind = WindowEvent::Kind::kWheel;
    event.wheel = y;
    event.control = IsDown(w, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    static_cast<State*>(glfwGetWindowUserPointer(w))->Add(event);
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int /*code*/, int action, int mods) {
    WindowEvent event;
    event.kind = WindowEvent::Kind::kKey;
    event.key = KeyOf(key);
    event.shift = (mods & GLFW_MOD_SHIFT) != 0;
    event.control = (mods & GLFW_MOD_CONTROL) != 0;
    if (action == GLFW_RELEASE || event.key == WindowEvent::Key::kNone) return;
    static_cast<State*>(glfwGetWindowUserPointer(w))->Add(event);
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int character) {
    WindowEvent event;
    event.kind = WindowEvent::Kind::kText;
    event.text = character;
    static_cast<State*>(glfwGetWindowUserPointer(w))->Add(event);
  });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int wide, int high) {
    State& s = *static_cast<State*>(glfwGetWindowUserPointer(w));
    s.width = wide;
    s.height = high;
  });
}

ViewWindow::State::~State() {
  if (display_lost) return;
  if (window != nullptr) glfwDestroyWindow(window);
  glfwTerminate();
  told_when_lost = nullptr;
}

ViewWindow::ViewWindow(const std::string& title, int width, int height, std::function<void()> lost)
    : state_(std::make_unique<State>()) {
  if (display_lost) throw LackError("the display was lost: start again to open a window");
  state_->lost = std::move(lost);
  told_when_lost = &state_->lost;
  state_->Open(title, width, height);
  HoldXlib();  // after GLFW, which sets its own while it opens a window
  state_->Listen();
}

std::vector<WindowEvent> ViewWindow::Events(double wait) {
  if (wait > 0) {
    glfwWaitEventsTimeout(wait);
  } else {
    glfwPollEvents();
  }
  return std::exchange(state_->events, {});
}

bool ViewWindow::closed() const { return glfwWindowShouldClose(state_->window) == GLFW_TRUE; }

bool ViewWindow::shown() const {
  return state_->width > 0 && state_->height > 0 &&
         glfwGetWindowAttrib(state_->window, GLFW_ICONIFIED) != GLFW_TRUE;
}

int ViewWindow::width() const { return state_->width; }
int ViewWindow::height() const { return state_->height; }

void ViewWindow::SetTitle(const std::string& title) {
  glfwSetWindowTitle(state_->window, title.c_str());
}

void ViewWindow::Swap() { glfwSwapBuffers(state_->window); }

bool ViewWindow::DisplayWasLost() noexcept { return display_lost; }

#else

struct ViewWindow::State {};

ViewWindow::ViewWindow(const std::string& /*title*/, int /*width*/, int /*height*/,
                       std::function<void()> /*lost*/) {
  throw LackError("this build opens no window: install libglfw3-dev and build again");
}

std::vector<WindowEvent> ViewWindow::Events(double /*wait*/) { return {}; }
bool ViewWindow::closed() const { return true; }
bool ViewWindow::shown() const { return false; }
int ViewWindow::width() const { return 0; }
int ViewWindow::height() const { return 0; }
void ViewWindow::SetTitle(const std::string& /*title*/) {}
void ViewWindow::Swap() {}
void ViewWindow::RequireDisplayNamed() {
  throw LackError("this build opens no window: install libglfw3-dev and build again");
}
bool ViewWindow::DisplayWasLost() noexcept { return false; }

#endif

ViewWindow::~ViewWindow() = default;

}  // namespace moontrace
