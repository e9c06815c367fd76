#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/reader/link_shapes.h"
#include "sim/reader/step_gains.h"

namespace moontrace {

/// Two signs that may be linked, on the base line, and where the line is divided between them [em].
struct SignPair {
  std::size_t a = 0, b = 0;
  double x_a = 0, x_b = 0;
  double from = 0, split = 0, to = 0;  ///< their shares of the line
};

/// What links explain of a line's points. All in em.
class LinkGains {
 public:
  /// The points by x. Of `line` what points count. `shapes` must outlive this.
  LinkGains(const SignShapes& shapes, const SteppedLine& line, const std::vector<glm::dvec2>& ink,
            const std::vector<glm::dvec2>& flat, const std::vector<glm::dvec2>& of_links);

  /// What a link explains that its signs do not: its ends, which are as deep as letters, explain
  /// ink, if less well than signs do, and all of it what was felt to be a link's; flat paper on it
  /// speaks against it, up to a bound, since links may go otherwise than they would alone [nats].
  /// What lies LinkShapes::kFarthest from it and farther counts nothing.
  double Of(const LinkShapes::Link& link, const SignPair& pair) const;

 private:
  /// Points by the rows of LinkShapes, each row by x.
  class Rows {
   public:
    explicit Rows(const std::vector<glm::dvec2>& points);
    /// Calls `each` with those that lie within a link's spans and right of `from`, left of `to`;
    /// spans and points from the origin of the sign that the link leaves, which is `x` from theirs.
    template <typename Each>
    void Within(const LinkShapes::Spans& spans, double x, double from, double to, Each each) const;

   private:
    int first_ = 0;  ///< number of the first row
    std::vector<std::vector<glm::dvec2>> rows_;
  };

  const SignShapes* shapes_;
  SteppedLine line_;
  Rows ink_, flat_, of_links_;
};

}  // namespace moontrace
