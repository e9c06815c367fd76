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
/// only one in the records, otherwise who answers the question, be it by the first line of a pipe.
/// In the records stands a new one only once admitted. None: who was asked said "quit", and has
/// been told; nothing was kept.
///
/// Throws UsageError (nobody said who, or it is a simulated learner), InputError (a pseudonym or
/// records that cannot be used), LackError (records taken by another program), Interrupted.
std::optional<LearnMemory> OpenMemory(const LearnOptions& options, const Course& course,
                                      LineReader& lines, LearnTeller& teller,
                                      const Console& console);

/// What is to begin, for who has no device: "demonstration", "paper" or "mouse"; empty: nothing.
/// Throws Interrupted.
std::string AskWithoutDevice(LineReader& lines, LearnTeller& teller, const Console& console);

/// At the end, once for each learner: whether the path of the hand may be kept. Not answered, it is
/// asked again the next time. Throws as Records::SetConsent, and Interrupted.
void AskConsent(LearnMemory& memory, LineReader& lines, LearnTeller& teller,
                const Console& console);

}  // namespace moontrace
