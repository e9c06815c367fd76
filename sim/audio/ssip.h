#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "sim/console/line_buffer.h"
#include "textures/base/file_descriptor.h"

namespace moontrace {

/// How urgent a sentence is, with the meanings of SSIP.
enum class Priority : std::uint8_t {
  kImportant,     ///< never interrupted: the safety stop, lost force; keep it short
  kMessage,       ///< waits its turn: the result of a trial, what a tutor says
  kText,          ///< replaces older text: a letter's name, help, what lies there, answers
  kNotification,  ///< dropped if anything else speaks: what is under the tip while it moves
  kProgress,      ///< only the last one is said whole: long work
};

struct SpeechOptions {
  std::string user = "learner";  ///< in the name under which the service knows us
  int rate = 0;                  ///< -100 to 100
  std::string language;          ///< "en"; empty: the service's own
};

/// A connection to speech-dispatcher in its protocol, SSIP 1 (the package's info page): lines with
/// CR LF, answers with a three-digit code, of which 2xx is good and 7xx an event.
class Ssip {
 public:
  /// Why a connection is of no use any more.
  enum class Fault { kNone, kNotThere, kSilent, kGone, kRefused };
  /// Asked while waiting for an answer: true leaves only a short wait.
  using Hurry = std::function<bool()>;

  /// Answers are waited for 2 s, once `hurry` is true 0.2 s in all.
  explicit Ssip(Hurry hurry);

  bool Connect(const std::string& path);
  // Each is false if the service refused that one command, or if there is a fault.

  /// Says who we are, in which language and how fast we speak.
  bool Greet(const SpeechOptions& options);
  bool Speak(Priority priority, std::string_view text);
  bool Spell(std::string_view word);
  bool Character(std::string_view character);
  bool SetRate(int rate);
  /// Drops what is spoken and what waits, unless something important is being spoken.
  bool Cancel();
  /// Says good-bye, without waiting for an answer.
  void Leave();

  Fault fault() const { return fault_; }
  const std::string& refusal() const { return refusal_; }  ///< the service's words, if kRefused

 private:
  using Clock = std::chrono::steady_clock;
  bool Do(const std::string& command);
  bool Queue(Priority priority, const std::string& command);
  bool SendText(std::string_view text);
  bool Send(std::string_view bytes);
  bool Answered();
  bool Fetch(Clock::time_point& until);
  bool TakeLine(const std::string& line);
  void TakeEvent(const std::string& line);
  bool Fail(Fault fault);

  Hurry hurry_;
  FileDescriptor fd_;
  LineBuffer in_{4000};
  Fault fault_ = Fault::kNone;
  std::string refusal_;
  bool refused_ = false;  ///< the command answered last
  Priority priority_ = Priority::kText;
  std::string message_;                ///< number of the one queued last
  std::string event_message_;          ///< that the event being received is about
  std::set<std::string> important_;    ///< numbers that are not spoken to their end yet
  Clock::time_point important_until_;  ///< they are not waited for longer
};

/// What follows SPEAK: without control characters, with a point doubled that begins a line, closed
/// by a line of one point.
std::string SsipText(std::string_view text);

}  // namespace moontrace
