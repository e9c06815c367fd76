#pragma once

#include <string>

#include "sim/picture/drawing.h"
#include "sim/study/reading_summary.h"

namespace moontrace {

/// A study of reading as a picture: a row for each combination, how many signs were right and how
/// long one took, each a dot with its 95 percent interval as a bar. The first 100 combinations.
Drawing ReadingPlot(const std::string& title, const ReadingSummary& summary);

}  // namespace moontrace
