#include "sim/reader/line_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace moontrace {
namespace {

// In em; ours, chosen on seeds 1 to 20.
constexpr double kCoarseHeight = 0.07;
constexpr double kCoarseStep = 0.08, kFineStep = 0.04;  ///< of where signs can begin
constexpr double kAbout = 0.1;                          ///< a line's ink counts as its own
constexpr std::size_t kStray = 2;                       ///< felt points may lie left of the line
constexpr std::size_t kFlatShare =
    3;  ///< one in so many places of flat paper tells enough coarsely
constexpr double kHeights[] = {-0.04, -0.02, 0.02, 0.04};
constexpr double kScales[] = {0.97, 0.98, 0.99, 1.01, 1.02, 1.03};
constexpr double kTurns[] = {-0.012, -0.006, 0.006, 0.012};  ///< [rad]
constexpr int kRounds = 2;
constexpr std::size_t kBegun = 4;  ///< of those tried coarsely, where the size is not known

class Search {
 public:
  Search(const LineBelief& belief, const std::vector<HatchPoint>& points, const FrameRange& range)
      : belief_(belief), points_(points), range_(range) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].ink || i % kFlatShare == 0) few_.push_back(points[i]);
    }
  }

  /// Everywhere.
  void Coarsely() {
    for (const double size : range_.sizes) {
      for (const double turn : range_.turns) {
        for (double y = range_.from; y < range_.to; y += kCoarseHeight) {
          SignPlace frame{range_.met, size, turn};
          frame.origin = FromEm(frame, {0, -y});
          const std::optional<double> left = FirstInk(frame);
          if (!left) continue;
          frame.origin = FromEm(frame, {*left, 0});
          tried_.push_back({frame, Fit(few_, frame, kCoarseStep)});
        }
      }
    }
  }

  /// About the best of those, and about the best that are quite different.
  void Finely() {
    std::sort(tried_.begin(), tried_.end(), [](const FrameFit& a, const FrameFit& b) {
      return a.log_likelihood > b.log_likelihood;
    });
    std::vector<SignPlace> begun;
    for (const FrameFit& tried : tried_) {
      if (begun.size() == (range_.sizes.size() > 1 ? kBegun : 1)) break;
      const auto like = [&tried](const SignPlace& other) { return AreAlike(tried.frame, other); };
      if (std::any_of(begun.begin(), begun.end(), like)) continue;
      begun.push_back(tried.frame);
      FinelyAbout(tried.frame);
    }
  }

  FrameFit Best() const {
    FrameFit best = best_;
    if (!tried_.empty()) best.log_likelihood += belief_.CostOfInk(points_, best.frame);
    return best;
  }

 private:
  /// Where the line's ink begins, but for what was felt astray [em].
  std::optional<double> FirstInk(const SignPlace& frame) const {
    const Box& own = belief_.bounds();
    std::vector<double> ink;
    for (const HatchPoint& point : points_) {
      const glm::dvec2 p = ToEm(frame, point.p);
      const bool inside = p.y > own.min.y - kAbout && p.y < own.max.y + kAbout;
      if (point.ink && inside) ink.push_back(p.x);
    }
    if (ink.size() <= kStray) return std::nullopt;
    std::nth_element(ink.begin(), ink.begin() + kStray, ink.end());
    return ink[kStray];
  }

  static bool AreAlike(const SignPlace& a, const SignPlace& b) {
    constexpr double kSize = 0.06, kHeight = 0.2;  // log, em
    return std::abs(std::log(a.size / b.size)) < kSize && std::abs(ToEm(a, b.origin).y) < kHeight;
  }

  /// One number after another.
  void FinelyAbout(const SignPlace& begin) {
    FrameFit best{begin, Fit(points_, begin, kFineStep)};
    const auto consider = [this, &best](const SignPlace& frame) {
      const double log = Fit(points_, frame, kFineStep);
      if (log > best.log_likelihood) best = {frame, log};
    };
    for (int round = 0; round < kRounds; ++round) {
      const SignPlace about = best.frame;
      for (const double y : kHeights) {
        SignPlace frame = about;
        frame.origin = FromEm(about, {0, y});
        consider(frame);
      }
      const SignPlace lifted = best.frame;
      for (const double scale : kScales) {
        SignPlace frame = lifted;
        frame.size = scale * lifted.size;
        if (range_.sizes.size() > 1) consider(frame);
      }
      const SignPlace sized = best.frame;
      for (const double turn : kTurns) {
        SignPlace frame = sized;
        frame.turn = sized.turn + turn;
        if (range_.turns.size() > 1) consider(frame);
      }
    }
    if (best.log_likelihood > best_.log_likelihood) best_ = best;
  }

  double Fit(const std::vector<HatchPoint>& points, const SignPlace& frame, double step) const {
    LinePrior prior;
    prior.next = frame;
    prior.before = range_.before;
    prior.behind = range_.behind;
    prior.unsure = range_.unsure;
    prior.anywhere = true;
    prior.felt_to = ToEm(frame, range_.felt_to).x;
    return belief_.Fit(points, prior, step) - belief_.CostOfInk(points, frame);
  }

  const LineBelief& belief_;
  const std::vector<HatchPoint>& points_;
  const FrameRange& range_;
  std::vector<HatchPoint> few_;
  std::vector<FrameFit> tried_;
  FrameFit best_{{}, -INFINITY};
};

}  // namespace

FrameFit FitFrame(const LineBelief& belief, const std::vector<HatchPoint>& points,
                  const FrameRange& range) {
  Search search(belief, points, range);
  search.Coarsely();
  search.Finely();
  return search.Best();
}

}  // namespace moontrace
