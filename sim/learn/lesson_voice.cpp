#include "sim/learn/lesson_voice.h"

#include "sim/learn/learn_messages.h"

namespace moontrace {

namespace {

/// Comes again with every sign.
bool Repeats(lesson_action::Sentence sentence) {
  using lesson_action::Sentence;
  return sentence == Sentence::kAskName || sentence == Sentence::kAskSame ||
         sentence == Sentence::kTraceIt;
}

}  // namespace

std::string LessonVoice::Words(const Course& course, const lesson_action::Say& sentence, bool brief,
                               bool in_full) {
  const bool known = !said_.insert(sentence.sentence).second && Repeats(sentence.sentence);
  const bool shorter = (brief || known) && !in_full;
  return shorter ? say::BriefSentence(course, sentence) : say::LessonSentence(course, sentence);
}

}  // namespace moontrace
