#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/reader/sign_shapes.h"

namespace moontrace {

/// Where a sign's em box lies on the paper, in the frame in which the hand feels.
struct SignPlace {
  glm::dvec2 origin{0, 0};  ///< left edge on the base line [m]
  double size = 0;          ///< of an em [m]
  double turn = 0;          ///< of the line, counter-clockwise [rad]
};
glm::dvec2 ToEm(const SignPlace& place, glm::dvec2 p) noexcept;
/// The same for many points.
class EmFrame {
 public:
  explicit EmFrame(const SignPlace& place) noexcept
      : place_(place), c_(std::cos(place.turn)), s_(std::sin(place.turn)) {}
  glm::dvec2 To(glm::dvec2 p) const noexcept {
    const glm::dvec2 d = (p - place_.origin) / place_.size;
    return {c_ * d.x + s_ * d.y, c_ * d.y - s_ * d.x};
  }

 private:
  SignPlace place_;
  double c_, s_;
};
glm::dvec2 FromEm(const SignPlace& place, glm::dvec2 p_em) noexcept;

/// What was felt at a point, and how much it says: 1 for a point that stands by itself.
struct FeltPoint {
  glm::dvec2 p{0, 0};  ///< [m]
  double weight = 1;
  bool crossed = false;  ///< felt on the way across, not while a groove was followed
};

/// All that was felt of one sign.
struct SignEvidence {
  std::vector<FeltPoint> grooves;  ///< the tip was in a groove
  std::vector<FeltPoint> flats;    ///< flat paper, or a wall that the tip did not pass
  double width = 0;                ///< of a groove [m]
  double unsure = 0;               ///< rms error of all places [m]
};

/// Where the next sign can stand, and how large it can be.
struct PlacePrior {
  /// Expected left edges on the base line [m]; none: anywhere.
  std::vector<glm::dvec2> origins;
  bool leftwards = false;         ///< the line runs so: right edges in place of left ones
  bool whole = false;             ///< grooves were felt to their ends: larger signs reach farther
  double along = 0, across = 0;   ///< standard deviations from those [em]
  std::vector<double> sizes;      ///< of an em [m]
  std::vector<double> size_logs;  ///< log of how likely each of them is; empty: equally
  /// Of lines that are rarer, such as headings: e^-8 as likely. Ours: a letter's fit at a wrong
  /// size is worse than that, a ring is a ring at any [m].
  std::vector<double> other_sizes;
  std::vector<double> turns;  ///< of the line, equally likely [rad]
};

/// One answer to what was felt.
struct SignGuess {
  static constexpr std::size_t kUnknown = static_cast<std::size_t>(-1);
  std::size_t sign = kUnknown;  ///< index into SignShapes
  double log_likelihood = 0;    ///< at its best place
  double probability = 0;
  SignPlace place;
};

/// What was felt of one sign, whichever it is, says of the sizes: the log likelihood of each of
/// `prior.sizes`, the greatest 0. A sign that is none of the script's speaks for no size: no value
/// is below log 0.02. Of nothing felt: zeros.
std::vector<double> SizeLogs(const SignShapes& shapes, const SignEvidence& evidence,
                             const PlacePrior& prior);

/// Probabilities of all signs, each at its best place, and of something unknown, best first. A
/// groove point costs the squared distance from the sign's lines over twice the variance, up to a
/// bound, which is low for one that was only crossed where the next sign stands; a flat
/// point costs where the sign has its groove. Signs are equally likely before.
std::vector<SignGuess> Believe(const SignShapes& shapes, const SignEvidence& evidence,
                               const PlacePrior& prior);

}  // namespace moontrace
