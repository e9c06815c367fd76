#include "lessons/guide/guidance_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <map>

namespace moontrace {

namespace {

constexpr double kLeastLength = 1e-9;  ///< a shorter piece, or a shorter gap, is none [m]

void Append(GuidanceStroke& stroke, const Piece& piece) {
  stroke.parts.push_back(PartOf(piece, stroke.length));
  stroke.length += stroke.parts.back().length;
}

GuidanceStroke StrokeOf(const IntendedStroke& intended) {
  GuidanceStroke stroke;
  stroke.width = intended.width;
  glm::dvec2 end{0, 0};
  for (const Piece& piece : intended.spine_P) {
    if (Length(piece) < kLeastLength) continue;
    const glm::dvec2 start = StartOf(piece);
    if (!stroke.parts.empty() && glm::distance(end, start) > kLeastLength) {
      Append(stroke, Line{end, start});
    }
    Append(stroke, piece);
    end = EndOf(piece);
  }
  if (stroke.parts.empty() && !intended.spine_P.empty()) {
    const glm::dvec2 dot = StartOf(intended.spine_P.front());
    Append(stroke, Line{dot, dot});
  }
  return stroke;
}

const PathPart& PartAt(const GuidanceStroke& stroke, double s) noexcept {
  std::size_t low = 0, high = stroke.parts.size();  // the last part that begins at s or before
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (stroke.parts[middle].offset <= s ? low : high) = middle;
  }
  return stroke.parts[low];
}

/// Where on the whole line or circle `p` is nearest, as arc length from the part's start [m].
double FootOf(const PathPart& part, glm::dvec2 p) noexcept {
  return part.is_arc ? part.radius * AngleTo(part, p) : glm::dot(p - part.anchor, part.direction);
}

}  // namespace

glm::dvec2 PointAt(const GuidanceStroke& stroke, double s) noexcept {
  const PathPart& part = PartAt(stroke, s);
  return PointAt(part, std::clamp(s - part.offset, 0.0, part.length));
}

glm::dvec2 TangentAt(const GuidanceStroke& stroke, double s) noexcept {
  const PathPart& part = PartAt(stroke, s);
  return TangentAt(part, std::clamp(s - part.offset, 0.0, part.length));
}

NearestPlace NearestWithin(const GuidanceStroke& stroke, glm::dvec2 p, double s, double from,
                           double to) noexcept {
  const double first = std::clamp(from, 0.0, stroke.length);
  const double last = std::clamp(to, first, stroke.length);
  NearestPlace nearest;
  nearest.s = std::clamp(s, first, last);
  nearest.distance = glm::distance(p, PointAt(stroke, nearest.s));
  const auto take = [&](const PathPart& part, double along) noexcept {
    constexpr double kSame = 1e-12;
    const double distance = glm::distance(p, PointAt(part, along));
    if (distance < nearest.distance - kSame) nearest = {part.offset + along, distance};
  };
  const PathPart* end = stroke.parts.data() + stroke.parts.size();
  for (const PathPart* part = &PartAt(stroke, first); part != end && part->offset <= last; ++part) {
    const double begin = std::clamp(first - part->offset, 0.0, part->length);
    const double finish = std::clamp(last - part->offset, 0.0, part->length);
    const double foot = FootOf(*part, p);
    if (foot >= begin && foot <= finish) {
      take(*part, foot);
    } else {
      take(*part, begin);
      take(*part, finish);
    }
  }
  return nearest;
}

glm::dvec2 RecordedPointAt(const GuidancePath& path, double time) noexcept {
  if (!(time > 0)) return path.points.front();
  if (time >= path.times.back()) return path.points.back();
  std::size_t low = 0, high = path.times.size() - 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (path.times[middle] <= time ? low : high) = middle;
  }
  const double share = (time - path.times[low]) / (path.times[high] - path.times[low]);
  return path.points[low] + share * (path.points[high] - path.points[low]);
}

std::shared_ptr<const GuidancePath> MakeGuidancePath(const std::vector<IntendedStroke>& strokes) {
  auto path = std::make_shared<GuidancePath>();
  std::map<std::size_t, Box> letters;
  for (const IntendedStroke& stroke : strokes) {
    Box& letter = letters[stroke.glyph];
    for (const Piece& piece : stroke.spine_P) Include(letter, BoundsOf(piece));
  }
  for (const IntendedStroke& intended : strokes) {
    GuidanceStroke stroke = StrokeOf(intended);
    if (stroke.parts.empty()) continue;
    stroke.letter = Grown(letters[intended.glyph], stroke.width);
    path->strokes.push_back(stroke);
  }
  return path;
}

std::shared_ptr<const GuidancePath> MakeRecordedPath(const std::vector<double>& times,
                                                     const std::vector<glm::dvec3>& tips_P,
                                                     double width) {
  auto path = std::make_shared<GuidancePath>();
  // What stays near the last point kept is left out: resting would make parts without length.
  const double spacing = width / 10;
  GuidanceStroke stroke;
  stroke.width = width;
  Box box;
  glm::dvec2 kept{0, 0};
  double begin = 0;
  for (std::size_t i = 0; i < std::min(times.size(), tips_P.size()); ++i) {
    const glm::dvec2 tip(tips_P[i]);
    if (!std::isfinite(times[i]) || !std::isfinite(tip.x) || !std::isfinite(tip.y)) continue;
    if (path->times.empty()) {
      begin = times[i];
      kept = tip;
    } else if (times[i] - begin <= path->times.back()) {
      continue;
    }
    path->times.push_back(times[i] - begin);
    path->points.push_back(tip);
    Include(box, tip);
    if (glm::distance(kept, tip) < spacing) continue;
    Append(stroke, Line{kept, tip});
    kept = tip;
  }
  if (path->points.empty()) return path;
  if (stroke.parts.empty()) Append(stroke, Line{kept, kept});
  stroke.letter = Grown(box, width);
  path->strokes.push_back(stroke);
  return path;
}

}  // namespace moontrace
