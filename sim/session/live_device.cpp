#include "sim/session/live_device.h"

#include <cmath>
#include <glm/glm.hpp>
#include <ostream>
#include <utility>

#include "devices/hand/simulated_stylus.h"
#include "lessons/measure/intended_strokes.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_messages.h"
#include "sim/setup/text_trial.h"
#include "sim/trial/plan.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {
constexpr double kPress = 1;  ///< [N]
}

LiveDevice::LiveDevice(const SessionRequest& request, Console& console)
    : name_(request.live.device),
      simulated_(IsSimulated(name_)),
      mouse_(IsMouse(name_)),
      scale_(request.live.scale.value_or(1)),
      tick_(1 / request.rate()),
      press_(request.press),
      seed_(request.seed) {
  if ((simulated_ || mouse_) && request.live.scale) {
    throw UsageError(say::OnlyWithDevice("--scale"));
  }
  if (mouse_ && request.aims == nullptr) throw UsageError(say::MouseNeedsWindow());
  if (simulated_ || mouse_) hand_ = ShippedHand();
  if (simulated_) return;
  if (mouse_) {
    // its frame is the page's
    opened_ = MakeAimedStylus(hand_, request.aims, {0, 0, -1}, tick_);
  } else {
    const auto tell = [&console](std::string_view sentence) {
      console.Result(sentence);
      console.out().flush();
    };
    opened_ = OpenNamed(name_, tick_, press(), tell, console.stop(), request.live.seconds);
  }
  limits_ = opened_->Limits();
}

double LiveDevice::press() const { return press_.value_or(kPress); }

bool LiveDevice::pushes() const { return !mouse_ && glm::any(limits_.pushes); }

glm::dvec2 LiveDevice::room() const {
  if (simulated_ || mouse_) return glm::dvec2(INFINITY);
  return 2 * scale_ * glm::dvec2(limits_.workspace_D);
}

DevicePlace LiveDevice::PlaceOn(const Typeset& set, const Pose& X_WP) const {
  DevicePlace place;
  if (simulated_ || mouse_) return place;
  place.scale = scale_;
  const std::vector<PlacedGlyph>& glyphs = set.pages[0].glyphs;
  const glm::dvec2 begin = glyphs.empty() ? glm::dvec2(0, 0) : glyphs.front().origin_P;
  const bool bounded = std::isfinite(limits_.workspace_D.x) && std::isfinite(limits_.workspace_D.y);
  const glm::dvec2 middle = bounded ? 0.5 * glm::dvec2(set.page.width, set.page.height) : begin;
  place.origin_W = ToWorld(X_WP, glm::dvec3(middle, 0));
  return place;
}

HandOnPage LiveDevice::HandOn(const FeltPage& page) const {
  const TextSetup& text = *page.text;
  PlanOptions options;
  SetPress(hand_, text.set.style.relief, press_, options);
  options.repeats = true;
  const auto strokes = IntendedStrokes(page.set(), text.script, text.set.style);
  const auto links = LinksOf(page.set(), text.script, text.set.style);
  const Plan plan = MakePlan(strokes, WalksOf(strokes, page.set(), *links), options, Pose());
  return {MakeSimulatedStylus(hand_, plan.path_W, tick_, seed_), plan.duration};
}

DeviceSource LiveDevice::Reopening() {
  return [this](const std::atomic<bool>& ending) {
    const auto tell = [this](std::string_view sentence) {
      const std::lock_guard lock(sentences_mutex_);
      sentences_.emplace_back(sentence);
    };
    return OpenNamed(name_, tick_, press(), tell, &ending);
  };
}

std::vector<std::string> LiveDevice::TakeSentences() {
  const std::lock_guard lock(sentences_mutex_);
  return std::exchange(sentences_, {});
}

}  // namespace moontrace
