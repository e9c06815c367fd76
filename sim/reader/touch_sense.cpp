#include "sim/reader/touch_sense.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace moontrace {
namespace {

constexpr double kSmooth = 0.008;    ///< of the vertical speed [s]
constexpr double kRest = 0.040;      ///< the level is taken after so long a rest [s]
constexpr double kSettles = 0.6;     ///< or so long after a first landing that hums on [s]
constexpr double kHum = 0.2;         ///< over which its height is taken then [s]
constexpr double kMostGive = 0.005;  ///< of device and paper [m/N]
constexpr double kResting = 0.003;   ///< slower up and down is at rest [m/s]

}  // namespace

TouchSense::TouchSense(const ReaderKnowledge& knowledge, double tick)
    : tick_(tick),
      press_(knowledge.press),
      depth_(knowledge.depth),
      width_(knowledge.width),
      up_(knowledge.raised ? -1 : 1),
      give_(1 / knowledge.device_stiffness),
      yields_(give_),
      swings_tell_(!knowledge.followed),
      feels_height_(knowledge.feels_height),
      hold_(knowledge.Hold()),
      late_(knowledge.delay + knowledge.lag),
      level_known_(!knowledge.feels_height) {}

void TouchSense::Lift() noexcept {
  resting_for_ = presses_for_ = 0;
  calm_ = {0, 0};
  if (!feels_height_) felt_.depth = 0;
}

/// A hand knows that it presses, and what it feels from then on comes late.
void TouchSense::FeelWalls(bool presses) noexcept {
  constexpr double kCalm = 0.010;    // [s]
  constexpr double kSurely = 0.5;    // of the hold is surely a wall
  constexpr double kHeld = 0.2;      // of that is a wall all the same
  constexpr double kForgets = 4;     // without a wall, as on a straight way [s]
  constexpr double kLanding = 0.05;  // [s]
  presses_for_ = presses ? presses_for_ + tick_ : 0;
  felt_.touching = presses_for_ > late_ + kLanding;
  resting_for_ = felt_.touching ? resting_for_ + tick_ : 0;
  if (!felt_.touching) return;
  calm_ += std::min(1.0, tick_ / kCalm) * (felt_.wall - calm_);
  const double held = std::min(1.0, glm::length(calm_) / (kSurely * hold_));
  felt_.held = held > kHeld;
  felt_.depth = std::max(held, felt_.depth - tick_ / kForgets);
}

/// The level of flat paper is where the tip comes to rest under its press; no groove is higher and
/// no ridge lower.
void TouchSense::FindLevel() noexcept {
  resting_for_ = felt_.touching && std::abs(sink_) < kResting ? resting_for_ + tick_ : 0;
  const double z = felt_.tip.z;
  touches_for_ = felt_.touching ? touches_for_ + tick_ : 0;
  mean_height_ += tick_ / std::min(kHum, std::max(touches_for_, tick_)) * (z - mean_height_);
  const bool rests = resting_for_ >= kRest;
  if (!level_known_ && (rests || touches_for_ > kSettles)) {
    level_ = rests ? z : mean_height_;
    level_known_ = true;
  }
  if (!rests) return;
  const double above = up_ * (z - level_);  // or below, beside ridges
  if (std::abs(above) < 0.15 * depth_) level_ += up_ * tick_ / 0.5 * above;
  // what is higher and wide is the flat; a ridge is narrow
  constexpr double kWide = 1.2;  // widths of a groove
  const bool above_now = above > 0.15 * depth_;
  if (above_now && !above_) above_from_ = felt_.place;
  above_ = above_now;
  if (above_ && glm::distance(felt_.place, above_from_) > kWide * width_) {
    level_ = z;
    above_ = false;
  }
}

/// A landing tells how far device and paper yield together: the less of the press they carry, the
/// higher the tip. One into a groove tells a little less.
void TouchSense::FindGive(const ReaderInput& input) noexcept {
  constexpr double kNew = 0.3;      // share of the newest landing
  constexpr double kSlowest = 0.9;  // of the press; more at the first touch was no landing
  if (input.force.z > kSlowest * press_) return;
  const double found = (input.tip.z - level_) / (press_ - input.force.z);
  if (found < give_ || found > kMostGive) return;
  yields_ += (landed_ ? kNew : 1.0) * (found - yields_);
  landed_ = true;
}

