#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/progress/lesson_machine.h"
#include "sim/audio/sound.h"
#include "sim/audio/speech.h"
#include "sim/console/console.h"
#include "sim/learn/learn_options.h"

namespace moontrace {

/// The one place where a lesson speaks. Everything is text first, a line each; what is spoken,
/// sounded or reported to tutors comes beside it. Speech of one turn is said as one, or each
/// sentence would silence the one before it.
class LearnTeller {
 public:
  /// `speech` and `sound` may be null, and must outlive this.
  LearnTeller(Console& console, Speech* speech, Sound* sound);
  /// Is given every line too: what the learner is told, for tutors.
  void SetListener(std::function<void(std::string_view)> listener);

  /// Every line goes through it before it is told, as one for who has single keys.
  void SetWording(std::function<std::string(std::string_view)> wording);

  void Say(Priority priority, std::string_view line);
  /// What nobody asked for: not with `--quiet`.
  void Happening(Priority priority, std::string_view line);
  /// On standard error: hints, and what cannot be.
  void Remark(std::string_view line);
  /// A word letter by letter; `line` is the text of it.
  void Spell(std::string_view line, std::string_view word);
  void Play(Earcon earcon);
  /// What is being spoken ends: the learner has typed.
  void Interrupt();
  /// Silence, for a stop.
  void Hush();
  /// Speaks what was gathered and writes all lines out. Also tells why speech or sound ended.
  void EndTurn();

  /// Writes out what was told, before something slow.
  void Flush();

  /// Lines told so far.
  int told() const { return told_; }

 private:
  void Gather(Priority priority, std::string_view line);
  std::string Worded(std::string_view line) const;

  Console& console_;
  Speech* speech_;
  Sound* sound_;
  std::function<void(std::string_view)> listener_;
  std::function<std::string(std::string_view)> wording_;
  std::string gathered_;
  Priority priority_ = Priority::kNotification;
  int told_ = 0;
};

/// How urgent a sentence of the lesson is.
Priority PriorityOf(lesson_action::Sentence sentence);
/// The earcon that goes with it, if there is one.
std::optional<Earcon> EarconOf(lesson_action::Sentence sentence);

/// What was asked for on the command line; null: nothing. Throws InputError: an own table of
/// sounds.
std::unique_ptr<Speech> SpeechFor(const LearnOptions& options, const Course& course);
std::unique_ptr<Sound> SoundFor(const LearnOptions& options);

}  // namespace moontrace
