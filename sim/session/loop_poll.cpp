#include "sim/session/loop_poll.h"

#include "sim/session/loop_messages.h"

namespace moontrace {

void LoopPoll::Look(LoopListener& listener) {
  loop_.TakeSnapshot(newest_);
  lateness_us_ = loop_.TakeLateness();
  LoopEvent event;
  while (loop_.TakeEvent(event)) {
    const bool lost =
        event.kind == LoopEventKind::kSafety && event.safety == SafetyEvent::kDeviceLost;
    listener.Happened(event, lost ? say::DeviceLost(loop_.WhyGone()) : say::Event(event));
  }
  for (const std::string& sentence : device_.TakeSentences()) listener.Reported(sentence, false);
  const bool silent = loop_.silent();
  if (silent && !silent_) listener.Reported(say::LoopSilent(), true);
  silent_ = silent;
  const std::string why = loop_.WhyLost();
  if (why != why_lost_ && !why.empty()) listener.Reported(say::StillLost(why), false);
  why_lost_ = why;
  listener.Stands(newest_);
  LoopSample sample;
  while (loop_.TakeSample(sample)) listener.Felt(sample);
}

}  // namespace moontrace
