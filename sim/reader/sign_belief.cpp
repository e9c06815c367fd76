#include "sim/reader/sign_belief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace moontrace {
namespace {

// In em and nats; ours, chosen on seeds 1 to 20.
constexpr double kWithinFill = 0.045;  ///< counts for the distance there at most
constexpr double kSpread = 0.03;       ///< of felt points from the centre line
constexpr double kMostAGroove = 8;     ///< cost of a groove where the sign has none
constexpr double kCrossedSpread =
    1.2;                              ///< of a groove that was only crossed, against a followed one
constexpr double kNextSign = 0.5;     ///< cost of one that was crossed where the next sign is
constexpr double kBefore = 0.06;      ///< from so far before that
constexpr double kMostAFlat = 4;      ///< cost of flat paper in the middle of a groove
constexpr double kWithinALeg = 0.5;   ///< of an unsure place's error, what changes over a leg
constexpr double kUnknownCost = 1.0;  ///< of each groove point, for what is no sign
constexpr double kOtherSize = 8;      ///< log of how much rarer they are; see PlacePrior
constexpr double kUnknownPrior = 5;   ///< before anything was felt
constexpr double kCoarse = 0.06, kFine = 0.02;
constexpr double kSlack = 0.12;  ///< felt points may lie so far beyond a sign's box
/// Fits that cost so much more than the best say nothing: e^-30 as likely.
constexpr double kNegligible = 30;
constexpr double kOffGrid = 1;  ///< may cost each groove point, for the coarse grid's steps

/// Evidence in em, about the first place that is tried, so that other places are a shift away.
struct ScaledEvidence {
  std::vector<FeltPoint> grooves, flats;
  Box box;            ///< of the grooves that were followed
  double weight = 0;  ///< of all grooves
  double half_width = 0;
  double spread = kSpread;  ///< of felt points
  double crossed_spread = kSpread;
  double next_within = kBefore;  ///< before a sign's end what is crossed may be the next one's
  bool leftwards = false;        ///< the next one stands on the left
  double flat_cost = kMostAFlat, wall_cost = kMostAFlat;
};

/// What was felt one after another lies side by side and says much the same: taken in leaps, a bad
/// fit shows sooner.
std::vector<FeltPoint> InLeaps(const std::vector<FeltPoint>& points) {
  std::size_t leap = std::max<std::size_t>(1, points.size() * 5 / 8);
  while (std::gcd(leap, points.size()) > 1) ++leap;
  std::vector<FeltPoint> leapt;
  leapt.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) leapt.push_back(points[i * leap % points.size()]);
  return leapt;
}

ScaledEvidence Scaled(const SignEvidence& evidence, const SignPlace& place, bool leftwards) {
  ScaledEvidence scaled;
  scaled.leftwards = leftwards;
  const EmFrame frame(place);
  for (const FeltPoint& felt : evidence.grooves) {
    scaled.grooves.push_back({frame.To(felt.p), felt.weight, felt.crossed});
    scaled.weight += felt.weight;
    if (!felt.crossed) Include(scaled.box, scaled.grooves.back().p);
  }
  for (const FeltPoint& felt : evidence.flats) {
    const glm::dvec2 p = frame.To(felt.p);
    if (Contains(Grown(scaled.box, 1.2), p)) scaled.flats.push_back({p, felt.weight, felt.crossed});
  }
  scaled.grooves = InLeaps(scaled.grooves);
  scaled.flats = InLeaps(scaled.flats);
  scaled.half_width = 0.5 * evidence.width / place.size;
  const double unsure = evidence.unsure / place.size;
  scaled.spread = std::hypot(kSpread, kWithinALeg * unsure);
  scaled.crossed_spread = std::hypot(kCrossedSpread * kSpread, unsure);
  // what was felt beside a line by an unsure hand may have been on it
  scaled.next_within = kBefore + unsure;
  scaled.wall_cost = kMostAFlat * kSpread / scaled.spread;
  scaled.flat_cost = kMostAFlat * kSpread / std::hypot(kSpread, unsure);
  return scaled;
}

/// Cost of all that was felt if the sign lies shifted by `shift` [em]; gives up beyond `most`.
double CostOf(const SignShapes& shapes, std::size_t sign, const ScaledEvidence& felt,
              glm::dvec2 shift, double most) {
  const double followed = 0.5 / (felt.spread * felt.spread);
  const double crossed = 0.5 / (felt.crossed_spread * felt.crossed_spread);
  // where the sign on its right begins, or the one on its left ends, as the line runs
  const double gap = shapes.Advance(sign) - shapes.Bounds(sign).max.x;
  const double end = felt.leftwards ? HUGE_VAL : shapes.Advance(sign) - felt.next_within;
  const double begin = felt.leftwards ? felt.next_within - gap : -HUGE_VAL;
  double cost = 0;
  for (const FeltPoint& groove : felt.grooves) {
    const glm::dvec2 p = groove.p - shift;
    // a tip within a fill may be anywhere in it, which says less than one on a line
    const double d = std::max(shapes.Distance(sign, p), -kWithinFill);
    const bool beyond = groove.crossed && (p.x > end || p.x < begin);
    cost += groove.weight * std::min((groove.crossed ? crossed : followed) * d * d,
                                     beyond ? kNextSign : kMostAGroove);
    if (cost > most) return cost;
  }
  const double inner = 0.75 * felt.half_width;
  for (const FeltPoint& flat : felt.flats) {
    const double d = std::max(shapes.Distance(sign, flat.p - shift), 0.0);
    if (d >= inner) continue;
    cost += flat.weight * (flat.crossed ? felt.flat_cost : felt.wall_cost) *
            std::min(1.0, 2 * (1 - d / inner));
    if (cost > most) return cost;
  }
  return cost;
}

