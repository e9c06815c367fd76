#include "sim/app/program_help.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 good; 1 the work failed; 2 the command line holds what no machine could take; 3 "
    "an input cannot be used: a file, a script, a text, or letters that do not fit it; 4 this "
    "machine lacks something: a device, a library, a permission, room; 130 interrupted; 141 "
    "whoever "
    "read its output has left.";
constexpr std::size_t kLongestExample = 40;  // [bytes]
/// CLI11's own heading, for options that were added before any other.
constexpr const char* kOwn = "Options";

/// What people call an option elsewhere, and what does it here: the first that the command has.
struct UsualOption {
  const char* words;
  const char* options;
  const char* value;  ///< that is to stand behind it
};
constexpr UsualOption kUsualOptions[] = {
    {"font fonts typeface alphabet", "script", ""},
    {"braille", "script", " braille"},
    {"height letter-size font-size fontsize", "size-mm", ""},
    {"pdf", "picture print", " page.pdf"},
    {"svg", "picture print", " page.svg"},
    {"png", "picture print", " page.png"},
    {"output out o save image draw", "output picture print to html folder", ""},
    {"input in i", "file", ""},
    {"paper format paper-size", "page", ""},
    {"name user pupil student", "learner", ""},
};

std::vector<std::string> Words(const char* text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::string Titled(const OptionSheet& option) {
  return option.value.empty() ? option.name : option.name + " " + option.value;
}

std::string Line(std::string_view text) { return std::string(text) + '\n'; }

std::string OptionLine(const OptionSheet& option) {
  return Line(fmt::format("{}: {}", Titled(option), option.description));
}

/// In Markdown a bar would end a table's cell.
std::string Cell(std::string_view text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c;
  }
  return cell;
}

std::string Table(const std::vector<const OptionSheet*>& options) {
  std::string table = "| option | what it does |\n| --- | --- |\n";
  for (const OptionSheet* option : options) {
    table += fmt::format("| `{}` | {} |\n", Cell(Titled(*option)), Cell(option->description));
  }
  return table + "\n";
}

/// Whether two commands have the same options, as help tells them.
bool Alike(const std::vector<const OptionSheet*>& a, const std::vector<const OptionSheet*>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const OptionSheet* one, const OptionSheet* other) {
        return Titled(*one) == Titled(*other) && one->description == other->description;
      });
}

/// The group of that heading and those options; null: there is none.
template <typename Groups>
auto* Find(Groups& groups, const std::string& heading,
           const std::vector<const OptionSheet*>& options) {
  const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
    return group.heading == heading && Alike(group.options, options);
  });
  return same == groups.end() ? nullptr : &*same;
}

}  // namespace

const char* HeadingOf(Audience audience) {
  switch (audience) {
    case Audience::kLearner:
      return "To learn and feel Moon";
    case Audience::kTutor:
      return "To teach it";
    case Audience::kWriter:
      return "To set, read and print text";
    case Audience::kResearcher:
      return "To label models, to measure and study";
    case Audience::kDeviceBuilder:
      return "Devices";
  }
  return "";
}

std::string UsageOf(const CommandSheet& sheet) {
  std::string usage = "moontrace " + sheet.name;
  for (const OptionSheet& option : sheet.options) {
    if (option.positional) usage += " [" + option.name + "]";
  }
  return usage + " [options]";
}

const char* ExitCodes() { return kExitCodes; }

Grouped ByGroup(const CommandSheet& sheet) {
  Grouped groups;
  for (const OptionSheet& option : sheet.options) {
    const auto at = std::find_if(groups.begin(), groups.end(), [&option](const auto& group) {
      return group.first == option.group;
    });
    if (at != groups.end()) {
      at->second.push_back(&option);
    } else {
      groups.push_back({option.group, {&option}});
    }
  }
  return groups;
}

SharedGroups::SharedGroups(const std::vector<CommandSheet>& sheets) {
  for (const CommandSheet& sheet : sheets) {
    for (const auto& [heading, options] : ByGroup(sheet)) {
      if (heading == kOwn) continue;
      if (Group* same = Find(groups_, heading, options)) {
        same->users.push_back(sheet.name);
      } else {
        groups_.push_back({heading, options, {sheet.name}});
      }
    }
  }
  const auto single = [](const Group& group) { return group.users.size() < 2; };
  groups_.erase(std::remove_if(groups_.begin(), groups_.end(), single), groups_.end());
}

bool SharedGroups::Holds(const std::string& heading,
                         const std::vector<const OptionSheet*>& options) const {
  return Find(groups_, heading, options) != nullptr;
}

std::string Introduction() {
  return Line(
             "Moontrace: learn, read and write Moon, the raised script of lines and curves, by "
             "touch.") +
         Line("To begin, type one of these and Enter:") +
         Line("moontrace demo: a word is traced at four sizes; a minute, no device needed.") +
         Line("moontrace learn: lessons; without a force device it says what works instead.") +
         Line("moontrace page \"good morning\": your own words in Moon, sign by sign.") +
         Line("moontrace read book.epub: a book, a web page or a text, to read by touch.") +
         Line("moontrace help: all commands. moontrace help learn: one of them.");
}

