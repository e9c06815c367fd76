#include "sim/tutor/tutor_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/tutor/tutor_messages.h"
#include "sim/tutor/word_line.h"
#include "sim/tutor/word_messages.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

enum class Behind { kNothing, kPage, kHelp, kMode, kText, kLessonWord };

/// What stands behind a word.
struct Rule {
  TutorWord word;
  const char* name;
  Behind behind = Behind::kNothing;
  const char* wants = "";
};

/// In the order of TutorWord; "?" stands for itself.
constexpr auto kRules = [] {
  using W = TutorWord;
  return std::to_array<Rule>({
      {W::kStop, "stop"},
      {W::kHelp, "help", Behind::kHelp},
      {W::kMode, "mode", Behind::kMode, kGuidanceModes},
      {W::kDepth, "depth", Behind::kPage},
      {W::kSpacing, "spacing", Behind::kPage},
      {W::kTilt, "tilt", Behind::kPage},
      {W::kPause, "pause"},
      {W::kGo, "go"},
      {W::kShow, "show"},
      {W::kSay, "say", Behind::kText, "a text for the learner"},
      {W::kAgain, "again"},
      {W::kSkip, "skip"},
      {W::kNext, "next", Behind::kLessonWord},
      {W::kLesson, "lesson", Behind::kText, "the number of a lesson"},
      {W::kRecord, "record"},
      {W::kPlayback, "playback"},
      {W::kWhere, "where"},
      {W::kWho, "who"},
      {W::kQuit, "quit"},
      {W::kWidth, "width", Behind::kPage},
      {W::kPitch, "pitch", Behind::kPage},
      {W::kEngraved, "engraved", Behind::kPage},
      {W::kEmbossed, "embossed", Behind::kPage},
      {W::kForm, "form", Behind::kPage},
      {W::kPaper, "paper", Behind::kPage},
      {W::kSize, "size", Behind::kPage},
  });
}();
static_assert(kRules.size() == static_cast<std::size_t>(TutorWord::kQuestion));

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

std::variant<TutorCommand, TutorRefusal> ReadPage(const Rule& rule, const std::string& behind) {
  const std::vector<std::string>& words = PageWords();
  const auto word = std::find(words.begin(), words.end(), rule.name) - words.begin();
  const auto read = ReadPageCommand(static_cast<PageWord>(word), behind);
  if (const std::string* refusal = std::get_if<std::string>(&read)) return TutorRefusal{*refusal};
  TutorCommand command{rule.word};
  command.page = std::get<PageCommand>(read);
  return command;
}

std::variant<TutorCommand, TutorRefusal> ReadHelp(const Rule& rule, const std::string& behind) {
  static const NumberRule number = {"a number from 0 to 10", 0, 10, 1, {}};
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
    case Behind::kPage:
      return ReadPage(rule, behind);
    case Behind::kHelp:
      return ReadHelp(rule, behind);
    case Behind::kMode:
      return ReadMode(rule, behind);
    case Behind::kText:
      command.text = behind;
      return command;
    case Behind::kLessonWord: {
      const std::string lower = LowerCase(behind);
      if (std::string_view("lesson").substr(0, lower.size()) == lower) return command;
      return TutorRefusal{say::WordStandsAlone(rule.name, behind)};
    }
    case Behind::kNothing:
      break;
  }
  if (!behind.empty()) return TutorRefusal{say::WordStandsAlone(rule.name, behind)};
  return command;
}

}  // namespace

const std::vector<std::string>& TutorWords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> names;
    names.reserve(kRules.size());
    for (const Rule& rule : kRules) names.emplace_back(rule.name);
    return names;
  }();
  return words;
}

std::variant<TutorCommand, TutorRefusal> ReadTutorCommand(std::string_view line) {
  const std::string clean = Cleaned(line);
  if (clean.empty()) return TutorRefusal{say::TutorSaidNothing()};
  // not a broken byte, which is shown as "?" too
  if (clean == "?" && line.find('?') != std::string_view::npos) return TutorCommand{};
  const WordLine said = SplitWord(clean);
  const WordChoice choice = ChooseWord(said.word, TutorWords());
  if (choice.index) return ReadBehind(kRules[*choice.index], said.behind);
  if (!choice.begun.empty()) return TutorRefusal{say::WordAmbiguous(said.word, choice.begun)};
  return TutorRefusal{say::WordUnknown(said.word, NearestWord(said.word, TutorWords()))};
}

}  // namespace moontrace
