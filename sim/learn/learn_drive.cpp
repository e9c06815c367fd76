#include "sim/learn/learn_drive.h"

#include <chrono>

#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_sound.h"
#include "sim/learn/learn_teller.h"
#include "sim/learn/learn_tutor.h"
#include "sim/learn/learn_view.h"

namespace moontrace {

namespace {
constexpr int kPoll = 20;  ///< [ms]
}

void Drive(LearnSession& session, LearnTeller& teller, LearnInput& input,
           const LearnCompany& company, std::optional<double> seconds, const Console& console) {
  const auto begin = std::chrono::steady_clock::now();
  while (!session.over()) {
    console.CheckStop();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    if (seconds && passed.count() >= *seconds) break;
    session.Look();
    if (company.sound != nullptr) company.sound->Hear();
    if (company.tutor != nullptr) company.tutor->Serve();
    if (company.view != nullptr) company.view->Look();
    if (session.over()) break;
    // while all rests, a key is a word, since nobody answers then
    const Asked asked = session.asked();
    const bool typed = asked == Asked::kText || (asked != Asked::kNothing && !session.stopped());
    if (const auto line = input.Next(kPoll, typed)) session.Obey(*line);
    if (input.ended() && !seconds) {
      teller.Say(Priority::kText, say::EndOfInput());
      break;
    }
  }
}

}  // namespace moontrace
