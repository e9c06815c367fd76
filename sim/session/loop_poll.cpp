#include "sim/session/loop_poll.h"

#include <glm/geometric.hpp>
#include <utility>

#include "sim/session/loop_messages.h"

namespace moontrace {

bool MotorsTold::WentOff(double time) {
  since_ = time;
  return !std::exchange(off_, true);
}

bool MotorsTold::IsBack(double time, double force) {
  constexpr double kOn = 2;  // [s]
  if (!off_ || !(force > 0) || time < since_ + kOn) return false;
  off_ = false;
  return true;
}

/// What happens again and again is said once.
std::string LoopPoll::Sentence(const LoopEvent& event) {
  if (event.kind != LoopEventKind::kSafety) return say::Event(event, device_.felt());
  if (event.safety == SafetyEvent::kDeviceLost) {
    motors_.Lost();
    return say::DeviceLost(loop_.WhyGone());
  }
  if (event.safety == SafetyEvent::kNotReady && !motors_.WentOff(event.time)) return {};
  bool& said = said_[static_cast<std::size_t>(event.safety)];
  if (std::exchange(said, say::MayRepeat(event.safety))) return {};
  return say::Event(event.safety, device_.felt());
}

std::string LoopPoll::Repeated() const {
  return device_.felt() ? say::Repeated(newest_.safety_counts) : std::string();
}

void LoopPoll::Look(LoopListener& listener) {
  loop_.TakeSnapshot(newest_);
  lateness_us_ = loop_.TakeLateness();
  LoopEvent event;
  while (loop_.TakeEvent(event)) {
    listener.Happened(event, Sentence(event));
  }
  for (const std::string& sentence : device_.TakeSentences()) listener.Reported(sentence, false);
  const bool silent = loop_.silent();
  if (silent && !silent_ && device_.felt()) listener.Reported(say::LoopSilent(), true);
  silent_ = silent_ || silent;
  const bool back = motors_.IsBack(newest_.time, glm::length(newest_.force_D));
  if (back && device_.felt()) listener.Reported(say::ForceIsBack(), false);
  const std::string why = loop_.WhyLost();
  if (why != why_lost_ && !why.empty()) listener.Reported(say::StillLost(why), false);
  why_lost_ = why;
  listener.Stands(newest_);
  LoopSample sample;
  while (loop_.TakeSample(sample)) listener.Felt(sample);
}

}  // namespace moontrace
