#pragma once

#include <memory>

namespace moontrace {

/// OpenGL without a display, through EGL: current for the thread that made it, as long as it lives.
class HeadlessGl {
 public:
  /// Throws LackError: this build has no EGL, or the machine no OpenGL of the old profile that
  /// MuJoCo draws with.
  HeadlessGl();
  ~HeadlessGl();
  HeadlessGl(const HeadlessGl&) = delete;
  HeadlessGl& operator=(const HeadlessGl&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
