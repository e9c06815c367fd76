#include "devices/hid/homing.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace moontrace {
namespace {

/// Greatest difference of an encoder, across the wrap.
int Difference(const ArmCounts& a, const ArmCounts& b) noexcept {
  int most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int difference = static_cast<std::int16_t>(a[i] - b[i]);
    most = std::max(most, std::abs(difference));
  }
  return most;
}

}  // namespace

std::string_view SentenceOf(HomingStep step) {
  switch (step) {
    case HomingStep::kRest:
      return "Move the arm a little, put it in its rest, hold it still for a second.";
    case HomingStep::kMove:
      return "Now move the tip up, to the right and towards you, 2 cm each.";
    case HomingStep::kWrongDirection:
      return "It moved the wrong way: move it, put it in its rest, hold it for a second.";
    case HomingStep::kDone:
      break;
  }
  return {};
}

void Homing::Reset() noexcept {
  step_ = HomingStep::kRest;
  has_counts_ = false;
  has_moved_ = false;
}

HomingStep Homing::Advance(const ArmCounts& counts, double time) noexcept {
  if (!has_counts_) {
    has_counts_ = true;
    first_ = still_ = counts;
    still_since_ = time;
  }
  if (step_ == HomingStep::kRest || step_ == HomingStep::kWrongDirection) {
    SeekRest(counts, time);
  } else if (step_ == HomingStep::kMove) {
    CheckSense(counts);
  }
  return step_;
}

void Homing::SeekRest(const ArmCounts& counts, double time) noexcept {
  has_moved_ = has_moved_ || Difference(counts, first_) >= kMoved;
  if (Difference(counts, still_) > kStill || !has_moved_) {
    still_ = counts;
    still_since_ = time;
    return;
  }
  if (time - still_since_ < kStillTime) return;
  rest_ = counts;
  is_checked_.fill(false);
  step_ = HomingStep::kMove;
}

void Homing::CheckSense(const ArmCounts& counts) noexcept {
  const glm::dvec3 moved =
      ArmPosition(arm_, AnglesAt(arm_, counts, rest_)) - ArmPosition(arm_, arm_.rest);
  const glm::dvec3 asked(moved.x, -moved.y, moved.z);
  bool is_done = true;
  for (int i = 0; i < 3; ++i) {
    bool& is_checked = is_checked_[static_cast<std::size_t>(i)];
    is_checked = is_checked || asked[i] >= kChecked;
    is_done = is_done && is_checked;
    if (!is_checked && asked[i] <= -kChecked) {
      Reset();
      step_ = HomingStep::kWrongDirection;
      return;
    }
  }
  if (is_done) step_ = HomingStep::kDone;
}

bool Home(Device& device, const std::function<void(HomingStep)>& say,
          const std::function<bool()>& go_on) {
  const auto* const needs = dynamic_cast<const NeedsHoming*>(&device);
  if (needs == nullptr) return true;
  HomingStep said = HomingStep::kDone;
  while (go_on()) {
    DeviceState state;
    if (device.Read(state) == DeviceStatus::kLost) return false;
    device.Write({0, 0, 0});
    const HomingStep step = needs->NextStep();
    if (step != said) say(step);
    said = step;
    if (step == HomingStep::kDone) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace moontrace
