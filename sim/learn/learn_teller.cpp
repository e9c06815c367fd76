#include "sim/learn/learn_teller.h"

#include <algorithm>
#include <ostream>
#include <utility>

namespace moontrace {

LearnTeller::LearnTeller(Console& console, Speech* speech, Sound* sound)
    : console_(console), speech_(speech), sound_(sound) {}

void LearnTeller::SetListener(std::function<void(std::string_view)> listener) {
  listener_ = std::move(listener);
}

void LearnTeller::SetWording(std::function<std::string(std::string_view)> wording) {
  wording_ = std::move(wording);
}

std::string LearnTeller::Worded(std::string_view line) const {
  return wording_ ? wording_(line) : std::string(line);
}

void LearnTeller::Gather(Priority priority, std::string_view line) {
  if (listener_) listener_(line);
  ++told_;
  if (speech_ == nullptr) return;
  if (priority == Priority::kImportant) return speech_->Say(priority, line);  // waits for nothing
  if (!gathered_.empty()) gathered_ += ' ';
  gathered_ += line;
  priority_ = std::min(priority_, priority);
}

void LearnTeller::Say(Priority priority, std::string_view line) {
  if (line.empty()) return;
  const std::string worded = Worded(line);
  console_.Result(worded);
  Gather(priority, worded);
}

void LearnTeller::Happening(Priority priority, std::string_view line) {
  if (line.empty()) return;
  const std::string worded = Worded(line);
  console_.Happening(worded);
  Gather(priority, worded);
}

void LearnTeller::Remark(std::string_view line) {
  if (line.empty()) return;
  console_.out().flush();
  console_.Remark(line);
  Gather(Priority::kText, line);
}

void LearnTeller::Spell(std::string_view line, std::string_view word) {
  console_.Result(line);
  if (listener_) listener_(line);
  ++told_;
  if (speech_ != nullptr) speech_->Spell(word);
}

void LearnTeller::Play(Earcon earcon) {
  if (sound_ != nullptr) sound_->Play(earcon);
}

void LearnTeller::Interrupt() {
  if (speech_ != nullptr) speech_->Cancel();
}

void LearnTeller::Hush() {
  gathered_.clear();
  if (speech_ != nullptr) speech_->Cancel();
  if (sound_ != nullptr) sound_->Silence();
}

void LearnTeller::EndTurn() {
  if (speech_ != nullptr && !gathered_.empty()) speech_->Say(priority_, gathered_);
  gathered_.clear();
  priority_ = Priority::kNotification;
  if (speech_ != nullptr) {
    if (const auto why = speech_->TakeSentence()) console_.Remark(*why);
  }
  if (sound_ != nullptr) {
    if (const auto why = sound_->TakeSentence()) console_.Remark(*why);
  }
  Flush();
}

void LearnTeller::Flush() { console_.out().flush(); }

Priority PriorityOf(lesson_action::Sentence sentence) {
  using lesson_action::Sentence;
  switch (sentence) {
    case Sentence::kRight:
    case Sentence::kWrong:
    case Sentence::kTold:
    case Sentence::kTraceGood:
    case Sentence::kTraceBad:
    case Sentence::kTestResult:
    case Sentence::kLessonDone:
    case Sentence::kCourseDone:
    case Sentence::kBreak:
      return Priority::kMessage;
    default:
      return Priority::kText;
  }
}

std::optional<Earcon> EarconOf(lesson_action::Sentence sentence) {
  using lesson_action::Sentence;
  switch (sentence) {
    case Sentence::kRight:
      return Earcon::kRight;
    case Sentence::kWrong:
    case Sentence::kTraceBad:
      return Earcon::kWrong;
    case Sentence::kTraceGood:
      return Earcon::kLetterDone;
    case Sentence::kHelpNow:
    case Sentence::kModeNow:
      return Earcon::kHelpChanged;
    default:
      return std::nullopt;
  }
}

std::unique_ptr<Speech> SpeechFor(const LearnOptions& options, const Course& course) {
  if (!options.speak) return nullptr;
  SpeechOptions voice;
  voice.language = course.language;
  return std::make_unique<Speech>(voice);
}

std::unique_ptr<Sound> SoundFor(const LearnOptions& options) {
  if (!options.sound) return nullptr;
  return std::make_unique<Sound>(LoadSounds(options.sounds));
}

}  // namespace moontrace
