#include "sim/learn/learn_learner.h"

#include <algorithm>
#include <ctime>
#include <optional>
#include <utility>
#include <vector>

#include "lessons/progress/answer.h"
#include "lessons/records/learner_names.h"
#include "sim/console/choice.h"
#include "sim/console/line_wrap.h"
#include "sim/console/vocabulary.h"
#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_stage.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr int kPoll = 50;  ///< [ms]

/// Who was asked said "quit".
struct LeftAtQuestion {};

std::string Trimmed(const std::string& line) {
  const auto begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t") - begin + 1);
}

/// The next line that somebody types; none: there will be no more. The words that are words at any
/// moment are so here: "quit" throws LeftAtQuestion, "?" and "help" say `help` and ask once more.
std::optional<std::string> Ask(LineReader& lines, LearnTeller& teller, const std::string& question,
                               const std::string& help, const Console& console) {
  const auto ask = [&] {
    for (const std::string& sentence : Sentences(question)) teller.Say(Priority::kText, sentence);
    teller.EndTurn();
  };
  ask();
  for (;;) {
    console.CheckStop();
    if (std::optional<std::string> line = lines.Next(kPoll)) {
      const std::string said = Trimmed(*line);
      const std::string word = LowerCase(said.substr(said.find_first_not_of('/') == 1 ? 1 : 0));
      const TypedWord* whole = WholeWord(word, WordPlace::kLesson);
      if (whole == WordNamed("quit")) throw LeftAtQuestion{};
      // "what?" and the like; who says again may be asked for a name
      const bool again = whole == WordNamed("again") && word != "again";
      if (word != "?" && word != "help" && !again) return said;
      teller.Say(Priority::kText, help);
      ask();
    } else if (lines.ended()) {
      return std::nullopt;
    }
  }
}

/// Enter alone is no, and so are the words stop and quit; none: neither was said. More may stand
/// behind it: "Yes, please!"
std::optional<bool> YesOrNo(const std::string& line) {
  const std::string answer = LowerCase(line);
  const TypedWord* word = ReadLine(answer, WordPlace::kLesson).word;
  if (word != nullptr && (word->word == "stop" || word->word == "quit")) return false;
  if (SaysYes(answer)) return true;
  const std::string first = answer.substr(0, answer.find_first_of(" .,;:!"));
  for (const char* no : {"no", "n", "noo", "nope"}) {
    if (first == no) return false;
  }
  if (answer.empty()) return false;
  return std::nullopt;
}

/// What is said in lessons, whole or by its number, or in answer to a question, and would be kept
/// as a name by mistake: the refusal. Empty: it may be a name.
std::string RefusedName(const std::string& line) {
  const std::string said = LowerCase(line);
  const TypedWord* word = FindWord(said, WordPlace::kLesson).word;
  const bool number = word != nullptr && said == std::to_string(word->number);
  if (number) return say::NumberIsNoName(said, word->word);
  const bool whole = word != nullptr && said == word->word;
  if (whole || said == "yes" || said == "no") return say::WordIsNoName(line);
  return DoesNotKnow(said) ? say::AnyNameWillDo() : "";
}

std::string WhoLearns(const LearnOptions& options, const std::vector<LearnerEntry>& known,
                      LineReader& lines, LearnTeller& teller, const Console& console) {
  if (!options.learner.empty()) return options.learner;
  const std::vector<std::string> names = PeopleAmong(known);
  if (names.size() == 1) return names.front();
  const std::string asked = names.empty() ? say::AskLearner() : say::AskWhich(names);
  std::string question = asked;
  for (;;) {
    const std::optional<std::string> line =
        Ask(lines, teller, std::exchange(question, asked), say::QuitLeaves(), console);
    if (!line) throw UsageError(say::NoLearner());
    if (std::find(names.begin(), names.end(), *line) != names.end()) return *line;
    for (std::size_t i = 0; i < names.size() && names.size() > 1; ++i) {  // of the names just told
      if (*line == std::to_string(i + 1)) return names[i];
    }
    const std::string refusal = RefusedName(*line);
    if (!refusal.empty()) question = refusal;
    if (line->empty() || !refusal.empty()) continue;
    try {
      RequirePseudonym(*line);
      return *line;
    } catch (const InputError&) {
      teller.Say(Priority::kText, say::NotAName());
    }
  }
}

}  // namespace

std::optional<LearnMemory> OpenMemory(const LearnOptions& options, const Course& course,
                                      LineReader& lines, LearnTeller& teller,
                                      const Console& console) try {
  if (!Records::Available()) {
    teller.Say(Priority::kText, say::NoRecords());
    return LearnMemory{};
  }
  Records records =
      Records::Open(options.records.empty() ? Records::DefaultPath() : options.records);
  const std::vector<LearnerEntry> known = records.Learners();
  const std::string given = WhoLearns(options, known, lines, teller, console);
  RequirePseudonym(given);
  const std::string name = KeptName(given, known);
  if (name != given) teller.Say(Priority::kText, say::TakenForKept(given, name));
  std::optional<LearnerEntry> learner = records.Find(name);
  if (learner && learner->simulated) throw UsageError(say::SimulatedOnly(name));
  const bool fresh = !learner;
  if (fresh) {
    learner = LearnerEntry{name, static_cast<std::int64_t>(std::time(nullptr)), false, "", false};
  }
  LearnMemory memory(std::move(records), *learner, course.id, fresh);
  teller.Say(Priority::kText, say::Learner(name, memory.trials(), fresh));
  return memory;
} catch (const LeftAtQuestion&) {
  teller.Say(Priority::kText, say::LeftBeforeBeginning());
  teller.EndTurn();
  return std::nullopt;
}

namespace {

/// Yes is the first. None: it was not said.
std::optional<std::string> ChosenWithoutDevice(const std::string& line) {
  const std::vector<std::string> ways{"demonstration", "paper", "mouse"};
  if (const std::optional<std::size_t> way = ChoiceOf(line, ways)) return ways[*way];
  const std::optional<bool> yes = YesOrNo(line);
  if (!yes) return std::nullopt;
  return *yes ? "demonstration" : "";
}

}  // namespace

std::string AskWithoutDevice(LineReader& lines, LearnTeller& teller, const Console& console) {
  const std::string question = say::AskWithoutDevice(WindowMayOpen());
  try {
    for (;;) {
      const auto line = Ask(lines, teller, question, say::DemonstrationIs(), console);
      if (!line) return {};
      if (const std::optional<std::string> way = ChosenWithoutDevice(*line)) return *way;
      teller.Say(Priority::kText, say::NoneOfThree(*line));  // and all of it again
    }
  } catch (const LeftAtQuestion&) {
    return {};
  }
}

void AskConsent(LearnMemory& memory, LineReader& lines, LearnTeller& teller,
                const Console& console) {
  if (!memory.remembers() || memory.consent_asked()) return;
  std::string question = say::AskConsent();
  try {
    for (;;) {
      const auto line = Ask(lines, teller, question, say::ConsentHelp(), console);
      if (!line) return;
      const std::optional<bool> yes = YesOrNo(*line);
      question = say::YesOrNo();
      if (!yes) continue;
      memory.SetConsent(*yes, say::kConsentVersion);
      teller.Say(Priority::kText, say::ConsentGiven(*yes));
      return teller.EndTurn();
    }
  } catch (const LeftAtQuestion&) {
    // asked again the next time
  }
}

}  // namespace moontrace
