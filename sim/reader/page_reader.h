#pragma once

#include <cstddef>
#include <vector>

#include "sim/reader/reader_knowledge.h"
#include "sim/reader/sign_belief.h"

namespace moontrace {

/// One thing read: a sign, a space or the end of a line.
struct ReadToken {
  enum class Kind { kSign, kUnknown, kSpace, kLineEnd } kind = Kind::kSign;
  std::size_t glyph = 0;   ///< of a sign: index into the script's glyphs
  double probability = 1;  ///< of that sign against all others
  double time = 0;         ///< when it was decided [s]
  SignPlace place;         ///< of a sign
};

/// What a reader's hand is at, as its time is told.
enum class ReaderActivity {
  kFlying,     ///< lifted, until it rests on the paper again
  kSearching,  ///< for a groove or a ridge
  kCrossing,   ///< a place that tells signs apart
  kSettling,   ///< back at a groove that it met
  kFollowing,  ///< a groove
  kTurning,    ///< looks where a groove that stopped goes on
  kHatching,   ///< goes up and down over a whole line
  kDone,
};
inline constexpr std::size_t kReaderActivities = 8;

/// Who reads a page by touch alone. The same knowledge, seed and inputs give the same actions and
/// the same text.
class PageReader {
 public:
  virtual ~PageReader() = default;

  /// What the hand is to do next. Most ticks take well below a microsecond; where it decides, some
  /// milliseconds, as a mind does: not for the haptic thread.
  virtual ReaderAction Step(const ReaderInput& input) = 0;

  virtual bool done() const = 0;
  /// What has been read.
  virtual std::vector<ReadToken> tokens() const = 0;
  /// What comes next among `tokens`: of a line that is decided as a whole, its signs so far.
  virtual std::vector<ReadToken> Pending() const = 0;
  /// What it thinks of the sign that it felt last, best first; empty before the first.
  virtual std::vector<SignGuess> belief() const = 0;
  virtual ReaderActivity activity() const = 0;
};

}  // namespace moontrace
