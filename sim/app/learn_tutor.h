#pragma once

#include <optional>
#include <string>

#include "sim/app/learn_session.h"
#include "sim/app/tutor_command.h"
#include "sim/app/tutor_server.h"
#include "sim/app/tutor_stroke.h"

namespace moontrace {

/// Does what tutors say to a lesson. Each command is told to the learner first, done at once, and
/// written into the records; tutors hear all that the learner is told. The learner's own stop is
/// never undone.
class TutorDesk {
 public:
  /// Throws LackError: no door can be opened (tutor_server.h).
  explicit TutorDesk(LearnSession& session);
  ~TutorDesk();
  TutorDesk(const TutorDesk&) = delete;
  TutorDesk& operator=(const TutorDesk&) = delete;

  /// Everything that tutors have said since the last call.
  void Serve();

 private:
  void Do(const TutorServer::Line& line, const TutorCommand& command);
  bool DoToPage(std::size_t tutor, const TutorCommand& command);
  void DoToLesson(const TutorCommand& command);
  void Record(std::size_t tutor);
  void PlayBack();  ///< there is a stroke, and it can be felt

  LearnSession& session_;
  TutorServer server_;
  std::optional<StrokeRecorder> recorder_;
  std::optional<RecordedStroke> stroke_;
};

}  // namespace moontrace
