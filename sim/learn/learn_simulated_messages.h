#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Sentences of `moontrace learn --simulate`; see messages.h.
namespace moontrace::say {

std::string SimulatedBegins(std::string_view course, std::size_t lessons);
std::string SimulatedGoesOn(std::string_view learner, std::size_t trials);
std::string SimulatedLesson(std::string_view title, int day, std::size_t trials);
/// Sizes [m] at which items became sure in the lesson just done, descending.
std::string SimulatedSizes(const std::vector<double>& sizes);
std::string SimulatedDone(int days, std::size_t trials, double hours);
std::string SimulatedEnded(int days, std::string_view lesson);
/// What came of it: items sure at standard size [m], of how many that were worked on.
std::string SimulatedMastered(std::size_t mastered, std::size_t items, double size);
std::string SimulatedStuck(std::string_view lesson, std::string_view item);
std::string SimulatedProves();
std::string NotSimulated(std::string_view learner);

}  // namespace moontrace::say
