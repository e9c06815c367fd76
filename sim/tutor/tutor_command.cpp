#include "sim/tutor/tutor_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "sim/console/vocabulary.h"
#include "sim/console/word_messages.h"
#include "sim/tutor/number_behind.h"
#include "sim/tutor/tutor_messages.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

enum class Behind { kNothing, kHelp, kMode, kText };

/// What stands behind a word.
struct Rule {
  TutorWord word;
  std::string_view name;
  Behind behind = Behind::kNothing;
  const char* wants = "";
};

/// Those that change the page are PageWords.
constexpr auto kRules = [] {
  using W = TutorWord;
  return std::to_array<Rule>({
      {W::kStop, "stop"},
      {W::kNext, "next"},
      {W::kWhere, "where"},
      {W::kAgain, "again"},
      {W::kGo, "go"},
      {W::kPause, "pause"},
      {W::kQuit, "quit"},
      {W::kHelp, "help", Behind::kHelp},
      {W::kSkip, "skip"},
      {W::kMode, "mode", Behind::kMode, kGuidanceModes},
      {W::kShow, "show"},
      {W::kSay, "say", Behind::kText, "a text for the learner"},
      {W::kLesson, "lesson", Behind::kText, "the number of a lesson"},
      {W::kRecord, "record"},
      {W::kPlayback, "playback"},
      {W::kWho, "who"},
      {W::kNextLesson, "next lesson"},
      {W::kPlace, "find", Behind::kText, "a word of the page"},
      {W::kPlace, "find next"},
      {W::kPlace, "return"},
      {W::kPlace, "next line"},
      {W::kPlace, "next heading"},
  });
}();

/// Without control characters and broken bytes, and without blanks at the ends.
std::string Cleaned(std::string_view line) {
  std::string clean(line);
  for (char& c : clean) {
    if (c == '\t' || c == '\r') c = ' ';
  }
  clean = OneLine(clean, clean.size());
  const auto begin = clean.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return clean.substr(begin, clean.find_last_not_of(' ') - begin + 1);
}

std::variant<TutorCommand, TutorRefusal> ReadPage(PageWord word, const std::string& behind) {
  const auto read = ReadPageCommand(word, behind);
  if (const std::string* refusal = std::get_if<std::string>(&read)) return TutorRefusal{*refusal};
  TutorCommand command{TutorWord::kPage};
  command.page = std::get<PageCommand>(read);
  return command;
}

/// The strength of the push; alone, or before a word, what can be said.
std::variant<TutorCommand, TutorRefusal> ReadHelp(const Rule& rule, const std::string& behind) {
  static const NumberRule number = {"a number from 0 to 10", 0, 10, 1, {}};
  if (behind.empty() || WordNamed(LowerCase(behind)) != nullptr) {
    TutorCommand command;
    command.text = behind;
    return command;
  }
  const auto read = ReadNumberBehind(rule.name, number, behind);
  if (const std::string* refusal = std::get_if<std::string>(&read)) return TutorRefusal{*refusal};
  TutorCommand command{rule.word};
  command.help = static_cast<int>(std::lround(std::get<double>(read)));
  return command;
}

std::variant<TutorCommand, TutorRefusal> ReadMode(const Rule& rule, const std::string& behind) {
  const std::optional<GuidanceMode> mode = GuidanceModeOf(LowerCase(behind));
  if (!mode) return TutorRefusal{say::WordCannotBe(rule.name, behind, rule.wants)};
  TutorCommand command{rule.word};
  command.mode = *mode;
  return command;
}

std::variant<TutorCommand, TutorRefusal> ReadBehind(const Rule& rule, const std::string& behind) {
  TutorCommand command{rule.word};
  const bool wanted = rule.behind == Behind::kMode || rule.behind == Behind::kText;
  if (wanted && behind.empty()) return TutorRefusal{say::WordWants(rule.name, rule.wants)};
  switch (rule.behind) {
    case Behind::kHelp:
      return ReadHelp(rule, behind);
    case Behind::kMode:
      return ReadMode(rule, behind);
    case Behind::kText:
      command.text = behind;
      return command;
    case Behind::kNothing:
      break;
  }
  return command;
}

}  // namespace

std::variant<TutorCommand, TutorRefusal> ReadTutorCommand(std::string_view line) {
  const std::string clean = Cleaned(line);
  if (clean.empty()) return TutorRefusal{say::TutorSaidNothing()};
  // a broken byte is shown as "?" too, and asks nothing
  const bool broken = clean == "?" && line.find('?') == std::string_view::npos;
  if (broken) return TutorRefusal{say::WordUnknown(clean, "")};
  if (clean == "?") return TutorCommand{};
  SaidLine said = ReadLine(clean, WordPlace::kTutor);
  if (!said.refusal.empty()) {
    return TutorRefusal{std::move(said.refusal), std::move(said.meant)};
  }
  if (said.word == nullptr) return TutorRefusal{say::TutorSaidNothing()};
  const std::string_view name = said.word->word;
  if (const std::optional<PageWord> page = PageWordOf(name)) return ReadPage(*page, said.behind);
  const auto rule = std::find_if(kRules.begin(), kRules.end(),
                                 [name](const Rule& one) { return one.name == name; });
  auto read = ReadBehind(*rule, said.behind);
  auto* command = std::get_if<TutorCommand>(&read);
  if (command == nullptr || command->word != TutorWord::kPlace) return read;
  command->text =
      command->text.empty() ? std::string(name) : std::string(name) + " " + command->text;
  return read;
}

}  // namespace moontrace
