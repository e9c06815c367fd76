#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/book/book_walk.h"
#include "sim/console/vocabulary.h"
#include "sim/session/loop_drive.h"
#include "sim/tutor/tutor_command.h"
#include "sim/tutor/tutor_server.h"

namespace moontrace {

/// Tutors of somebody who reads: they hear all that is said and each line as the hand comes to it,
/// move the reader by the reader's words, and send passages. The reader's own stop is never undone.
class BookDesk : public Elsewhere {
 public:
  /// `walk` must outlive this. Throws LackError: no door can be opened (tutor_server.h).
  BookDesk(const std::string& learner, std::string_view title, BookWalk& walk);

  std::optional<Line> Next(const LoopSnapshot& now) override;
  void Told(std::string_view line) override { server_.SendToAll(line); }
  void Typed(std::string_view line) override;

 private:
  std::optional<Line> Take(TutorServer::Line line, const LoopSnapshot& now);
  std::optional<Line> Do(const TutorServer::Line& line, const TutorCommand& command,
                         const LoopSnapshot& now);
  std::optional<Line> TakeReadersWord(const TutorServer::Line& line, const LoopSnapshot& now);
  void TellWords(const TutorServer::Line& to, const std::string& word);
  void Answer(const TutorServer::Line& to, std::string_view line);
  void Follow(const LoopSnapshot& now);

  BookWalk& walk_;
  std::string learner_;
  TutorServer server_;
  std::map<std::size_t, Proposal> proposals_;  ///< by tutor
  std::vector<std::string> comings_;           ///< not yet told, the newest first
  std::string followed_;                       ///< the line that tutors were told last
  bool stopped_ = false;                       ///< by a tutor, and by nobody else since
  bool rested_ = false;                        ///< all was stopped when it was looked at last
};

}  // namespace moontrace
