#include "sim/audio/path_events.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moontrace {

PassedEnd PassedEndOf(const TextPage& page, const Script& script, const TypeStyle& style,
                      glm::dvec2 tip_P) {
  constexpr double kBeyond = 0.25;  // [em]
  if (page.glyphs.size() < 2 || style.lines != LineDirection::kLeftToRight) {
    return PassedEnd::kNothing;
  }
  double nearest = std::numeric_limits<double>::infinity();
  double end = 0;
  std::size_t line = 0;
  for (const PlacedGlyph& glyph : page.glyphs) {  // in order: a line's last one stays
    const double size = ScaleOf(glyph.kind, style) * style.size;
    const double away = std::abs(tip_P.y - (glyph.origin_P.y + 0.5 * size));
    if (away > nearest) continue;
    nearest = away;
    line = glyph.line;
    end = glyph.origin_P.x + size * script.glyphs[glyph.glyph].advance;
  }
  if (nearest > 0.5 * style.line_pitch || tip_P.x < end + kBeyond * style.size) {
    return PassedEnd::kNothing;
  }
  return line == page.glyphs.back().line ? PassedEnd::kPage : PassedEnd::kLine;
}

std::optional<Earcon> PathEvents::Changed(const PathMoment& now) {
  const PassedEnd before = std::exchange(end_, now.touching ? now.end : end_);
  if (now.touching != std::exchange(touching_, now.touching)) {
    off_ = false;
    return now.touching ? Earcon::kStrokeStart : Earcon::kStrokeEnd;
  }
  if (!now.touching) return std::nullopt;
  if (end_ != before && end_ != PassedEnd::kNothing) {
    return end_ == PassedEnd::kPage ? Earcon::kPageEnd : Earcon::kLineEnd;
  }
  const bool was_off = off_;
  off_ = was_off ? now.off_line > 0 : now.off_line >= 0.5;
  if (off_ == was_off) return std::nullopt;
  return off_ ? Earcon::kOffLine : Earcon::kBackOn;
}

std::optional<Earcon> PathEvents::Take(const PathMoment& now) {
  constexpr double kAtLeast = 3;  // between two of a kind [s]
  const std::optional<Earcon> heard = Changed(now);
  if (!heard || *heard == Earcon::kStrokeStart || *heard == Earcon::kStrokeEnd) return heard;
  double& last = last_[static_cast<std::size_t>(*heard)];
  if (now.time < last + kAtLeast) return std::nullopt;
  last = now.time;
  return heard;
}

}  // namespace moontrace
