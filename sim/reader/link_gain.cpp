#include "sim/reader/link_gain.h"

#include <algorithm>
#include <cmath>

namespace moontrace {
namespace {

// Ours, chosen on seeds 1 to 4.
constexpr double kLinkInk = 0.7;  ///< share of a sign's ink that ink on a link's end counts
constexpr double kOfLink = 0.3;   ///< the same of ink felt to be a link's
constexpr double kOtherWay = 15;  ///< costs a link that goes otherwise than it would alone [nats]

}  // namespace

LinkGains::Rows::Rows(const std::vector<glm::dvec2>& points) {
  if (points.empty()) return;
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.y < b.y; });
  first_ = LinkShapes::RowOf(low->y);
  rows_.resize(static_cast<std::size_t>(LinkShapes::RowOf(high->y) - first_) + 1);
  for (const glm::dvec2 p : points) {
    rows_[static_cast<std::size_t>(LinkShapes::RowOf(p.y) - first_)].push_back(p);
  }
}

template <typename Each>
void LinkGains::Rows::Within(const LinkShapes::Spans& spans, double x, double from, double to,
                             Each each) const {
  const int last = first_ + static_cast<int>(rows_.size()) - 1;
  for (int row = std::max(first_, spans.first); row <= std::min(last, spans.last()); ++row) {
    const LinkShapes::Span span = spans.At(row);
    const double left = std::max(from, x + span.from), right = std::min(to, x + span.to);
    if (left >= right) continue;
    const std::vector<glm::dvec2>& points = rows_[static_cast<std::size_t>(row - first_)];
    auto point = std::lower_bound(points.begin(), points.end(), left,
                                  [](glm::dvec2 p, double edge) { return p.x < edge; });
    for (; point != points.end() && point->x < right; ++point) each(*point);
  }
}

LinkGains::LinkGains(const SignShapes& shapes, const SteppedLine& line,
                     const std::vector<glm::dvec2>& ink, const std::vector<glm::dvec2>& flat,
                     const std::vector<glm::dvec2>& of_links)
    : shapes_(&shapes), line_(line), ink_(ink), flat_(flat), of_links_(of_links) {}

double LinkGains::Of(const LinkShapes::Link& link, const SignPair& pair) const {
  if (!link.exists()) return 0;
  const glm::dvec2 at{pair.x_a, 0}, at_b{pair.x_b, 0};
  const double ink_fall = 0.5 / (line_.spread * line_.spread), flat_fall = 2 / line_.inner;
  const auto to_sign = [&](glm::dvec2 p) {
    return p.x < pair.split ? shapes_->Distance(pair.a, p - at)
                            : shapes_->Distance(pair.b, p - at_b);
  };
  double gain = 0, flat = 0;
  ink_.Within(link.deep_spans(), at.x, pair.from, pair.to, [&](glm::dvec2 p) {
    const double to_link = link.DistanceToDeep(p - at);
    const double by_link = kLinkInk * InkWorth(to_link, line_.worth, ink_fall);
    if (by_link <= 0 || to_link >= LinkShapes::kFarthest) return;
    gain += std::max(0.0, by_link - InkWorth(std::max(0.0, to_sign(p)), line_.worth, ink_fall));
  });
  of_links_.Within(link.spans(), at.x, pair.from, pair.to, [&](glm::dvec2 p) {
    const double to_link = link.Distance(p - at);
    if (to_link < LinkShapes::kFarthest) gain += kOfLink * InkWorth(to_link, line_.worth, ink_fall);
  });
  const bool near = line_.inner <= LinkShapes::kNear;
  flat_.Within(near ? link.near_spans() : link.spans(), at.x, pair.from, pair.to,
               [&](glm::dvec2 p) {
                 const double share = FlatShare(link.Distance(p - at), flat_fall);
                 if (share > 0 && to_sign(p) >= line_.inner) flat += share;
               });
  return std::max(-kOtherWay, line_.weight * (gain - line_.cost * flat));
}

}  // namespace moontrace
