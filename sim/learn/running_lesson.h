#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lessons/course/course.h"
#include "lessons/guide/guidance.h"
#include "lessons/progress/lesson_machine.h"
#include "sim/session/loop_poll.h"

namespace moontrace {

class LearnMemory;
class LearnStage;
class LearnTeller;

/// What a lesson is held with; all of it outlives the lesson, its tutors and its view.
struct LearnParts {
  const Course& course;
  LearnMemory& memory;
  LearnStage& stage;
  LearnTeller& teller;
};

/// What moves on the page now, as sounds meet it.
class RunningStage {
 public:
  virtual ~RunningStage() = default;
  /// As of the last look at the loop.
  virtual const LoopPoll& poll() const = 0;
  /// The force rests.
  virtual bool stopped() const = 0;
};

/// A lesson that runs, as its tutors and its view meet it: how it stands, and what may be done to
/// it. All in the lesson's thread.
class RunningLesson : public RunningStage {
 public:
  virtual const LessonState& state() const = 0;
  /// It has ended, or is about to.
  virtual bool over() const = 0;
  /// The device is lost: the lesson waits for it.
  virtual bool waits() const = 0;
  /// Lesson and step: one line.
  virtual std::string Status() const = 0;
  /// What a tutor wants to know besides: size, help and push; what was last right and wrong.
  virtual std::vector<std::string> StatusForTutor() const = 0;

  /// A line of the learner's; always answered by a line.
  virtual void Obey(const std::string& line) = 0;

  // What tutors do. The caller tells the learner first.
  virtual void TutorSays(lesson_event::Said said) = 0;
  virtual void Overrule(const lesson_event::Overrule& overrule) = 0;
  /// The force rests; a pause by the tutor ends by the tutor's word or the learner's.
  virtual void Pause(bool by_tutor) = 0;
  /// False: nothing rests, or the learner's own stop stands.
  virtual bool GoOn(bool by_tutor) = 0;
  /// As Pause, and all sound and speech end.
  virtual void Stop(bool by_tutor) = 0;
  /// Leads the hand along a path once; nothing of it counts, then the trace begins anew.
  virtual void Lead(std::shared_ptr<const GuidancePath> path) = 0;
};

}  // namespace moontrace
