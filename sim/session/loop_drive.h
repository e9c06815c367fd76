#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/console/console.h"
#include "sim/console/line_reader.h"
#include "sim/console/vocabulary.h"
#include "sim/session/loop_session.h"
#include "sim/session/place_walk.h"
#include "sim/session/view_feed.h"

namespace moontrace {

/// Goes with a session and has words of its own. Called off the tick, on the thread of Drive.
class Companion {
 public:
  virtual ~Companion() = default;
  /// Where its words hold.
  virtual WordPlace words() const = 0;
  /// Once, before all else. What is to be said.
  virtual std::vector<std::string> Begin(PlaceWalk& walk) = 0;
  /// A line before the loop reads it, at the newest tick: what is said of it, possibly nothing;
  /// none: it is no word of its own.
  virtual std::optional<std::vector<std::string>> Obey(std::string_view line,
                                                       const LoopSnapshot& now) = 0;
  /// The page of a place that was gone to lies under the hand: a byte of the text.
  virtual void Arrived(std::size_t source) = 0;
  /// Two presses at a place: what is said.
  virtual std::string Marked(const LetterPlace& place) = 0;
  /// A press, or two, of the button, at a place: whether it is taken, before all else.
  struct Press {
    bool taken = false;
    std::string line;  ///< to be obeyed as if it were typed; empty: nothing
  };
  virtual Press Pressed(bool twice, const LoopEvent& event) = 0;
  /// What was answered to a line or a press, or must be known; whether it was laid under the hand.
  virtual bool Answered(const std::vector<std::string>& lines, const LoopSnapshot& now) = 0;
  /// Takes from under the hand what does not belong to the text; false: there was nothing.
  virtual bool ClearPage() = 0;
  /// At each look: what is to be said.
  virtual std::vector<std::string> Look(const LoopSnapshot& now) = 0;
  /// What Look said last must reach who cannot hear as well: a failure, the end.
  virtual bool urgent() const = 0;
  /// Something new lies under the hand since the Look before the last: who cannot hear feels a
  /// tremble.
  virtual bool trembles() const = 0;
  /// Nothing more is to come.
  virtual bool ended() const = 0;
};

/// Somebody at another terminal, who hears what is said and may speak. Called off the tick, on the
/// thread of Drive.
class Elsewhere {
 public:
  virtual ~Elsewhere() = default;
  struct Line {
    std::string said;   ///< to be told to who feels the page; empty: nothing
    std::string word;   ///< to be obeyed then, as if it were typed; empty: nothing
    bool lies = false;  ///< something else was laid under the hand with it
  };
  /// The next line that came from there, at the newest tick, if there is one.
  virtual std::optional<Line> Next(const LoopSnapshot& now) = 0;
  /// All that is said.
  virtual void Told(std::string_view line) = 0;
  /// All that is typed here.
  virtual void Typed(std::string_view line) = 0;
};

/// How a running session is led.
struct DriveOptions {
  std::optional<double> seconds;  ///< ends by itself; none: by "quit", or once input has ended
  bool sizes = true;              ///< words that change the page do something
  bool input_ends = true;         ///< ends with its input; else it ends otherwise, as by itself
  std::function<void(const LoopSample&)> sample;  ///< is given every tick, off the tick
  ViewFeed* view = nullptr;                       ///< shows it; closing its window ends it
  Companion* companion = nullptr;
  Elsewhere* elsewhere = nullptr;
  LineReader* typed = nullptr;  ///< what is typed, where several sessions follow one another
};

/// Leads a running session from the text face until it ends: reads words, tells events, hands the
/// samples on. The loop has ended behind it, at zero force. False: nobody said a word, and there is
/// no terminal at which somebody could. Throws Interrupted.
bool Drive(LoopSession& session, const DriveOptions& options, Console& console);

/// Behind Drive: throws LackError if the device was lost and did not come back.
void RequireDevice(LoopSession& session);

/// What is said before a session: device, rate, priority, pages, scale.
void SayBeginning(const LoopSession& session, Console& console);

}  // namespace moontrace
