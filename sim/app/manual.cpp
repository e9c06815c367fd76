#include "sim/app/manual.h"

#include <fmt/core.h>

#include <sstream>

#include "sim/console/wording.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

/// As text of man(7): no character of it is a request, and a hyphen can be copied as one.
std::string Roff(std::string_view text) {
  std::string escaped = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string Section(std::string_view heading) { return fmt::format(".SH {}\n", Roff(heading)); }

std::string Options(const std::vector<const OptionSheet*>& options) {
  std::string text;
  for (const OptionSheet* option : options) {
    text += fmt::format(".TP\n\\fB{}\\fR", Roff(option->name));
    if (!option->value.empty()) text += fmt::format(" \\fI{}\\fR", Roff(option->value));
    text += "\n" + Roff(option->description) + "\n";
  }
  return text;
}

std::string CommandText(const CommandSheet& sheet, const SharedGroups& shared) {
  std::string text = fmt::format(".SS {}\n{}.\n.PP\n.B {}\n", Roff(sheet.name), Roff(sheet.purpose),
                                 Roff(UsageOf(sheet)));
  std::string elsewhere;
  for (const auto& [heading, options] : ByGroup(sheet)) {
    if (shared.Holds(heading, options)) {
      elsewhere += (elsewhere.empty() ? "" : "; ") + LowerCase(heading);
    } else {
      text += Options(options);
    }
  }
  if (!elsewhere.empty()) {
    text += fmt::format(".PP\nShared options: {}.\n", Roff(elsewhere));
  }
  return text;
}

}  // namespace

std::string Manual(const std::vector<CommandCard>& cards, const std::vector<CommandSheet>& sheets,
                   std::string_view version) {
  const SharedGroups shared(sheets);
  std::string text =
      fmt::format(".TH MOONTRACE 1 \"\" \"Moontrace {}\" \"User commands\"\n", Roff(version));
  text += Section("NAME") + Roff("moontrace - learn, read and write Moon by touch") + "\n";
  text += Section("SYNOPSIS") +
          ".B moontrace\n.I COMMAND\n[\\fITEXT\\fR] [\\fB\\-\\-file\\fR \\fIF\\fR | \\-] "
          "[\\fIoptions\\fR]\n";
  text += Section("DESCRIPTION");
  std::istringstream lines(Introduction());
  for (std::string line; std::getline(lines, line);) text += Roff(line) + "\n.PP\n";
  text += Section("COMMANDS");
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    if (i == 0 || cards[i - 1].audience != cards[i].audience) {
      text += fmt::format(".PP\n\\fI{}:\\fR\n", Roff(HeadingOf(cards[i].audience)));
    }
    text += CommandText(sheets[i], shared);
  }
  text += Section("SHARED OPTIONS");
  for (const SharedGroups::Group& group : shared.groups()) {
    text +=
        fmt::format(".SS {}\nOf {}.\n", Roff(group.heading), Roff(say::Joined(group.users, ", ")));
    text += Options(group.options);
  }
  text += Section("EXIT STATUS") + Roff(ExitCodes()) + "\n";
  text += Section("FILES") + ".TP\n.I ~/.local/share/moontrace/records.sqlite\n" +
          Roff(
              "What learners did, and where readers are: of the one who uses the machine, and "
              "nobody else can read it. With XDG_DATA_HOME set, in its folder.") +
          "\n";
  return text;
}

std::string BashCompletion(const std::vector<std::string>& words,
                           const std::vector<CommandSheet>& sheets) {
  std::string commands;
  for (const std::string& word : words) commands += (commands.empty() ? "" : " ") + word;
  std::string cases;
  for (const CommandSheet& sheet : sheets) {
    std::string options = "--help --help-all";
    for (const OptionSheet& option : sheet.options) {
      if (!option.positional) options += " " + option.name;
    }
    cases += fmt::format("    {}) words='{}' ;;\n", sheet.name, options);
  }
  return fmt::format(
      "# Completes moontrace for bash. Made by: moontrace help --bash\n"
      "_moontrace() {{\n"
      "  local words= word=${{COMP_WORDS[COMP_CWORD]}}\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    words='{}'\n"
      "  elif [[ $word == -* ]]; then\n"
      "    case ${{COMP_WORDS[1]}} in\n{}    esac\n"
      "  fi\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
      "}}\n"
      "complete -o default -F _moontrace moontrace\n",
      commands, cases);
}

}  // namespace moontrace