/// Half the squared distance to the nearest expected origin, in standard deviations.
double PriorCost(const std::vector<glm::dvec2>& origins, const PlacePrior& prior,
                 glm::dvec2 shift) {
  if (origins.empty()) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec2 origin : origins) {
    const glm::dvec2 off = (shift - origin) / glm::dvec2(prior.along, prior.across);
    least = std::min(least, 0.5 * (off.x * off.x + off.y * off.y));
  }
  return least;
}

/// Cost of how much farther a sign reaches than what was felt, along or across the line, whichever
/// it falls less short of: a mark may have been left out.
double ShortfallCost(const Box& sign, const Box& felt) {
  constexpr double kTells = 0.6, kAllowed = 0.08, kSpreads = 0.1;  // [em]
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    const double extent = sign.max[i] - sign.min[i];
    if (extent > kTells) least = std::min(least, extent - (felt.max[i] - felt.min[i]));
  }
  if (!std::isfinite(least)) return 0;
  const double off = std::max(0.0, least - kAllowed) / kSpreads;
  return 0.5 * off * off;
}

struct Fit {
  double cost = std::numeric_limits<double>::infinity();
  glm::dvec2 shift{0, 0};
  bool found = false;  ///< else the cost is only a bound
};

/// Tries places on a grid about `middle`, `reach` to either side.
void TryAbout(const SignShapes& shapes, std::size_t sign, const ScaledEvidence& felt,
              const std::vector<glm::dvec2>& origins, const PlacePrior& prior, Box range,
              double step, Fit& best) {
  const int columns = static_cast<int>(std::ceil((range.max.x - range.min.x) / step - 1e-9));
  const int rows = static_cast<int>(std::ceil((range.max.y - range.min.y) / step - 1e-9));
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const glm::dvec2 shift = range.min + step * glm::dvec2(i, j);
      const double prior_cost = PriorCost(origins, prior, shift);
      if (prior_cost > best.cost) continue;
      const double cost = prior_cost + CostOf(shapes, sign, felt, shift, best.cost - prior_cost);
      if (cost < best.cost) best = {cost, shift, true};
    }
  }
}

/// Shifts that put all grooves into the sign's box, with some slack, and within reach of what is
/// expected.
Box RangeOf(const Box& sign, const ScaledEvidence& felt, const std::vector<glm::dvec2>& origins,
            const PlacePrior& prior) {
  Box range{felt.box.max - sign.max - kSlack, felt.box.min - sign.min + kSlack};
  if (!origins.empty()) {
    Box expected;
    for (const glm::dvec2 origin : origins) Include(expected, origin);
    const glm::dvec2 reach = 3.0 * glm::dvec2(prior.along, prior.across);
    range.min = {std::max(range.min.x, expected.min.x - reach.x),
                 std::max(range.min.y, expected.min.y - reach.y)};
    range.max = {std::min(range.max.x, expected.max.x + reach.x),
                 std::min(range.max.y, expected.max.y + reach.y)};
  }
  return range;
}

/// None that costs more than `most`.
std::optional<Fit> BestFit(const SignShapes& shapes, std::size_t sign, const ScaledEvidence& felt,
                           const std::vector<glm::dvec2>& origins, const PlacePrior& prior,
                           double most) {
  const Box range = RangeOf(shapes.Bounds(sign), felt, origins, prior);
  if (range.min.x > range.max.x || range.min.y > range.max.y) return std::nullopt;
  Fit best;
  best.cost = most + kOffGrid * felt.weight;
  TryAbout(shapes, sign, felt, origins, prior, range, kCoarse, best);
  if (!best.found) return std::nullopt;
  const glm::dvec2 reach(kCoarse - kFine);
  TryAbout(shapes, sign, felt, origins, prior, {best.shift - reach, best.shift + reach}, kFine,
           best);
  return best;
}

