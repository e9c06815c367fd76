#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <vector>

#include "sim/physics/scene.h"
#include "sim/reader/page_reader.h"
#include "sim/reading/led_hand.h"
#include "sim/reading/reading_score.h"
#include "sim/trial/trial_result.h"
#include "textures/fonts/script.h"
#include "textures/typeset/text_page.h"

namespace moontrace {

/// One tick of a reading, for who looks on.
struct ReadingTick {
  double time;               ///< [s]
  const ReaderInput& input;  ///< what the reader was given
  const PageReader& reader;
  const TickResult& felt;  ///< what it was not given
  const Scene& scene;
};

/// Everything that decides one reading of one page.
struct ReadingSetup : LedHandSetup {
  const TextPage* page = nullptr;           ///< must outlive the run; the reader never sees it
  double path_spacing = 0;                  ///< of the path kept for a picture [m]; 0: none
  double longest = 14400;                   ///< a reader that has not ended by then is stopped [s]
  const std::atomic<bool>* stop = nullptr;  ///< looked at every tick; set: Interrupted is thrown
  /// Called in each tick, after the reader. None: costs nothing.
  std::function<void(const ReadingTick& tick)> watch;
  std::function<void()> alive;  ///< called each simulated second
};

struct ReadingResult {
  std::vector<ReadToken> tokens;                    ///< places in the page's frame
  bool ended = false;                               ///< by itself
  std::size_t through = 0;                          ///< how often the paper gave way under the tip
  double duration = 0;                              ///< simulated [s]
  std::array<double, kReaderActivities> seconds{};  ///< of it, by ReaderActivity
  double real_time_factor = 0;                      ///< the only value that varies
  std::vector<PathPoint> path;  ///< kTravel where it searches, kStroke where it follows
};

/// Lets a reader lead the hand until it ends by itself. Throws InputError as LedHand, Interrupted.
ReadingResult RunReading(const ReadingSetup& setup);

/// What the page holds, as it should be read: signs by their number among the script's glyphs, a
/// form of a sign as that sign itself; guide lines are none.
std::vector<int> MarksOf(const TextPage& page, const Script& script);
/// The same of what was read.
std::vector<int> MarksOf(const std::vector<ReadToken>& tokens, const Script& script);

}  // namespace moontrace
