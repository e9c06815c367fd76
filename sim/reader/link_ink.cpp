#include "sim/reader/link_ink.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 4.
constexpr double kNear = 0.55;    ///< a groove's floor lies so near to all of it, in widths
constexpr double kLetter = 0.65;  ///< of the way from a link's depth to a letter's is no link

bool IsLeft(glm::dvec2 a, glm::dvec2 b) { return a.x < b.x; }

}  // namespace

void MarkLinks(std::vector<HatchPoint>& points, double width, double link_depth) {
  const double deep = link_depth + kLetter * (1 - link_depth), reach = kNear * width;
  std::vector<glm::dvec2> floors;
  for (const HatchPoint& point : points) {
    if (point.ink && point.depth > deep) floors.push_back(point.felt);
  }
  std::sort(floors.begin(), floors.end(), IsLeft);
  for (HatchPoint& point : points) {
    const glm::dvec2 p = point.felt;
    const auto is_near = [p, reach](glm::dvec2 floor) { return glm::distance(floor, p) < reach; };
    const auto from = std::lower_bound(floors.begin(), floors.end(), p - reach, IsLeft);
    const auto to = std::upper_bound(from, floors.end(), p + reach, IsLeft);
    point.of_link = point.ink && std::none_of(from, to, is_near);
  }
}

}  // namespace moontrace
