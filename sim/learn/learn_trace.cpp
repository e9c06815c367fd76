#include "sim/learn/learn_trace.h"

#include <utility>

namespace moontrace {

namespace {

constexpr double kLifted = 0.5;        ///< long enough to be meant [s], ours
constexpr double kLongestTrack = 300;  ///< [s]
/// A tip at rest covers half a groove's width, of a line of one em some 6 percent; ours.
constexpr double kAtRest = 0.1;
constexpr std::size_t kColumns = 5;

}  // namespace

LearnTrace::LearnTrace(std::vector<IntendedStroke> strokes, std::size_t glyph_count, double tick,
                       double reach, bool keep_track)
    : strokes_(std::move(strokes)),
      nearest_(strokes_, reach),
      meter_(strokes_, glyph_count, tick),
      keep_track_(keep_track),
      longest_track_(kColumns * static_cast<std::size_t>(kLongestTrack / tick)) {}

TraceSample ToScore(const LoopSample& sample) {
  TraceSample scored;
  scored.time = sample.time;
  scored.tip_P = sample.tip_P;
  scored.force_P = sample.force_P;
  scored.in_contact = sample.in_contact;
  return scored;
}

void LearnTrace::Add(const LoopSample& sample) {
  TraceSample scored = ToScore(sample);
  nearest_.Assign(scored);
  meter_.Add(scored, sample.guidance_P);
  now_ = sample.time;
  if (sample.in_contact) {
    if (!first_touch_) first_touch_ = sample.time;
    last_touch_ = sample.time;
  }
  if (!keep_track_ || track_.size() >= longest_track_) return;
  track_.insert(track_.end(), {sample.time, sample.tip_P.x, sample.tip_P.y, sample.tip_P.z,
                               sample.in_contact ? 1.0 : 0.0});
}

bool LearnTrace::followed() const { return touched() && Coverage() > kAtRest; }

bool LearnTrace::Ended(double coverage) const {
  return touched() && now_ - last_touch_ >= kLifted && Coverage() >= coverage;
}

Trial LearnTrace::Measured() const {
  Trial trial;
  meter_.Fill(trial);
  return trial;
}

}  // namespace moontrace
