#include "lessons/measure/stroke_trace.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lessons/measure/shape_distance.h"

namespace moontrace {
namespace {

constexpr std::size_t kCapacity = 16;  ///< covered parts of a stroke held without allocating
constexpr std::size_t kFewestPoints = 16, kMostPoints = 128;  ///< of shapes that are compared

/// Points along the pieces, `spacing` apart or less, and each piece's ends.
std::vector<glm::dvec2> PointsAlong(const std::vector<Piece>& pieces, double spacing) {
  std::vector<glm::dvec2> points;
  for (const Piece& piece : pieces) {
    const double length = Length(piece);
    const auto steps = static_cast<std::size_t>(std::clamp(std::ceil(length / spacing), 1.0, 1e4));
    for (std::size_t i = 0; i <= steps; ++i) {
      points.push_back(
          PointAt(piece, length * static_cast<double>(i) / static_cast<double>(steps)));
    }
  }
  return points;
}

}  // namespace

void TipPath::Add(glm::dvec2 p) {
  newest_ = p;
  if (!points_.empty() && glm::distance(points_.back(), p) < spacing_) return;
  points_.push_back(p);
  if (points_.size() < kMost) return;
  for (std::size_t i = 0; i < kMost / 2; ++i) points_[i] = points_[2 * i];
  points_.resize(kMost / 2);
  spacing_ *= 2;
}

std::vector<glm::dvec2> TipPath::Points() const {
  std::vector<glm::dvec2> points = points_;
  if (!points.empty() && points.back() != newest_) points.push_back(newest_);
  return points;
}

StrokeTrace::StrokeTrace(const IntendedStroke& stroke)
    : pieces_P(stroke.spine_P),
      outline_P(stroke.outline_P),
      edges(RisingEdges(stroke.outline_P)),
      spine(stroke.spine_P),
      covered(kCapacity),
      width(stroke.width),
      glyph(stroke.glyph),
      is_dot(stroke.kind == StrokeKind::kDot || !(spine.length() > 0)),
      path(stroke.width / 8) {}

double StrokeTrace::Cover(glm::dvec2 p) {
  const double reach = width / 4;
  if (outline_P.empty()) return spine.Cover(p, reach, covered);
  const Spine::Foot foot = spine.FootOf(p);
  const double distance = glm::distance(p, foot.point);
  // beyond the arc's ends nothing of it lies beside the tip
  const double beyond = std::abs(glm::dot(p - foot.point, foot.tangent));
  if (beyond > reach) return spine.Cover(p, reach, covered);
  const double error = std::min(distance, std::max(width / 2 - Inside(p), 0.0));
  if (error <= reach) spine.Cover(foot.point, reach, covered);
  return error;
}

double StrokeTrace::Inside(glm::dvec2 p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Piece& piece : outline_P) nearest = std::min(nearest, DistanceTo(piece, p));
  const auto crossed = std::count_if(edges.begin(), edges.end(),
                                     [p](const RisingEdge& edge) { return Crosses(edge, p); });
  return crossed % 2 == 1 ? nearest : -nearest;
}

TraceTally StrokeTrace::Closed() const {
  TraceTally closed = tally;
  closed.length = is_dot ? width : spine.length();
  closed.covered = covered.Total();
  if (is_dot) closed.covered = closest <= width / 4 ? width : 0;
  if (is_dot && std::isfinite(closest)) {
    closed.path_length = width;
    closed.error_integral = width * closest;
    closed.square_error_integral = width * closest * closest;
    closed.max_error = closest;
  }
  return closed;
}

void StrokeTrace::AddShape(TraceTally& closed) const {
  if (is_dot || !visited()) return;
  const double spacing = width / 4;
  const double wanted = std::ceil(spine.length() / spacing) + 1;
  const auto count =
      static_cast<std::size_t>(std::clamp(wanted, double{kFewestPoints}, double{kMostPoints}));
  const ShapeDistance distance =
      ShapeDistanceOf(Resampled(path.Points(), count),
                      Resampled(PointsAlong(pieces_P, spine.length() / 1000), count));
  closed.shaped = spine.length();
  closed.warped_length = spine.length() * distance.warped;
  closed.frechet = distance.frechet;
  closed.hausdorff = distance.hausdorff;
}

bool StrokeTrace::visited() const {
  return is_dot ? closest <= width / 4 : tally.followed > std::min(width, spine.length() / 2);
}

}  // namespace moontrace
