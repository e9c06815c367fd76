#include "sim/tutor/page_words.h"

#include <algorithm>
#include <utility>

#include "sim/console/word_messages.h"
#include "sim/console/wording.h"
#include "sim/tutor/number_behind.h"
#include "textures/base/enum_names.h"
#include "textures/base/text_file.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

constexpr std::string_view NameOf(PageWord word) {
  switch (word) {
    case PageWord::kSize:
      return "size";
    case PageWord::kDepth:
      return "depth";
    case PageWord::kWidth:
      return "width";
    case PageWord::kSpacing:
      return "spacing";
    case PageWord::kPitch:
      return "pitch";
    case PageWord::kTilt:
      return "tilt";
    case PageWord::kEngraved:
      return "engraved";
    case PageWord::kEmbossed:
      return "embossed";
    case PageWord::kForm:
      return "form";
    case PageWord::kPaper:
      return "paper";
  }
  return {};
}

/// Null for words that want no number.
const NumberRule* RuleOf(PageWord word) {
  static const std::vector<NumberUnit> shares = {{"%", 0.01}, {"percent", 0.01}, {"times", 1}};
  static const NumberRule size = {
      "mm, 1 to 1000", 1, 1000, kMillimetre, {{"mm", 1}, {"cm", 10}, {"m", 1000}}};
  static const NumberRule depth = {"20 to 200 %", 0.2, 2, 1, shares};
  static const NumberRule width = {"50 to 200 %", 0.5, 2, 1, shares};
  static const NumberRule spaces = {"100 to 300 %", 1, 3, 1, shares};
  static const NumberRule tilt = {
      "degrees, -60 to 60", -60, 60, kDegree, {{"degrees", 1}, {"degree", 1}, {"deg", 1}}};
  switch (word) {
    case PageWord::kSize:
      return &size;
    case PageWord::kDepth:
      return &depth;
    case PageWord::kWidth:
      return &width;
    case PageWord::kSpacing:
    case PageWord::kPitch:
      return &spaces;
    case PageWord::kTilt:
      return &tilt;
    case PageWord::kEngraved:
    case PageWord::kEmbossed:
    case PageWord::kForm:
    case PageWord::kPaper:
      break;
  }
  return nullptr;
}

/// "reverse N" as the scripts call it: "reverse-n".
std::string FormNamed(std::string_view given) {
  std::string name = LowerCase(given);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::variant<PageCommand, std::string> ReadPaper(std::string_view word, std::string_view given) {
  PageCommand command{PageWord::kPaper};
  const std::string name = LowerCase(given);
  if (name == "smooth") return command;
  command.paper = PaperKindOf(name);
  // an array's heights are in a file, which a word cannot bring
  if (command.paper && *command.paper != PaperKind::kSampled) return command;
  return say::WordCannotBe(word, given, say::Joined(PaperChoices(), " or "));
}

}  // namespace

const std::vector<std::string>& FormChoices() {
  static const std::vector<std::string> choices = {"crescent", "arc", "pocket", "reverse-n"};
  return choices;
}

const std::vector<std::string>& PaperChoices() {
  static const std::vector<std::string> choices = {"smooth", "sine", "grid", "noise"};
  return choices;
}

const std::vector<std::string>& PageWords() {
  static const std::vector<std::string> words = AllNames(&NameOf);
  return words;
}

std::optional<PageWord> PageWordOf(std::string_view word) {
  const std::vector<std::string>& words = PageWords();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<PageWord>(found - words.begin());
}

std::variant<PageCommand, std::string> ReadPageCommand(PageWord word, std::string_view behind) {
  const std::string name(NameOf(word));
  PageCommand command{word};
  if (const NumberRule* rule = RuleOf(word)) {
    const auto read = ReadNumberBehind(name, *rule, behind);
    if (const std::string* refusal = std::get_if<std::string>(&read)) return *refusal;
    command.value = std::get<double>(read);
    return command;
  }
  if (word == PageWord::kEngraved || word == PageWord::kEmbossed) {
    if (!behind.empty()) return say::WordStandsAlone(name, behind);
    return command;
  }
  const bool is_form = word == PageWord::kForm;
  if (behind.empty()) {
    return say::WordWants(name, say::Joined(is_form ? FormChoices() : PaperChoices(), " or "));
  }
  if (!is_form) return ReadPaper(name, behind);
  command.h_form = FormNamed(behind);
  return command;
}

PageForm Changed(PageForm form, const PageCommand& command) {
  switch (command.word) {
    case PageWord::kDepth:
      form.depth = command.value;
      break;
    case PageWord::kWidth:
      form.width = command.value;
      break;
    case PageWord::kSpacing:
      form.spacing = command.value;
      break;
    case PageWord::kPitch:
      form.pitch = command.value;
      break;
    case PageWord::kEngraved:
      form.relief = Relief::kEngraved;
      break;
    case PageWord::kEmbossed:
      form.relief = Relief::kEmbossed;
      break;
    case PageWord::kForm:
      form.h_form = command.h_form;
      break;
    case PageWord::kPaper:
      form.paper = command.paper;
      break;
    case PageWord::kSize:
    case PageWord::kTilt:
      break;
  }
  return form;
}

}  // namespace moontrace
