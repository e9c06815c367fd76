#pragma once

#include <optional>

#include "sim/console/console.h"
#include "sim/learn/learn_input.h"
#include "sim/learn/learn_session.h"

namespace moontrace {

class TutorDesk;
class PathListener;
class LearnView;

/// Who takes part in a lesson beside the learner; null: nobody.
struct LearnCompany {
  TutorDesk* tutor = nullptr;
  PathListener* sound = nullptr;
  LearnView* view = nullptr;
};

/// Leads a lesson until it is over, `seconds` have passed, or input has ended (which counts only
/// where no `seconds` are given). Throws Interrupted.
void Drive(LearnSession& session, LearnTeller& teller, LearnInput& input,
           const LearnCompany& company, std::optional<double> seconds, const Console& console);

}  // namespace moontrace
