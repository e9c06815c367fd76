#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// The door through which tutors speak to a running lesson: a Unix socket in the user's runtime
/// folder, open to this user alone. A thread of its own serves it, so that no call below ever waits
/// for a tutor. Lines are of at most 1000 bytes, tutors at most 8; one that does not read what it
/// is sent, or sends without end, is dropped, and the lesson goes on.
class TutorServer {
 public:
  /// What a tutor said.
  struct Line {
    std::size_t tutor = 0;  ///< from 1, in the order they came; never used again
    std::string text;       ///< valid UTF-8 without control characters
  };

  /// Opens `tutor-LEARNER.sock` and listens. `greeting`: the first line that each tutor gets.
  /// Throws LackError, one line: a live lesson of this learner has the socket; the folder is
  /// another's or open to others; no room. What a dead program left behind is taken over.
  TutorServer(const std::string& learner, std::string_view greeting);
  /// Sends tutors the lines still queued for them (for at most 0.2 s) and disconnects them.
  ~TutorServer();
  TutorServer(const TutorServer&) = delete;
  TutorServer& operator=(const TutorServer&) = delete;

  /// The next line that has come, in order of coming, if there is one. Never waits.
  std::optional<Line> Next();
  /// One line to one tutor; nothing if that one has gone.
  void Answer(std::size_t tutor, std::string_view line);
  /// One line to every tutor: what the learner is told.
  void SendToAll(std::string_view line);
  /// Disconnects one tutor once its lines have been sent: its "quit".
  void Dismiss(std::size_t tutor);

  /// Comings and goings since the last call, one sentence each, for the learner to know.
  std::vector<std::string> TakeSentences();
  std::size_t tutors() const;
  const std::string& path() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
