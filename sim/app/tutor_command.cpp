#include "sim/app/tutor_command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/app/tutor_messages.h"
#include "textures/nearest_word.h"
#include "textures/text_file.h"

namespace moontrace {

namespace {

enum class Behind { kNothing, kNumber, kMode, kText, kLessonWord };

struct Unit {
  std::string_view name;
  double factor;  ///< to what the range is told in
};

/// What stands behind a word. Ranges are in the unit that people use, `scale` makes it SI.
struct Rule {
  TutorWord word;
  const char* name;
  Behind behind;
  const char* wants;
  double low, high, scale;
  std::vector<Unit> units;
};

constexpr double kDegree = std::numbers::pi / 180;

const std::vector<Rule>& Rules() {
  using W = TutorWord;
  const std::vector<Unit> shares = {{"%", 0.01}, {"percent", 0.01}, {"times", 1}};
  static const std::vector<Rule> rules = {
      {W::kSize,
       "size",
       Behind::kNumber,
       "mm of the letters, 1 to 1000",
       1,
       1000,
       1e-3,
       {{"mm", 1}, {"cm", 10}, {"m", 1000}}},
      {W::kHelp, "help", Behind::kNumber, "a number from 0 to 10", 0, 10, 1, {}},
      {W::kMode, "mode", Behind::kMode, kGuidanceModes, 0, 0, 1, {}},
      {W::kDepth, "depth", Behind::kNumber, "a factor from 0.2 to 2", 0.2, 2, 1, shares},
      {W::kSpacing, "spacing", Behind::kNumber, "a factor from 1 to 3", 1, 3, 1, shares},
      {W::kTilt,
       "tilt",
       Behind::kNumber,
       "degrees, -60 to 60",
       -60,
       60,
       kDegree,
       {{"degrees", 1}, {"degree", 1}, {"deg", 1}}},
      {W::kPause, "pause", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kGo, "go", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kShow, "show", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kSay, "say", Behind::kText, "a text for the learner", 0, 0, 1, {}},
      {W::kAgain, "again", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kSkip, "skip", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kNext, "next", Behind::kLessonWord, "", 0, 0, 1, {}},
      {W::kLesson, "lesson", Behind::kText, "the id of a lesson", 0, 0, 1, {}},
      {W::kRecord, "record", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kPlayback, "playback", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kWhere, "where", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kWho, "who", Behind::kNothing, "", 0, 0, 1, {}},
      {W::kQuit, "quit", Behind::kNothing, "", 0, 0, 1, {}},
  };
  return rules;
}

/// Without control characters and broken bytes, and without blanks at the ends.
std::string Cleaned(std::string_view line) {
  std::string clean(line);
  for (char& c : clean) {
    if (c == '\t' || c == '\r') c = ' ';
  }
  clean = OneLine(clean, clean.size());
  // the control characters above ASCII: U+0080 to U+009F, C2 80 to C2 9F
  for (std::size_t i = 0; i + 1 < clean.size(); ++i) {
    if (clean[i] == '\xC2' && static_cast<unsigned char>(clean[i + 1]) < 0xA0U) {
      clean.replace(i, 2, "?");
    }
  }
  const auto begin = clean.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return clean.substr(begin, clean.find_last_not_of(' ') - begin + 1);
}

/// The rule of a word, its number, or an unambiguous beginning; else the refusal.
std::variant<const Rule*, TutorRefusal> RuleOf(const std::string& given) {
  std::vector<std::string> begun;
  const Rule* found = nullptr;
  const std::vector<Rule>& rules = Rules();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const std::string name = rules[i].name;
    if (given == name || given == std::to_string(i + 1)) return &rules[i];
    if (name.compare(0, given.size(), given) != 0) continue;
    begun.push_back(name);
    found = &rules[i];
  }
  if (begun.size() == 1) return found;
  if (!begun.empty()) return TutorRefusal{say::TutorAmbiguous(given, begun)};
  return TutorRefusal{say::TutorUnknown(given, NearestWord(given, TutorWords()))};
}

/// A number and its unit in the rule's own; nothing if it is none.
std::optional<double> NumberIn(const Rule& rule, const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [after, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  std::string_view unit(after, static_cast<std::size_t>(end - after));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  if (unit.empty()) return value;
  for (const Unit& known : rule.units) {
    if (unit == known.name) return value * known.factor;
  }
  return std::nullopt;
}

std::variant<TutorCommand, TutorRefusal> ReadNumber(const Rule& rule, const std::string& text) {
  constexpr double kRounding = 1e-9;  // of "0.1 m" in mm
  const std::optional<double> value = NumberIn(rule, text);
  if (!value) return TutorRefusal{say::TutorCannotRead(rule.name, text, rule.wants)};
  if (*value < rule.low - kRounding || *value > rule.high + kRounding) {
    return TutorRefusal{say::TutorOutOfRange(rule.name, text, rule.wants)};
  }
  return TutorCommand{rule.word, *value * rule.scale, {}, {}};
}

std::variant<TutorCommand, TutorRefusal> ReadBehind(const Rule& rule, const std::string& behind) {
  const std::string lower = LowerCase(behind);
  const TutorCommand alone{rule.word, 0, {}, {}};
  if (rule.behind == Behind::kLessonWord) {
    const bool is_lesson = std::string_view("lesson").substr(0, lower.size()) == lower;
    if (!is_lesson) return TutorRefusal{say::TutorNothingBehind(rule.name, behind)};
    return alone;
  }
  if (rule.behind == Behind::kNothing) {
    if (!behind.empty()) return TutorRefusal{say::TutorNothingBehind(rule.name, behind)};
    return alone;
  }
  if (behind.empty()) return TutorRefusal{say::TutorWants(rule.name, rule.wants)};
  if (rule.behind == Behind::kNumber) return ReadNumber(rule, lower);
  if (rule.behind == Behind::kText) return TutorCommand{rule.word, 0, {}, behind};
  const std::optional<GuidanceMode> mode = GuidanceModeOf(lower);
  if (!mode) return TutorRefusal{say::TutorCannotRead(rule.name, behind, rule.wants)};
  return TutorCommand{rule.word, 0, *mode, {}};
}

}  // namespace

const std::vector<std::string>& TutorWords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> names;
    for (const Rule& rule : Rules()) names.emplace_back(rule.name);
    return names;
  }();
  return words;
}

std::variant<TutorCommand, TutorRefusal> ReadTutorCommand(std::string_view line) {
  const std::string clean = Cleaned(line);
  if (clean.empty()) return TutorRefusal{say::TutorSaidNothing()};
  if (clean == "?") return TutorCommand{};
  const std::size_t end = std::min(clean.find(' '), clean.size());
  const auto rule = RuleOf(LowerCase(clean.substr(0, end)));
  if (const TutorRefusal* refusal = std::get_if<TutorRefusal>(&rule)) return *refusal;
  const std::size_t behind = std::min(clean.find_first_not_of(' ', end), clean.size());
  return ReadBehind(*std::get<const Rule*>(rule), clean.substr(behind));
}

}  // namespace moontrace
