#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/reader/sign_shapes.h"

namespace moontrace {

/// A line that is looked at step by step, and what its points count. All in em.
struct SteppedLine {
  double from = 0;    ///< of the first step
  int steps = 0;      ///< behind the first
  double window = 0;  ///< a sign's share of the line begins there, and is as long as its advance
  double weight = 1;  ///< of a point
  double worth = 0;   ///< of ink on a sign's lines [nats]
  double spread = 1;  ///< about them
  double cost = 0;    ///< of flat paper on them [nats]
  double inner = 1;   ///< flat paper so far off costs nothing, and all up to half of that
};

/// What ink so far from a line is worth against flat paper, but not below zero [nats]. `fall`: half
/// of one over its spread squared.
template <typename Real>
Real InkWorth(Real distance, Real worth, Real fall) {
  const Real left = worth - fall * distance * distance;
  return left > 0 ? left : 0;
}

/// How much flat paper at this distance speaks against a line: 1 on it and near it, 0 from `inner`
/// on. `fall`: two over `inner`.
template <typename Real>
Real FlatShare(Real distance, Real fall) {
  const Real left = 2 - fall * distance;
  const Real above = left > 0 ? left : 0;
  return above < 1 ? above : 1;
}

/// What a line's points say for a sign that begins at each of evenly spaced steps, all steps of a
/// sign at once: steps are whole cells of the signs' tables, which are laid out so that the cells
/// that a point falls into step by step lie side by side. Points beyond a sign's table, farther
/// from it than SignShapes::kFarthest, count nothing.
class StepGains {
 public:
  /// `cells` of the tables from step to step.
  StepGains(const SignShapes& shapes, int cells);

  double step() const { return cells_ / SignShapes::kPerEm; }  ///< [em]
  /// Of each sign at each step [nats].
  std::vector<std::vector<double>> Of(const std::vector<glm::dvec2>& ink,
                                      const std::vector<glm::dvec2>& flat,
                                      const SteppedLine& line) const;

 private:
  struct Sign {
    glm::dvec2 corner{0, 0};  ///< of the table, lower left [em]
    int columns = 0, rows = 0;
    double advance = 0;        ///< [em]
    int run = 0;               ///< cells of a row that lie whole steps apart
    std::vector<float> table;  ///< by row, then by column modulo `cells`, then by step
  };
  /// A point: in cells from the origin of a sign that begins at the first step, and how many steps
  /// right of the beginning of that sign's share it lies.
  struct Point {
    double column = 0, row = 0, steps = 0;
  };
  /// A point's cells, and the steps that they count for, last step first.
  struct Run {
    const float* cells = nullptr;
    std::ptrdiff_t to = 0, count = 0;
  };
  std::vector<Point> Points(const std::vector<glm::dvec2>& points, const SteppedLine& line) const;
  void FindRuns(const Sign& sign, const std::vector<Point>& points, int steps,
                std::vector<Run>& runs) const;
  static void AddInk(const std::vector<Run>& runs, float worth, float fall, float* gains);
  static void AddFlat(const std::vector<Run>& runs, float cost, float fall, float* gains);

  int cells_;
  std::vector<Sign> signs_;
};

}  // namespace moontrace
