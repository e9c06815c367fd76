#include "lessons/measure/pause_meter.h"

#include <glm/geometric.hpp>

namespace moontrace {

PauseMeter::Step PauseMeter::Add(double time, glm::dvec2 p) {
  Step step;
  if (!any_) {
    any_ = true;
    rest_ = p;
    since_ = last_ = time;
    pausing_ = went_on_ = false;
    return step;
  }
  if (glm::distance(p, rest_) > kSpeed * kLeast) {
    since_ = pausing_ ? last_ : time;
    went_on_ = pausing_;
    pausing_ = false;
    rest_ = p;
  } else if (pausing_) {
    step.time = time - last_;
  } else if (time - since_ > kLeast) {
    pausing_ = true;
    step.began = !went_on_;
    step.time = time - since_;
  }
  last_ = time;
  return step;
}

}  // namespace moontrace