/// Where a swinging tip turns, its speed is zero and no damper adds to the force: its height
/// differs from the level by as much as device and paper yield to what the force differs from the
/// press. Beside grooves a tip above the level, and beside ridges one below it, can only be over
/// flat paper; those turns tell, and the median of what they tell is kept.
void TouchSense::FindGiveInSwing(const ReaderInput& input) noexcept {
  constexpr double kSwing = 0.15;   // of the press; less is trembling
  constexpr double kNewest = 0.03;  // share by which a swing moves the median
  const double step = input.tip.z - last_height_;
  const bool turns = step * last_step_ < 0;
  if (step != 0) last_step_ = step;
  const double off = up_ * (last_height_ - level_), less = up_ * (press_ - last_press_);
  last_press_ = input.force.z;
  if (!turns || !felt_.touching || !level_known_ || off <= 0 || less < kSwing * press_) return;
  const double found = off / less;
  if (found < give_ || found > kMostGive) return;
  if (swings_++ == 0) {
    yields_ = found;
    return;
  }
  const double share = std::max(kNewest, 0.5 / swings_);
  yields_ *= found > yields_ ? 1 + share : 1 - share;
}

const Felt& TouchSense::Add(const ReaderInput& input, bool presses) noexcept {
  if (!begun_) last_height_ = input.tip.z;
  begun_ = true;
  if (swings_tell_) FindGiveInSwing(input);
  sink_ += std::min(1.0, tick_ / kSmooth) * ((input.tip.z - last_height_) / tick_ - sink_);
  last_height_ = input.tip.z;
  felt_.time = input.time;
  felt_.tip = input.tip;
  felt_.wall = glm::dvec2(input.force);
  felt_.place = glm::dvec2(input.tip) + give_ * felt_.wall;
  if (!feels_height_) {
    felt_.tip.z = 0;
    FeelWalls(presses);
    return felt_;
  }
  const bool touching = input.force.z > 0.3 * press_;
  if (touching && !felt_.touching && level_known_ && !swings_tell_) FindGive(input);
  felt_.touching = touching;
  FindLevel();
  // what the press does not carry yet, device and paper have not yet yielded to
  const double height = input.tip.z - level_ + yields_ * (input.force.z - press_);
  felt_.depth = level_known_ && felt_.touching ? -up_ * height / depth_ : 0;
  return felt_;
}

namespace {

constexpr double kLearn = 0.25;  ///< several periods of a tremor [s]
constexpr double kFlat = 0.2;    ///< deeper, a groove leads the tip; share of its depth

}  // namespace

AimDrift::AimDrift(const ReaderKnowledge& knowledge, double tick)
    : tick_(tick),
      aims_(static_cast<std::size_t>(std::lround((knowledge.delay + knowledge.lag) / tick)) + 1,
            glm::dvec2(0, 0)) {}

void AimDrift::Begin() noexcept {
  count_ = 0;
  drift_ = {0, 0};
}

void AimDrift::Add(const Felt& felt, glm::dvec2 aim) noexcept {
  const std::size_t slot = count_ % aims_.size();
  const glm::dvec2 then = aims_[slot];
  aims_[slot] = aim;
  if (count_++ < aims_.size() || !felt.touching || felt.depth > kFlat) return;
  drift_ += tick_ / kLearn * (glm::dvec2(felt.tip) - then - drift_);
}

void AsideDrift::Begin() noexcept {
  count_ = 0;
  left_ = 0;
}

AsideDrift::AsideDrift(const ReaderKnowledge& knowledge, double learn, double tick)
    : share_(tick / learn),
      then_(static_cast<std::size_t>(std::lround((knowledge.delay + knowledge.lag) / tick)) + 1) {}

void AsideDrift::Add(glm::dvec2 tip, bool flat, glm::dvec2 aim, glm::dvec2 heading) noexcept {
  constexpr double kSteady = 0.99;  // cosine between headings then and now
  Then& slot = then_[count_ % then_.size()];
  const Then then = slot;
  slot = {aim, heading};
  if (count_++ < then_.size() || !flat || glm::dot(then.heading, heading) < kSteady) return;
  const glm::dvec2 off = tip - then.aim;
  left_ += share_ * (then.heading.x * off.y - then.heading.y * off.x - left_);
}

}  // namespace moontrace
