#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/reader/link_gain.h"
#include "sim/reader/link_shapes.h"
#include "sim/reader/sign_belief.h"
#include "sim/reader/step_gains.h"

namespace moontrace {

/// What was felt at one place of a line that is gone over from edge to edge.
struct HatchPoint {
  glm::dvec2 p{0, 0};     ///< of ink where its middle must lie, as its slope tells [m]
  bool ink = false;       ///< else flat paper
  bool of_link = false;   ///< ink of a link between letters
  glm::dvec2 felt{0, 0};  ///< where the tip was [m]
  double depth = 0;       ///< of it, share of a letter's
};

/// What is known of a line before its signs.
struct LinePrior {
  SignPlace next;         ///< where the next sign is expected
  double before = 0;      ///< it may begin so far left of that [em]
  double behind = 0;      ///< or right [em]
  double gap = 0;         ///< between signs, beyond the script's own [em]
  double unsure = 0;      ///< rms error of places [m]
  double felt_to = 0;     ///< all before was felt, from `next` [em]
  bool anywhere = false;  ///< within those bounds it begins anywhere, not most likely at `next`
  double claimed = 0;     ///< share of the ink left of `next` that the sign before accounts for
  const LinkShapes* links = nullptr;  ///< between signs; null: signs stand apart
  std::optional<std::size_t> left;    ///< the sign before, from which a link may come
};

/// The next thing on a line.
struct NextOnLine {
  SignGuess sign;      ///< kUnknown: something that is no sign
  bool space = false;  ///< before it
  bool end = false;    ///< nothing more comes
};

/// Signs one after another, made out from all that was felt of a line: where each begins depends on
/// the one before, so that a line's likelihood is a sum over all ways to divide it, from its end
/// backwards (the backward half of the forward-backward algorithm). Each point counts by what it
/// says against flat paper: ink by its squared distance from the sign's lines, up to a bound, flat
/// paper against signs that have ink there. Where signs are linked, each pair also by its link: its
/// ends explain ink, if less well than signs do, and all of it what was felt to be a link's. For
/// ridges and dots, which no tip follows, and for linked grooves.
class LineBelief {
 public:
  /// `width`: of groove or ridge [m]; `space`: advance [em]. The shapes have dots by their middles.
  /// `shapes` must outlive this.
  LineBelief(const SignShapes& shapes, double width, double space);

  /// How closely it looks for where signs begin: every 0.04 em, or 0.08.
  enum class Steps { kFine, kCoarse };

  /// Log likelihood of what was felt, against flat paper. Pure; the time grows with points times
  /// signs.
  double Fit(const std::vector<HatchPoint>& points, const LinePrior& prior, Steps steps) const;
  /// What ink costs that a line must account for: all that lies above it, which is part of none,
  /// and half of that on it, so that a line is not better for taking in what lies between two
  /// others.
  double CostOfInk(const std::vector<HatchPoint>& points, const SignPlace& line) const;
  /// What comes next. Its place is fitted to its points.
  NextOnLine Next(const std::vector<HatchPoint>& points, const LinePrior& prior) const;

  /// All ink of all signs, in em.
  const Box& bounds() const { return bounds_; }
  double widest() const { return widest_; }  ///< advance [em]

 private:
  struct Line {
    // by x, apart, since a branch on what a point is would be mispredicted
    std::vector<glm::dvec2> ink, flat;  ///< [em]
    double half_width = 0;              ///< [em]
    double spread = 0;                  ///< of ink about a sign's lines [em]
    double flat_cost = 0;               ///< of flat paper on one
    double step = 0;                    ///< [em]
    double from = 0;                    ///< of the first step [em]
    int steps = 0;
    std::vector<double> worth;               ///< of ink left of each step's sign's share, at most
    std::vector<std::vector<double>> gains;  ///< Gain of each sign at each step
    std::optional<LinkGains> of_links;       ///< where there are links

    double XOf(int k) const { return from + k * step; }
    int StepOf(double em) const;  ///< the number of a step
    int StepsIn(double em) const;
    /// Of the ink between two steps: signs that begin nearer than they are wide both claim it.
    double WorthBetween(int a, int b) const;
  };
  /// What a line says from each step on.
  struct Backward {
    std::vector<double> begins;    ///< a sign begins there
    std::vector<double> expected;  ///< one is expected about there
    // the same of each sign, where there are links, by step and sign
    std::vector<std::vector<double>> sign_begins, sign_expected;
    std::vector<double> unlinked;  ///< what is no sign is expected there, or nothing
  };
  /// A sign that begins at a step, and what its own points say.
  struct Begins {
    std::size_t sign = 0;
    int step = 0;
    double own = 0;
  };

  Line Prepared(const std::vector<HatchPoint>& points, const LinePrior& prior, Steps steps) const;
  double Gain(const Line& line, std::size_t sign, glm::dvec2 at) const;
  double UnknownGain(const Line& line, double x) const;
  double OwnGain(const Line& line, const LinePrior& prior, std::size_t sign, int k) const;
  SignPair PairOf(std::size_t a, std::size_t b, double x_a, double x_b) const;
  double FromLeft(const Line& line, const LinePrior& prior, std::size_t sign, double x,
                  int spaces) const;
  double From(const Line& line, const LinePrior& prior, const Backward& back, const Begins& begins,
              int then) const;
  void Expect(const Line& line, const LinePrior& prior, int k, Backward& back) const;
  Backward LookBack(const Line& line, const LinePrior& prior) const;
  SignPlace Placed(const Line& line, std::size_t sign, double x, const LinePrior& prior) const;

  const SignShapes* shapes_;
  StepGains fine_, coarse_;
  double width_, space_;
  Box bounds_;
  double widest_ = 0;
  double window_ = 0;  ///< a sign's share of the line begins there [em]
};

}  // namespace moontrace
