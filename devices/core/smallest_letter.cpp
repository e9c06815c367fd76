#include "devices/core/smallest_letter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moontrace {
namespace {

// The default style of engraved Moon letters (design, defaults): large letters, and small ones
// whose grooves are wider and flatter. Between the sizes both values go linearly.
constexpr double kLargeSize = 8e-3, kSmallSize = 6e-3;          // [m]
constexpr double kLargeWidth = 0.1165, kSmallWidth = 0.2;       // w [em]
constexpr double kLargeDepth = 1.0 / 2, kSmallDepth = 1.0 / 3;  // D [w]
constexpr double kRounding = 0.2;                               // r [w]

constexpr double kSkip = 0.25;  // [em]
constexpr double kStepsOnAFlank = 5;
constexpr double kHandPull = 0.06 * 200;  // drift share times the hand's stiffness [N/m]

constexpr double kFirst = 1e-3, kLast = 0.2, kStride = 1e-4;  // sizes that are tried [m]

struct Groove {
  double flank;  ///< width of one [m]
  double slope;
};

Groove GrooveOf(double size) {
  const double small = std::clamp((kLargeSize - size) / (kLargeSize - kSmallSize), 0.0, 1.0);
  const double width = size * (kLargeWidth + small * (kSmallWidth - kLargeWidth));
  const double depth = width * (kLargeDepth + small * (kSmallDepth - kLargeDepth));
  const double flank = width * (0.5 - kRounding);
  return {flank, depth / flank};
}

}  // namespace

double SmallestLetter(const DeviceProfile& profile, double press) {
  const glm::bvec3 pushes = profile.limits.pushes;
  if (!pushes.x && !pushes.y) return 0;
  const double stiffness = CouplingOf(profile).stiffness;
  const auto sizes = static_cast<int>(std::lround((kLast - kFirst) / kStride));
  // From the large ones down to the first that fails: not every small letter is worse than a larger
  // one, since small ones have flatter flanks.
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = sizes; i >= 0; --i) {
    const double size = kFirst + i * kStride;
    const Groove groove = GrooveOf(size);
    const double force = std::min(press * groove.slope, profile.limits.peak_force);
    const bool skips = force > stiffness * kSkip * size;
    const bool is_stairs = groove.flank < kStepsOnAFlank * profile.position_step;
    if (skips || is_stairs) break;
    // Larger letters ask for more force still: those that slip may have smaller ones that do not.
    if (force >= kHandPull * size) smallest = size;
  }
  return smallest;
}

}  // namespace moontrace
