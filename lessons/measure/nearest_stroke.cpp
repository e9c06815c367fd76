#include "lessons/measure/nearest_stroke.h"

#include <limits>

namespace moontrace {

namespace {

constexpr double kEntryTime = 0.05;   ///< [s]
constexpr double kKeepWidths = 0.25;  ///< of the groove

double DistanceTo(const Spine& spine, glm::dvec2 p_P) {
  CoveredLength none(1);
  return spine.Cover(p_P, 0, none);
}

}  // namespace

NearestStroke::NearestStroke(const std::vector<IntendedStroke>& strokes, double reach)
    : reach_(reach) {
  candidates_.reserve(strokes.size());
  for (const IntendedStroke& stroke : strokes) {
    candidates_.push_back({Spine(stroke.spine_P), stroke.width});
  }
}

void NearestStroke::Assign(TraceSample& sample) {
  sample.phase = TracePhase::kAir;
  sample.stroke = 0;
  if (!sample.in_contact) {
    touching_ = has_stroke_ = false;
    return;
  }
  if (!touching_) touched_at_ = sample.time;
  touching_ = true;
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    double distance = DistanceTo(candidates_[i].spine, glm::dvec2(sample.tip_P));
    if (has_stroke_ && i == stroke_) distance -= kKeepWidths * candidates_[i].width;
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  has_stroke_ = least <= reach_;
  if (!has_stroke_) return;
  stroke_ = nearest;
  sample.stroke = nearest;
  const bool entering = sample.time - touched_at_ < kEntryTime;
  sample.phase = entering ? TracePhase::kEntry : TracePhase::kStroke;
}

}  // namespace moontrace
