#include "sim/reader/guide_line.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace moontrace {
namespace {

// Ours, in em unless said. Lines lie at least an em apart.
constexpr double kLeastHeight = 1.1, kMostHeight = 4;
constexpr double kMostSlant = 0.4;                  ///< of the chord, as a tangent
constexpr double kFlattest = 0.1, kRoundest = 0.5;  ///< how far it bulges, share of its height
constexpr double kNear = 0.15;                      ///< the arc, most of what was felt
constexpr double kMost = 0.85;

}  // namespace

std::optional<GuideLine> FitGuide(const std::vector<FeltPoint>& grooves, const SignPlace& line) {
  if (grooves.empty()) return std::nullopt;
  const EmFrame frame(line);
  std::vector<glm::dvec2> felt;
  felt.reserve(grooves.size());
  for (const FeltPoint& groove : grooves) felt.push_back(frame.To(groove.p));
  const auto [low, high] = std::minmax_element(
      felt.begin(), felt.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
  const glm::dvec2 chord = *high - *low;
  if (!(chord.y > kLeastHeight && chord.y < kMostHeight)) return std::nullopt;
  if (std::abs(chord.x) > kMostSlant * chord.y) return std::nullopt;
  const double height = glm::length(chord);
  const glm::dvec2 normal = glm::dvec2(-chord.y, chord.x) / height;  // to the left of it
  double left = 0, right = 0;
  for (const glm::dvec2 p : felt) {
    const double off = glm::dot(p - *low, normal);
    left = std::max(left, off);
    right = std::max(right, -off);
  }
  const double bulge = left > right ? left : -right;
  if (std::abs(bulge) < kFlattest * height || std::abs(bulge) > kRoundest * height) {
    return std::nullopt;
  }
  // the circle through both ends and where it bulges most
  const double radius = (0.25 * height * height + bulge * bulge) / (2 * std::abs(bulge));
  const glm::dvec2 middle = 0.5 * (*low + *high) + normal * (bulge - std::copysign(radius, bulge));
  double near = 0, all = 0;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const double off = std::abs(glm::distance(felt[i], middle) - radius);
    near += off < kNear ? grooves[i].weight : 0;
    all += grooves[i].weight;
  }
  if (near < kMost * all) return std::nullopt;
  return GuideLine{grooves[static_cast<std::size_t>(high - felt.begin())].p,
                   grooves[static_cast<std::size_t>(low - felt.begin())].p, bulge < 0};
}

}  // namespace moontrace