std::string ProgramHelp(const std::vector<CommandCard>& cards) {
  std::string help = Line("Usage: moontrace COMMAND [TEXT] [--file F | -] [options]");
  const Audience* former = nullptr;
  for (const CommandCard& card : cards) {
    if (former == nullptr || *former != card.audience) {
      help += fmt::format("\n{}:\n", HeadingOf(card.audience));
    }
    former = &card.audience;
    help += Line(fmt::format("{}: {}.", card.name, card.purpose));
  }
  return help + "\n" +
         Line(
             "One command: moontrace help COMMAND, or moontrace COMMAND --help-all for every "
             "option. The version: moontrace version. In a clone, ./moontrace test runs the "
             "tests.") +
         Line(kExitCodes);
}

std::string CommandHelp(const CommandCard& card, const CommandSheet& sheet, bool all) {
  const std::vector<std::string> common = Words(card.common);
  std::string help = Line(fmt::format("moontrace {}: {}.", sheet.name, sheet.purpose)) +
                     Line("Usage: " + UsageOf(sheet));
  if (all || common.empty()) {
    for (const auto& [heading, options] : ByGroup(sheet)) {
      if (!common.empty() && heading != kOwn) help += fmt::format("\n{}:\n", heading);
      for (const OptionSheet* option : options) help += OptionLine(*option);
    }
    return help;
  }
  std::string others;
  for (const auto& [heading, options] : ByGroup(sheet)) {
    bool is_whole = true;
    for (const OptionSheet* option : options) {
      const bool told = std::find(common.begin(), common.end(), option->name) != common.end();
      if (told) help += OptionLine(*option);
      is_whole &= told;
    }
    if (is_whole) continue;
    if (!others.empty()) others += "; ";
    others += LowerCase(heading);
  }
  return help + "\n" +
         Line(fmt::format("moontrace {} --help-all tells {} options more, of: {}.", sheet.name,
                          sheet.options.size() - common.size(), others));
}

std::string Reference(const std::vector<CommandCard>& cards,
                      const std::vector<CommandSheet>& sheets) {
  const SharedGroups shared(sheets);
  std::string text =
      "# Commands and their options\n\nMade by `moontrace help --markdown`; a test holds it to the "
      "program. `./moontrace COMMAND --help` tells\nthe common options of one command, "
      "`--help-all` "
      "all of them.\n\n## Options that commands share\n\n";
  for (const SharedGroups::Group& group : shared.groups()) {
    std::string of;
    for (const std::string& name : group.users) of += (of.empty() ? "`" : ", `") + name + "`";
    text += "### " + group.heading + "\n\nOf " + of + ".\n\n" + Table(group.options);
  }
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const CommandSheet& sheet = sheets[i];
    text += fmt::format("## {}\n\n    moontrace{}\n\n{}.", sheet.name,
                        UsageOf(sheet).substr(std::string("moontrace").size()), sheet.purpose);
    std::string elsewhere, own;
    for (const auto& [heading, options] : ByGroup(sheet)) {
      if (shared.Holds(heading, options)) {
        elsewhere += (elsewhere.empty() ? "" : "; ") + LowerCase(heading);
      } else {
        own += (heading == kOwn ? "" : "### " + heading + "\n\n") + Table(options);
      }
    }
    if (!elsewhere.empty()) text += fmt::format(" Shared options: {}.", elsewhere);
    if (cards[i].common[0] != '\0') text += fmt::format(" Common ones: `{}`.", cards[i].common);
    text += "\n\n" + own;
  }
  return text;
}

std::string TextAsPage(const std::vector<std::string>& args) {
  std::string text;
  std::size_t words = 0;
  for (const std::string& word : args) {
    if (word.empty() || word.front() == '-') break;
    text += (words++ == 0 ? "" : " ") + word;
  }
  if (text.find(' ') == std::string::npos) return {};
  // what a shell would change within quotes, and what is too long to be typed again
  const bool as_given = text.size() <= kLongestExample && OneLine(text) == text &&
                        text.find_first_of("\"$`\\!") == std::string::npos;
  return fmt::format("moontrace page \"{}\"", as_given ? text : "your text");
}

std::string NearestOption(std::string_view given, const std::vector<std::string>& names) {
  given.remove_prefix(std::min(given.find_first_not_of('-'), given.size()));
  const auto holds = [](const std::vector<std::string>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  for (const UsualOption& usual : kUsualOptions) {
    if (!holds(Words(usual.words), given)) continue;
    for (const std::string& name : Words(usual.options)) {
      if (holds(names, name)) return name + usual.value;
    }
  }
  return NearestWord(given, names);
}

std::string NearestCommand(std::string_view word, const std::vector<CommandCard>& cards) {
  const std::string meant = LowerCase(word);
  std::map<std::string, std::string> known;
  for (const CommandCard& card : cards) {
    for (const std::string& also : Words(card.also)) known.emplace(also, card.name);
  }
  for (const CommandCard& card : cards) known.insert_or_assign(card.name, card.name);
  const auto exact = known.find(meant);
  if (exact != known.end()) return exact->second;
  const std::size_t dashes = std::min(meant.find_first_not_of('-'), meant.size());
  if (dashes > 0) return NearestCommand(meant.substr(dashes), cards);
  std::vector<std::string> names(cards.size());
  std::transform(cards.begin(), cards.end(), names.begin(),
                 [](const CommandCard& card) { return card.name; });
  std::string nearest = NearestWord(meant, names);
  if (!nearest.empty()) return nearest;
  names.clear();
  for (const auto& [also, name] : known) names.push_back(also);
  nearest = NearestWord(meant, names);
  return nearest.empty() ? nearest : known.at(nearest);
}

}  // namespace moontrace
