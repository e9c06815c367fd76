#pragma once

#include <optional>
#include <string>

#include "lessons/course/course.h"
#include "sim/console/console.h"
#include "sim/learn/learn_keys.h"
#include "sim/learn/learn_options.h"

namespace moontrace {

/// The program's hand, and nobody wants more of it: no tutor, no course, no records of one's own. A
/// name makes no lesson of it: whose hand is led nowhere has no use for lessons.
bool IsDemonstration(const LearnOptions& options);

/// Tells the shipped demonstration to the console, until it ends by itself or by a word; which way
/// on was chosen, "mouse", "paper" or "device"; empty: none.
/// `all_keys`: single keys without Enter. Throws InputError (an own table of sounds), DeviceError,
/// Interrupted.
std::string Demonstrate(const LearnOptions& options, const std::optional<KeyMap>& all_keys,
                        const Course& course, Console& console);

}  // namespace moontrace
