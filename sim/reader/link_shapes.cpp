#include "sim/reader/link_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace moontrace {

LinkShapes::Link::Link(const LinkWay& way)
    : all_(way.all),
      deep_(way.deep),
      spans_(all_.Within(kFarthest)),
      near_spans_(all_.Within(kNear)),
      deep_spans_(deep_.Within(kFarthest)) {}

LinkShapes::Spans LinkShapes::Link::Table::Within(double distance) const {
  constexpr double kNone = 1e9;
  Spans spans;
  if (cells.empty()) return spans;
  const double top = corner.y + rows / kPerEm;
  spans.first = RowOf(corner.y);
  spans.rows.assign(static_cast<std::size_t>(RowOf(top) - spans.first) + 1, {kNone, -kNone});
  for (int row = 0; row < rows; ++row) {
    const double low = corner.y + row / kPerEm, high = corner.y + (row + 1) / kPerEm;
    for (int column = 0; column < columns; ++column) {
      const std::uint8_t cell =
          cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                static_cast<std::size_t>(column)];
      if (kUnit * cell >= distance) continue;
      for (int of = RowOf(low); of <= RowOf(high); ++of) {
        Span& span = spans.rows[static_cast<std::size_t>(of - spans.first)];
        span.from = std::min(span.from, corner.x + column / kPerEm);
        span.to = std::max(span.to, corner.x + (column + 1) / kPerEm);
      }
    }
  }
  return spans;
}

LinkShapes::Link::Table::Table(const std::vector<glm::dvec2>& points) {
  if (points.empty()) return;
  glm::dvec2 least = points.front(), most = points.front();
  for (const glm::dvec2& p : points) {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  corner = least - kFarthest;
  const glm::ivec2 count(glm::ceil((most + kFarthest - corner) * kPerEm));
  columns = count.x;
  rows = count.y;
  const auto width = static_cast<std::size_t>(columns);
  // of the least distances, since square roots for each point would take most of the time
  std::vector<double> squares(width * static_cast<std::size_t>(rows), kFarthest * kFarthest);
  for (const glm::dvec2& p : points) {
    const glm::ivec2 from = glm::max(glm::ivec2((p - kFarthest - corner) * kPerEm), 0);
    const glm::ivec2 to =
        glm::min(glm::ivec2((p + kFarthest - corner) * kPerEm), count - glm::ivec2(1));
    for (int row = from.y; row <= to.y; ++row) {
      double* const of_row = squares.data() + static_cast<std::size_t>(row) * width;
      const double y = corner.y + (row + 0.5) / kPerEm - p.y;
      for (int column = from.x; column <= to.x; ++column) {
        const double x = corner.x + (column + 0.5) / kPerEm - p.x;
        of_row[column] = std::min(of_row[column], x * x + y * y);
      }
    }
  }
  cells.reserve(squares.size());
  for (const double square : squares) {
    cells.push_back(static_cast<std::uint8_t>(std::lround(std::sqrt(square) / kUnit)));
  }
}

LinkShapes::LinkShapes(std::size_t signs, const Between& next, const Between& across,
                       const std::function<LinkWay(std::size_t)>& within)
    : signs_(signs) {
  for (std::size_t a = 0; a < signs; ++a) {
    within_.emplace_back(within(a));
    for (std::size_t b = 0; b < signs; ++b) {
      next_.emplace_back(next(a, b));
      if (across) across_.emplace_back(across(a, b));
    }
  }
}

}  // namespace moontrace
