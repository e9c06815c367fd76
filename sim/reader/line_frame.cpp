#include "sim/reader/line_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace moontrace {
namespace {

// In em; ours, chosen on seeds 1 to 20.
constexpr double kCoarseHeight = 0.07;
constexpr double kAbout = 0.1;     ///< a line's ink counts as its own
constexpr std::size_t kStray = 2;  ///< felt points may lie left of the line
constexpr std::size_t kFlatShare =
    3;                              ///< one in so many places of flat paper tells enough coarsely
constexpr double kBeginning = 0.5;  ///< so much of the line tells most frames to be wrong
constexpr std::size_t kLikeliest = 60;  ///< the others are tried on all of it
constexpr std::size_t kByLinks = 6;     ///< and so many with their links
constexpr double kHeights[] = {-0.04, -0.02, 0.02, 0.04};
constexpr double kScales[] = {0.97, 0.98, 0.99, 1.01, 1.02, 1.03};
constexpr double kTurns[] = {-0.012, -0.006, 0.006, 0.012};  ///< [rad]
constexpr int kRounds = 3;

class Search {
 public:
  Search(const LineBelief& belief, const std::vector<HatchPoint>& points, const FrameRange& range)
      : belief_(belief), points_(points), range_(range) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].ink || i % kFlatShare == 0) few_.push_back(points[i]);
    }
    beginning_ = range.met.x + kBeginning * (range.felt_to.x - range.met.x);
    for (std::size_t i = 0; i < few_.size(); ++i) {
      if (few_[i].p.x > beginning_) continue;
      if (few_[i].ink || i % 2 == 0) fewer_.push_back(few_[i]);
    }
  }

  /// Everywhere: all frames by the line's beginning, and the likeliest of them by all of it.
  void Coarsely() {
    struct Tried {
      SignPlace frame;
      double log = 0;
    };
    std::vector<Tried> tried;
    const glm::dvec2 beginning{beginning_, range_.felt_to.y};
    for (const double size : range_.sizes) {
      for (const double turn : range_.turns) {
        for (double y = range_.from; y < range_.to; y += kCoarseHeight) {
          SignPlace frame{range_.met, size, turn};
          frame.origin = FromEm(frame, {0, -y});
          const std::optional<double> left = FirstInk(frame);
          if (!left) continue;
          frame.origin = FromEm(frame, {*left, 0});
          tried.push_back({frame, Fit(fewer_, frame, LineBelief::Steps::kCoarse, beginning)});
        }
      }
    }
    const auto likeliest =
        tried.begin() + static_cast<std::ptrdiff_t>(std::min(kLikeliest, tried.size()));
    std::partial_sort(tried.begin(), likeliest, tried.end(),
                      [](const Tried& a, const Tried& b) { return a.log > b.log; });
    tried.erase(likeliest, tried.end());
    for (Tried& one : tried) one.log = Consider(few_, one.frame, LineBelief::Steps::kCoarse);
    std::sort(tried.begin(), tried.end(),
              [](const Tried& a, const Tried& b) { return a.log > b.log; });
    for (const Tried& one : tried) likeliest_.push_back(one.frame);
  }

  /// With the links of letters as large as those of the best, among the likeliest.
  void WithLinks() {
    if (!range_.links || !std::isfinite(most_)) return;
    links_ = range_.links(best_.size);
    most_ = -INFINITY;
    likeliest_.resize(std::min(likeliest_.size(), kByLinks));
    for (const SignPlace& frame : likeliest_) Consider(few_, frame, LineBelief::Steps::kCoarse);
  }

  void BeginAbout(const SignPlace& frame) {
    if (range_.links) links_ = range_.links(frame.size);
    best_ = frame;
    most_ = 0;
  }

  /// About the best so far, one number after another.
  void Finely(bool sizes, bool turns) {
    if (!std::isfinite(most_)) return;
    most_ = Fit(points_, best_, LineBelief::Steps::kFine, range_.felt_to);
    for (int round = 0; round < kRounds; ++round) {
      const SignPlace about = best_;
      for (const double y : kHeights) {
        SignPlace frame = about;
        frame.origin = FromEm(about, {0, y});
        Consider(points_, frame, LineBelief::Steps::kFine);
      }
      const SignPlace lifted = best_;
      for (const double scale : kScales) {
        const SignPlace frame = Changed(lifted, 0, scale, 0);
        if (sizes) Consider(points_, frame, LineBelief::Steps::kFine);
      }
      const SignPlace sized = best_;
      for (const double turn : kTurns) {
        const SignPlace frame = Changed(sized, 0.5 * ToEm(sized, range_.felt_to).x, 1, turn);
        if (turns) Consider(points_, frame, LineBelief::Steps::kFine);
      }
    }
  }

  FrameFit Best() const {
    if (!std::isfinite(most_)) return {{}, -INFINITY};
    return {best_, most_ + belief_.CostOfInk(points_, best_)};
  }

 private:
  /// About what lies so far right of the frame's origin, halfway up its ink: so one number changes
  /// the others least.
  SignPlace Changed(const SignPlace& frame, double x, double scale, double turn) const {
    const glm::dvec2 about{x, 0.5 * (belief_.bounds().min.y + belief_.bounds().max.y)};
    const SignPlace there{FromEm(frame, about), frame.size * scale, frame.turn + turn};
    return {FromEm(there, -about), there.size, there.turn};
  }

  /// Where the line's ink begins, but for what was felt astray [em].
  std::optional<double> FirstInk(const SignPlace& frame) const {
    const Box& own = belief_.bounds();
    std::vector<double> ink;
    const EmFrame em(frame);
    for (const HatchPoint& point : points_) {
      const glm::dvec2 p = em.To(point.p);
      const bool inside = p.y > own.min.y - kAbout && p.y < own.max.y + kAbout;
      if (point.ink && !point.of_link && inside) ink.push_back(p.x);
    }
    if (ink.size() <= kStray) return std::nullopt;
    std::nth_element(ink.begin(), ink.begin() + kStray, ink.end());
    return ink[kStray];
  }

  double Fit(const std::vector<HatchPoint>& points, const SignPlace& frame, LineBelief::Steps steps,
             glm::dvec2 felt_to) const {
    LinePrior prior;
    prior.next = frame;
    prior.before = range_.before;
    prior.behind = range_.behind;
    prior.unsure = range_.unsure;
    prior.anywhere = true;
    prior.links = links_.get();
    prior.felt_to = ToEm(frame, felt_to).x;
    return belief_.Fit(points, prior, steps) - belief_.CostOfInk(points, frame);
  }

  double Consider(const std::vector<HatchPoint>& points, const SignPlace& frame,
                  LineBelief::Steps steps) {
    const double log = Fit(points, frame, steps, range_.felt_to);
    if (log > most_) {
      most_ = log;
      best_ = frame;
    }
    return log;
  }

  const LineBelief& belief_;
  const std::vector<HatchPoint>& points_;
  const FrameRange& range_;
  std::vector<HatchPoint> few_, fewer_;
  double beginning_ = 0;  ///< of the line ends there, `fewer_` lies left of it [m]
  std::vector<SignPlace> likeliest_;
  std::shared_ptr<const LinkShapes> links_;
  SignPlace best_;
  double most_ = -INFINITY;
};

}  // namespace

FrameFit FitFrame(const LineBelief& belief, const std::vector<HatchPoint>& points,
                  const FrameRange& range) {
  Search search(belief, points, range);
  search.Coarsely();
  search.WithLinks();
  search.Finely(range.sizes.size() > 1, range.turns.size() > 1);
  return search.Best();
}

FrameFit RefineFrame(const LineBelief& belief, const std::vector<HatchPoint>& points,
                     const FrameRange& range, const SignPlace& about) {
  Search search(belief, points, range);
  search.BeginAbout(about);
  search.Finely(true, true);
  return search.Best();
}

}  // namespace moontrace
