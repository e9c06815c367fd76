#pragma once

#include <memory>

#include "sim/view/view_history.h"
#include "sim/view/view_look.h"

struct mjrContext_;

namespace moontrace {

/// Force, error, tick lateness and motor heat over the last 10 s, one figure below the other.
class ViewPlots {
 public:
  ViewPlots();
  ~ViewPlots();

  void Draw(const ViewHistory& history, const ViewColors& colors, const PixelBox& box,
            const mjrContext_& context);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
