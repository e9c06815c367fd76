#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <vector>

namespace moontrace {

/// A link between two signs: its centre line, as points close together, from the origin of the sign
/// that it leaves [em]. Empty: there is none.
struct LinkWay {
  std::vector<glm::dvec2> all;
  std::vector<glm::dvec2> deep;  ///< those at its ends that are as deep as letters
};

/// The links that a script's signs have at a size, made ready for asking how far a felt point lies
/// from one. A value; read by any number of threads.
class LinkShapes {
 public:
  static constexpr double kFarthest = 0.25;  ///< as far as a distance gets [em]

  /// Part of a row of a line [em].
  struct Span {
    double from = 0, to = 0;
  };
  /// Rows of a line in which something lies, from below, and where.
  struct Spans {
    int first = 0;  ///< number of a row
    std::vector<Span> rows;
    int last() const { return first + static_cast<int>(rows.size()) - 1; }
    const Span& At(int row) const { return rows[static_cast<std::size_t>(row - first)]; }
  };
  /// The number of the row that a height above the base line lies in [em].
  static int RowOf(double y) { return static_cast<int>(std::floor(y / kRow)); }
  static constexpr double kNear = 0.1;  ///< of Link::near_spans [em]

  class Link {
   public:
    explicit Link(const LinkWay& way);
    bool exists() const { return !all_.cells.empty(); }
    /// Where Distance, and DistanceToDeep, can be less than kFarthest.
    const Spans& spans() const { return spans_; }
    const Spans& deep_spans() const { return deep_spans_; }
    /// Where Distance can be less than kNear.
    const Spans& near_spans() const { return near_spans_; }
    /// To its centre line, and to what of that is as deep as letters [em]. From a table of 0.03 em.
    double Distance(glm::dvec2 p) const noexcept { return all_.At(p); }
    double DistanceToDeep(glm::dvec2 p) const noexcept { return deep_.At(p); }

   private:
    static constexpr double kPerEm = 33;  ///< cells of a table
    static constexpr double kUnit = kFarthest / 255;
    struct Table {
      explicit Table(const std::vector<glm::dvec2>& points);
      Spans Within(double distance) const;
      double At(glm::dvec2 p) const noexcept {
        const glm::dvec2 cell = (p - corner) * kPerEm;
        if (!(cell.x >= 0 && cell.y >= 0 && cell.x < columns && cell.y < rows)) return kFarthest;
        const auto row = static_cast<std::size_t>(cell.y),
                   column = static_cast<std::size_t>(cell.x);
        return kUnit * cells[row * static_cast<std::size_t>(columns) + column];
      }
      glm::dvec2 corner{0, 0};  ///< lower left [em]
      int columns = 0, rows = 0;
      std::vector<std::uint8_t>
          cells;  ///< row by row from below, distance of their middles [kUnit]
    };
    Table all_, deep_;
    Spans spans_, near_spans_, deep_spans_;
  };

  using Between = std::function<LinkWay(std::size_t a, std::size_t b)>;

  /// `next`: from a sign to the next; `across`: over a space, null where words are not linked;
  /// `within`: between a sign's own parts. Each is asked once for all of `signs`.
  LinkShapes(std::size_t signs, const Between& next, const Between& across,
             const std::function<LinkWay(std::size_t)>& within);

  const Link& Next(std::size_t a, std::size_t b) const { return next_[a * signs_ + b]; }
  bool LinksWords() const { return !across_.empty(); }
  /// Only where words are linked.
  const Link& Across(std::size_t a, std::size_t b) const { return across_[a * signs_ + b]; }
  const Link& Within(std::size_t sign) const { return within_[sign]; }

 private:
  static constexpr double kRow = 0.16;  ///< height of a row [em]

  std::size_t signs_;
  std::vector<Link> next_, across_, within_;
};

}  // namespace moontrace
