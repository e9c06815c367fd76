#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "sim/console/vocabulary.h"
#include "sim/learn/running_lesson.h"
#include "sim/tutor/tutor_command.h"
#include "sim/tutor/tutor_server.h"
#include "sim/tutor/tutor_stroke.h"

namespace moontrace {

/// Does what tutors say to a lesson, at once. Each command is told to the learner and written into
/// the records; what a page may refuse, its form, only once it is done, and a refusal reaches the
/// tutor alone. Tutors hear all that the learner is told. The learner's own stop is never undone.
class TutorDesk {
 public:
  using Told = std::function<void(std::string_view line)>;
  /// `lesson` must outlive this, as `parts` do. `door`: tutors may come in from other terminals;
  /// throws LackError: none can be opened (tutor_server.h). `window`: is told, beside them, what
  /// the learner is told; may be empty.
  TutorDesk(const LearnParts& parts, RunningLesson& lesson, bool door, Told window = {});
  ~TutorDesk();
  TutorDesk(const TutorDesk&) = delete;
  TutorDesk& operator=(const TutorDesk&) = delete;

  /// Everything that tutors have said since the last call.
  void Serve();
  /// A line of the tutor at the window, whom `answer` reaches.
  void Hear(const std::string& line, const Told& answer);

 private:
  void Take(TutorServer::Line line);
  void Answer(std::size_t tutor, std::string_view line);
  std::string Does(const TutorCommand& command) const;
  void TellWords(std::size_t tutor, const std::string& word);
  void Do(const TutorServer::Line& line, const TutorCommand& command);
  void ChangeForm(const TutorServer::Line& line, const TutorCommand& command);
  bool DoToPage(std::size_t tutor, const TutorCommand& command);
  void DoToLesson(const TutorCommand& command);
  void Record(std::size_t tutor);
  void PlayBack();  ///< there is a stroke, and it can be felt

  const Course& course_;
  LearnMemory& memory_;
  LearnStage& stage_;
  LearnTeller& teller_;
  RunningLesson& lesson_;
  std::optional<TutorServer> server_;
  Told window_, answer_;
  std::map<std::size_t, Proposal> proposals_;  ///< by tutor
  std::optional<StrokeRecorder> recorder_;
  std::optional<RecordedStroke> stroke_;
};

}  // namespace moontrace
