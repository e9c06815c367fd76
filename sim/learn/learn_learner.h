#pragma once

#include <optional>

#include "lessons/course/course.h"
#include "sim/console/console.h"
#include "sim/console/line_reader.h"
#include "sim/learn/learn_memory.h"
#include "sim/learn/learn_options.h"
#include "sim/learn/learn_teller.h"

namespace moontrace {

/// Finds out who learns, and opens what is remembered: the learner that is named, otherwise the
/// only one in the records, otherwise who answers the question. A new one is asked whether raw
/// tracks may be kept; no is taken where nobody can be asked. In the records stands a new one only
/// once admitted. `may_ask`: a person sits at a terminal. None: who was asked said "quit", and has
/// been told; nothing was kept.
///
/// Throws UsageError (nobody said who, or it is a simulated learner), InputError (a pseudonym or
/// records that cannot be used), LackError (records taken by another program), Interrupted.
std::optional<LearnMemory> OpenMemory(const LearnOptions& options, const Course& course,
                                      bool may_ask, LineReader& lines, LearnTeller& teller,
                                      const Console& console);

}  // namespace moontrace