/// Calls `each` with a sign, the frame that fits its evidence, the index of its size (those of
/// prior.other_sizes come last) and the best fit there, with what its size costs. Fits that are
/// negligible beside one before are left out.
template <typename Each>
void TryAll(const SignShapes& shapes, const SignEvidence& evidence, const PlacePrior& prior,
            Each each) {
  struct Frame {
    SignPlace place;
    std::size_t size = 0;
    double cost = 0;
    ScaledEvidence felt;
    std::vector<glm::dvec2> origins;  // or right edges, if the line runs to the left
  };
  std::vector<Frame> frames;
  const auto add = [&](double size, std::size_t index, double cost) {
    for (const double turn : prior.turns) {
      Frame frame{{evidence.grooves.front().p, size, turn}, index, cost, {}, {}};
      frame.felt = Scaled(evidence, frame.place, prior.leftwards);
      for (const glm::dvec2 origin : prior.origins) {
        frame.origins.push_back(ToEm(frame.place, origin));
      }
      frames.push_back(std::move(frame));
    }
  };
  for (std::size_t i = 0; i < prior.sizes.size(); ++i) {
    add(prior.sizes[i], i, prior.size_logs.empty() ? 0 : -prior.size_logs[i]);
  }
  for (std::size_t i = 0; i < prior.other_sizes.size(); ++i) {
    add(prior.other_sizes[i], prior.sizes.size() + i, kOtherSize);
  }
  double least = std::numeric_limits<double>::infinity();
  std::vector<glm::dvec2> origins;
  for (std::size_t sign = 0; sign < shapes.size(); ++sign) {
    const glm::dvec2 edge(prior.leftwards ? shapes.Bounds(sign).max.x : 0, 0);
    for (const Frame& frame : frames) {
      origins = frame.origins;
      for (glm::dvec2& origin : origins) origin -= edge;
      const double before =
          frame.cost + (prior.whole ? ShortfallCost(shapes.Bounds(sign), frame.felt.box) : 0);
      const std::optional<Fit> fit =
          BestFit(shapes, sign, frame.felt, origins, prior, least + kNegligible - before);
      if (!fit) continue;
      const double cost = fit->cost + before;
      least = std::min(least, cost);
      each(sign, frame.place, frame.size, Fit{cost, fit->shift});
    }
  }
}

}  // namespace

glm::dvec2 ToEm(const SignPlace& place, glm::dvec2 p) noexcept { return EmFrame(place).To(p); }

glm::dvec2 FromEm(const SignPlace& place, glm::dvec2 p_em) noexcept {
  const double c = std::cos(place.turn), s = std::sin(place.turn);
  return place.origin + place.size * glm::dvec2(c * p_em.x - s * p_em.y, s * p_em.x + c * p_em.y);
}

std::vector<double> SizeLogs(const SignShapes& shapes, const SignEvidence& evidence,
                             const PlacePrior& prior) {
  constexpr double kNoSign = 0.02;  // share of what is none
  std::vector<double> logs(prior.sizes.size(), 0);
  if (evidence.grooves.empty() || prior.sizes.empty() || prior.turns.empty()) return logs;
  std::vector<double> sums(logs.size(), 0);
  PlacePrior equal = prior;
  equal.size_logs.clear();
  equal.other_sizes.clear();
  TryAll(shapes, evidence, equal,
         [&sums](std::size_t, const SignPlace&, std::size_t size, const Fit& fit) {
           sums[size] += std::exp(-fit.cost);
         });
  const double most = *std::max_element(sums.begin(), sums.end());
  for (std::size_t i = 0; i < logs.size() && most > 0; ++i) {
    logs[i] = std::log(kNoSign + (1 - kNoSign) * sums[i] / most);
  }
  return logs;
}

std::vector<SignGuess> Believe(const SignShapes& shapes, const SignEvidence& evidence,
                               const PlacePrior& prior) {
  std::vector<SignGuess> guesses;
  if (evidence.grooves.empty() || prior.sizes.empty() || prior.turns.empty()) return guesses;
  double weight = 0;
  for (const FeltPoint& groove : evidence.grooves) weight += groove.weight;
  std::vector<SignGuess> signs(shapes.size());
  for (std::size_t sign = 0; sign < shapes.size(); ++sign) {
    signs[sign] = {sign, -std::numeric_limits<double>::infinity(), 0, {}};
  }
  TryAll(shapes, evidence, prior,
         [&](std::size_t sign, const SignPlace& frame, std::size_t, const Fit& fit) {
           const double log = -fit.cost;
           SignGuess& guess = signs[sign];
           if (log <= guess.log_likelihood) return;
           guess.log_likelihood = log;
           guess.place = frame;
           guess.place.origin = FromEm(frame, fit.shift);
         });
  guesses.push_back({SignGuess::kUnknown, -kUnknownPrior - kUnknownCost * weight, 0, {}});
  for (const SignGuess& guess : signs) {
    if (std::isfinite(guess.log_likelihood)) guesses.push_back(guess);
  }
  std::sort(guesses.begin(), guesses.end(), [](const SignGuess& a, const SignGuess& b) {
    return a.log_likelihood != b.log_likelihood ? a.log_likelihood > b.log_likelihood
                                                : a.sign < b.sign;
  });
  double sum = 0;
  for (SignGuess& guess : guesses) {
    guess.probability = std::exp(guess.log_likelihood - guesses.front().log_likelihood);
    sum += guess.probability;
  }
  for (SignGuess& guess : guesses) guess.probability /= sum;
  return guesses;
}

}  // namespace moontrace
