#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "sim/study/reading_sweep.h"

namespace moontrace {

/// How one page was read.
struct PageReading {
  std::size_t signs = 0;        ///< that stood there
  std::size_t signs_right = 0;  ///< of them
  /// Of all that stood there, spaces and line ends included: read as something else, not read, and
  /// read without standing there.
  std::size_t wrong = 0, missed = 0, extra = 0;
  double duration = 0;      ///< simulated [s]
  std::size_t through = 0;  ///< how often the paper gave way under the tip
  bool ended = false;       ///< the reader, by itself
};

/// Reads the text, set on as many sheets as it needs; all chances by the seed. `check` is called
/// now and then and may throw to stop.
PageReading ReadPage(const ReadingCell& cell, const std::string& text, std::uint64_t seed,
                     const std::function<void()>& check);

/// Gives each page its press, and tells before the work begins which could not be read: no such
/// script, profile or paper, a device that does not measure and push along the paper, or not up and
/// down where ridges or dots are read, a groove that cannot be cut. Throws InputError, its line
/// begins with `file`.
void CompleteSweep(ReadingSweep& sweep, const std::string& file);

}  // namespace moontrace
