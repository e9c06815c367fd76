#include "sim/reader/sign_belief.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Evidence in em, about the first place that is tried, so that other places are a shift away.
struct ScaledEvidence {
  std::vector<FeltPoint> grooves, flats;
  Box box;  ///< of the grooves that were followed
  double half_width = 0;
  double spread = kSpread;  ///< of felt points
  double crossed_spread = kSpread;
  double next_within = kBefore;  ///< before a sign's end what is crossed may be the next one's
  double flat_cost = kMostAFlat, wall_cost = kMostAFlat;
};

ScaledEvidence Scaled(const SignEvidence& evidence, const SignPlace& place) {
  ScaledEvidence scaled;
  for (const FeltPoint& felt : evidence.grooves) {
    scaled.grooves.push_back({ToEm(place, felt.p), felt.weight, felt.crossed});
    if (!felt.crossed) Include(scaled.box, scaled.grooves.back().p);
  }
  for (const FeltPoint& felt : evidence.flats) {
    const glm::dvec2 p = ToEm(place, felt.p);
    if (Contains(Grown(scaled.box, 1.2), p)) scaled.flats.push_back({p, felt.weight, felt.crossed});
  }
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
  const double per_square = 0.5 / (felt.spread * felt.spread);
  double cost = 0;
  for (const FeltPoint& groove : felt.grooves) {
    // a tip within a fill may be anywhere in it, which says less than one on a line
    const double d = std::max(shapes.Distance(sign, groove.p - shift), -kWithinFill) /
                     (groove.crossed ? felt.crossed_spread / felt.spread : 1);
    const bool beyond =
        groove.crossed && groove.p.x - shift.x > shapes.Advance(sign) - felt.next_within;
    cost += groove.weight * std::min(per_square * d * d, beyond ? kNextSign : kMostAGroove);
    if (cost > most) return cost;
  }
  const double inner = 0.75 * felt.half_width;
  for (const FeltPoint& flat : felt.flats) {
    const double d = std::max(shapes.Distance(sign, flat.p - shift), 0.0);
    if (d < inner)
      cost += flat.weight * (flat.crossed ? felt.flat_cost : felt.wall_cost) *
              std::min(1.0, 2 * (1 - d / inner));
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

struct Fit {
  double cost = std::numeric_limits<double>::infinity();
  glm::dvec2 shift{0, 0};
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
      if (cost < best.cost) best = {cost, shift};
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

Fit BestFit(const SignShapes& shapes, std::size_t sign, const ScaledEvidence& felt,
            const std::vector<glm::dvec2>& origins, const PlacePrior& prior) {
  Fit best;
  const Box range = RangeOf(shapes.Bounds(sign), felt, origins, prior);
  if (range.min.x > range.max.x || range.min.y > range.max.y) return best;
  TryAbout(shapes, sign, felt, origins, prior, range, kCoarse, best);
  const glm::dvec2 reach(kCoarse - kFine);
  TryAbout(shapes, sign, felt, origins, prior, {best.shift - reach, best.shift + reach}, kFine,
           best);
  return best;
}

/// Calls `each` with a sign, the frame that fits its evidence, the index of its size (those of
/// prior.other_sizes come last) and the best fit there.
template <typename Each>
void TryAll(const SignShapes& shapes, const SignEvidence& evidence, const PlacePrior& prior,
            Each each) {
  std::vector<SignPlace> frames;
  for (const std::vector<double>* sizes : {&prior.sizes, &prior.other_sizes}) {
    for (const double size : *sizes) {
      for (const double turn : prior.turns) {
        frames.push_back({evidence.grooves.front().p, size, turn});
      }
    }
  }
  std::vector<ScaledEvidence> scaled;
  std::vector<std::vector<glm::dvec2>> origins(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    scaled.push_back(Scaled(evidence, frames[i]));
    for (const glm::dvec2 origin : prior.origins) origins[i].push_back(ToEm(frames[i], origin));
  }
  for (std::size_t sign = 0; sign < shapes.size(); ++sign) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Fit fit = BestFit(shapes, sign, scaled[i], origins[i], prior);
      each(sign, frames[i], i / prior.turns.size(), fit);
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
  TryAll(shapes, evidence, prior,
         [&sums](std::size_t, const SignPlace&, std::size_t size, const Fit& fit) {
           if (size < sums.size()) sums[size] += std::exp(-fit.cost);
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
         [&](std::size_t sign, const SignPlace& frame, std::size_t size, const Fit& fit) {
           double log = -fit.cost;
           if (size >= prior.sizes.size()) {
             log -= kOtherSize;
           } else if (!prior.size_logs.empty()) {
             log += prior.size_logs[size];
           }
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
