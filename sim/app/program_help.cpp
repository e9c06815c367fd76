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

std::string Usage(const CommandSheet& sheet) {
  std::string usage = "moontrace " + sheet.name;
  for (const OptionSheet& option : sheet.options) {
    if (option.positional) usage += " [" + option.name + "]";
  }
  return usage + " [options]";
}

/// The options under each heading, in the order in which headings first occur.
using Grouped = std::vector<std::pair<std::string, std::vector<const OptionSheet*>>>;
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

/// Equal groups of two commands read equal.
std::string KeyOf(const std::string& heading, const std::vector<const OptionSheet*>& options) {
  return "### " + heading + "\n\n" + Table(options);
}

}  // namespace

std::string Introduction() {
  return Line(
             "Moontrace: learn, read and write Moon, the raised script of lines and curves, by "
             "touch.") +
         Line("To begin, type one of these and Enter:") +
         Line("moontrace demo: a word is traced at four sizes; a minute, no device needed.") +
         Line("moontrace learn: lessons; without a force device it says what works instead.") +
         Line("moontrace page \"good morning\": your own words in Moon, sign by sign.") +
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
                     Line("Usage: " + Usage(sheet));
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
  std::map<std::string, std::vector<std::string>> users;  // of a group
  std::vector<std::string> order;
  for (const CommandSheet& sheet : sheets) {
    for (const auto& [heading, options] : ByGroup(sheet)) {
      if (heading == kOwn) continue;
      std::vector<std::string>& names = users[KeyOf(heading, options)];
      if (names.empty()) order.push_back(KeyOf(heading, options));
      names.push_back(sheet.name);
    }
  }
  std::string text =
      "# Commands and their options\n\nMade by `moontrace help --markdown`; a test holds it to the "
      "program. `./moontrace COMMAND --help` tells\nthe common options of one command, "
      "`--help-all` "
      "all of them.\n\n## Options that commands share\n\n";
  for (const std::string& key : order) {
    const std::vector<std::string>& names = users[key];
    if (names.size() < 2) continue;
    std::string of;
    for (const std::string& name : names) of += (of.empty() ? "`" : ", `") + name + "`";
    const std::size_t end = key.find('\n');
    text += key.substr(0, end) + "\n\nOf " + of + "." + key.substr(end);
  }
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const CommandSheet& sheet = sheets[i];
    text += fmt::format("## {}\n\n    moontrace{}\n\n{}.", sheet.name,
                        Usage(sheet).substr(std::string("moontrace").size()), sheet.purpose);
    std::string shared, own;
    for (const auto& [heading, options] : ByGroup(sheet)) {
      const std::string key = KeyOf(heading, options);
      if (heading != kOwn && users[key].size() > 1) {
        shared += (shared.empty() ? "" : "; ") + LowerCase(heading);
      } else {
        own += heading == kOwn ? Table(options) : key;
      }
    }
    if (!shared.empty()) text += fmt::format(" Shared options: {}.", shared);
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
