#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/setup/help.h"

/// What the program says of itself and of its commands: plain lines, each ended by a newline.
namespace moontrace {

/// Who mostly uses a command, in the order of help.
enum class Audience { kLearner, kTutor, kWriter, kResearcher, kDeviceBuilder };

/// A command as help introduces it.
struct CommandCard {
  const char* name;
  const char* purpose;
  Audience audience;
  const char* common;  ///< options that `--help` tells, as "--size-mm --script"; empty: all
  const char* also;    ///< other words that mean it: "lesson lessons teach"
};

/// What stands above the commands of one audience.
const char* HeadingOf(Audience audience);
/// "moontrace page [TEXT] [options]".
std::string UsageOf(const CommandSheet& sheet);
/// "Exit codes: 0 good; ..."
const char* ExitCodes();

/// The options under each heading, in the order in which headings first occur. Of the sheet, which
/// outlives them.
using Grouped = std::vector<std::pair<std::string, std::vector<const OptionSheet*>>>;
Grouped ByGroup(const CommandSheet& sheet);

/// Headings under which two commands or more have the same options.
class SharedGroups {
 public:
  struct Group {
    std::string heading;
    std::vector<const OptionSheet*> options;
    std::vector<std::string> users;  ///< names of commands
  };
  /// The sheets outlive this.
  explicit SharedGroups(const std::vector<CommandSheet>& sheets);
  /// In the order in which they first occur.
  const std::vector<Group>& groups() const { return groups_; }
  bool Holds(const std::string& heading, const std::vector<const OptionSheet*>& options) const;

 private:
  std::vector<Group> groups_;
};

/// `moontrace` alone: what this is and what to type first.
std::string Introduction();
/// `moontrace help`: all commands, by who uses them.
std::string ProgramHelp(const std::vector<CommandCard>& cards);
/// `COMMAND --help`, and `--help-all` with `all`: what it does, how it is called, a line an option.
std::string CommandHelp(const CommandCard& card, const CommandSheet& sheet, bool all);
/// The reference of all commands as Markdown, which sim/OPTIONS.md holds. Options that several
/// commands take alike stand once.
std::string Reference(const std::vector<CommandCard>& cards,
                      const std::vector<CommandSheet>& sheets);
/// The command meant by a word that is none: one of its other words, otherwise the nearest name or
/// other word; empty where none is near. Dashes in front do not count.
std::string NearestCommand(std::string_view word, const std::vector<CommandCard>& cards);
/// The option of a command that is meant by one that it lacks, without the dashes in front: by what
/// people call it elsewhere ("pdf": "picture page.pdf"), otherwise the nearest of `names`; empty
/// where none is near. Dashes in front of `given` do not count.
std::string NearestOption(std::string_view given, const std::vector<std::string>& names);
/// "moontrace page \"the moon\"" for a line that begins with a text where a command should stand:
/// with blanks, or of several words, up to the first option. Empty for any other.
std::string TextAsPage(const std::vector<std::string>& args);

}  // namespace moontrace
